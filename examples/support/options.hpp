#pragma once
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <strike/error.hpp>
#include <strike/process.hpp>

namespace examples {

/// A number with up to six significant digits.
inline std::string text(double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%g", number);
  return digits;
}

/// The key=value arguments of a program. Reading a key marks it as known; `check()` refuses the rest.
class Options {
 public:
  Options(int count, char** arguments) {
    for (int i = 1; i < count; ++i) {
      const std::string argument = arguments[i];
      const std::size_t equals = argument.find('=');
      if (equals == std::string::npos) throw strike::Error("Argument '" + argument + "' is not of the form key=value.");
      given_.insert_or_assign(argument.substr(0, equals), argument.substr(equals + 1));
    }
  }

  std::string text(const std::string& key, const std::string& otherwise) {
    const std::string* text = find(key, otherwise);
    return text ? *text : otherwise;
  }
  double number(const std::string& key, double otherwise) {
    const std::string* text = find(key, examples::text(otherwise));
    if (!text) return otherwise;
    double value = 0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
    if (error != std::errc{} || end != text->data() + text->size())
      throw strike::Error("'" + key + "=" + *text + "' is not a number.");
    return value;
  }
  unsigned count(const std::string& key, unsigned otherwise) {
    const double value = number(key, otherwise);
    if (!(value >= 1 && value <= 1e6 && value == static_cast<unsigned>(value)))
      throw strike::Error("'" + key + "' must be a whole number from 1 to 1000000.");
    return static_cast<unsigned>(value);
  }
  /// One of the words; the first if the key is not given.
  std::string choice(const std::string& key, const std::vector<std::string>& words) {
    const std::string* text = find(key, words.front());
    if (!text) return words.front();
    if (std::find(words.begin(), words.end(), *text) == words.end()) {
      std::string list;
      for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
      throw strike::Error("'" + key + "=" + *text + "' is not known; choose one of " + list + ".");
    }
    return *text;
  }

  /// Error: a key that the program does not read; the sentence lists the keys that it does.
  void check() const {
    for (const auto& [key, value] : given_)
      if (!known_.contains(key)) {
        std::string keys;
        for (const auto& [name, usual] : known_) keys += (keys.empty() ? "" : ", ") + name + "=" + usual;
        throw strike::Error("There is no option '" + key + "'; there are " + keys + ".");
      }
  }

 private:
  const std::string* find(const std::string& key, const std::string& usual) {
    known_.insert_or_assign(key, usual);
    const auto found = given_.find(key);
    return found == given_.end() ? nullptr : &found->second;
  }
  std::map<std::string, std::string> given_, known_;
};

/// Runs the program and turns an Error into one line and a failure.
inline int run(int count, char** arguments, const std::function<void(Options&)>& program) {
  try {
    Options options(count, arguments);
    program(options);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    if (strike::detail::this_process.is_first) std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
}

}  // namespace examples
