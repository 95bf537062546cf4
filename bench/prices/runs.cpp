#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/global_step.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/mesh/select.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/history.hpp>
#include <strike/output/vtu.hpp>

#include "feature.hpp"

namespace prices {

Group numbers() {
  Feature threads = hexahedra.by("two threads, by the clock on the wall", OpenMP{.threads = 2});
  threads.timed_by = TimedBy::wall;
  Feature global_step = hexahedra.by("GlobalStep, for longer steps", GlobalStep{});
  global_step.steps = 100;  // the mesh is asked now and then
  return {"Numbers, threads, bound of the step",
          {hexahedra.by("double, one lane", in<double>), hexahedra.by("Pack<float>", in<Pack<float>>),
           hexahedra.by("mixed: Pack<float> in the elements, double at the nodes", in<Pack<float>, double>), threads,
           global_step}};
}

Group conditions() {
  const auto symmetry = [](Axis axis) { return Symmetry{axis, nodes_where(bar.nodes, on_plane(axis, 0))}; };
  const RigidWall wall{{0, 0, 0}, {0, 0, 1}};
  return {"Loads and contact",
          {hexahedra.with("RigidWall that sees all nodes", wall),
           hexahedra.with("RigidWall that sees one face",
                          RigidWall{{0, 0, 0}, {0, 0, 1}, nodes_where(bar.nodes, on_plane(Axis::z, 0))}),
           hexahedra.with("three planes of Symmetry", symmetry(Axis::x), symmetry(Axis::y), symmetry(Axis::z)),
           hexahedra.with("BodyForce", BodyForce{{0, 0, -9.81}}),
           hexahedra.with("InitialVelocity, which has nothing to do in a step", InitialVelocity{{0, 0, 0}})}};
}

Group outputs() {
  Feature film{
      "a VTU file with a field every 100 steps", [] {
        const auto run = started(hexahedra.scene());
        return Trial{
            [run] {
              run->step();
              if (run->steps() % 100) return;
              const auto strain =
                  run->part<0>().field([](const auto& state) { return state.equivalent_plastic_strain; });
              write_vtu("out/prices/bar.vtu", run->time(), bar, run->positions(), {}, {{"plastic strain", strain}});
            },
            bytes(*run)};
      }};
  film.steps = 100;
  const Feature history{
      "a row of a History every step", [] {
        const auto run = started(hexahedra.scene());
        const auto file = std::make_shared<History>(
            "out/prices/history.csv",
            std::vector<Column>{
                {"time", "s"}, {"kinetic energy", "J"}, {"internal energy", "J"}, {"error of the balance"}});
        return Trial{[run, file] {
                       run->step();
                       const Energy& energy = run->energy();
                       file->row(run->time(), energy.kinetic, energy.internal, energy.error());
                     },
                     bytes(*run)};
      }};
  return {"Output", {film, history}};
}

}  // namespace prices
