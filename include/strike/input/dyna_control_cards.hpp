#pragma once
#include <string>

#include <strike/input/source.hpp>

// Control and output of an LS-DYNA deck as values (LS-DYNA Keyword User's Manual R13, volume I, *CONTROL and
// *DATABASE).
namespace strike {

/// *CONTROL_SHELL.
struct ShellControl {
  double warping_angle = 20;        ///< WRPANG [degree]
  FileNumber thickness_update = 0;  ///< ISTUPD: from 1 on the thickness follows the strains
  FileNumber element_form = 2;      ///< THEORY, of sections that have none
  FileNumber warping = 2;           ///< BWC: 1 for the stiffness of Belytschko, Wong and Chiang
  bool projects = false;            ///< PROJ
};

/// *DATABASE_...: the interval of an output.
struct OutputCard {
  std::string name;  ///< what follows *DATABASE_ and BINARY_, such as "D3PLOT" or "GLSTAT"
  double interval;   ///< DT [time]
};

}  // namespace strike
