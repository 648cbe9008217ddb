// Describes the options of a relaxation and of its start.

#include "gvd/lloyd_options.hpp"

#include <fmt/format.h>

namespace gvd {

void describe(OptionList& list, LloydOptions& options) {
  LloydOptions plain;
  plain.acceleration = Acceleration::none;
  list.group("Relaxation");
  list.option(
      "accelerate", choice(options.acceleration, kAccelerationNames),
      {.help = "How to find the steps", .more = ": by a quasi-Newton method (lbfgs), or by Lloyd's method alone"});
  list.option("relocate", Switch{&options.relocate},
              {.help = "Move generators from cells with little energy to distant cells with much",
               .more = ", where that lowers the energy at once",
               .usual = "on; off with \1accelerate=none\2"});
  list.option("iterations", Number{&options.max_iterations, {.least = 0, .most = 1'000'000}},
              {.help = "Largest number of iterations",
               .usual = fmt::format("{}; {} with \1accelerate=none\2", max_iterations(options), max_iterations(plain)),
               .shown = Shown::main});
  list.option("tolerance", Number{&options.energy_tolerance, {.least = 0}},
              {.help = "Stop once an iteration lowers the energy by less than this fraction of it",
               .more = "; 1e-8 is near the limit",
               .usual = fmt::format("stop once the next five iterations would lower it by less than {:g} %, as "
                                    "predicted; {} with \1accelerate=none\2",
                                    100 * kSettledFall, *energy_tolerance(plain))});
  list.option("move_tolerance", Number{&options.move_tolerance, {.least = 0}},
              {.help = "Stop once no generator is farther from its centroid than this", .unit = "mean cell radii"});
}

void describe(OptionList& list, RelaxationStartOptions& options) {
  StartOptions& constraints = options.constraints;
  list.group("Relaxation");
  list.option("coarse", Number{&options.copy.faces, {.least = 4, .most = 1e9}, {{"off", 0}}},
              {.help = "Sample and relax on a decimated copy with about this many faces first",
               .usual = "if the mesh is large enough"});
  list.group("Constraints");
  list.option(
      "features", CreaseAngle{&constraints.crease_angle, &constraints.prefers_creases, kUsualCreaseAngle},
      {.help = "Put generators on corners and creases first and keep them there",
       .more = fmt::format(
           "; a crease is a line along which the surface, as it looks at the distance of the generators, turns by more "
           "than this many degrees; 'auto': by more than {} degrees, where creases are sharp, and at most half of the "
           "sampled generators suffice for creases and boundary",
           kUsualCreaseAngle),
       .shown = Shown::main});
  list.option("keep_boundary", Flag{&constraints.keep_boundary},
              {.help = "Put generators on the boundary first and keep them there"});
  list.option("gradation", Number{&options.gradation, above(0)},
              {.help = "With \1density=curvature\2, how fast the size of cells may change along the surface"});
}

void resolve(LloydOptions& options) {
  options.max_iterations = max_iterations(options);
  options.energy_tolerance = energy_tolerance(options);
  options.relocate = relocates(options);
}

}  // namespace gvd
