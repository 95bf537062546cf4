#pragma once
#include <array>

#include <strike/input/dyna/draft.hpp>

// Sections, hourglass control, and the title of the run.
namespace strike::detail::dyna {

/// Cards of a user's element: points and constants, LMC after so many fields.
inline void pass_user_cards(FileNumber form, std::size_t fields, File& file) {
  if (form < 101 || form > 105) return;
  Card head = file.card();
  const FileNumber points = head.integer("NIP");
  head.pass(fields);
  const FileNumber constants = head.integer("LMC");
  file.ignore(1, "The element of the user");
  for (FileNumber left = points; left > 0 && file.pass_card(); --left) {
  }
  for (FileNumber left = constants; left > 0 && file.pass_card(); left -= 8) {
  }
}
inline void solid_section(File& file, Draft& draft) {
  file.for_each_titled_card([&](Card card) {
    const FileNumber number = draft.own_number("section", Id::other, card, file), form = card.integer("ELFORM", 1);
    file.ignore(card.number("AET"), "AET");
    draft.deck.sections.push_back({.number = number, .element_form = form, .corner_thickness = {}});
    pass_user_cards(form, 3, file);  // NXDOF, IHGF, ITAJ
  });
}
inline void shell_section(File& file, Draft& draft) {
  file.for_each_titled_card([&](Card card) {
    const FileNumber number = draft.own_number("section", Id::other, card, file);
    SectionCard section{.number = number, .element_form = card.integer("ELFORM"), .corner_thickness = {}};
    section.shear_factor = card.number("SHRF", 1);
    section.points = card.integer("NIP", 2);
    card.pass(1);
    file.ignore(card.number("QR/IRID"), "QR/IRID");
    const bool angles = card.integer("ICOMP") == 1;
    Card thicknesses = file.card();
    for (double& t : section.corner_thickness) t = thicknesses.number("T1 to T4");
    section.thickness = section.corner_thickness[0];
    for (double& t : section.corner_thickness)
      if (t == 0) t = section.thickness;
    section.reference = thicknesses.number("NLOC");
    file.ignore(thicknesses.number("MAREA"), "MAREA");
    if (angles) {
      file.ignore(1, "The angle of each layer");
      for (FileNumber left = section.points; left > 0 && file.pass_card(); left -= 8) {
      }
    }
    draft.deck.sections.push_back(section);
    pass_user_cards(section.element_form, 4, file);  // NXDOF, IUNF, IHGF, ITAJ
  });
}
inline void hourglass(File& file, Draft& draft) {
  file.for_each_titled_card([&](Card card) {
    const FileNumber number = draft.own_number("hourglass control", Id::other, card, file);
    HourglassCard control{.number = number, .type = card.integer("IHQ", 1)};
    control.coefficient = card.number("QM", 0.1);
    const double kind = card.number("IBQ", 1);
    file.ignore(kind == 1 ? 0 : kind, "IBQ");
    control.quadratic = card.number("Q1", 1.5);
    control.linear = card.number("Q2", 0.06);
    const double coefficient = card.number("QB or VDC");
    if (control.type == 6 || control.type == 7) file.ignore(coefficient, "VDC");
    control.bending = coefficient != 0 ? coefficient : control.coefficient;
    control.warping = card.number("QW", control.coefficient);
    draft.deck.hourglass_controls.push_back(control);
  });
}

inline void nothing_more(File&, Draft&) {}
inline void title_of_run(File& file, Draft&) { file.pass(); }
inline void title(File& file, Draft& draft) { draft.deck.title = file.heading(); }
inline constexpr Meaning of_solid_section{"`deck.section(part)`: form", "the choice of `Hex8`",
                                          "the element of a user, AET"};
inline constexpr Meaning of_shell_section{
    "`deck.section(part)`: form, thickness, points, shear factor, reference surface",
    "`Homogeneous{PlaneStress{...}, T1}` of five points by Simpson's rule; of plies `Layered`",
    "QR/IRID, the angles of ICOMP, MAREA, the element of a user; PROPT, SETYP, IDOF and EDGSET, passed in silence; in "
    "a scene: NIP other than 5, SHRF other than 5/6, T2 to T4 other than T1, NLOC without layers"};
inline constexpr Meaning of_hourglass{"`deck.hourglass(part)`: type, coefficients, bulk viscosity",
                                      "`ViscousHourglass{QM}`, `BulkViscosity{Q1, Q2}` of solids",
                                      "IBQ, VDC; in a scene: all of plates"};
inline constexpr Meaning of_nothing{"-", "-", "nothing"};
inline constexpr Meaning of_end{"nothing is read after it", "the same", "nothing"};
inline constexpr Meaning of_title{"`title`", "`title`", "nothing"};
inline constexpr auto section_keywords = std::to_array<Keyword>({
    {"*SECTION_SOLID", solid_section, Invariant::moved, &of_solid_section},
    {"*SECTION_SHELL", shell_section, Invariant::moved, &of_shell_section},
    {"*HOURGLASS", hourglass, Invariant::moved, &of_hourglass},
    {"*KEYWORD", nothing_more, Invariant::everywhere, &of_nothing},
    {"*KEYWORD_ID", title_of_run, Invariant::everywhere, &of_nothing},
    {"*KEYWORD_JOBID", title_of_run, Invariant::everywhere, &of_nothing},
    {"*END", nothing_more, Invariant::everywhere, &of_end},
    {"*TITLE", title, Invariant::everywhere, &of_title},
});

}  // namespace strike::detail::dyna
