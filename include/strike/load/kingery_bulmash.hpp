#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <strike/cxx20.hpp>

namespace strike {

/// Where a charge detonates: `free_air`, a sphere far from any wall, or `surface`, a hemisphere on rigid ground.
enum class Burst { free_air, surface };

/// The blast of a charge at a range, for a wall that stands across its way.
struct BlastWave {
  double arrival, duration;                      ///< since the detonation, and of the positive phase [time]
  double incident_pressure, reflected_pressure;  ///< their peaks above the air's [stress]
  double incident_impulse, reflected_impulse;    ///< of the positive phase [stress time]
  double incident_decay = 0,
         reflected_decay = 0;  ///< a of (1 - s) exp(-a s), s from 0 to 1 over the positive phase [1]
};

namespace detail {

/// log10 of a quantity is a polynomial of U = a + b log10 Z up to a scaled distance.
struct BlastFit {
  double up_to;  ///< [m/kg^(1/3)]
  double a, b;
  std::array<double, 12> c;

  double operator()(double log_Z) const {
    const double U = a + b * log_Z;
    double sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * U + c[i];
    return std::pow(10, sum);
  }
};

/// Kingery and Bulmash 1984 (ARBRL-TR-02555), for 1 kg of TNT at sea level, Z in m/kg^(1/3): pressures in kPa, impulses
/// in kPa ms, times in ms.
struct BlastFits {
  double nearest;  ///< from where all of them hold [m/kg^(1/3)]
  std::array<BlastFit, 1> incident_pressure, reflected_pressure;
  std::array<BlastFit, 2> incident_impulse;
  std::array<BlastFit, 1> reflected_impulse, arrival;
  std::array<BlastFit, 3> duration;
};

inline constexpr double farthest_blast = 40;  // [m/kg^(1/3)]

inline constexpr BlastFits free_air_fits{
    0.147,
    {{{40,
       -0.214362789151,
       1.35034249993,
       {2.611368669, -1.69012801396, 0.00804973591951, 0.336743114941, -0.00516226351334, -0.0809228619888,
        -0.00478507266747, 0.00793030472242, 0.0007684469735}}}},
    {{{40,
       -0.214362789151,
       1.35034249993,
       {3.22958031387, -2.21400538997, 0.035119031446, 0.657599992109, 0.0141818951887, -0.243076636231,
        -0.0158699803158, 0.0492741184234, 0.00227639644004, -0.00397126276058}}}},
    {{{0.792,
       2.34723921354,
       3.24299066475,
       {2.38830516757, -0.443749377691, 0.168825414684, 0.0348138030308, -0.010435192824}},
      {40,
       -1.75305660315,
       2.30629231803,
       {1.55197227115, -0.40463292088, -0.0142721946082, 0.00912366316617, -0.0006750681404, -0.00800863718901,
        0.00314819515931, 0.00152044783382, -0.0007470265899}}}},
    {{{40, -0.204004553231, 1.37882996018, {2.55875660396, -0.903118886091, 0.101771877942, -0.0242139751146}}}},
    {{{40,
       -0.253273111999,
       1.37407043777,
       {0.0720707787637, 1.36456871214, -0.0570035692784, -0.182832224796, 0.0118851436014, 0.0432648687627,
        -0.0007997367834, -0.00436073555033}}}},
    {{{0.888,
       2.26367268496,
       5.11588554305,
       {-0.686608550419, 0.164953518069, 0.127788499497, 0.00291430135946, 0.00187957449227, 0.0173413962543,
        0.00269739758043, -0.00361976502798, -0.00100926577934}},
      {2.28,
       -1.33361206714,
       9.2996288611,
       {0.23031841078, -0.0297944268969, 0.0306329542941, 0.0183405574074, -0.0173964666286, -0.00106321963576,
        0.0056206003128, 0.0001618217499, -0.0006860188944}},
      {40,
       -3.13005805346,
       3.1524725364,
       {0.621036276475, 0.0967031995552, -0.00801302059667, 0.00482705779732, 0.00187587272287, -0.00246738509321,
        -0.000841116668, 0.0006193291052}}}}};

inline constexpr BlastFits surface_fits{
    0.178,
    {{{40,
       -0.214362789151,
       1.35034249993,
       {2.78076916577, -1.6958988741, -0.154159376846, 0.514060730593, 0.0988534365274, -0.293912623038,
        -0.0268112345019, 0.109097496421, 0.00162846756311, -0.0214631030242, 0.0001456723382, 0.00167847752266}}}},
    {{{40,
       -0.240657322658,
       1.36637719229,
       {3.40283217581, -2.21030870597, -0.218536586295, 0.895319589372, 0.24989009775, -0.569249436807, -0.11791682383,
        0.224131161411, 0.0245620259375, -0.0455116002694, -0.00190930738887, 0.00361471193389}}}},
    {{{0.955,
       2.06761908721,
       3.0760329666,
       {2.52455620925, -0.502992763686, 0.171335645235, 0.0450176963051, -0.0118964626402}},
      {40,
       -1.94708846747,
       2.40697745406,
       {1.67281645863, -0.384519026965, -0.0260816706301, 0.00595798753822, 0.014544526107, -0.00663289334734,
        -0.00284189327204, 0.0013644816227}}}},
    {{{40, -0.246208804814, 1.33422049854, {2.70588058103, -0.949516092853, 0.112136118689, -0.0250659183287}}}},
    {{{40,
       -0.202425716178,
       1.37784223635,
       {-0.0591634288046, 1.35706496258, 0.052492798645, -0.196563954086, -0.0601770052288, 0.0696360270891,
        0.0215297490092, -0.0161658930785, -0.00232531970294, 0.00147752067524}}}},
    {{{1.01,
       1.92946154068,
       5.25099193925,
       {-0.614227603559, 0.130143717675, 0.134872511954, 0.0391574276906, -0.00475933664702, -0.00428144598008}},
      {2.78,
       -2.12492525216,
       9.2996288611,
       {0.315409245784, -0.0297944268976, 0.030632954288, 0.0183405574086, -0.0173964666211, -0.00106321963633,
        0.00562060030977, 0.0001618217499, -0.0006860188944}},
      {40,
       -3.53626218091,
       3.46349745571,
       {0.686906642409, 0.0933035304009, -0.0005849420883, -0.00226884995013, -0.00295908591505, 0.00148029868929}}}}};

inline constexpr const BlastFits& blast_fits(Burst burst) {
  return burst == Burst::free_air ? free_air_fits : surface_fits;
}

/// The integral of (1 - s) exp(-a s) over s from 0 to 1, (a - 1 + exp(-a))/a^2, and its derivative.
inline std::array<double, 2> friedlander_impulse(double a) {
  if (std::abs(a) < 1e-2)  // by its series, where the difference of nearly equal numbers loses digits
    return {1.0 / 2 + a * (-1.0 / 6 + a * (1.0 / 24 - a / 120)), -1.0 / 6 + a * (1.0 / 12 - a / 40)};
  const double e = std::exp(-a), share = (a - 1 + e) / (a * a);
  return {share, (1 - e) / (a * a) - 2 * share / a};
}
/// The decay a of a Friedlander history (1 - s) exp(-a s) that has a share of the impulse that its peak would have if
/// it stayed.
inline double friedlander_decay(double share) {
  // Newton from below the root, for the impulse is at least 1/(a + 2) and falls with a, ever less steeply.
  double a = 1 / share - 2;
  for (int i = 0; i < 60; ++i) {
    const auto [impulse, slope] = friedlander_impulse(a);
    const double change = (share - impulse) / slope;
    a += change;
    if (std::abs(change) <= 1e-13 * (1 + std::abs(a))) break;
  }
  return a;
}

/// The blast of 1 kg of TNT at a scaled distance, in SI units.
inline BlastWave scaled_blast(Burst burst, double Z) {
  const BlastFits& fits = blast_fits(burst);
  const double log_Z = std::log10(Z);
  const auto at = [&](std::span<const BlastFit> pieces) {
    std::size_t i = 0;
    while (i + 1 < pieces.size() && Z >= pieces[i].up_to) ++i;
    return pieces[i](log_Z);
  };
  BlastWave wave{.arrival = 1e-3 * at(fits.arrival),
                 .duration = 1e-3 * at(fits.duration),
                 .incident_pressure = 1e3 * at(fits.incident_pressure),
                 .reflected_pressure = 1e3 * at(fits.reflected_pressure),
                 .incident_impulse = at(fits.incident_impulse),
                 .reflected_impulse = at(fits.reflected_impulse)};
  wave.incident_decay = friedlander_decay(wave.incident_impulse / (wave.incident_pressure * wave.duration));
  wave.reflected_decay = friedlander_decay(wave.reflected_impulse / (wave.reflected_pressure * wave.duration));
  return wave;
}

}  // namespace detail

}  // namespace strike
