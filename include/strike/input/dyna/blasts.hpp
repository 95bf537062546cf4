#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/forces.hpp>
#include <strike/input/dyna/lookup.hpp>
#include <strike/input/dyna/sets.hpp>

// Charges of TNT in air, and the faces that they load.
namespace strike::detail::dyna {

inline constexpr double pound = 0.45359237, foot = 0.3048, inch = 0.0254;  // kg and m, exactly
inline constexpr double pound_per_square_inch = pound * 9.80665 / (inch * inch);
inline constexpr double slug = pound * 9.80665 / foot;
/// Kilograms, metres, seconds and pascals of UNIT 1 to 8 (LS-DYNA Keyword User's Manual R13, volume I,
/// *LOAD_BLAST_ENHANCED); 5 are given by the card.
inline constexpr std::array<std::array<double, 4>, 8> blast_units{{{pound, foot, 1, pound_per_square_inch},
                                                                   {1, 1, 1, 1},
                                                                   {12 * slug, inch, 1, pound_per_square_inch},
                                                                   {1e-3, 1e-2, 1e-6, 1e11},
                                                                   {0, 0, 0, 0},
                                                                   {1, 1e-3, 1e-3, 1e9},
                                                                   {1e3, 1e-3, 1, 1e6},
                                                                   {1e-3, 1e-3, 1e-3, 1e6}}};

/// *LOAD_BLAST_ENHANCED, and *LOAD_BLAST, which has no number and no node.
inline void blasts(File& file, Draft& draft) {
  const bool enhanced = file.base() == "*LOAD_BLAST_ENHANCED";
  file.for_each_titled_card([&](Card card) {
    PendingBlast pending{{}, 0, file.line()};
    BlastCard& blast = pending.card;
    if (enhanced) {
      blast.number = draft.own_number("blast", Id::other, card, file);
    } else if (!draft.blasts.empty() && draft.blasts.back().card.number == 0) {
      file.refuse({"*LOAD_BLAST is there twice: take one out, or give *LOAD_BLAST_ENHANCED."});
    }
    blast.mass = card.number(enhanced ? "M" : "WGT");
    if (!(blast.mass > 0)) file.refuse({"the mass of a charge is not positive: give its mass in TNT."});
    blast.centre = card.vector("XBO to ZBO");
    blast.start = card.number("TBO");
    blast.unit = card.integer(enhanced ? "UNIT" : "IUNIT", 2);
    const FileNumber kind = card.integer(enhanced ? "BLAST" : "ISURF", 2);
    if (blast.unit < 1 || blast.unit > 8)
      file.refuse({"the units ", std::to_string(blast.unit), " of a blast are none: give 1 to 8."});
    if (kind < 1 || kind > (enhanced ? 4 : 2))
      file.refuse({"the type ", std::to_string(kind), " of a blast is none: give 1 (on the ground) or 2 (in air)."});
    blast.kind = static_cast<BlastCard::Kind>(kind);
    blast.si = blast_units[static_cast<std::size_t>(blast.unit - 1)];
    Card second = file.card();
    std::array<double, 4> factors;
    for (double& factor : factors) factor = second.number("CFM to CFP");
    if (blast.unit == 5) {
      constexpr std::array<double, 4> si{pound, foot, 1e-3, pound_per_square_inch};
      for (std::size_t i = 0; i < 4; ++i) {
        if (!(factors[i] > 0)) file.refuse({"CFM to CFP are not positive: give the factors of the deck's units."});
        blast.si[i] = factors[i] * si[i];
      }
    }
    if (enhanced) pending.node = second.tag("NIDBO", Id::node);
    if (const double death = second.number("DEATH"); death > 0 && early(death) != 0) blast.death = death;
    if (enhanced) blast.without_suction = second.integer("NEGPHS") == 1;
    if (kind > 2) {
      file.pass_card();
      file.ignore(1, kind == 3 ? "BLAST 3 (a moving charge)" : "BLAST 4 (a charge above the ground)");
    }
    draft.blasts.push_back(std::move(pending));
  });
}
inline void tell_ambient(Card& card, File& file) {
  file.ignore(card.number("ALEPID"), "ALEPID");
  file.ignore(card.number("SFNRB"), "SFNRB");
  const double scale = card.number("SCALEP", 1);
  file.ignore(scale == 1 ? 0 : scale, "SCALEP");
}
inline void blast_segments(File& file, Draft& draft) {
  file.for_each_titled_card([&](Card card) {
    const FileNumber blast = card.own_tag("BID", "blast", Id::other);
    draft.blast_faces.push_back({blast, {segment_of(card, file)}, {}, file.line()});
    tell_ambient(card, file);
  });
}
inline void blast_sets(File& file, Draft& draft) {
  file.for_each_titled_card([&](Card card) {
    const FileNumber blast = card.own_tag("BID", "blast", Id::other), set = card.tag("SSID", Id::set);
    if (set == 0) file.refuse({"a blast has no SSID: give it a set of segments."});
    draft.blast_faces.push_back({blast, {}, {{Named::segment_set, set, file.line()}}, file.line()});
    tell_ambient(card, file);
  });
}

/// Charges with their faces, in a deck that is complete but for them. Error: no charge has the number.
inline void resolve_blasts(Draft& draft, const Lookup& lookup, DynaDeck& deck, File& file) {
  std::erase_if(draft.pressures, [&](PendingPressure& pressure) {
    if (pressure.card.history.curve != of_blast) return false;
    draft.blast_faces.push_back({0, std::move(pressure.segments), std::move(pressure.choices), pressure.line});
    return true;
  });
  std::map<FileNumber, std::size_t> places;
  for (PendingBlast& pending : draft.blasts) {
    places.try_emplace(pending.card.number, deck.blasts.size());
    deck.blasts.push_back(std::move(pending.card));
  }
  for (const auto& [number, segments, choices, line] : draft.blast_faces) {
    const auto place = places.find(number);
    if (place == places.end())
      file.source().refuse(
          line, {number == 0 ? "LCID -2 stands for *LOAD_BLAST, which" : "blast ",
                 number == 0 ? "" : std::to_string(number), " is not in the file: define it or correct the card."});
    std::vector<std::array<Index, 4>>& faces = deck.blasts[place->second].segments;
    const auto more = lookup.segments(segments, file);
    faces.insert(faces.end(), more.begin(), more.end());
    for (const Choice& choice : choices) lookup.add_faces(choice, faces);
  }
}

inline constexpr Meaning of_blasts{"`blasts`: charge, units, burst; `AirBlast{b.faces(), b.charge()}`",
                                   "`AirBlast`, as [theory](theory.md) has it", "BLAST 3 and 4"};
inline constexpr Meaning of_blast_faces{"faces of `blasts`", "faces of `AirBlast`", "ALEPID, SFNRB, SCALEP"};
inline constexpr auto blast_keywords = std::to_array<Keyword>({
    {"*LOAD_BLAST", blasts, Invariant::none, &of_blasts},
    {"*LOAD_BLAST_ENHANCED", blasts, Invariant::none, &of_blasts},
    {"*LOAD_BLAST_SEGMENT", blast_segments, Invariant::everywhere, &of_blast_faces},
    {"*LOAD_BLAST_SEGMENT_SET", blast_sets, Invariant::everywhere, &of_blast_faces},
});

}  // namespace strike::detail::dyna
