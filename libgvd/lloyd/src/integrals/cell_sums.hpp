#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geodesic/windows/nearest_paths.hpp"
#include "gvd/cell_moments.hpp"
#include "gvd/ids.hpp"
#include "integrals/path_samples.hpp"

namespace gvd {

/// Generators whose paths are wanted one by one: not 0 for each of them. Empty: none.
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
    if (!watched_->empty() && (*watched_)[path.generator]) {
      samples_.push_back(
          {path.generator, static_cast<float>(std::atan2(path.log.y(), path.log.x())), mass * path.distance});
    }
  }

  /// Joins the sums of all parts of the surface, in the order of the parts. If the parts do not depend on the number of
  /// threads, neither does rounding.
  static CellIntegrals join(std::size_t cells, const std::vector<CellSums>& parts) {
    CellIntegrals all;
    all.moments.resize(cells);
    for (const CellSums& part : parts) {
      for (const auto& [generator, moments] : part.sums_) add_to(all.moments[generator], moments);
      all.samples.insert(all.samples.end(), part.samples_.begin(), part.samples_.end());
    }
    for (CellMoments& cell : all.moments) {
      if (cell.mass > 0) cell.centroid /= cell.mass;
    }
    sort_by_generator(all.samples);
    return all;
  }

 private:
  struct Sum {
    GeneratorId generator;
    CellMoments moments;  // `centroid` is not yet divided by the mass
  };
  static void add_to(CellMoments& cell, const CellMoments& part) {
    cell.area += part.area;
    cell.mass += part.mass;
    cell.energy += part.energy;
    cell.centroid += part.centroid;
  }

  const WatchedGenerators* watched_;
  std::vector<Sum> sums_;
  std::vector<PathSample> samples_;
};

}  // namespace gvd
