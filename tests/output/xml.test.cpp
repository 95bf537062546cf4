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

TEST_CASE("xml_escaped gives valid XML 1.0 whatever the bytes") {
  CHECK(xml_escaped("a\tb\nc\rd") == "a&#9;b&#10;c&#13;d");
  CHECK(xml_escaped("\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80") ==
        "\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80");  // 2 to 4 bytes
  const std::string replaced = "\xEF\xBF\xBD";
  for (const char* none : {"\x01", "\x1F", "\x80", "\xFF"}) CHECK(xml_escaped(none) == replaced);
  CHECK(xml_escaped(std::string(1, '\0')) == replaced);
  CHECK(xml_escaped("\xC3") == replaced);                                               // cut short
  CHECK(xml_escaped("\xC0\xAF") == replaced + replaced);                                // too long for its value
  CHECK(xml_escaped("\xED\xA0\x80") == replaced + replaced + replaced);                 // a surrogate
  CHECK(xml_escaped("\xEF\xBF\xBF") == replaced + replaced + replaced);                 // U+FFFF
  CHECK(xml_escaped("\xF4\x90\x80\x80") == replaced + replaced + replaced + replaced);  // beyond U+10FFFF
}

TEST_CASE("json_escaped escapes quotes and backslashes") {
  CHECK(json_escaped("a\"b\\c") == "a\\\"b\\\\c");
  CHECK(is_plain_text("caf\xC3\xA9 <&> \"\\"));
  CHECK_FALSE(is_plain_text("a\nb"));
  CHECK_FALSE(is_plain_text("a\xFF"));
}

TEST_CASE("Xml nests, escapes, and leaves out attributes without text") {
  Xml xml;
  xml.open("g", {{"id", "a<b & \"c\""}, {"class", ""}});
  xml.element("r", {{"width", 2.5}, {"count", 3}});
  xml.element("t", {}, xml_escaped("x > y"));
  xml.close();
  CHECK(xml.str() == "<g id=\"a&lt;b &amp; &quot;c&quot;\">\n<r width=\"2.5\" count=\"3\"/>\n<t>x &gt; y</t>\n</g>\n");
}
