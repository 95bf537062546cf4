#pragma once
#include <algorithm>
#include <string>
#include <vector>

namespace strike::testing {

/// One of the sentences holds the piece.
inline bool has(const std::vector<std::string>& sentences, const std::string& piece) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(piece) != sentence.npos; });
}

}  // namespace strike::testing
