// The page docs/deck_cards.md, from the tables of keywords that the reader itself uses.
//
//   page FILE            compares the file with the page; fails if it is another one, or a keyword has no texts
//   page FILE --write    writes it
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include <strike/input/dyna.hpp>

namespace {

namespace dyna = strike::detail::dyna;

bool is_whole = true;  // every keyword has its texts

std::string code(std::string_view name) { return "`" + std::string(name) + "`"; }
/// A cell of the table; keywords in sentences are code.
std::string cell(std::string_view text) {
  if (text == "-") return {};
  std::string made;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    made += word.starts_with('*') ? code(word) : std::string(word);
    text.remove_prefix(word.size());
    if (!text.empty()) made += ' ', text.remove_prefix(1);
  }
  return made;
}

std::string row(const std::string& names, const dyna::Meaning* meaning) {
  if (!meaning || !meaning->is_whole()) {
    std::fprintf(stderr, "%s is read, and has no texts: give it a Meaning beside its name.\n", names.c_str());
    is_whole = false;
    return {};
  }
  std::string text = "| " + names + " |";
  for (const std::string_view column : {meaning->deck, meaning->scene, meaning->lacks})
    text += (column == "-" ? std::string() : " " + cell(column)) + " |";
  return text + "\n";
}
std::string list(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + code(name);
  return text;
}
const dyna::Meaning* meaning_of(const dyna::Family& family) {
  const dyna::Keyword* const keyword =
      family.find(std::string(family.beginning) +
                  std::string(family.endings.empty() ? std::string_view() : family.endings.front()));
  return keyword ? keyword->meaning : nullptr;
}

/// Keywords of one meaning, which follow each other, are one row.
std::string table(const dyna::KeywordGroup& group) {
  std::string text = "## " + std::string(group.title) + "\n\n| keyword | in a deck | in a scene | not honoured |\n";
  text += "|---|---|---|---|\n";
  for (const dyna::Family& family : group.families)
    text += row(family.endings.empty() ? code(family.beginning) + ", with any of " + list(family.options)
                                       : code(family.beginning) + " with " + list(family.endings),
                meaning_of(family));
  const auto is_of_family = [&](std::string_view name) {
    for (const dyna::Family& family : group.families)
      if (family.endings.empty() && family.beginning == name) return true;
    return false;
  };
  for (std::size_t i = 0; i < group.keywords.size();) {
    const dyna::Meaning* const meaning = group.keywords[i].meaning;
    std::string names;
    for (; i < group.keywords.size() && group.keywords[i].meaning == meaning; ++i)
      if (!is_of_family(group.keywords[i].name)) names += (names.empty() ? "" : ", ") + code(group.keywords[i].name);
    if (!names.empty()) text += row(names, meaning);
  }
  return text + "\n";
}

std::string page() {
  std::string text = R"(<!-- made by tests/cards/check --write -->
# What becomes of a card?

Every keyword of an LS-DYNA deck that is read, with what it gives in the `DynaDeck` of [read a mesh](read_a_mesh.md),
what that becomes in the scene of [run a deck](run_a_deck.md), and what of it is not honoured. Where it does not say
"in silence", a warning tells each value that is not honoured, and the scene a sentence; its "in a scene" concerns
the scene alone. The page is made from the tables that the reader itself uses, and a test fails where it is old.
`_TITLE` and `_ID` may follow where the manual has them, `_MPP` a contact, and `_COLLECT` a set, whose parts are one.

## Files

| keyword | in a deck | in a scene | not honoured |
|---|---|---|---|
)";
  for (const dyna::IncludeKeyword& keyword : dyna::include_keywords) text += row(code(keyword.name), keyword.meaning);
  text += "\n";
  for (const dyna::KeywordGroup& group : dyna::keyword_groups) text += table(group);
  text += R"(## Refused

The deck would be another one without these, and without all others that begin so and stand in no table above.

| begins with | reason, and what to do |
|---|---|
| `*INCLUDE` | takes more or less from a file than its text: write the cards that it gives |
)";
  for (const auto& [beginning, advice] : dyna::refusals) text += "| " + code(beginning) + " | " + cell(advice) + " |\n";
  text += R"(
## Passed over

| keyword | becomes |
|---|---|
)";
  text += "| " + code(std::string(dyna::comment) + "...") + " | nothing, in silence |\n";
  text += "| " + list(dyna::marks) + " | skipped, with a warning |\n";
  text += R"(| other `*ELEMENT_...` | an error, or left out with a warning by `{.leave_out_elements = true}` |
| all others | skipped, with a warning that counts their cards; the scene says that they are left out, but for `*DATABASE` and `*CONTROL` |
)";
  return text;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return std::fprintf(stderr, "usage: page FILE [--write]\n"), 2;
  const std::string file = arguments[1], made = page();
  if (!is_whole) return 1;
  if (count > 2 && std::string_view(arguments[2]) == "--write") {
    std::ofstream out(file, std::ios::binary);
    out << made;
    return out.good() ? 0 : 1;
  }
  std::ifstream in(file, std::ios::binary);
  const std::string there{std::istreambuf_iterator<char>(in), {}};
  if (there == made) return 0;
  return std::fprintf(stderr, "%s is old: tests/cards/check --write makes it.\n", file.c_str()), 1;
}
