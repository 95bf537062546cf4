#include <strike/output/xml.hpp>

#include "support/catch.hpp"

using namespace strike::detail;

TEST_CASE("pixels keeps two decimals and no more characters than needed") {
  CHECK(pixels(12) == "12");
  CHECK(pixels(12.5) == "12.5");
  CHECK(pixels(-0.001) == "0");
  CHECK(pixels(-3.14159) == "-3.14");
  CHECK(pixels(100) == "100");
}

TEST_CASE("Xml nests, escapes, and leaves out attributes without text") {
  Xml xml;
  xml.open("g", {{"id", "a<b & \"c\""}, {"class", ""}});
  xml.element("r", {{"width", 2.5}, {"count", 3}});
  xml.element("t", {}, xml_escaped("x > y"));
  xml.close();
  CHECK(xml.str() == "<g id=\"a&lt;b &amp; &quot;c&quot;\">\n<r width=\"2.5\" count=\"3\"/>\n<t>x &gt; y</t>\n</g>\n");
}
