#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "cell_integrals.hpp"
#include "constraints.hpp"
#include "gvd/lloyd.hpp"
#include "optimiser.hpp"

namespace gvd {

// At vertices.

/// A path that leaves a vertex.
struct DepartingPath {
  double angle;   ///< on the surface, in [0, total angle of the vertex), radians
  double weight;  ///< distance times mass
};

/// The slope of the energy at a generator on a vertex, in every direction.
///
/// A short step of a generator in direction u shortens a path that departs in direction t by cos(u, t) of the step. A
/// path that departs at more than 180 degrees from u bends round the vertex: the whole step lengthens it. So
/// the slope is -2 times the integral of density times distance times the cosine of the lesser of that angle and 180
/// degrees. Where the vertex is flat that is the scalar product with the gradient. Where the total angle is larger, the
/// slope can be positive in all directions: the energy has a minimum with a kink.
/// Source: the first variation of length; see docs/developer/lloyd.md.
class VertexSlope {
 public:
  /// `total`: angle of the faces round the vertex, radians, > 0. `is_closed`: whether they lie all round it.
  /// Cost: O(p log p) for p paths.
  VertexSlope(double total, bool is_closed, std::vector<DepartingPath> paths);

  /// Derivative of the energy along a step in a direction, radians as in DepartingPath; mesh units cubed. Cost: O(log
  /// p).
  double at(double angle) const;
  /// The direction of the least slope, and that slope.
  struct Least {
    double angle, slope;
  };
  /// By a search in 64 directions, and a golden-section search round the best one. Cost: O(log p).
  Least least() const;

 private:
  /// Sum of the paths' unit vectors, times their weights, at angles from `begin` to `end`; and of the weights.
  struct Sum {
    Vec2 vector = Vec2::Zero();
    double weight = 0;
  };
  Sum between(double begin, double end) const;

  double total_;
  bool is_closed_;
  std::vector<double> angles_;  // ascending
  std::vector<Sum> sums_;       // of the first 0, 1, 2 ... paths
};

/// Marks the generators at vertices, and those beside an inner saddle vertex, within `reach` of it.
WatchedGenerators watch_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators, double reach);

/// The way in which the energy falls fastest from a generator at a vertex: a tangent vector, of which -2 mass times the
/// length is the slope. Zero where the energy falls in no direction.
/// `paths`: to the points of the generator's cell. Where the vertex is flat, the mean of the log map, `mean`, is the
/// way.
Vec2 steepest_way(const Mesh& mesh, const SurfacePoint& vertex, std::span<const PathSample> paths, double mass,
                  const Vec2& mean);

/// The inner saddle vertex within `reach` that lies on the generator's way, less than 90 degrees off, and where its
/// paths would let it rest: a saddle that holds a generator draws it from all sides. The paths are taken for those from
/// the vertex. The ones that bend there spread evenly over the angle that the vertex has in excess of 360 degrees. For
/// short distances that is nearly so. What holds at the vertex is found out there.
std::optional<VertexId> find_rest(const Mesh& mesh, const SurfacePoint& generator, const Vec2& way, double reach,
                                  std::span<const PathSample> paths);

// States.

/// How the cells of generators are found.
struct Precision {
  DiagramOptions diagram;
  bool skips_diagram = false;  ///< measures the cells face by face instead (see measured_cells.cpp)
  /// Generators at vertices rest if their way is at most this fraction of the mean cell radius, >= 0.
  double rest_tolerance = 0;
};

/// Generators, their cells, and the integrals over these.
struct RelaxationState {
  std::vector<SurfacePoint> generators;
  Diagram diagram;  ///< empty if the precision skips it
  IdVector<GeneratorId, CellMoments> moments;
  CellGeometry geometry;
  double energy = 0;
  /// The ways to the centroids, projected to where the generators may go; at a vertex the steepest way. Mesh units.
  TangentField to_centroids;
  double residual = 0;  ///< length of the longest way
  /// Whether each generator is at a vertex where no short step, or hardly any, lowers the energy of its cell.
  std::vector<char> is_resting;
  /// The vertex nearby at which each generator would rest, if any (see find_rest).
  std::vector<std::optional<VertexId>> rest;
  double mean_cell_radius = 0;  ///< sqrt(area / (pi cells)), mesh units
};

/// Generators that rest, or go to rest, have no step.
inline bool is_held(const RelaxationState& state, std::size_t i) { return state.is_resting[i] || state.rest[i]; }

/// Whether the energy is no smooth function of the generator. The steps of other generators then tell nothing about its
/// own, and it takes Lloyd's.
inline bool is_at_kink(const RelaxationState& state, std::size_t i) {
  return is_held(state, i) || state.generators[i].kind() == SurfacePoint::Kind::vertex;
}

/// Cells, integrals and ways to the centroids of these generators.
RelaxationState evaluate_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const Precision& precision, const Density& density = {},
                                    const GeneratorConstraints& constraints = {});

/// The gradient of the energy: -2 mass centroid for each generator; mesh units cubed.
TangentField energy_gradient(const RelaxationState& state);

/// Twice the integrals of the density over the cells. The gradient divided by them is minus the way to the centroid, so
/// Lloyd's step is the step of a Newton method with this diagonal Hessian. A cell without any takes the mean.
std::vector<double> cell_masses(const RelaxationState& state);

/// How a relaxation finds the cells: at first without diagrams, at last by those of `options.diagram`. Energies of
/// different levels must not be compared with each other: they differ by the errors at the bisectors. A relaxation that
/// ends on a copy has no diagrams there.
std::vector<Precision> make_precision_levels(const LloydOptions& options);

/// Computes the states of a relaxation with one level of precision after the other.
class StateEvaluator {
 public:
  /// Begins at the first level. All arguments have to outlive this.
  StateEvaluator(const Mesh& mesh, const LloydOptions& options, const GeneratorConstraints& constraints)
      : mesh_(mesh), options_(options), constraints_(constraints), levels_(make_precision_levels(options)) {}

  bool is_first_level() const { return level_ == 0; }
  bool is_last_level() const { return level_ + 1 == levels_.size(); }
  void raise_level() { ++level_; }
  const Precision& precision() const { return levels_[level_]; }

  /// The state with the cells of this level. `report` is called with the fraction of the work that is done.
  RelaxationState evaluate(const std::vector<SurfacePoint>& generators, const std::function<void(double)>& report);
  /// The number of states.
  std::int64_t diagrams() const { return diagrams_; }

 private:
  const Mesh& mesh_;
  const LloydOptions& options_;
  const GeneratorConstraints& constraints_;
  std::vector<Precision> levels_;
  std::size_t level_ = 0;
  std::int64_t diagrams_ = 0;
};

}  // namespace gvd
