#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/input/deck.hpp>
#include <strike/input/dyna_cards.hpp>
#include <strike/input/raw_mesh.hpp>
#include <strike/input/source.hpp>

namespace strike {
namespace detail {

/// A data line: fields of fixed widths, or between commas. What is blank or missing is the fallback.
class DynaCard {
 public:
  DynaCard(std::string_view line, const Source& source)
      : rest_(line), source_(&source), commas_(line.find(',') != line.npos) {}

  std::string_view text(std::size_t width = 10) {
    if (commas_) return trimmed(taken(rest_, ','));
    const std::string_view field = rest_.substr(0, width);
    rest_.remove_prefix(field.size());
    return trimmed(field);
  }
  double number(std::string_view meaning, double fallback = 0, std::size_t width = 10) {
    const std::string_view field = text(width);
    return field.empty() ? fallback : source_->number(field, meaning);
  }
  FileNumber integer(std::string_view meaning, FileNumber fallback = 0, std::size_t width = 10) {
    const std::string_view field = text(width);
    return field.empty() ? fallback : source_->integer(field, meaning);
  }
  /// The number of a thing in the file; 0, which names none, if it is blank.
  FileNumber tag(std::string_view meaning, std::size_t width = 10) {
    const FileNumber n = integer(meaning, 0, width);
    if (n < 0 || n >= RawMesh::scope)
      source_->refuse({meaning, " ", std::to_string(n), " is out of bounds: number from 1 to 10^12."});
    return n;
  }
  double positive(std::string_view meaning) {
    const double value = number(meaning);
    if (!(value > 0)) source_->refuse({meaning, " is not positive: give the material its ", meaning, "."});
    return value;
  }
  Eigen::Vector3d vector(std::string_view meaning) {
    const double x = number(meaning), y = number(meaning), z = number(meaning);
    return {x, y, z};
  }
  void pass(std::size_t fields) {
    while (fields-- > 0) text();
  }
  bool is_blank() const { return trimmed(rest_).empty(); }
  /// Whether a field that was not read says more than 0.
  bool says_more() {
    while (!is_blank())
      if (const std::string_view field = text(); !field.empty() && to_number(field) != 0.0) return true;
    return false;
  }

 private:
  std::string_view rest_;
  const Source* source_;
  bool commas_;
};

/// Keywords with their cards (LS-DYNA Keyword User's Manual R13, volumes I and II).
class DynaReader {
 public:
  explicit DynaReader(Source source) : source_(std::move(source)) {}

  DynaDeck read() {
    std::string_view line;
    while (!ended_ && source_.next(line)) {
      if (line.empty() || line[0] == '$' || trimmed(line).empty()) continue;
      if (line[0] != '*') source_.refuse({shown(line), " stands before any keyword: begin the file with *KEYWORD."});
      keyword(trimmed(line));
      if (next_line(line)) further_cards(line);
    }
    if (skipped_.empty() && !known_) source_.refuse({"the file has no keyword: give an LS-DYNA keyword file."});
    Finished done = finished(std::move(raw_), source_);
    static_cast<Deck&>(deck_) = std::move(done.deck);
    deck_.title = std::move(title_);
    resolve(done);
    for (auto&& notice : skipped_.sentences(" was skipped: ")) deck_.notices.push_back(std::move(notice));
    for (auto&& notice : values_.sentences(" had no effect: ")) deck_.notices.push_back(std::move(notice));
    return std::move(deck_);
  }

 private:
  using Shape = RawMesh::Shape;
  static constexpr FileNumber shells = RawMesh::scope;  ///< their numbers are others than those of the solids

  /// The next data line of the keyword, without comments.
  bool next_line(std::string_view& line) {
    while (source_.peek() != '\0' && source_.peek() != '*') {
      source_.next(line);
      if (line.empty() || line[0] != '$') return true;
    }
    return false;
  }
  /// The next data line of a keyword whose cards repeat; blank lines say nothing there.
  bool next_full_line(std::string_view& line) {
    while (next_line(line))
      if (!trimmed(line).empty()) return true;
    return false;
  }
  DynaCard card() {
    std::string_view line;
    return next_line(line) ? DynaCard(line, source_) : DynaCard({}, source_);
  }
  void further_cards(std::string_view line) {
    const std::uint32_t at = source_.line();
    bool blank = trimmed(line).empty();
    while (next_line(line)) blank &= trimmed(line).empty();
    if (known_keyword_ && !blank) values_.add(joined({"What follows the cards of ", name_}), at);
  }
  /// A value that has no counterpart here.
  void ignore(double value, std::string_view what) {
    if (value != 0) values_.add(joined({what, " of ", name_}), source_.line());
  }

  template <class... Cards>
  void ignore_rest(Cards&... cards) {
    (ignore(cards.says_more(), "Further fields"), ...);
  }

  void keyword(std::string_view line) {
    name_ = upper(line.substr(0, std::min(line.find_first_of(" \t,"), line.size())));
    const std::string options = upper(line);
    known_keyword_ = true;
    if (name_.back() == '-') name_.pop_back();
    if (name_.back() == '+' || name_.back() == '%' || options.find(" %") != options.npos ||
        (name_ == "*KEYWORD" && (options.find("LONG=Y") != options.npos || options.find("I10=Y") != options.npos)))
      source_.refuse({"the file is in the long or the I10 format: write it in the standard one."});
    if (name_.substr(0, 8) == "*INCLUDE") source_.refuse({name_, " is not followed: put the text of that file here."});
    std::string_view base = name_;
    const auto ends = [&](std::string_view option) {
      if (base.size() <= option.size() || base.substr(base.size() - option.size()) != option) return false;
      base.remove_suffix(option.size());
      return true;
    };
    const bool contact = base.substr(0, 9) == "*CONTACT_";
    titled_ = contact ? ends("_ID") || ends("_TITLE")
              : base.substr(0, 10) == "*BOUNDARY_" || base.substr(0, 11) == "*RIGIDWALL_" ? ends("_ID")
                                                                                          : ends("_TITLE");
    using Action = void (DynaReader::*)();
    static constexpr auto actions = std::to_array<std::pair<std::string_view, Action>>({
        {"*KEYWORD", &DynaReader::nothing_more},
        {"*END", &DynaReader::end},
        {"*TITLE", &DynaReader::title},
        {"*NODE", &DynaReader::nodes},
        {"*ELEMENT_SOLID", &DynaReader::solids},
        {"*ELEMENT_SHELL", &DynaReader::plates},
        {"*ELEMENT_SHELL_THICKNESS", &DynaReader::thick_plates},
        {"*PART", &DynaReader::parts},
        {"*SET_NODE", &DynaReader::node_set},
        {"*SET_NODE_LIST", &DynaReader::node_set},
        {"*SET_NODE_LIST_GENERATE", &DynaReader::node_ranges},
        {"*SET_SOLID", &DynaReader::solid_set},
        {"*SET_SOLID_GENERATE", &DynaReader::solid_ranges},
        {"*SET_SHELL", &DynaReader::shell_set},
        {"*SET_SHELL_LIST", &DynaReader::shell_set},
        {"*SET_SHELL_LIST_GENERATE", &DynaReader::shell_ranges},
        {"*SET_PART", &DynaReader::part_set},
        {"*SET_PART_LIST", &DynaReader::part_set},
        {"*SECTION_SOLID", &DynaReader::solid_section},
        {"*SECTION_SHELL", &DynaReader::shell_section},
        {"*HOURGLASS", &DynaReader::hourglass},
        {"*MAT_ELASTIC", &DynaReader::elastic},
        {"*MAT_001", &DynaReader::elastic},
        {"*MAT_PLASTIC_KINEMATIC", &DynaReader::plastic_kinematic},
        {"*MAT_003", &DynaReader::plastic_kinematic},
        {"*MAT_PIECEWISE_LINEAR_PLASTICITY", &DynaReader::piecewise_plastic},
        {"*MAT_024", &DynaReader::piecewise_plastic},
        {"*MAT_ELASTIC_PLASTIC_HYDRO", &DynaReader::plastic_hydro},
        {"*MAT_010", &DynaReader::plastic_hydro},
        {"*MAT_JOHNSON_COOK", &DynaReader::johnson_cook},
        {"*MAT_015", &DynaReader::johnson_cook},
        {"*MAT_NULL", &DynaReader::null},
        {"*MAT_009", &DynaReader::null},
        {"*EOS_LINEAR_POLYNOMIAL", &DynaReader::linear_polynomial},
        {"*EOS_001", &DynaReader::linear_polynomial},
        {"*EOS_GRUNEISEN", &DynaReader::gruneisen},
        {"*EOS_004", &DynaReader::gruneisen},
        {"*BOUNDARY_SPC_NODE", &DynaReader::node_support},
        {"*BOUNDARY_SPC_SET", &DynaReader::set_support},
        {"*INITIAL_VELOCITY", &DynaReader::velocity},
        {"*INITIAL_VELOCITY_NODE", &DynaReader::node_velocity},
        {"*INITIAL_VELOCITY_GENERATION", &DynaReader::generated_velocity},
        {"*RIGIDWALL_PLANAR", &DynaReader::wall},
        {"*CONTACT_AUTOMATIC_SINGLE_SURFACE", &DynaReader::contact},
        {"*CONTACT_AUTOMATIC_GENERAL", &DynaReader::contact},
        {"*CONTACT_AUTOMATIC_NODES_TO_SURFACE", &DynaReader::contact},
        {"*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", &DynaReader::contact},
        {"*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", &DynaReader::contact},
        {"*CONTROL_TERMINATION", &DynaReader::termination},
        {"*CONTROL_TIMESTEP", &DynaReader::time_step},
        {"*CONTROL_BULK_VISCOSITY", &DynaReader::bulk_viscosity},
    });
    base_ = base;
    const auto* const action =
        std::find_if(actions.begin(), actions.end(), [&](const auto& known) { return known.first == base; });
    if (action != actions.end()) {
      known_ = true;
      (this->*action->second)();
    } else {
      known_keyword_ = false;
      skipped_.add(name_.substr(0, 60), source_.line());
    }
  }

  void nothing_more() {}
  void end() { ended_ = true; }
  std::string heading() {
    std::string_view line;
    return next_line(line) ? std::string(trimmed(line)) : std::string();
  }
  std::string title_of_card() { return titled_ ? heading() : std::string(); }
  void title() { title_ = heading(); }

  void nodes() {
    std::string_view line;
    while (next_full_line(line)) {
      DynaCard card(line, source_);
      const FileNumber number = defined(card.tag("the number of a node", 8), "node");
      Eigen::Vector3d x;
      for (Eigen::Index i = 0; i < 3; ++i) x[i] = card.number("the coordinate", 0, 16);
      raw_.nodes.push_back({number, x, source_.line()});
      if (card.is_blank()) continue;
      const Fixed fixed{held_by(card.integer("TC", 0, 8)), held_by(card.integer("RC", 0, 8))};
      if (fixed != Fixed{}) choice_of(fixed).push_back({Kind::node, number, source_.line()});
    }
  }
  FileNumber defined(FileNumber number, const char* thing) const {
    if (number == 0) source_.refuse({"a ", thing, " has no number: number from 1."});
    return number;
  }

  /// Along or about x, y, z.
  using Held = std::array<bool, 3>;
  using Fixed = std::pair<Held, Held>;
  Held held_by(FileNumber code) const {
    constexpr std::array<Held, 8> codes{{{false, false, false},
                                         {true, false, false},
                                         {false, true, false},
                                         {false, false, true},
                                         {true, true, false},
                                         {false, true, true},
                                         {true, false, true},
                                         {true, true, true}}};
    if (code < 0 || code > 7)
      source_.refuse({"the constraint ", std::to_string(code), " of a node is none: give 0 to 7."});
    return codes[static_cast<std::size_t>(code)];
  }

  /// The group of the elements of a part, which are the part.
  std::uint32_t part_of(FileNumber number) {
    const auto [place, is_new] = parts_.try_emplace(number, static_cast<std::uint32_t>(raw_.parts.size()));
    if (is_new) {
      raw_.groups.push_back({place->second});
      raw_.parts.push_back({number, {}, {}});
    }
    return place->second;
  }
  void add(RawMesh::Element element, FileNumber part) {
    element.group = part_of(part);
    raw_.elements.push_back(element);
  }
  void solids() {
    std::string_view line;
    while (next_full_line(line)) {
      DynaCard card(line, source_);
      RawMesh::Element element{
          defined(card.tag("the number of an element", 8), "solid"), {}, 0, source_.line(), Shape::hexahedron};
      const FileNumber part = card.tag("PID", 8);
      if (card.is_blank() && next_line(line)) card = DynaCard(line, source_);  // the corners have a line of their own
      for (FileNumber& corner : element.corners) corner = card.tag("a corner", 8);
      for (std::size_t i = 4; i < 8; ++i)
        if (element.corners[i] == 0) element.corners[i] = element.corners[i - 1];
      if (card.tag("a corner", 8) != 0)
        source_.refuse({"element ", std::to_string(element.number),
                        " is a tetrahedron of ten nodes: mesh in first order, with four."});
      add(element, part);
    }
  }
  void plate(std::string_view line) {
    DynaCard card(line, source_);
    const FileNumber number = defined(card.tag("the number of an element", 8), "shell"), part = card.tag("PID", 8);
    RawMesh::Element element{shells + number, {}, 0, source_.line(), Shape::quadrilateral};
    for (std::size_t i = 0; i < 4; ++i) element.corners[i] = card.tag("a corner", 8);
    if (element.corners[3] == 0) element.corners[3] = element.corners[2];
    if (card.tag("a corner", 8) != 0)
      source_.refuse({"element ", std::to_string(number), " is a shell of more than four nodes: mesh in first order."});
    add(element, part);
  }
  void plates() {
    std::string_view line;
    while (next_full_line(line)) plate(line);
  }
  void thick_plates() {
    std::string_view line;
    while (next_full_line(line)) {
      plate(line);
      if (next_line(line)) ignore(1, "The thickness of each shell");
    }
  }

  void parts() {
    std::string_view line;
    while (next_full_line(line)) {
      const std::string name(trimmed(line));
      DynaCard card = this->card();
      const FileNumber number = defined(card.tag("PID"), "part");
      raw_.parts[part_of(number)].name = name;
      const FileNumber section = card.tag("SECID"), material = card.tag("MID"), eos = card.tag("EOSID");
      deck_.part_cards.push_back({number, name, section, material, eos, card.tag("HGID")});
      ignore_rest(card);
    }
  }

  RawMesh::Set& begin_set(std::vector<RawMesh::Set>& sets) {
    std::string name = title_of_card();
    DynaCard card = this->card();
    sets.push_back({card.tag("SID"), std::move(name), {}, {}});
    return sets.back();
  }
  void listed(RawMesh::Set& set, FileNumber scope, bool ranges) {
    std::string_view line;
    while (next_full_line(line)) {
      DynaCard card(line, source_);
      for (int i = 0; i < (ranges ? 4 : 8); ++i) {
        const FileNumber first = card.tag("a number of the set"),
                         last = ranges ? card.tag("a number of the set") : first;
        if (first != 0 && first <= last) set.ranges.push_back({scope + first, scope + last, 1, source_.line()});
      }
    }
  }
  void node_set() { listed(begin_set(raw_.node_sets), 0, false); }
  void node_ranges() { listed(begin_set(raw_.node_sets), 0, true); }
  void solid_set() { listed(begin_set(raw_.element_sets), 0, false); }
  void solid_ranges() { listed(begin_set(raw_.element_sets), 0, true); }
  void shell_set() { listed(begin_set(raw_.element_sets), shells, false); }
  void shell_ranges() { listed(begin_set(raw_.element_sets), shells, true); }
  void part_set() { listed(begin_set(raw_part_sets_), 0, false); }

  void solid_section() {
    std::string_view line;
    while (next_full_line(line)) {
      if (titled_ && !next_line(line)) return;
      DynaCard card(line, source_);
      const FileNumber number = card.tag("SECID");
      deck_.sections.push_back({.number = number, .element_form = card.integer("ELFORM", 1), .corner_thickness = {}});
    }
  }
  void shell_section() {
    std::string_view line;
    while (next_full_line(line)) {
      if (titled_ && !next_line(line)) return;
      DynaCard card(line, source_);
      SectionCard section{
          .number = card.tag("SECID"), .element_form = card.integer("ELFORM", 2), .corner_thickness = {}};
      section.shear_factor = card.number("SHRF", 1);
      section.points = card.integer("NIP", 2);
      card.pass(1);
      ignore(card.number("QR/IRID"), "QR/IRID");
      const bool angles = card.integer("ICOMP") == 1;
      DynaCard thicknesses = this->card();
      for (double& t : section.corner_thickness) t = thicknesses.number("T1 to T4");
      section.thickness = section.corner_thickness[0];
      for (double& t : section.corner_thickness)
        if (t == 0) t = section.thickness;
      section.reference = thicknesses.number("NLOC");
      if (angles) {
        ignore(1, "The angle of each layer");
        for (FileNumber left = section.points; left > 0 && next_line(line); left -= 8) {
        }
      }
      deck_.sections.push_back(section);
    }
  }
  void hourglass() {
    std::string_view line;
    while (next_full_line(line)) {
      if (titled_ && !next_line(line)) return;
      DynaCard card(line, source_);
      HourglassCard control{.number = card.tag("HGID"), .type = card.integer("IHQ", 1)};
      control.coefficient = card.number("QM", 0.1);
      card.pass(1);
      control.quadratic = card.number("Q1", 1.5);
      control.linear = card.number("Q2", 0.06);
      control.bending = card.number("QB", control.coefficient);
      control.warping = card.number("QW", control.coefficient);
      deck_.hourglass_controls.push_back(control);
    }
  }

  void add(FileNumber number, std::string title, decltype(MaterialCard::material) material, double cutoff = 0) {
    MaterialCard card{number, name_, std::move(title), material, {}};
    if (cutoff != 0) card.pressure_cutoff = -std::abs(cutoff);
    deck_.materials.push_back(std::move(card));
  }
  double poissons_ratio(DynaCard& card) const {
    const double ratio = card.number("PR");
    if (!(ratio > -1) || !(ratio < 0.5)) source_.refuse({"PR is not between -1 and 0.5: correct it."});
    return ratio;
  }
  static std::optional<FailureStrain> failure_at(double strain) {
    return strain > 0 && strain < 1e6 ? std::optional(FailureStrain{strain}) : std::nullopt;
  }
  /// From Young's modulus and the tangent ETAN, and Cowper and Symonds' D and p.
  PlasticMaterial plastic(const Elastic& m, double yield, double tangent, double D, double p) const {
    if (!(tangent < m.youngs_modulus)) source_.refuse({"ETAN is not below E: correct the tangent modulus."});
    const double hardening = m.youngs_modulus * tangent / (m.youngs_modulus - tangent);
    RateVonMises strength{m.shear_modulus(), yield, hardening};
    if (D > 0 && p > 0) strength.rate_factor = std::pow(D, -1 / p), strength.rate_exponent = 1 / p;
    return {{m.reference_density, m.bulk_modulus()}, strength};
  }

  void elastic() {
    std::string title = title_of_card();
    DynaCard card = this->card();
    const FileNumber number = card.tag("MID");
    const double density = card.positive("RO"), E = card.positive("E");
    const Elastic material{density, E, poissons_ratio(card)};
    ignore_rest(card);
    add(number, std::move(title), material);
  }
  void plastic_kinematic() {
    std::string title = title_of_card();
    DynaCard card = this->card();
    const FileNumber number = card.tag("MID");
    const double density = card.positive("RO"), E = card.positive("E");
    const Elastic m{density, E, poissons_ratio(card)};
    const double yield = card.number("SIGY"), tangent = card.number("ETAN"), beta = card.number("BETA");
    if (tangent != 0) ignore(1 - beta, "BETA (hardening is isotropic here)");
    DynaCard rate = this->card();
    const double D = rate.number("SRC"), p = rate.number("SRP");
    PlasticMaterial material = plastic(m, yield, tangent, D, p);
    material.failure = failure_at(rate.number("FS"));
    ignore_rest(card, rate);
    add(number, std::move(title), material);
  }
  void piecewise_plastic() {
    std::string title = title_of_card();
    DynaCard card = this->card();
    const FileNumber number = card.tag("MID");
    const double density = card.positive("RO"), E = card.positive("E");
    const Elastic m{density, E, poissons_ratio(card)};
    const double yield = card.number("SIGY"), tangent = card.number("ETAN"), fails = card.number("FAIL");
    DynaCard rate = this->card();
    const double D = rate.number("C"), p = rate.number("P");
    PlasticMaterial material = plastic(m, yield, tangent, D, p);
    material.failure = failure_at(fails);
    ignore(rate.number("LCSS"), "LCSS (SIGY and ETAN are taken)");
    ignore(rate.number("LCSR"), "LCSR");
    ignore_rest(card, rate);
    table("EPS and ES (SIGY and ETAN are taken)", 2);
    add(number, std::move(title), material);
  }
  /// Cards of eight strains or stresses, which have no counterpart.
  void table(std::string_view what, int cards) {
    for (; cards > 0; --cards) {
      DynaCard card = this->card();
      double sum = 0;
      for (int i = 0; i < 8; ++i) sum += std::abs(card.number("a point of the table"));
      ignore(sum, what);
    }
  }
  void plastic_hydro() {
    std::string title = title_of_card();
    DynaCard card = this->card();
    const FileNumber number = card.tag("MID");
    const double density = card.positive("RO"), G = card.positive("G");
    const double yield = card.number("SIGY"), hardening = card.number("EH"), cutoff = card.number("PC");
    const HydroMaterial material{density, {G, yield, hardening}, failure_at(card.number("FS"))};
    ignore_rest(card);
    table("EPS and ES (SIGY and EH are taken)", 4);
    add(number, std::move(title), material, cutoff);
  }
  void johnson_cook() {
    std::string title = title_of_card();
    DynaCard card = this->card();
    const FileNumber number = card.tag("MID");
    const double density = card.positive("RO");
    double G = card.number("G");
    const double E = card.number("E");
    const double ratio = poissons_ratio(card);
    if (G == 0) G = E / (2 * (1 + ratio));
    if (!(G > 0)) source_.refuse({"G is not positive: give the material its G, or E and PR."});
    DynaCard law = this->card(), heat = this->card(), last = this->card();
    JohnsonCookMaterial material{density, {.shear_modulus = G, .A = 0, .B = 0, .n = 0}, {}};
    JohnsonCook& s = material.strength;
    s.A = law.number("A"), s.B = law.number("B"), s.n = law.number("N"), s.C = law.number("C"), s.m = law.number("M");
    const double melting = law.number("TM");
    s.initial_temperature = law.number("TR");
    s.melting_temperature = melting > s.initial_temperature ? melting : 1e30;
    s.reference_rate = law.number("EPS0", 1);
    const double capacity = heat.number("CP");
    s.heating = capacity > 0 ? 1 / (density * capacity) : 0;
    const double cutoff = heat.number("PC");
    ignore(heat.number("SPALL"), "SPALL");
    heat.pass(1);
    for (std::size_t i = 0; i < 4; ++i) material.damage[i] = heat.number("D1 to D4");
    material.damage[4] = last.number("D5");
    ignore_rest(card, law, last);
    add(number, std::move(title), material, cutoff);
  }
  void null() {
    std::string title = title_of_card();
    DynaCard card = this->card();
    const FileNumber number = card.tag("MID");
    const double density = card.positive("RO"), cutoff = card.number("PC");
    const NullMaterial material{density, card.number("MU")};
    ignore(card.number("TEROD"), "TEROD");
    ignore(card.number("CEROD"), "CEROD");
    add(number, std::move(title), material, cutoff);
  }

  void linear_polynomial() {
    title_of_card();
    DynaCard card = this->card();
    const FileNumber number = card.tag("EOSID");
    PolynomialEos eos{.density = 0};
    for (double* C : {&eos.C0, &eos.C1, &eos.C2, &eos.C3, &eos.C4, &eos.C5, &eos.C6}) *C = card.number("C0 to C6");
    DynaCard start = this->card();
    eos.initial_energy = start.number("E0");
    if (const double V0 = start.number("V0"); V0 != 0) ignore(V0 - 1, "V0");
    ignore_rest(card, start);
    deck_.equations_of_state.push_back({number, name_, eos});
  }
  void gruneisen() {
    title_of_card();
    DynaCard card = this->card();
    const FileNumber number = card.tag("EOSID");
    GruneisenEos eos{.density = 0, .sound_speed = card.positive("C"), .S1 = card.number("S1"), .gamma = 0};
    eos.S2 = card.number("S2"), eos.S3 = card.number("S3"), eos.gamma = card.number("GAMAO"), eos.a = card.number("A");
    eos.initial_energy = card.number("E0");
    if (const double V0 = this->card().number("V0"); V0 != 0) ignore(V0 - 1, "V0");
    deck_.equations_of_state.push_back({number, name_, eos});
  }

  /// Nodes that a card names, found when all are read.
  enum class Kind { all, node, set, part, part_set };
  struct Chosen {
    Kind kind;
    FileNumber number;
    std::uint32_t line;
  };
  using Choice = std::vector<Chosen>;

  /// The nodes of their own that are fixed so.
  Choice& choice_of(const Fixed& fixed) {
    const auto known =
        std::find_if(fixed_nodes_.begin(), fixed_nodes_.end(), [&](const auto& nodes) { return nodes.first == fixed; });
    return known != fixed_nodes_.end() ? known->second : fixed_nodes_.emplace_back(fixed, Choice{}).second;
  }
  void supports(Kind kind) {
    std::string_view line;
    while (next_full_line(line)) {
      if (titled_ && !next_line(line)) return;
      DynaCard card(line, source_);
      const Chosen chosen{kind, defined(card.tag(kind == Kind::node ? "NID" : "NSID"), "support"), source_.line()};
      ignore(card.number("CID"), "CID");
      Fixed fixed;
      for (bool& held : fixed.first) held = card.integer("DOFX to DOFZ") != 0;
      for (bool& held : fixed.second) held = card.integer("DOFRX to DOFRZ") != 0;
      if (kind == Kind::node)
        choice_of(fixed).push_back(chosen);
      else
        supports_.push_back({fixed, {chosen}});
    }
  }
  void node_support() { supports(Kind::node); }
  void set_support() { supports(Kind::set); }

  void velocity() {
    DynaCard card = this->card(), values = this->card();
    const FileNumber set = card.tag("NSID");
    for (const char* what : {"NSIDEX", "BOXID", "IRIGID", "ICID"}) ignore(card.number(what), what);
    VelocityCard velocity{{}, values.vector("VX to VZ")};
    ignore(values.vector("VXR to VZR").norm(), "VXR to VZR");
    velocities_.push_back({velocity, {{set == 0 ? Kind::all : Kind::set, set, source_.line()}}});
  }
  void node_velocity() {
    std::string_view line;
    while (next_full_line(line)) {
      DynaCard card(line, source_);
      const Chosen chosen{Kind::node, defined(card.tag("NID"), "velocity"), source_.line()};
      const VelocityCard velocity{{}, card.vector("VX to VZ")};
      ignore(card.vector("VXR to VZR").norm(), "VXR to VZR");
      ignore(card.number("ICID"), "ICID");
      if (velocities_.empty() || velocities_.back().first.velocity != velocity.velocity ||
          velocities_.back().second.front().kind != Kind::node)
        velocities_.push_back({velocity, {}});
      velocities_.back().second.push_back(chosen);
    }
  }
  void generated_velocity() {
    std::string_view line;
    while (next_full_line(line)) {
      DynaCard card(line, source_);
      const std::uint32_t at = source_.line();
      const FileNumber number = card.tag("ID"), kind = card.integer("STYP");
      const double omega = card.number("OMEGA");
      VelocityCard velocity{{}, card.vector("VX to VZ")};
      DynaCard turn = this->card();
      velocity.centre = turn.vector("XC to ZC");
      const Eigen::Vector3d axis = turn.vector("NX to NZ");
      if (omega != 0 && axis[0] == -999)
        ignore(1, "OMEGA about an axis between nodes");
      else if (omega != 0) {
        if (!(axis.norm() > 0)) source_.refuse({"the axis of a spin has no direction: give NX, NY and NZ."});
        velocity.spin = omega / axis.norm() * axis;
      }
      ignore(turn.number("PHASE"), "PHASE");
      ignore_rest(card, turn);
      if (number != 0 && (kind < 1 || kind > 3))
        source_.refuse({"STYP ", std::to_string(kind), " is none: give 1 (part set), 2 (part) or 3 (node set)."});
      constexpr std::array<Kind, 4> kinds{Kind::all, Kind::part_set, Kind::part, Kind::set};
      velocities_.push_back({velocity, {{number == 0 ? Kind::all : kinds[std::size_t(kind)], number, at}}});
    }
  }

  void wall() {
    title_of_card();
    DynaCard card = this->card();
    const FileNumber set = card.tag("NSID");
    const std::uint32_t at = source_.line();
    for (const char* what : {"NSIDEX", "BOXID", "OFFSET", "BIRTH"}) ignore(card.number(what), what);
    const double death = card.number("DEATH");
    ignore(death < 1e20 ? death : 0, "DEATH");
    DynaCard plane = this->card();
    WallCard wall{plane.vector("XT to ZT"), {}, {}, 0};
    wall.normal = plane.vector("XH to ZH") - wall.point;
    if (!(wall.normal.norm() > 0))
      source_.refuse({"the normal of the wall has no length: give it a head that is not its tail."});
    wall.normal.normalize();
    wall.friction = plane.number("FRIC");
    ignore_rest(card, plane);
    walls_.push_back({wall, {{set == 0 ? Kind::all : Kind::set, set, at}}});
  }

  struct Side {
    FileNumber number, kind;
    std::uint32_t line;
  };
  void contact() {
    if (titled_) heading();
    DynaCard card = this->card();
    const std::uint32_t at = source_.line();
    const FileNumber slave = card.tag("SSID"), master = card.tag("MSID");
    const FileNumber slave_kind = card.integer("SSTYP"), master_kind = card.integer("MSTYP");
    ignore(card.number("SBOXID"), "SBOXID");
    ignore(card.number("MBOXID"), "MBOXID");
    DynaCard friction = this->card();
    ContactCard contact{base_.substr(std::string_view("*CONTACT_AUTOMATIC_").size()), {}, {}};
    contact.static_friction = friction.number("FS");
    contact.dynamic_friction = friction.number("FD");
    contact.decay = friction.number("DC");
    for (const char* what : {"VC", "VDC", "PENCHK", "BT"}) ignore(friction.number(what), what);
    const double death = friction.number("DT");
    ignore(death < 1e20 ? death : 0, "DT");
    DynaCard scales = this->card();
    for (const char* what : {"SFS", "SFM", "SST", "MST", "SFST", "SFMT", "FSF", "VSF"}) {
      const double value = scales.number(what);
      ignore(value == 1 ? 0 : value, what);
    }
    const std::array<Side, 2> sides{{{slave, slave_kind, at}, {master, master_kind, at}}};
    contacts_.emplace_back(std::move(contact), sides);
  }

  void termination() {
    DynaCard card = this->card();
    deck_.end_time = card.number("ENDTIM");
    ignore(card.number("ENDCYC"), "ENDCYC");
    ignore(card.number("DTMIN"), "DTMIN");
  }
  void time_step() {
    DynaCard card = this->card();
    ignore(card.number("DTINIT"), "DTINIT");
    deck_.step_factor = card.number("TSSFAC", 0.9);
    card.pass(2);
    ignore(card.number("DT2MS"), "DT2MS");
  }
  void bulk_viscosity() {
    DynaCard card = this->card();
    const double quadratic = card.number("Q1", 1.5);
    deck_.bulk_viscosity = {quadratic, card.number("Q2", 0.06)};
  }

  void resolve(const Finished& done) {
    std::map<FileNumber, std::size_t> node_sets, part_sets;
    for (std::size_t i = 0; i < deck_.node_sets.size(); ++i) node_sets.try_emplace(deck_.node_sets[i].number, i);
    for (RawMesh::Set& set : raw_part_sets_) {
      NamedSet named{set.number, std::move(set.name), {}};
      for (const RawMesh::Range& range : set.ranges) {
        const auto part = parts_.find(range.first);
        if (part == parts_.end())
          source_.refuse(range.line,
                         {"part ", std::to_string(range.first), " is not in the file: take it off the set."});
        named.members.push_back(part->second);
      }
      part_sets.try_emplace(set.number, deck_.part_sets.size());
      deck_.part_sets.push_back(std::move(named));
    }
    const auto missing = [&](const Chosen& chosen, const char* kind) {
      source_.refuse(chosen.line,
                     {kind, " ", std::to_string(chosen.number), " is not in the file: define it or correct the card."});
    };
    const auto parts_of = [&](const Chosen& chosen) -> std::vector<Index> {
      if (chosen.kind == Kind::part) {
        const auto part = parts_.find(chosen.number);
        if (part == parts_.end()) missing(chosen, "part");
        return {part->second};
      }
      const auto set = part_sets.find(chosen.number);
      if (set == part_sets.end()) missing(chosen, "the set of parts");
      return deck_.part_sets[set->second].members;
    };
    const auto nodes_of = [&](const Choice& choice) {
      std::vector<Index> nodes;
      for (const Chosen& chosen : choice) {
        if (chosen.kind == Kind::all) {
          nodes = all_nodes(deck_.mesh.nodes);
        } else if (chosen.kind == Kind::node) {
          if (const Index node = done.node(chosen.number, source_, chosen.line); node != nothing) nodes.push_back(node);
        } else if (chosen.kind == Kind::set) {
          const auto set = node_sets.find(chosen.number);
          if (set == node_sets.end()) missing(chosen, "the set of nodes");
          const auto& members = deck_.node_sets[set->second].members;
          nodes.insert(nodes.end(), members.begin(), members.end());
        } else {
          for (const Index part : parts_of(chosen)) {
            const std::vector<Index> own = deck_.cells(deck_.parts[part].members).nodes();
            nodes.insert(nodes.end(), own.begin(), own.end());
          }
        }
      }
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      return nodes;
    };
    for (const auto& [fixed, choice] : fixed_nodes_)
      deck_.supports.push_back({nodes_of(choice), fixed.first, fixed.second});
    for (const auto& [fixed, choice] : supports_)
      deck_.supports.push_back({nodes_of(choice), fixed.first, fixed.second});
    for (auto& [velocity, choice] : velocities_) {
      velocity.nodes = nodes_of(choice);
      deck_.velocities.push_back(std::move(velocity));
    }
    for (auto& [wall, choice] : walls_) {
      wall.nodes = nodes_of(choice);
      deck_.walls.push_back(std::move(wall));
    }
    for (auto& [contact, sides] : contacts_) {
      for (std::size_t i = 0; i < 2; ++i) {
        ContactSide& side = i == 0 ? contact.slave : contact.master;
        const auto& [number, kind, line] = sides[i];
        if (number == 0 || kind == 5) continue;
        if (kind == 2 || kind == 3) {
          for (const Index part : parts_of({kind == 2 ? Kind::part_set : Kind::part, number, line}))
            side.parts.push_back(deck_.parts[part].number);
        } else if (kind == 4) {
          side.nodes = nodes_of({{Kind::set, number, line}});
        } else {
          values_.add(
              joined({i == 0 ? "SSTYP " : "MSTYP ", std::to_string(kind), " of a contact (all parts are taken)"}),
              line);
        }
      }
      deck_.contacts.push_back(std::move(contact));
    }
  }

  Source source_;
  DynaDeck deck_ = {};
  RawMesh raw_ = {};
  std::string name_ = {}, base_ = {}, title_ = {};
  bool titled_ = false, ended_ = false, known_ = false, known_keyword_ = false;
  std::map<FileNumber, std::uint32_t> parts_ = {};
  std::vector<RawMesh::Set> raw_part_sets_ = {};
  std::vector<std::pair<Fixed, Choice>> fixed_nodes_ = {};  ///< one for each way of being fixed
  std::vector<std::pair<Fixed, Choice>> supports_ = {};
  std::vector<std::pair<VelocityCard, Choice>> velocities_ = {};
  std::vector<std::pair<WallCard, Choice>> walls_ = {};
  std::vector<std::pair<ContactCard, std::array<Side, 2>>> contacts_ = {};
  Skipped skipped_ = {}, values_ = {};
};

}  // namespace detail

/// The mesh and the cards of an LS-DYNA keyword file (.k, .key, .dyn) in the standard format, of fixed columns or with
/// commas. Which keywords are read says docs/read_a_mesh.md; others are skipped with a notice, and so are values that
/// have no counterpart here. `name` stands in messages. Errors: `*INCLUDE`; the long formats; elements of higher order,
/// wedges; a number that is none, or is there twice; a node, set or part that is not there; a material without a
/// density or a modulus.
inline DynaDeck read_dyna(std::string_view text, std::string name) {
  return detail::DynaReader(detail::Source(text, std::move(name))).read();
}
inline DynaDeck read_dyna(const std::string& path) { return read_dyna(detail::content_of_file(path), path); }

}  // namespace strike
