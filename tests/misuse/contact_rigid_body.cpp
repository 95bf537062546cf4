// expect: where a body has a clearance(x)
#include <strike/contact/contact.hpp>
#include <strike/contact/rigid.hpp>

using namespace strike;

int main() { const Contact contact{NodeToRigid{{0, 1, 2}, 42}}; }
