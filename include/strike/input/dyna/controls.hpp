#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/sets.hpp>
#include <strike/input/dyna/unused.hpp>

// Control of the run, and its outputs.
namespace strike::detail::dyna {

using Fields8 = std::array<UnusedField, 8>;

inline void termination(File& file, Draft& draft) {
  Card card = file.card();
  draft.deck.end_time = card.number("ENDTIM");
  tell_fields(card, std::array<UnusedField, 5>{{{"ENDCYC"}, {"DTMIN"}, {"ENDENG"}, {"ENDMAS", 1e8}, {"NOSOL"}}}, file);
}
inline void time_step(File& file, Draft& draft) {
  Card card = file.card();
  file.ignore(card.number("DTINIT"), "DTINIT");
  draft.deck.step_factor = card.number("TSSFAC", 0.9);
  tell_fields(card, std::array<UnusedField, 2>{{{"ISDO"}, {"TSLIMT"}}}, file);
  draft.deck.mass_scaled_step = card.number("DT2MS");
  file.ignore(draft.deck.mass_scaled_step, "DT2MS (give it to MassScaled)");
  tell_fields(card, std::array<UnusedField, 3>{{{"LCTM"}, {"ERODE"}, {"MS1ST"}}}, file);
  file.ignore(file.card().says_more(), "The second card");
}
inline void bulk_viscosity(File& file, Draft& draft) {
  Card card = file.card();
  const double quadratic = card.number("Q1", 1.5);
  draft.deck.bulk_viscosity = {quadratic, card.number("Q2", 0.06)};
  tell_fields(card, std::array<UnusedField, 3>{{{"TYPE", 1}, {"BTYPE"}, {"TSTYPE"}}}, file);
}
inline void default_hourglass(File& file, Draft& draft) {
  Card card = file.card();
  HourglassCard control{.number = 0, .type = card.integer("IHQ", 1)};
  control.coefficient = control.bending = control.warping = card.number("QH", 0.1);
  draft.deck.hourglass_control = control;
}
inline void shell_control(File& file, Draft& draft) {
  Card card = file.card();
  ShellControl& control = draft.deck.shell_control;
  control.warping_angle = card.number("WRPANG", 20);
  file.ignore(card.number("ESORT"), "ESORT");
  card.pass(1);  // IRNXX: normals of forms that are not here
  control.thickness_update = card.integer("ISTUPD");
  control.element_form = card.integer("THEORY", 2);
  control.warping = card.integer("BWC", 2);
  const double iterations = card.number("MITER", 1);
  file.ignore(iterations == 1 ? 0 : iterations, "MITER");
  control.projects = card.integer("PROJ") != 0;
  tell_card(std::array<UnusedField, 5>{{{"ROTASCL", 1}, {"INTGRD"}, {"LAMSHT"}, {"CSTYP6", 1}, {"THSHEL"}}}, file);
  tell_card(Fields8{{{"PSTUPD"}, {"SIDT4TU"}, {"CNTCO"}, {"ITSFLG"}, {"IRQUAD", 3}, {"W-MODE"}, {"STRETCH"}, {"ICRQ"}}},
            file);
  tell_card(
      Fields8{{{"NFAIL1"}, {"NFAIL4"}, {"PSNFAIL"}, {"KEEPCS"}, {"DELFR"}, {"DRCPSID"}, {"DRCPRM", 1}, {"INTPERR"}}},
      file);
}
inline void contact_control(File& file, Draft& draft) {
  Card card = file.card();
  draft.deck.contact_stiffness = card.number("SLSFAC", 0.1);
  // without ISLCHK, a check of the input
  tell_fields(
      card,
      std::array<UnusedField, 7>{{{"RWPNAL"}, {}, {"SHLTHK"}, {"PENOPT", 1}, {"THKCHG"}, {"ORIEN", 1}, {"ENMASS"}}},
      file);
  tell_card(
      Fields8{{{"USRSTR"}, {"USRFRC"}, {"NSBCS", 10}, {"INTERM"}, {"XPENE", 4}, {"SSTHK"}, {"ECDT"}, {"TIEDPRJ"}}},
      file);
  tell_card(Fields8{{{"SFRIC"}, {"DFRIC"}, {"EDC"}, {"VFC"}, {"TH"}, {"TH_SF"}, {"PEN_SF"}, {"PTSCL", 1}}}, file);
  // without IGNORE, FRCENG, SKIPRWG and OUTSEG: nodes that begin inside are no fault here, and what is printed
  tell_card(std::array<UnusedField, 7>{{{}, {}, {}, {}, {"SPOTSTP"}, {"SPOTDEL"}, {"SPOTHIN"}}}, file);
  tell_card(Fields8{{{"ISYM"}, {"NSEROD"}, {"RWGAPS"}, {"RWGDTH"}, {"RWKSF", 1}, {"ICOV"}, {"SWRADF"}, {"ITHOFF"}}},
            file);
}
inline void accuracy(File& file, Draft&) {
  tell_card(std::array<UnusedField, 5>{{{"OSU"}, {"INN", 1}, {"PIDOSU"}, {"IACC"}, {"EXACC"}}}, file);
}
/// Energies that the balance has anyway.
inline void energy_control(File& file, Draft&) { file.pass(); }

inline constexpr std::string_view database = "*DATABASE_";
/// Outputs of an interval of time.
inline constexpr auto output_names = std::to_array<std::string_view>(
    {"BINARY_D3PLOT", "BINARY_D3THDT", "BINARY_D3PART", "BINARY_INTFOR", "GLSTAT",  "MATSUM",  "RCFORC",
     "RWFORC",        "NODOUT",        "ELOUT",         "SLEOUT",        "SPCFORC", "NODFOR",  "BNDOUT",
     "SECFORC",       "RBDOUT",        "NCFORC",        "DEFORC",        "SWFORC",  "JNTFORC", "ABSTAT",
     "TRHIST",        "CURVOUT",       "DCFAIL",        "DEFGEO",        "GCEOUT",  "SBTOUT"});
inline void output(File& file, Draft& draft) {
  std::string_view name = file.base().substr(database.size());
  const bool binary = name.starts_with("BINARY_");
  if (binary) name.remove_prefix(std::string_view("BINARY_").size());
  Card card = file.card();
  const double interval = card.number("DT");
  if (interval < 0) file.refuse({"DT of ", file.name(), " is negative: give the interval of the output."});
  if (binary) {
    tell_fields(card, std::array<UnusedField, 2>{{{"LCDT"}, {"BEAM"}}}, file);
    const double plots = card.number("NPLTC");
    if (name == "D3PLOT" && plots > 0)
      draft.plots = plots;
    else
      file.ignore(plots, "NPLTC");
    file.ignore_rest(card);
    file.ignore(file.card().says_more(), "The second card");
  } else {
    card.pass(1);  // BINARY
    file.ignore(card.number("LCUR"), "LCUR");
    file.ignore_rest(card);
  }
  auto& all = draft.deck.outputs;
  const auto known = std::find_if(all.begin(), all.end(), [&](const OutputCard& other) { return other.name == name; });
  if (known != all.end())
    known->interval = interval;
  else
    all.push_back({std::string(name), interval});
}
/// Numbers eight to a line, or one with its heading.
template <Named named>
void history(File& file, Draft& draft) {
  constexpr bool of_nodes = named == Named::node || named == Named::set;
  constexpr Id id = named == Named::node                             ? Id::node
                    : named == Named::shell || named == Named::solid ? Id::element
                                                                     : Id::set;
  file.for_each_card([&](Card card) {
    for (int field = 0; field < (file.titled() ? 1 : 8); ++field)
      if (const FileNumber number = card.tag("a number of the history", id); number != 0)
        (of_nodes ? draft.history_nodes : draft.history_cells).push_back({named, number, file.line()});
  });
}

inline constexpr Meaning of_termination{"`end_time`", "the end of the run", "ENDCYC, DTMIN, ENDENG, ENDMAS, NOSOL"};
inline constexpr Meaning of_time_step{"`step_factor`, `mass_scaled_step`", "`.step_factor`",
                                      "DTINIT, ISDO, TSLIMT, LCTM, ERODE, MS1ST, the second card; in a scene: DT2MS"};
inline constexpr Meaning of_bulk_viscosity{"`bulk_viscosity`",
                                           "`BulkViscosity{Q1, Q2}` of solids whose part has no `*HOURGLASS`",
                                           "TYPE other than 1, BTYPE, TSTYPE"};
inline constexpr Meaning of_default_hourglass{"`deck.hourglass(part)` of parts without one", "as `*HOURGLASS`",
                                              "nothing"};
inline constexpr Meaning of_shell_control{"`shell_control`: WRPANG, ISTUPD, THEORY, BWC, PROJ",
                                          "THEORY of sections without ELFORM",
                                          "ESORT, MITER, all fields of further cards; IRNXX, passed in silence; in a "
                                          "scene: ISTUPD, WRPANG, BWC and PROJ"};
inline constexpr Meaning of_contact_control{
    "`contact_stiffness` (SLSFAC)", "-",
    "all other fields; ISLCHK, IGNORE, FRCENG, SKIPRWG and OUTSEG, passed in silence; in a scene: SLSFAC"};
inline constexpr Meaning of_accuracy{"-", "-", "OSU, INN other than 1, PIDOSU, IACC, EXACC"};
inline constexpr Meaning of_energy_control{"nothing: a run balances all energies", "the same", "nothing"};
inline constexpr Meaning of_node_histories{"`history_nodes`", "columns of the history: displacements", "nothing"};
inline constexpr Meaning of_cell_histories{"`history_cells`", "-", "in a scene: all of it"};
inline constexpr Meaning of_outputs{"`outputs`: the interval of each, `deck.interval(\"D3PLOT\")`",
                                    "the interval of the film, of `_BINARY_D3PLOT`",
                                    "LCDT, BEAM, LCUR, NPLTC but of D3PLOT, further fields, the second card; in a "
                                    "scene: all others, passed in silence"};
inline constexpr auto control_keywords = std::to_array<Keyword>({
    {"*CONTROL_TERMINATION", termination, Invariant::moved, &of_termination},
    {"*CONTROL_TIMESTEP", time_step, Invariant::moved, &of_time_step},
    {"*CONTROL_BULK_VISCOSITY", bulk_viscosity, Invariant::moved, &of_bulk_viscosity},
    {"*CONTROL_HOURGLASS", default_hourglass, Invariant::moved, &of_default_hourglass},
    {"*CONTROL_SHELL", shell_control, Invariant::moved, &of_shell_control},
    {"*CONTROL_CONTACT", contact_control, Invariant::moved, &of_contact_control},
    {"*CONTROL_ACCURACY", accuracy, Invariant::moved, &of_accuracy},
    {"*CONTROL_ENERGY", energy_control, Invariant::everywhere, &of_energy_control},
    {"*DATABASE_HISTORY_NODE", history<Named::node>, Invariant::everywhere, &of_node_histories},
    {"*DATABASE_HISTORY_NODE_SET", history<Named::set>, Invariant::everywhere, &of_node_histories},
    {"*DATABASE_HISTORY_SHELL", history<Named::shell>, Invariant::everywhere, &of_cell_histories},
    {"*DATABASE_HISTORY_SHELL_SET", history<Named::shell_set>, Invariant::everywhere, &of_cell_histories},
    {"*DATABASE_HISTORY_SOLID", history<Named::solid>, Invariant::everywhere, &of_cell_histories},
    {"*DATABASE_HISTORY_SOLID_SET", history<Named::solid_set>, Invariant::everywhere, &of_cell_histories},
});
/// The reader of *DATABASE with an output of an interval; null for other keywords.
inline const Keyword* output_keyword(std::string_view name) {
  static constexpr Keyword found{database, output, Invariant::moved, &of_outputs};
  if (!name.starts_with(database)) return nullptr;
  const auto known = std::find(output_names.begin(), output_names.end(), name.substr(database.size()));
  return known == output_names.end() ? nullptr : &found;
}
inline constexpr auto output_families = std::to_array<Family>({
    {database, output_names, {}, output_keyword},
});

}  // namespace strike::detail::dyna
