#pragma once
#include <optional>
#include <vector>

#include <strike/input/dyna/material_head.hpp>

// Rubber and viscoelastic materials.
namespace strike::detail::dyna {

/// The terms of LS-DYNA, A (I1 - 3) + B (I2 - 3) and two of the volume; here those of the volume are linear.
inline void mooney_rivlin(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const double ratio = poissons_ratio(head.card, file), A = head.card.number("A"), B = head.card.number("B");
  file.ignore(head.card.number("REF"), "REF");
  Card fit = file.card();
  fit.pass(3);
  const FileNumber curve = fit.tag("LCID", Id::curve);
  if (A == 0 && B == 0 && curve == 0) file.refuse({"A and B are 0: give the material its A and B."});
  if (A == 0 && B == 0) return file.ignore(1, "The material (no curve is fitted here)");
  if (!(A >= 0) || !(B >= 0) || !(A + B > 0)) return file.ignore(1, "The material (A or B is negative)");
  const double G = 2 * (A + B);
  add(file, draft, head,
      RubberMaterial{{head.density, 2 * G * (1 + ratio) / (3 * (1 - 2 * ratio))}, {.C10 = A, .C01 = B}});
}
inline void viscoelastic(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const double K = head.card.positive("BULK"), G0 = head.card.positive("G0"), GI = head.card.number("GI");
  const double decay = head.card.number("BETA");
  if (!(GI >= 0 && GI <= G0)) file.refuse({"GI is not between 0 and G0: correct it."});
  if (!(decay >= 0)) return file.ignore(1, "The material (BETA is a curve)");
  const double share = decay > 0 ? (G0 - GI) / G0 : 0;
  add(file, draft, head,
      ViscoelasticMaterial{{head.density, K}, {.shear_modulus = G0, .terms = {{share, decay > 0 ? 1 / decay : 1}}}});
}
/// G(t) is the sum of GI exp(-BETAI t); the bulk modulus is that of BULK, or the sum of all KI.
inline void general_viscoelastic(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  double K = head.card.number("BULK");
  for (const char* name : {"PCF", "EF", "TREF", "A", "B"}) file.ignore(head.card.number(name), name);
  Card fit = file.card();
  const FileNumber curve = fit.tag("LCID", Id::curve);
  fit.pass(3);
  const FileNumber bulk_curve = fit.tag("LCIDK", Id::curve);
  double G = 0, sum_of_K = 0;
  std::vector<Prony<1>::Term> terms;
  file.for_each_card([&](Card card) {
    const double GI = card.number("GI"), decay = card.number("BETAI");
    const double KI = card.number("KI"), bulk_decay = card.number("BETAKI");
    if (!(GI >= 0) || !(decay >= 0) || !(KI >= 0))
      file.refuse({"a term of relaxation is negative: give GI, BETAI and KI from 0 on."});
    G += GI, sum_of_K += KI;
    if (GI > 0 && decay > 0) terms.push_back({GI, 1 / decay});
    if (KI > 0 && bulk_decay != 0) file.ignore(bulk_decay, "BETAKI");
  });
  if (!(G > 0) && curve == 0) file.refuse({"GI are all 0: give the material its terms."});
  if (!(G > 0)) return file.ignore(1, "The material (no curve is fitted here)");
  if (curve != 0) file.ignore(1, "LCID");
  if (bulk_curve != 0) file.ignore(1, "LCIDK");
  if (sum_of_K > 0) K = sum_of_K;
  if (!(K > 0)) file.refuse({"BULK is not positive: give the material its BULK."});
  for (auto& term : terms) term.share /= G;
  add(file, draft, head, PronyMaterial{{head.density, K}, G, std::move(terms)});
}

}  // namespace strike::detail::dyna
