#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gvd/cell_moments.hpp"
#include "gvd/density.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

struct CoarseCopy;  // coarse_copy.hpp

/// How a generator may move while it is relaxed.
enum class Freedom {
  free,       ///< over the whole surface
  on_crease,  ///< along the creases, up to their corners
  fixed,      ///< not at all
};

/// How the steps of an iteration are found.
enum class Acceleration {
  none,   ///< Lloyd's method: every generator goes to the centroid of its cell
  lbfgs,  ///< a quasi-Newton method (L-BFGS) with the Hessian of the centroidal Voronoi energy to begin with
};
inline const Choices<Acceleration> kAccelerationNames{{"lbfgs", Acceleration::lbfgs}, {"none", Acceleration::none}};

struct LloydOptions {
  /// How each generator may move, one for each; empty: all are free.
  std::vector<Freedom> freedom;
  std::vector<EdgeId> creases;  ///< of the generators that stay on creases (see creases.hpp)
  Density density;              ///< weight of the surface in the energy; of the mesh's faces, or uniform
  Acceleration acceleration = Acceleration::lbfgs;
  /// >= 0; without a value 300, or 100 without acceleration. Iterations on a copy count.
  std::optional<std::int32_t> max_iterations;
  /// Stop after an iteration that lowers the energy by less than this fraction of it, on the average of five iterations
  /// if they are accelerated. >= 0; 1e-8 is near the limit. Without a value, an accelerated relaxation ends where
  /// little is left (LloydStop::prediction), and another one by 1e-5.
  std::optional<double> energy_tolerance;
  /// Stop if no centroid is farther from its generator than this fraction of the mean cell radius,
  /// sqrt(area / (pi cells)). >= 0.
  double move_tolerance = 1e-3;
  /// Move generators from cells with little energy to distant cells with much, where that lowers the energy at once:
  /// this evens out clustered starts. Without a value, accelerated runs do.
  std::optional<bool> relocate;
  DiagramOptions diagram;  ///< for every iteration; its progress callback is not used
  Progress progress;       ///< may be empty
  /// Called with the number of iterations so far, the energy and the generators after them, at first for the given
  /// generators; may be empty. Called again when the energy is measured anew, with better diagrams: then, iterations
  /// that count as one with those before are fewer.
  std::function<void(std::int64_t iterations, double energy, const std::vector<SurfacePoint>& generators)> on_iteration;
  /// Asked before each iteration; the relaxation ends where it returns true. May be empty. The library reads no clock:
  /// with a predicate that does, for a limit of time, the result is not the same in every run.
  std::function<bool()> is_time_over;
};

/// The stages of a relaxation beside its iterations on the mesh, for remeshes and comparisons.
struct LloydStages {
  /// Begin without diagrams, face by face, and end with those of the options. Only accelerated runs with Method::exact
  /// do.
  bool early_approximation = true;
  /// Relax on this decimated copy of the mesh first (see relax_generators); null: on none. It has to outlive the call.
  const CoarseCopy* copy = nullptr;
  bool ends_on_copy = false;  ///< where there is a copy, no iteration on the mesh follows
  /// Move generators to the extremities of their cells at the end, and relax the others once more: see
  /// relax_generators.
  bool keeps_extremities = false;
};

/// The default end of accelerated relaxations: the decrease of the energy that the next five iterations are predicted
/// to give is below this fraction of it.
inline constexpr double kSettledFall = 1e-3;

/// The largest number of iterations, and the energy tolerance if it ends the relaxation: those of the options or their
/// defaults.
inline std::int32_t max_iterations(const LloydOptions& options) {
  return options.max_iterations.value_or(options.acceleration == Acceleration::none ? 100 : 300);
}
inline std::optional<double> energy_tolerance(const LloydOptions& options) {
  if (options.energy_tolerance || options.acceleration != Acceleration::none) return options.energy_tolerance;
  return 1e-5;
}

inline bool relocates(const LloydOptions& options) {
  return options.relocate.value_or(options.acceleration != Acceleration::none);
}

/// After the relaxation on a copy, the most iterations on the mesh, and what each has to promise: the fall of the
/// energy, as a fraction of it, if every generator went to its centroid and all cells kept their borders. Measured with
/// 50 to 1,000 generators on 278,000 to 1.7 million faces: three more iterations lower the energy by .06 % at most, or
/// by .15 % after ten iterations on the copy. The promise is .002 to .08 %, and about what they gain.
inline constexpr std::int32_t kFinishIterations = 3;
inline constexpr double kFinishPromise = 5e-4;

/// Why a relaxation ended.
enum class LloydStop {
  centroids,   ///< every generator is at its centroid, within move_tolerance
  energy,      ///< the last iterations lowered the energy by less than energy_tolerance each
  no_descent,  ///< no step towards the centroids lowers the energy
  /// The next five iterations would lower the energy by less than kSettledFall, as the last steps predict; twice that
  /// counts as less once the diagrams are those of the options. After a copy, the next iteration promises less than
  /// kFinishPromise, or kFinishIterations were made.
  prediction,
  max_iterations,  ///< the number of iterations is max_iterations
  time_limit,      ///< is_time_over returned true
};
inline const Choices<LloydStop> kLloydStopNames{
    {"centroids", LloydStop::centroids},       {"energy", LloydStop::energy},
    {"no descent", LloydStop::no_descent},     {"prediction", LloydStop::prediction},
    {"iterations", LloydStop::max_iterations}, {"time limit", LloydStop::time_limit}};

/// One iteration that lowered the energy.
struct LloydIteration {
  double energy = 0;              ///< after it, mesh units to the fourth
  double largest_move = 0;        ///< length of the longest path of a generator, mesh units
  double mean_move = 0;           ///< mean length of the paths, mesh units
  double scale = 1;               ///< factor of all steps: 1, or less where the whole step does not lower the energy
  std::int32_t held = 0;          ///< generators that did not move: they would collide
  std::int32_t relocated = 0;     ///< generators that left their place for a distant one; nothing else moved
  Method method = Method::exact;  ///< of the diagram that the energy was measured with
  bool is_sampled = false;        ///< measured face by face, without a diagram
  Acceleration by = Acceleration::none;  ///< how the steps were found; none where only Lloyd's lower the energy
};

/// The part of a relaxation on a copy of the mesh.
struct CoarseRelaxation {
  std::int64_t faces = 0;  ///< of the copy; 0 where none was used
  std::int64_t iterations = 0;
  std::int64_t diagrams = 0;  ///< of the copy
};

struct LloydResult {
  std::vector<SurfacePoint> generators;
  Diagram diagram;                             ///< of these generators
  IdVector<GeneratorId, CellMoments> moments;  ///< of the cells of `diagram`
  double initial_energy = 0;                   ///< measured as that of the first iteration, mesh units to the fourth
  double final_energy = 0;                     ///< of `diagram`
  double residual = 0;                         ///< largest distance from a generator to its centroid, mesh units
  double mean_cell_radius = 0;
  std::vector<LloydIteration> iterations;
  std::vector<GeneratorId> extremities;  ///< ascending: the generators that went to extremities, and stayed there
  CoarseRelaxation copy;                 ///< what was done on a copy of the mesh first
  std::int64_t diagrams = 0;             ///< number of diagrams computed, including those of rejected steps
  LloydStop stop = LloydStop::no_descent;
};

/// Moves all generators to the geodesic centroids of their cells, step by step.
///
/// Each generator moves along a straight geodesic. Lloyd's step leads in the direction of the mean of its cell's log
/// map; accelerated steps take that mean for the gradient of the energy. At a vertex with curvature the direction in
/// which the energy falls fastest takes its place; where it falls in none, the generator rests. A generator stops at
/// the boundary; from a boundary point, an outward step slides along the boundary. A step is taken only if it lowers
/// the energy; where energies differ by less than their error, their slopes along the paths decide. An accelerated step
/// is shortened up to three times. Then better diagrams follow, or Lloyd's step with the last ones. If that does not
/// lower the energy, generators that went too far shorten their own steps, and after that all do. A generator that
/// would collide with another one does not move.
///
/// An extremity is an inner vertex that is farther from its generator than all its neighbours; these are in the same
/// cell. It is the end of a limb, which the centroid of the cell misses. With `keeps_extremities`, a free generator
/// goes to the farthest one of its cell and stays there, if that is half the cell's radius away or more. If there is
/// one, up to five iterations with the others follow. The energy may rise between these iterations and those before.
/// Where they leave many more cells that are no discs or have fewer than three neighbours, these iterations do not
/// count.
///
/// With a `copy`, all this happens on the copy first, without a call of `on_iteration`. Generators that are not free
/// stay there. Without an `energy_tolerance` it ends at 1e-5 on the copy. On the mesh, at most kFinishIterations
/// follow, each if it promises kFinishPromise of the energy; with an `energy_tolerance`, as many as it takes. The
/// initial energy is then that of the generators which come from the copy. Generators that are on extremities of the
/// copy stay there. The copy is not used where it has more than half of the faces, or where two generators coincide on
/// it.
///
/// Properties: (1) the energies of the iterations fall, but for that rise: a step that raises the energy by less than its
/// error counts as one with the iteration before, and none exceeds the initial energy; (2) every generator stays on the
/// surface, in its component; (3) no two coincide; (4) deterministic, if `is_time_over` is; (5) the last iteration is
/// measured with the diagrams of the options; with `ends_on_copy`, those of the copy.
/// Throws Error{invalid_option} for an option out of its range, and Error{interrupted} if the progress callback cancels.
/// Throws Error{precondition} where `compute_diagram` does, without generators, and if the energy is no finite number.
/// Cost: the windows of a diagram and O(n log n) for an early iteration, a diagram and O(n log n) for others.
LloydResult relax_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const LloydOptions& options = {}, const LloydStages& stages = {});

}  // namespace gvd
