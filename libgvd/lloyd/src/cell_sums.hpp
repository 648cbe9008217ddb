#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/windows/nearest_paths.hpp"
#include "gvd/cell_moments.hpp"
#include "gvd/ids.hpp"

// The results of integration over cells, whether they come from a diagram (window_integrals.hpp) or are measured
// without one (measured_cells.hpp).

namespace gvd {

/// A path to a point of a cell, as the energy's slope at the generator sees it.
struct PathSample {
  GeneratorId generator;
  float angle;    ///< tangent angle in which the path departs, radians
  double weight;  ///< distance times the mass that the point stands for, mesh units cubed: a float may overflow
};

/// The samples of generator g among sorted ones. Cost: O(log k).
std::span<const PathSample> samples_of(const std::vector<PathSample>& sorted, GeneratorId g);

/// Marks generators whose paths are wanted one by one: not 0 for each of them. Empty: none.
using WatchedGenerators = IdVector<GeneratorId, char>;

/// The integrals over all cells.
struct CellIntegrals {
  IdVector<GeneratorId, CellMoments> moments;
  std::vector<PathSample> samples;  ///< of watched generators, sorted by generator
};

/// Sums over points of the cells, by one thread.
class CellSums {
 public:
  /// `watched` has to outlive this.
  explicit CellSums(const WatchedGenerators& watched) : watched_(&watched) {}

  /// Adds a point of cell g that stands for a piece of the surface. `spread` is the mean squared distance of the piece
  /// from the point, square mesh units, >= 0. Fast where points of one cell follow each other.
  void add(GeneratorId g, double area, double mass, const NearestPath& path, double spread) {
    if (sums_.empty() || sums_.back().generator != g) sums_.push_back({g, {}});
    CellMoments& sum = sums_.back().moments;
    sum.area += area;
    sum.mass += mass;
    if (!path.generator.valid()) return;  // where none reaches
    sum.energy += mass * (path.distance * path.distance + spread);
    sum.centroid += mass * path.log;
    if (watched_->empty() || !(*watched_)[path.generator]) return;
    const double angle = std::atan2(path.log.y(), path.log.x());
    samples_.push_back({path.generator, static_cast<float>(angle), mass * path.distance});
  }

  /// Joins the sums of all parts of the surface, in the order of the parts. If the parts do not depend on the number of
  /// threads, neither does rounding.
  static CellIntegrals join(std::size_t cells, const std::vector<CellSums>& parts);

 private:
  struct Sum {
    GeneratorId generator;
    CellMoments moments;  // `centroid` is not yet divided by the mass
  };

  const WatchedGenerators* watched_;
  std::vector<Sum> sums_;
  std::vector<PathSample> samples_;
};

/// A straight piece of the bisector of two cells.
struct BisectorSegment {
  GeneratorId left, right;  ///< the lesser one first
  Vec3 from, to;
  double length = 0;   ///< of the bisector that it stands for, mesh units
  double density = 1;  ///< mean over the segment
};

/// The segments of all bisectors of a diagram between different cells, bisector by bisector, sorted by their cells.
/// Cost: O(points), and sorting.
std::vector<BisectorSegment> bisector_segments(const Mesh& mesh, const Diagram& diagram, const Density& density = {});

/// Sorts segments by their cells, and keeps the order of those with the same cells. Cost: O(segments + cells).
void sort_by_cells(std::vector<BisectorSegment>& segments);

/// The pairs of cells that share sorted segments, each pair once, ascending. Cost: O(segments).
std::vector<std::pair<GeneratorId, GeneratorId>> neighbouring_cells(const std::vector<BisectorSegment>& segments);

}  // namespace gvd
