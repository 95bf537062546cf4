#ifndef COPPER_VUMAT_H
#define COPPER_VUMAT_H
// A VUMAT in C: von Mises plasticity with linear hardening, and the pressure K (rho/rho0 - 1).
//   props  rho0, K, G, Y, H       state  equivalent plastic strain
#include <math.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" inline
#endif
    void
    copper_vumat(const int* nblock, const int* ndir, const int* nshr, const int* nstatev, const int* nfieldv,
                 const int* nprops, const int* lanneal, const double* stepTime, const double* totalTime,
                 const double* dt, const char* cmname, const double* coordMp, const double* charLength,
                 const double* props, const double* density, const double* strainInc, const double* relSpinInc,
                 const double* tempOld, const double* stretchOld, const double* defgradOld, const double* fieldOld,
                 const double* stressOld, const double* stateOld, const double* enerInternOld,
                 const double* enerInelasOld, const double* tempNew, const double* stretchNew, const double* defgradNew,
                 const double* fieldNew, double* stressNew, double* stateNew, double* enerInternNew,
                 double* enerInelasNew, size_t cmname_length) {
  const int n = *nblock;
  const double rho0 = props[0], K = props[1], G = props[2], Y = props[3], H = props[4];
  (void)ndir, (void)nshr, (void)nstatev, (void)nfieldv, (void)nprops, (void)lanneal, (void)stepTime, (void)totalTime;
  (void)dt, (void)cmname, (void)coordMp, (void)charLength, (void)relSpinInc, (void)tempOld, (void)stretchOld;
  (void)defgradOld, (void)fieldOld, (void)tempNew, (void)stretchNew, (void)defgradNew, (void)fieldNew;
  (void)cmname_length;
  for (int k = 0; k < n; ++k) {
    const double *e = strainInc + k, *old = stressOld + k;
    const double theta = e[0] + e[n] + e[2 * n], p_old = -(old[0] + old[n] + old[2 * n]) / 3;
    double s[6], ss = 0;
    for (int c = 0; c < 6; ++c) {
      const int direct = c < 3;
      s[c] = old[c * n] + (direct ? p_old : 0) + 2 * G * (e[c * n] - (direct ? theta / 3 : 0));
      ss += (direct ? 1 : 2) * s[c] * s[c];
    }
    const double q = sqrt(1.5 * ss), excess = q - (Y + H * stateOld[k]);
    const double plastic = excess > 0 ? excess / (3 * G + H) : 0, scale = excess > 0 ? 1 - 3 * G * plastic / q : 1;
    const double p = K * (density[k] / (rho0 * (1 + 0.5 * theta)) - 1);  // the density given is that of the mid-step

    double power = 0;
    for (int c = 0; c < 6; ++c) {
      stressNew[c * n + k] = scale * s[c] - (c < 3 ? p : 0);
      power += (c < 3 ? 0.5 : 1.0) * (old[c * n] + stressNew[c * n + k]) * e[c * n];
    }
    stateNew[k] = stateOld[k] + plastic;
    enerInternNew[k] = enerInternOld[k] + power / density[k];
    enerInelasNew[k] = enerInelasOld[k] + (q * scale) * plastic / density[k];
  }
}

#endif
