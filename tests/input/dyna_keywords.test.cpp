// The tables of keywords, which docs/deck_cards.md is made from: what they list is what the reader does.
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <strike/input/dyna.hpp>

#include "input/dyna_text.hpp"
#include "support/catch.hpp"

using namespace strike;
namespace dyna = strike::detail::dyna;

namespace {

const std::string mesh = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT_SOLID\n1,1,1,2,3,4\n";

/// Names of a family: with each ending, or with none, each and each two of the options.
std::vector<std::string> names_of(const dyna::Family& family) {
  std::vector<std::string> names;
  const std::string beginning(family.beginning);
  for (const std::string_view ending : family.endings) names.push_back(beginning + std::string(ending));
  if (family.endings.empty()) names.push_back(beginning);
  for (const std::string_view first : family.options) {
    names.push_back(beginning + std::string(first));
    for (const std::string_view second : family.options)
      names.push_back(beginning + std::string(first) + std::string(second));
  }
  return names;
}
bool has_texts(const dyna::Meaning* meaning) { return meaning && meaning->is_whole(); }

}  // namespace

TEST_CASE("dyna keywords: each has its texts, and a name of its own") {
  std::set<std::string_view> names;
  for (const dyna::KeywordGroup& group : dyna::keyword_groups) {
    for (const dyna::Keyword& keyword : group.keywords) {
      INFO(keyword.name);
      CHECK(names.insert(keyword.name).second);
      CHECK(dyna::find_keyword(keyword.name) == &keyword);
      CHECK(has_texts(keyword.meaning));
    }
    for (const dyna::Family& family : group.families)
      for (const std::string& name : names_of(family)) {
        INFO(name);
        REQUIRE(family.find(name));
        CHECK(has_texts(family.find(name)->meaning));
        CHECK(dyna::find_keyword(name)->read == family.find(name)->read);
        CHECK(dyna::find_keyword(name)->meaning == family.find(name)->meaning);
        CHECK_FALSE(family.find(name + "_NO_SUCH_OPTION"));
      }
  }
  for (const dyna::IncludeKeyword& keyword : dyna::include_keywords) CHECK(has_texts(keyword.meaning));
}

TEST_CASE("dyna keywords: those that are listed as refused are, and comments alone pass in silence") {
  for (const auto& [beginning, advice] : dyna::refusals) {
    const std::string name = std::string(beginning) + (beginning.ends_with('_') ? "X" : "_X");
    INFO(name);
    CHECK_FALSE(dyna::find_keyword(name));
    decks::expect_refused(mesh + name + "\n1\n", name + " " + std::string(advice));
  }
  decks::expect_refused(mesh + "*INCLUDE_X\n1\n", "*INCLUDE_X is not read");
  CHECK(decks::read(mesh + std::string(dyna::comment) + "\nnumbers 1, 2, 3\n").warnings.empty());
  for (const std::string_view mark : dyna::marks) {
    const auto warnings = decks::read(mesh + std::string(mark) + "\n1,1,2\n").warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0] == std::string(mark) + " (1 card) was skipped: line 8.");
  }
}

TEST_CASE("dyna keywords: each is read, and none of them is skipped") {
  for (const dyna::KeywordGroup& group : dyna::keyword_groups) {
    const auto expect_read = [](const std::string& name) {
      INFO(name);
      try {
        for (const std::string& warning : decks::read(mesh + name + "\n").warnings)
          CHECK(warning.find("was skipped") == std::string::npos);
      } catch (const Error& error) {  // a card without numbers is none
        const std::string_view sentence = error.what();
        CHECK(sentence.find("of a kind that is not read") == sentence.npos);
      }
    };
    for (const dyna::Keyword& keyword : group.keywords) expect_read(std::string(keyword.name));
    for (const dyna::Family& family : group.families)
      for (const std::string& name : names_of(family)) expect_read(name);
  }
}

TEST_CASE("dyna keywords: the mass of a section by its area is told") {
  const auto warnings = decks::read(mesh + "*SECTION_SHELL\n2,2\n.1,,,,,7\n").warnings;
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] == "MAREA of *SECTION_SHELL (1) had no effect: line 10.");
}
