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

/// How a generator may move during a relaxation.
enum class Freedom {
  free,       ///< over the whole surface
  on_crease,  ///< along the creases, up to their corners
  fixed,      ///< not at all
};

/// How the steps of an iteration are found.
enum class Acceleration {
  none,   ///< Lloyd's method: every generator moves to the centroid of its cell
  lbfgs,  ///< a quasi-Newton method (L-BFGS) that starts from the Hessian of the centroidal Voronoi energy
};
inline const Choices<Acceleration> kAccelerationNames{{"lbfgs", Acceleration::lbfgs}, {"none", Acceleration::none}};

struct LloydOptions {
  /// How each generator may move; empty: all are free.
  std::vector<Freedom> freedom;
  std::vector<EdgeId> creases;  ///< for the generators that stay on creases (see creases.hpp)
  Density density;              ///< weight of the surface in the energy; for the mesh's faces, or uniform
  Acceleration acceleration = Acceleration::lbfgs;
  /// >= 0; without a value 300, or 100 without acceleration. Iterations on a copy count, too.
  std::optional<std::int32_t> max_iterations;
  /// Stop after an iteration that lowers the energy by less than this fraction; with acceleration, the mean of five
  /// iterations counts. >= 0; 1e-8 is near the limit of precision. Without a value, an accelerated relaxation ends when
  /// it has converged (LloydStop::prediction), and one without acceleration ends at 1e-5.
  std::optional<double> energy_tolerance;
  /// Stop if no centroid is farther from its generator than this fraction of the mean cell radius,
  /// sqrt(area / (pi cells)). >= 0.
  double move_tolerance = 1e-3;
  /// Move generators from cells with little energy to distant cells with much energy, if that lowers the energy at
  /// once. This evens out clustered starts. Without a value, only accelerated runs do.
  std::optional<bool> relocate;
  DiagramOptions diagram;  ///< for every iteration; its progress callback is not used
  Progress progress;       ///< may be empty
  /// Called first for the initial generators and then after each iteration, with the number of iterations so far, the
  /// energy and the generators; may be empty. Called again when the energy is measured again with better diagrams. The
  /// number of iterations can then be smaller, because some iterations were merged with earlier ones.
  std::function<void(std::int64_t iterations, double energy, const std::vector<SurfacePoint>& generators)> on_iteration;
  /// Called before each iteration; the relaxation ends if it returns true. May be empty. The library itself reads no
  /// clock; if this function does, to limit the time, the result can differ from run to run.
  std::function<bool()> is_time_over;
};

/// The stages of a relaxation besides its iterations on the mesh, for remeshes and comparisons.
struct LloydStages {
  /// Begin without diagrams, measuring cells face by face, and end with the diagrams of the options. Applies only to
  /// accelerated runs with Method::exact.
  bool early_approximation = true;
  /// Relax on this decimated copy of the mesh first (see `relax_generators`); null: no copy. It must outlive the call.
  const CoarseCopy* copy = nullptr;
  bool ends_on_copy = false;  ///< if there is a copy, do no iteration on the mesh
  /// In the end, move generators to the extremities of their cells, and relax the other generators once more (see
  /// `relax_generators`).
  bool keeps_extremities = false;
};

/// By default, an accelerated relaxation ends when the next five iterations are predicted to lower the energy by less
/// than this fraction.
inline constexpr double kSettledFall = 1e-3;

/// The largest number of iterations, and the energy tolerance if there is one: the values of the options or their
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

/// After the relaxation on a copy, the largest number of iterations on the mesh, and the fall of the energy that each
/// must promise: the fraction by which the energy would fall if every generator moved to its centroid and all cells
/// kept their borders.
inline constexpr std::int32_t kFinishIterations = 3;
inline constexpr double kFinishPromise = 5e-4;

/// Why a relaxation ended.
enum class LloydStop {
  centroids,   ///< every generator is at its centroid, within move_tolerance
  energy,      ///< the last iterations lowered the energy by less than energy_tolerance each
  no_descent,  ///< no step towards the centroids lowers the energy
  /// Converged: according to the last steps, the next five iterations would lower the energy by less than kSettledFall,
  /// or by less than twice that once the diagrams are those of the options. After a copy: the next iteration promises
  /// less than kFinishPromise, or kFinishIterations were made.
  prediction,
  max_iterations,  ///< the number of iterations is max_iterations
  time_limit,      ///< is_time_over returned true
};
inline const Choices<LloydStop> kLloydStopNames{
    {"centroids", LloydStop::centroids},       {"energy", LloydStop::energy},
    {"no descent", LloydStop::no_descent},     {"prediction", LloydStop::prediction},
    {"iterations", LloydStop::max_iterations}, {"time limit", LloydStop::time_limit}};

/// An iteration that lowered the energy.
struct LloydIteration {
  double energy = 0;              ///< after the iteration, mesh units to the fourth
  double largest_move = 0;        ///< length of the longest path of a generator, mesh units
  double mean_move = 0;           ///< mean length of the paths, mesh units
  double scale = 1;               ///< factor of all steps: 1, or less if the whole step would not lower the energy
  std::int32_t held = 0;          ///< generators that did not move, because they would collide
  std::int32_t relocated = 0;     ///< generators that moved to a distant place; then no other generator moved
  Method method = Method::exact;  ///< of the diagram that measured the energy
  bool is_sampled = false;        ///< whether it was measured face by face, without a diagram
  Acceleration by = Acceleration::none;  ///< how the steps were found; none if only Lloyd's steps lowered the energy
};

/// The part of a relaxation on a copy of the mesh.
struct CoarseRelaxation {
  std::int64_t faces = 0;  ///< of the copy; 0 if none was used
  std::int64_t iterations = 0;
  std::int64_t diagrams = 0;  ///< number of diagrams of the copy
};

struct LloydResult {
  std::vector<SurfacePoint> generators;
  Diagram diagram;                             ///< of these generators
  IdVector<GeneratorId, CellMoments> moments;  ///< of the cells of `diagram`
  /// Measured in the same way as the energy of the first iteration, mesh units to the fourth.
  double initial_energy = 0;
  double final_energy = 0;  ///< of `diagram`
  double residual = 0;      ///< largest distance from a generator to its centroid, mesh units
  double mean_cell_radius = 0;
  std::vector<LloydIteration> iterations;
  std::vector<GeneratorId> extremities;  ///< the generators that moved to extremities and stayed there; ascending
  CoarseRelaxation copy;                 ///< the part of the relaxation on a copy of the mesh
  std::int64_t diagrams = 0;             ///< number of diagrams computed, including rejected steps
  LloydStop stop = LloydStop::no_descent;
};

/// Moves all generators to the geodesic centroids of their cells, step by step.
///
/// Each generator moves along a straight geodesic. Lloyd's step is the mean of its cell's log map; accelerated steps
/// use this mean as the gradient of the energy. At a vertex with curvature, the direction in which the energy falls
/// fastest replaces it; if the energy falls in no direction, the generator rests. A generator stops at the boundary;
/// from a boundary point, an outward step slides along the boundary. A step is taken only if it lowers the energy; if
/// energies differ by less than their error, their slopes along the paths decide. An accelerated step is shortened up
/// to three times. If it still fails, better diagrams follow or, with the last ones, Lloyd's step. If that does not
/// lower the energy, generators that went too far shorten their own steps, and after that all generators do. A
/// generator that would collide with another one does not move.
///
/// An extremity is an inner vertex that is farther from its generator than all its neighbours, which are in the same
/// cell. It is the end of a limb, which the centroid of the cell misses. With `keeps_extremities`, a free generator
/// moves to the farthest extremity of its cell and stays there, if it is at least half the cell's radius away. If any
/// generator does, up to five iterations with the other generators follow. The energy may rise when generators move to
/// extremities. If many more cells than before are not discs or have fewer than three neighbours in the end, these
/// iterations are undone.
///
/// With a `copy`, all this happens on the copy first, without calls of `on_iteration`. Generators that are not free do
/// not move on the copy. There, the energy tolerance is at least 1e-5. On the mesh, at most kFinishIterations follow,
/// each only if it promises kFinishPromise; with an `energy_tolerance`, as many iterations as it takes follow. The
/// initial energy is then the energy of the generators that come from the copy. Generators on extremities of the copy
/// stay there. The copy is not used if it has more than half of the mesh's faces, or if two generators coincide on it.
///
/// Properties: (1) the energies of the iterations decrease, except for that rise; a step that raises the energy by less
/// than its error is merged with the iteration before it, and no energy exceeds the initial energy; (2) every generator
/// stays on the surface and in its component; (3) no two generators coincide; (4) the result is deterministic, if
/// `is_time_over` is; (5) the last iteration is measured with the diagrams of the options, or with the copy's diagrams
/// if `ends_on_copy` is set.
/// Throws Error{invalid_option} for an option out of range, and Error{interrupted} if the progress callback cancels.
/// Throws Error{precondition} if `compute_diagram` does, if there are no generators, and if the energy is not finite.
/// Cost: the windows of a diagram and O(n log n) for an early iteration; a diagram and O(n log n) for every other
/// iteration.
LloydResult relax_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const LloydOptions& options = {}, const LloydStages& stages = {});

}  // namespace gvd
