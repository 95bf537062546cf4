#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <strike/input/dyna/draft.hpp>

// Fields and checks that cards of materials share.
namespace strike::detail::dyna {

/// First fields of every material card.
struct MaterialHead {
  std::string title;
  Card card;
  FileNumber number;
  double density;
};
inline MaterialHead material_head(File& file, Draft& draft) {
  std::string title = file.title();
  Card card = file.card();
  const FileNumber number = draft.own_number("material", Id::material, card, file);
  const double density = card.positive("RO");
  return {std::move(title), card, number, density};
}
inline void add(const File& file, Draft& draft, const MaterialHead& head, decltype(MaterialCard::material) material,
                double cutoff = 0) {
  draft.deck.materials.push_back(
      {head.number, file.name(), head.title, material, cutoff != 0 ? std::optional(-std::abs(cutoff)) : std::nullopt});
}

inline double poissons_ratio(Card& card, const File& file) {
  const double ratio = card.number("PR");
  if (!(ratio > -1) || !(ratio < 0.5)) file.refuse({"PR is not between -1 and 0.5: correct it."});
  return ratio;
}
inline Elastic elastic_of(MaterialHead& head, const File& file) {
  const double E = head.card.positive("E");
  return {head.density, E, poissons_ratio(head.card, file)};
}
inline std::optional<FailureStrain> failure_at(double strain) {
  return strain > 0 && strain < 1e6 ? std::optional(FailureStrain{strain}) : std::nullopt;
}
/// An equation of state by its first card.
inline std::pair<Card, FileNumber> eos_head(File& file, Draft& draft) {
  file.title();
  Card card = file.card();
  const FileNumber number = draft.own_number("equation of state", Id::material, card, file);
  return {card, number};
}

}  // namespace strike::detail::dyna
