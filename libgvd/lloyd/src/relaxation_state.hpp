#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "cell_integrals.hpp"
#include "constraints.hpp"
#include "gvd/lloyd.hpp"
#include "optimiser.hpp"

namespace gvd {

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
  std::vector<BisectorSegment> segments;       ///< of all bisectors, sorted by cells
  IdVector<VertexId, double> vertex_distance;  ///< to the nearest generator, mesh units; infinity where none reaches
  double energy = 0;
  /// The ways to the centroids, projected to where the generators may go; at a vertex the steepest way. Mesh units.
  TangentField to_centroids;
  double residual = 0;  ///< length of the longest way
  /// Whether each generator is at a vertex where no short step, or hardly any, lowers the energy of its cell.
  std::vector<char> is_resting;
  /// The vertex nearby at which each generator would rest, if any (see vertex_rests.hpp).
  std::vector<std::optional<VertexId>> rest;
  double mean_cell_radius = 0;  ///< sqrt(area / (pi cells)), mesh units
};

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
/// different levels must not be compared with each other: they differ by the errors at the bisectors.
std::vector<Precision> make_precision_levels(const LloydOptions& options);

/// Computes the states of a relaxation with the diagrams of one level of precision after the other.
class StateEvaluator {
 public:
  /// Begins at the first level. All arguments have to outlive this.
  StateEvaluator(const Mesh& mesh, const LloydOptions& options, const GeneratorConstraints& constraints)
      : mesh_(mesh), options_(options), constraints_(constraints), levels_(make_precision_levels(options)) {}

  bool is_first_level() const { return level_ == 0; }
  bool is_last_level() const { return level_ + 1 == levels_.size(); }
  /// Whether more than one level follows.
  bool is_early_level() const { return level_ + 2 < levels_.size(); }
  void raise_level() { ++level_; }
  /// Where more than one level follows, goes to the last but one.
  void skip_early_levels() {
    while (is_early_level()) raise_level();
  }
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
