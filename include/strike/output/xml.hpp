#pragma once
#include <charconv>
#include <cstddef>
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

/// Size of the character that a text in UTF-8 starts with (RFC 3629); 0 if it is none, or none that XML 1.0 allows.
[[gnu::cold]] inline std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= ' ' || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  unsigned code = first & (0x7fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3f);
  }
  const bool shortest = code >= (size == 2 ? 0x80u : size == 3 ? 0x800u : 0x10000u);
  const bool is_character = code < 0xd800 || (code > 0xdfff && code < 0xfffe) || (code > 0xffff && code < 0x110000);
  return (first & 0xc0) == 0xc0 && first < 0xf8 && shortest && is_character ? size : 0;
}
/// True if a text is UTF-8 without control characters.
[[gnu::cold]] inline bool is_plain_text(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = static_cast<unsigned char>(text[0]) < ' ' ? 0 : character_size(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

/// Text for XML: & < > quotes, tabs and line ends as entities, and U+FFFD for each byte that XML does not allow.
[[gnu::cold]] inline std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (std::size_t at = 0, size = 0; at < text.size(); at += size) {
    size = character_size(text.substr(at));
    if (size != 1) {
      escaped += size > 1 ? text.substr(at, size) : std::string_view("\xEF\xBF\xBD");
      size += size == 0;
      continue;
    }
    switch (const char c = text[at]) {
      case '\t':
      case '\n':
      case '\r':
        escaped += joined({"&#", std::to_string(int(c)), ";"});
        break;
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
  }
  return escaped;
}
/// Plain text for a string of JSON.
[[gnu::cold]] inline std::string json_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
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
