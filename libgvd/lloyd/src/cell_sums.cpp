// Sums over the points of cells, and the segments of their bisectors.
//
// Each thread sums over its own part of the surface. Points of one cell mostly follow each other, so a part has a list
// of short sums and no table of all cells. The parts are joined in their order, and sorting is stable: the result does
// not depend on the number of threads. Two counting sorts, by the second cell and then by the first one, order the
// segments of bisectors in linear time.
#include <algorithm>
#include <numeric>

#include "cell_integrals.hpp"

namespace gvd {
namespace {

/// Counting sort: keeps the order of segments with the same cell.
void sort_by(GeneratorId BisectorSegment::*cell, std::vector<BisectorSegment>& segments) {
  std::vector<std::size_t> begin;  // of each cell's segments
  for (const BisectorSegment& segment : segments) {
    const std::size_t next = (segment.*cell).index() + 1;
    if (begin.size() <= next) begin.resize(next + 1, 0);
    ++begin[next];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<BisectorSegment> sorted(segments.size());
  for (const BisectorSegment& segment : segments) sorted[begin[(segment.*cell).index()]++] = segment;
  segments = std::move(sorted);
}

}  // namespace

std::span<const PathSample> samples_of(const std::vector<PathSample>& sorted, GeneratorId g) {
  return {std::ranges::lower_bound(sorted, g, {}, &PathSample::generator),
          std::ranges::upper_bound(sorted, g, {}, &PathSample::generator)};
}

CellIntegrals CellSums::join(std::size_t cells, const std::vector<CellSums>& parts) {
  CellIntegrals all;
  all.moments.resize(cells);
  for (const CellSums& part : parts) {
    for (const auto& [generator, moments] : part.sums_) {
      CellMoments& cell = all.moments[generator];
      cell.area += moments.area;
      cell.mass += moments.mass;
      cell.energy += moments.energy;
      cell.centroid += moments.centroid;
    }
    all.samples.insert(all.samples.end(), part.samples_.begin(), part.samples_.end());
  }
  for (CellMoments& cell : all.moments) {
    if (cell.mass > 0) cell.centroid /= cell.mass;
  }
  std::ranges::stable_sort(all.samples, {}, &PathSample::generator);
  return all;
}

std::vector<BisectorSegment> bisector_segments(const Mesh& mesh, const Diagram& diagram, const Density& density) {
  std::vector<BisectorSegment> segments;
  for (const Bisector& bisector : diagram.bisectors) {
    if (bisector.left == bisector.right) continue;
    for (std::size_t k = 0; k + 1 < bisector.points.size(); ++k) {
      const SurfacePoint &from = bisector.points[k], &to = bisector.points[k + 1];
      const Vec3 p = position(mesh, from), q = position(mesh, to);
      const double mean_density = 0.5 * (density.at(from.face, from.bary) + density.at(to.face, to.bary));
      const auto [first, second] = std::minmax(bisector.left, bisector.right);
      segments.push_back({first, second, p, q, (q - p).norm(), mean_density});
    }
  }
  sort_by_cells(segments);
  return segments;
}

void sort_by_cells(std::vector<BisectorSegment>& segments) {
  sort_by(&BisectorSegment::right, segments);
  sort_by(&BisectorSegment::left, segments);
}

std::vector<std::pair<GeneratorId, GeneratorId>> neighbouring_cells(const std::vector<BisectorSegment>& segments) {
  std::vector<std::pair<GeneratorId, GeneratorId>> pairs;
  for (const BisectorSegment& segment : segments) pairs.emplace_back(segment.left, segment.right);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace gvd
