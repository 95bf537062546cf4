// Drives the harness beside it without libFuzzer: mutations of the decks in a folder, the same in every run.
//   mutations FOLDER COUNT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Random = std::mt19937_64;

std::size_t below(std::size_t bound, Random& random) {
  return static_cast<std::size_t>(random() % (bound + (bound == 0)));
}

std::string mutated(std::string text, const std::vector<std::string>& decks, Random& random) {
  static const std::vector<std::string> words{"0",
                                              "-1",
                                              "1e308",
                                              "1e-308",
                                              "99999999999999999999",
                                              "9223372036854775807",
                                              "-9223372036854775808",
                                              "1099511627775",
                                              "2.5",
                                              "nan",
                                              "*",
                                              "\n*",
                                              "$",
                                              "$End",
                                              ",",
                                              ",,",
                                              "\"",
                                              "\n",
                                              "\r\n",
                                              " ",
                                              "\t",
                                              ".",
                                              "+",
                                              "*NODE\n",
                                              "*ELEMENT_SOLID\n",
                                              "*SET_NODE_LIST_GENERATE\n",
                                              "*NSET, NSET=a, GENERATE\n1, 1000000000, 1\n",
                                              "*PART\n",
                                              "*END PART\n",
                                              "4294967296"};
  for (std::size_t edits = 1 + below(6, random); edits > 0; --edits) {
    const std::size_t at = below(text.size() + 1, random), length = below(1 + below(40, random), random);
    switch (below(6, random)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, words[below(words.size(), random)]);
        break;
      case 2:
        text.insert(at, text.substr(below(text.size() + 1, random), length));
        break;
      case 3:
        if (at < text.size()) text[at] = static_cast<char>(random() % 256);
        break;
      case 4:
        text.replace(at, std::min(length, text.size() - at), words[below(words.size(), random)]);
        break;
      default: {  // lines of another deck
        const std::string& other = decks[below(decks.size(), random)];
        text.insert(at, other, below(other.size() + 1, random), 5 * length);
      }
    }
  }
  return text;
}

void read(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::puts("usage: mutations FOLDER COUNT"), 2;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> decks;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    decks.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  if (decks.empty()) return std::puts("the folder holds no deck"), 2;
  for (const std::string& deck : decks) {
    read(deck);
    for (std::size_t end = 0; end < deck.size(); end += 7) read(deck.substr(0, end));
  }
  Random random(1);
  const int count = std::atoi(argv[2]);
  for (int i = 0; i < count; ++i) read(mutated(decks[below(decks.size(), random)], decks, random));
  std::printf("%zu decks, %d mutations: each a deck or an Error\n", decks.size(), count);
}
