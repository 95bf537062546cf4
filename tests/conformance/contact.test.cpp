#include "conformance/contact.hpp"

using namespace strike;

TEST_CASE("conformance: Kinematic") { testing::conforms_as_contact(Kinematic{}); }
TEST_CASE("conformance: Penalty") { testing::conforms_as_contact(Penalty{}); }
TEST_CASE("conformance: Kinematic with Coulomb") { testing::conforms_as_contact(Kinematic{}, Coulomb{0.3}); }
TEST_CASE("conformance: Penalty with Coulomb") { testing::conforms_as_contact(Coulomb{0.3}, Penalty{}); }
