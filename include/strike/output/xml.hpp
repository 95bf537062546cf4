#pragma once
#include <charconv>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/text.hpp>

namespace strike::detail {

/// A length in a drawing: two decimals, no trailing zeros.
[[gnu::cold]] inline std::string pixels(double x) {
  char buffer[32];
  std::string digits{buffer, std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, 2).ptr};
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits == "-0" ? "0" : digits;
}

/// Text for XML: & < > and quotes as entities.
[[gnu::cold]] inline std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  return escaped;
}

/// name="value": a text, left out if empty, or a number, a length in pixels or a count.
struct Attribute {
  std::string_view name, text;
  double number = 0;
  bool is_number = false;

  Attribute(std::string_view of_name, std::string_view value) : name(of_name), text(value) {}
  Attribute(std::string_view of_name, const char* value) : name(of_name), text(value) {}
  template <class Number>
    requires std::is_arithmetic_v<Number>
  Attribute(std::string_view of_name, Number value)
      : name(of_name), number(static_cast<double>(value)), is_number(true) {}
};

using Attributes = std::initializer_list<Attribute>;

/// An XML text being written.
class Xml {
 public:
  [[gnu::cold]] void open(std::string_view tag, Attributes attributes = {}) {
    begin(tag, attributes);
    text_ += ">\n";
    tags_.push_back(tag);
  }
  [[gnu::cold]] void close() {
    end(tags_.back());
    tags_.pop_back();
  }
  [[gnu::cold]] void element(std::string_view tag, Attributes attributes) {
    begin(tag, attributes);
    text_ += "/>\n";
  }
  /// An element with content that is already XML.
  [[gnu::cold]] void element(std::string_view tag, Attributes attributes, std::string_view content) {
    begin(tag, attributes);
    text_ += '>';
    text_ += content;
    end(tag);
  }
  void raw(std::string_view xml) { text_ += xml; }

  const std::string& str() const { return text_; }

 private:
  [[gnu::cold]] void begin(std::string_view tag, Attributes attributes) {
    text_ += '<';
    text_ += tag;
    for (const Attribute& attribute : attributes)
      if (attribute.is_number || !attribute.text.empty())
        text_ += joined({" ", attribute.name, "=\"",
                         attribute.is_number ? pixels(attribute.number) : xml_escaped(attribute.text), "\""});
  }
  [[gnu::cold]] void end(std::string_view tag) {
    text_ += "</";
    text_ += tag;
    text_ += ">\n";
  }

  std::string text_;
  std::vector<std::string_view> tags_;
};

}  // namespace strike::detail
