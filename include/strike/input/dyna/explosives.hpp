#pragma once
#include <utility>

#include <strike/input/dyna/material_head.hpp>

// Explosives and where they are lit.
namespace strike::detail::dyna {

inline void explosive(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  ExplosiveMaterial material{head.density, head.card.positive("D"), head.card.positive("PCJ")};
  const double burning = head.card.number("BETA");
  if (burning == 2) material.pressure_CJ = 0;
  file.ignore(burning == 1, "BETA 1 (the front of a detonation lights it too)");
  if (!(material.pressure_CJ < head.density * material.detonation_velocity * material.detonation_velocity))
    file.refuse({"PCJ is not below RO D^2: correct it."});
  for (const char* name : {"K", "G", "SIGY"}) file.ignore(head.card.number(name), name);
  add(file, draft, head, material);
}
inline void jwl(File& file, Draft& draft) {
  auto [card, number] = eos_head(file, draft);
  Jwl eos{};
  eos.A_products = card.number("A"), eos.B_products = card.number("B"), eos.R1 = card.number("R1");
  eos.R2 = card.number("R2"), eos.omega = card.number("OMEG"), eos.initial_energy = card.number("E0");
  if (const double V0 = card.number("VO"); V0 != 0) file.ignore(V0 - 1, "VO");
  draft.deck.equations_of_state.push_back({number, file.name(), eos});
}
inline void detonations(File& file, Draft& draft) {
  file.title();
  bool goes_on = false;  // the card before was of PID -1, which has two
  file.for_each_card([&](Card card) {
    if (std::exchange(goes_on, false)) return;
    Card first = card;
    if (const FileNumber kind = first.integer("PID"); kind < 0) {
      file.ignore(1, "PID below 0");
      goes_on = kind == -1;
      return;
    }
    const FileNumber part = card.tag("PID", Id::part);
    const Eigen::Vector3d place = card.vector("X to Z");
    draft.deck.detonations.push_back({part, {place, card.number("LT")}});
    file.ignore_rest(card);
  });
}

}  // namespace strike::detail::dyna
