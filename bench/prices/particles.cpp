#include "feature.hpp"

namespace prices {

Group particle_choices() {
  return {"Particle",
          {cloud.of_element("two Mirrors, which it touches",
                            Particle{Smoothing{}, Mirrors{Mirror{{1, 0, 0}}, Mirror{{0, 1, 0}}}}),
           cloud.of_element("Smoothing of 1.5", Particle{Smoothing{1.5}}),
           cloud.of_material("copper, with VonMises", copper), cloud.by("double, one lane", in<double>),
           cloud.by("Pack<float>", in<Pack<float>>),
           cloud.by("mixed: Pack<float> in the elements, double at the nodes", in<Pack<float>, double>)}};
}

}  // namespace prices
