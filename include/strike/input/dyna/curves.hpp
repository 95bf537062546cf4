#pragma once
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include <strike/error.hpp>
#include <strike/input/dyna/draft.hpp>
#include <strike/input/raw_mesh.hpp>

// Laws of points and curves; the curves may stand after their cards.
namespace strike::detail::dyna {

/// The curves of a deck for the cards of laws.
class Curves {
 public:
  Curves(const DynaDeck& deck, const File& file, Allowance& allowance) : file_(file), allowance_(allowance) {
    for (const CurveCard& curve : deck.curves) curves_.try_emplace(curve.number, &curve);
  }
  /// The curve that a card on a line names, of such as "material 3". Error: it is not in the file.
  const CurveCard& at(FileNumber number, std::string_view owner, std::uint32_t line) const {
    if (const auto found = curves_.find(number); found != curves_.end()) {
      allowance_.take(found->second->points.size(), line);
      return *found->second;
    }
    const std::string skipped = file_.skipped("*DEFINE_");
    file_.source().refuse(
        line, {"the curve ", std::to_string(number), " of ", owner, " is not in the file", skipped.empty() ? "" : " (",
               skipped, skipped.empty() ? "" : " was skipped)", ": define it or correct the card."});
  }

 private:
  const File& file_;
  Allowance& allowance_;
  std::map<FileNumber, const CurveCard*> curves_;
};

/// A law of points. Error: no law of such as "material 3" can follow these.
template <class Make>
auto made_of_points(std::string_view owner, std::uint32_t line, const File& file, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    std::string_view why = error.what();
    why.remove_prefix(std::min(why.size(), std::string_view("strike: ").size()));
    file.source().refuse(line, {owner, " cannot follow its points: ", why});
  }
}

}  // namespace strike::detail::dyna
