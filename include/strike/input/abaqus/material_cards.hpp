#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/input/abaqus/file.hpp>
#include <strike/input/abaqus_cards.hpp>

namespace strike::detail::abaqus {

/// *MATERIAL and the keywords after it (Abaqus Analysis User's Guide, "Material data definition").
class MaterialCards {
 public:
  explicit MaterialCards(File& file) : file_(file) {}

  /// True if the keyword belongs to a material. Keywords that a material cannot go without make it unread.
  bool read(Skipped& skipped) {
    const std::string& word = file_.word();
    if (word == "*MATERIAL") {
      drafts_.push_back({.name = file_.required("NAME"), .line = file_.keyword_line()});
      if (!names_.insert(label(drafts_.back().name)).second)
        file_.refuse({"material ", shown(drafts_.back().name), " is there twice: give each a name of its own."});
      is_open_ = true;
      return true;
    }
    if (!is_open_) return false;
    const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
      return std::find(names.begin(), names.end(), word) != names.end();
    };
    Draft& draft = drafts_.back();
    std::string_view line;
    if (word == "*DENSITY")
      draft.density = first_number("the density", {"DEPENDENCIES"});
    else if (word == "*ELASTIC")
      elastic(draft);
    else if (word == "*PLASTIC")
      plastic(draft);
    else if (word == "*RATEDEPENDENT")
      rate(draft);
    else if (word == "*EOS")
      eos(draft);
    else if (word == "*VISCOSITY")
      draft.viscosity = first_number("the viscosity", {"DEPENDENCIES", "DEFINITION"});
    else if (word == "*SPECIFICHEAT")
      draft.specific_heat = first_number("the specific heat", {"DEPENDENCIES"});
    else if (word == "*INELASTICHEATFRACTION")
      draft.heat_fraction = file_.data(line) ? file_.number_or(field(line), 0.9, "the fraction") : 0.9;
    else if (is_one_of({"*HYPERELASTIC",
                        "*HYPERFOAM",
                        "*LOWDENSITYFOAM",
                        "*VISCOELASTIC",
                        "*USERMATERIAL",
                        "*CRUSHABLEFOAM",
                        "*DRUCKERPRAGER",
                        "*CONCRETE",
                        "*BRITTLECRACKING",
                        "*POTENTIAL",
                        "*CREEP",
                        "*CONCRETEDAMAGEDPLASTICITY",
                        "*FABRIC",
                        "*CAPPLASTICITY",
                        "*MOHRCOULOMB",
                        "*HYPOELASTIC",
                        "*POROUSMETALPLASTICITY",
                        "*MULLINSEFFECT",
                        "*EOSCOMPACTION",
                        "*NOTENSION",
                        "*SUPERELASTIC",
                        "*ACOUSTICMEDIUM",
                        "*CASTIRONPLASTICITY",
                        "*CYCLICHARDENING",
                        "*ANNEALTEMPERATURE"}))
      leave(draft, "");
    else if (is_one_of({"*DAMAGEINITIATION", "*DAMAGEEVOLUTION", "*DAMAGESTABILIZATION", "*SHEARFAILURE",
                        "*TENSILEFAILURE", "*DAMPING", "*EXPANSION", "*CONDUCTIVITY", "*DEPVAR", "*FAILSTRESS",
                        "*FAILSTRAIN", "*USEROUTPUTVARIABLES", "*DETONATIONPOINT", "*LATENTHEAT", "*POROUSELASTIC"}))
      skipped.add(file_.name().substr(0, 60), file_.keyword_line());
    else
      return is_open_ = false;
    return true;
  }

  /// The materials, and a warning for each that was not read.
  void resolve(AbaqusDeck& deck, bool is_adiabatic) const {
    for (const Draft& draft : drafts_) {
      std::string why = draft.unread;
      std::optional<NamedMaterial> material;
      try {
        if (why.empty()) material = made(draft, is_adiabatic, why);
      } catch (const Error& error) {
        why = error.what();
        if (why.ends_with('.')) why.pop_back();
      }
      if (material)
        deck.materials.push_back(*std::move(material));
      else
        deck.warnings.push_back(joined({"Material ", shown(draft.name), " on line ", file_.source().place(draft.line),
                                        " was not read: ", why, "."}));
    }
  }

 private:
  struct Draft {
    std::string name;
    std::uint32_t line = 0;
    std::string unread = {};  ///< the reason why it has no counterpart
    double density = 0, E = 0, ratio = 0, G = 0;
    std::vector<TabulatedHardening::Point> table = {};
    std::optional<JohnsonCook> johnson_cook = {};
    std::optional<RateConstants> rate = {};
    std::optional<GruneisenEos> gruneisen = {};
    std::optional<Jwl> jwl = {};
    double detonation_speed = 0, viscosity = 0, specific_heat = 0, heat_fraction = 0.9;
  };

  void leave(Draft& draft, std::string_view value) const {
    if (draft.unread.empty())
      draft.unread = joined({file_.name().substr(0, 40), value.empty() ? "" : " with ", value.substr(0, 40),
                             " on line ", file_.source().place(file_.keyword_line()), " has no counterpart"});
  }
  /// The first number of the first line. Error: further lines make it depend on something.
  double first_number(std::string_view meaning, std::initializer_list<std::string_view> unread) {
    for (const std::string_view key : unread)
      if (file_.find(key)) leave(drafts_.back(), key);
    std::string_view line;
    double value = 0;
    if (file_.data(line)) value = file_.number(field(line), meaning);
    if (file_.data(line)) leave(drafts_.back(), "several lines");
    return value;
  }
  void elastic(Draft& draft) {
    const std::string type = file_.label_of("TYPE");
    if (!(type.empty() || type.starts_with("ISO") || type == "SHEAR")) return leave(draft, "TYPE=" + type);
    std::string_view line;
    if (!file_.data(line)) file_.refuse({"*ELASTIC has no data: give the modulus on the line after it."});
    if (type == "SHEAR") {
      draft.G = file_.number(field(line), "the shear modulus");
    } else {
      draft.E = file_.number(field(line), "Young's modulus");
      draft.ratio = file_.number_or(field(line), 0, "Poisson's ratio");
      if (!(draft.E > 0)) file_.refuse({"Young's modulus is not positive: correct it."});
      if (!(draft.ratio > -1) || !(draft.ratio < 0.5))
        file_.refuse({"Poisson's ratio is not between -1 and 0.5: correct it."});
      draft.G = draft.E / (2 * (1 + draft.ratio));
    }
    if (!(draft.G > 0)) file_.refuse({"the shear modulus is not positive: correct it."});
    if (file_.data(line)) leave(draft, "several lines");
  }
  void plastic(Draft& draft) {
    const std::string hardening = file_.label_of("HARDENING");
    for (const char* key : {"RATE", "DEPENDENCIES", "DATATYPE", "EXTRAPOLATION"})
      if (file_.find(key)) return leave(draft, key);
    std::string_view line;
    if (hardening == "JOHNSONCOOK") {
      if (!file_.data(line)) file_.refuse({"*PLASTIC has no data: give A, B, n, m and the temperatures after it."});
      JohnsonCook law{.shear_modulus = 1, .A = 0, .B = 0, .n = 0};
      for (double* value : {&law.A, &law.B, &law.n, &law.m}) *value = file_.number_or(field(line), 0, "a constant");
      const double melting = file_.number_or(field(line), 0, "the melting temperature");
      law.initial_temperature = file_.number_or(field(line), 0, "the transition temperature");
      law.melting_temperature = melting > law.initial_temperature ? melting : 1e30;
      draft.johnson_cook = law;
      return;
    }
    if (!hardening.empty() && !hardening.starts_with("ISO")) return leave(draft, "HARDENING=" + hardening);
    std::optional<double> temperature;
    while (file_.data(line)) {
      const double stress = file_.number(field(line), "the yield stress");
      const double strain = file_.number_or(field(line), 0, "the plastic strain");
      const double now = file_.number_or(field(line), 0, "the temperature");
      if (temperature && *temperature != now) return leave(draft, "several temperatures");
      temperature = now;
      draft.table.push_back({strain, stress});
    }
    if (draft.table.empty()) file_.refuse({"*PLASTIC has no data: give a yield stress on the line after it."});
  }
  void rate(Draft& draft) {
    const std::string type = file_.label_of("TYPE");
    std::string_view line;
    if (type == "JOHNSONCOOK" && draft.johnson_cook) {
      if (!file_.data(line)) file_.refuse({"*RATE DEPENDENT has no data: give C and the rate after it."});
      draft.johnson_cook->C = file_.number(field(line), "C");
      draft.johnson_cook->reference_rate = file_.number_or(field(line), 1, "the reference rate");
    } else if (type.empty() || type == "POWERLAW") {
      if (!file_.data(line)) file_.refuse({"*RATE DEPENDENT has no data: give D and n after it."});
      const double D = file_.number(field(line), "D"), n = file_.number(field(line), "n");
      if (!(D > 0) || !(n > 0)) file_.refuse({"D and n of *RATE DEPENDENT are not both positive: correct them."});
      draft.rate = RateConstants{D, n};
      if (file_.data(line)) leave(draft, "several lines");
    } else {
      leave(draft, "TYPE=" + type);
    }
  }
  void eos(Draft& draft) {
    const std::string type = file_.label_of("TYPE");
    std::string_view line;
    if (type != "USUP" && type != "JWL") return leave(draft, "TYPE=" + type);
    if (!file_.data(line)) file_.refuse({"*EOS has no data: give its constants on the line after it."});
    const auto next = [&] { return file_.number_or(field(line), 0, "a constant of *EOS"); };
    if (type == "USUP") {
      GruneisenEos e{.density = 0, .sound_speed = next(), .S1 = next(), .gamma = 0};
      e.gamma = next();
      draft.gruneisen = e;
    } else {
      draft.detonation_speed = next();
      Jwl e{};
      e.A_products = next(), e.B_products = next(), e.omega = next(), e.R1 = next(), e.R2 = next();
      e.initial_energy = next();  // per mass, until the density is known
      draft.jwl = e;
    }
  }

  std::optional<NamedMaterial> made(const Draft& draft, bool is_adiabatic, std::string& why) const {
    const auto no = [&](const char* reason) {
      why = reason;
      return std::nullopt;
    };
    if (!(draft.density > 0)) return no("it has no *DENSITY");
    NamedMaterial result{draft.name, Elastic{draft.density, 1, 0}, LinearEos{draft.density, 0}, draft.detonation_speed};
    const bool has_volume = draft.gruneisen || draft.jwl;
    if (draft.gruneisen) {
      GruneisenEos eos = *draft.gruneisen;
      eos.density = draft.density;
      result.eos = eos;
    } else if (draft.jwl) {
      Jwl eos = *draft.jwl;
      eos.density = draft.density, eos.initial_energy *= draft.density;
      result.eos = eos;
    } else if (draft.E > 0) {
      result.eos = LinearEos{draft.density, Elastic{draft.density, draft.E, draft.ratio}.bulk_modulus()};
    } else {
      return no("it has neither *ELASTIC nor *EOS");
    }
    const LinearEos* const linear = std::get_if<LinearEos>(&result.eos);
    if (draft.johnson_cook) {
      JohnsonCookMaterial material{draft.density, *draft.johnson_cook, {}};
      if (!(draft.G > 0)) return no("*PLASTIC has no *ELASTIC");
      if (draft.rate) return no("*RATE DEPENDENT of Johnson and Cook's law is not TYPE=JOHNSON COOK");
      material.strength.shear_modulus = draft.G;
      if (is_adiabatic && draft.specific_heat > 0)
        material.strength.heating = draft.heat_fraction / (draft.density * draft.specific_heat);
      result.material = material;
    } else if (draft.table.empty()) {
      if (has_volume && draft.G > 0) return no("*ELASTIC with *EOS and without *PLASTIC has no counterpart");
      if (has_volume)
        result.material = NullMaterial{draft.density, draft.viscosity};
      else
        result.material = Elastic{draft.density, draft.E, draft.ratio};
    } else if (!(draft.G > 0)) {
      return no("*PLASTIC has no *ELASTIC");
    } else if (draft.table.size() == 1) {
      const double yield = draft.table.front().stress;
      if (linear) {
        PlasticMaterial material{*linear, {draft.G, yield}};
        if (draft.rate)
          material.strength.rate_factor = std::pow(draft.rate->D, -1 / draft.rate->p),
          material.strength.rate_exponent = 1 / draft.rate->p;
        result.material = material;
      } else {
        if (draft.rate) return no("*RATE DEPENDENT with *EOS has no counterpart");
        result.material = HydroMaterial{draft.density, {draft.G, yield}};
      }
    } else {
      if (!linear) return no("a table of *PLASTIC with *EOS has no counterpart");
      result.material = TabulatedMaterial{*linear, TabulatedHardening(draft.G, draft.table), draft.rate};
    }
    return result;
  }

  File& file_;
  std::vector<Draft> drafts_ = {};
  std::set<std::string> names_ = {};
  bool is_open_ = false;
};

}  // namespace strike::detail::abaqus
