#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/forces.hpp>
#include <strike/input/dyna/unused.hpp>

// Contacts.
namespace strike::detail::dyna {

inline constexpr std::string_view contact_beginning = "*CONTACT_";

inline void optional_cards(ContactCard& contact, File& file) {
  Card a = file.card();
  contact.soft = a.integer("SOFT");
  contact.soft_scale = a.number("SOFSCL", 0.1);
  tell_fields(a, std::array<UnusedField, 3>{{{"LCIDAB"}, {"MAXPAR", 1.025}, {"SBOPT", 2}}}, file);
  contact.depth = a.integer("DEPTH", 2);
  tell_fields(a, std::array<UnusedField, 2>{{{"BSORT"}, {"FRCFRQ", 1}}}, file);
  tell_card(
      std::array<UnusedField, 8>{
          {{"PENMAX"}, {"THKOPT"}, {"SHLTHK"}, {"SNLOG"}, {"ISYM"}, {"I2D3D"}, {"SLDTHK"}, {"SLDSTF"}}},
      file);
  Card c = file.card();
  const double gap = c.number("IGAP");
  file.ignore(gap == 1 ? 0 : gap, "IGAP");
  c.pass(1);  // IGNORE: nodes that begin inside are no fault here
  tell_fields(c, std::array<UnusedField, 6>{{{"DPRFAC"}, {"DTSTIF"}, {"EDGEK"}, {}, {"FLANGL"}, {"CID_RCF"}}}, file);
  tell_card(
      std::array<UnusedField, 8>{
          {{"Q2TRI"}, {"DTPCHK"}, {"SFNBR"}, {"FNLSCL"}, {"DNLSCL"}, {"TCSO"}, {"TIEDID"}, {"SHLEDG"}}},
      file);
  tell_card(
      std::array<UnusedField, 8>{
          {{"SHAREC"}, {"CPARM8"}, {"IPBACK"}, {"SRNDE"}, {"FRICSF", 1}, {"ICOR"}, {"FTORQ"}, {"REGION"}}},
      file);
}
/// FS, FD and DC. FS below 0 takes the friction of the parts or of a table.
inline void friction(ContactCard& contact, Card& card, File& file) {
  contact.static_friction = card.number("FS");
  contact.dynamic_friction = card.number("FD");
  contact.decay = card.number("DC");
  if (contact.static_friction >= 0) return;
  file.ignore(1, "FS below 0 (friction of parts or of a table)");
  contact.static_friction = contact.dynamic_friction = contact.decay = 0;
}
inline void contact(File& file, Draft& draft) {
  ContactCard contact{};
  contact.title = file.id_title(contact.number);
  contact.kind = file.base().substr(contact_beginning.size());
  contact.automatic = contact.kind.starts_with("AUTOMATIC_");
  if (contact.automatic) contact.kind.erase(0, std::string_view("AUTOMATIC_").size());
  if (file.is_parallel()) {
    file.ignore(file.card().says_more(), "The MPP card");
    if (file.goes_on_with_ampersand()) file.ignore(file.pass_card(), "The second MPP card");
  }
  Card card = file.card();
  const std::uint32_t line = file.line();
  Side slave{}, master{};
  Card later = card;
  later.pass(2);
  slave.kind = later.integer("SSTYP"), master.kind = later.integer("MSTYP");
  slave.number = card.tag("SSID", slave.kind == 3 ? Id::part : Id::set);
  master.number = card.tag("MSID", master.kind == 3 ? Id::part : Id::set);
  card.pass(2);
  if (contact.is_tied() && ((slave.number == 0 && slave.kind != 5) || (master.number == 0 && master.kind != 5)))
    file.refuse({"a tied contact names too little: give it SSID and MSID."});
  for (const char* what : {"SBOXID", "MBOXID"}) file.ignore(card.number(what), what);
  Card values = file.card();
  friction(contact, values, file);
  file.ignore(values.number("VC"), "VC");
  contact.damping = values.number("VDC");
  file.ignore(values.number("PENCHK"), "PENCHK");
  contact.birth = values.number("BT");
  if (const double death = values.number("DT"); death > 0 && early(death) != 0) contact.death = death;
  Card scales = file.card();
  contact.slave.stiffness = scales.number("SFS", 1), contact.master.stiffness = scales.number("SFM", 1);
  contact.slave.thickness = scales.number("SST"), contact.master.thickness = scales.number("MST");
  contact.slave.thickness_scale = scales.number("SFST", 1), contact.master.thickness_scale = scales.number("SFMT", 1);
  tell_fields(scales, std::array<UnusedField, 2>{{{"FSF", 1}, {"VSF", 1}}}, file);
  if (contact.is_eroding()) {
    Card erosion = file.card();
    file.ignore(erosion.number("ISYM"), "ISYM");
    const FileNumber outside = erosion.integer("EROSOP"), inside = erosion.integer("IADJ");
    contact.exposes = outside != 0 || inside != 0;
  }
  optional_cards(contact, file);
  draft.contacts.push_back({std::move(contact), slave, master, line});
}

inline constexpr Meaning of_contacts{
    "`contacts`: kind, parts, segments or nodes of both sides, friction, thickness, scales, SOFT, SOFSCL, DEPTH",
    "`Contact{Everything{.except = ...}, Penalty{}, Coulomb{FS}}`, one for each friction, between parts",
    "SBOXID, MBOXID, VC, PENCHK, FSF, VSF, most fields of the optional cards; in a scene: contacts of nodes or "
    "segments, BT and DT within the run, the fall of friction with the speed, thickness, VDC, SFS, SFM, SOFT, SOFSCL "
    "and DEPTH"};
inline constexpr Meaning of_tied_contacts{"`contacts`, `c.is_tied()`", "`Tied{nodes_near(...), surface, ...}`",
                                          "as other contacts; in a scene: rotations of `_SHELL_EDGE_TO_SURFACE`, ties "
                                          "of rigid parts, BT and DT within the run"};
inline constexpr auto contact_kinds = std::to_array<std::string_view>(
    {"SURFACE_TO_SURFACE", "NODES_TO_SURFACE", "SINGLE_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE",
     "AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_NODES_TO_SURFACE", "AUTOMATIC_SINGLE_SURFACE",
     "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", "AUTOMATIC_GENERAL", "ERODING_SURFACE_TO_SURFACE",
     "ERODING_NODES_TO_SURFACE", "ERODING_SINGLE_SURFACE"});
inline constexpr auto tied_kinds = std::to_array<std::string_view>(
    {"TIED_NODES_TO_SURFACE", "TIED_NODES_TO_SURFACE_OFFSET", "TIED_NODES_TO_SURFACE_BEAM_OFFSET",
     "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", "TIED_SURFACE_TO_SURFACE", "TIED_SURFACE_TO_SURFACE_OFFSET",
     "TIED_SURFACE_TO_SURFACE_BEAM_OFFSET", "TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE",
     "TIED_SHELL_EDGE_TO_SURFACE_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET",
     "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET"});
/// The reader of *CONTACT_ with those kinds of surfaces that are read; null for other keywords.
inline const Keyword* contact_keyword(std::string_view name) {
  static constexpr Keyword free{contact_beginning, contact, Invariant::moved, &of_contacts},
      tied{contact_beginning, contact, Invariant::moved, &of_tied_contacts};
  if (!name.starts_with(contact_beginning)) return nullptr;
  name.remove_prefix(contact_beginning.size());
  const auto is_in = [&](const auto& kinds) { return std::find(kinds.begin(), kinds.end(), name) != kinds.end(); };
  return is_in(contact_kinds) ? &free : is_in(tied_kinds) ? &tied : nullptr;
}
inline constexpr auto contact_families = std::to_array<Family>({
    {contact_beginning, contact_kinds, {}, contact_keyword},
    {contact_beginning, tied_kinds, {}, contact_keyword},
});

}  // namespace strike::detail::dyna
