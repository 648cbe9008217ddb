// Moves vertices within a tolerance of each other to the same place, where the repair welds them. Vertices that no
// polygon uses take no part, because the surface must not move to a vertex that is dropped afterwards.
//
// In the order of their numbers, each vertex stays unless an earlier vertex that stays is within the tolerance. Then
// every other vertex moves to the nearest vertex that stays. Joining all chains of near pairs instead could move
// vertices by many tolerances, would collapse a mesh whose edges are shorter than the tolerance, and could compare all
// pairs. Vertices that stay are farther apart than the tolerance, so a ball holds only few of them, however many
// vertices lie in it. They are found through the sorted cells of a grid.
// Source: the leader algorithm, J. A. Hartigan, Clustering Algorithms, 1975, chapter 3.
// Invariant: where a vertex moves depends only on the vertices that stay, and not on the order in which cells list
// them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gvd/text.hpp"
#include "mesh/repair/clean_polygons.hpp"
#include "mesh/repair/defect_log.hpp"

namespace gvd {
namespace {

/// The side of a cell, in tolerances. With 4, half of the balls cross a side of their cell along each axis, and a cell
/// holds at most 176 vertices that stay, because balls of half a tolerance fill at most 74 % of a cube of 5 tolerances.
constexpr double kCellSide = 4;
/// Cells are searched up to this multiple of the tolerance. Dimensionless; the excess is far above the rounding of a
/// distance, so that no vertex within the tolerance lies in a cell that is not searched.
constexpr double kReach = 1 + 1e-12;

/// The numbers of a cell are whole, but may be too large for an integer type.
using GridCell = std::array<double, 3>;

/// The next whole number that a double can hold. Beyond 2^53, these are more than 1 apart.
double next_whole(double number) { return std::max(number + 1, std::nextafter(number, kInfinity)); }

/// The vertex nearest to a given one among the vertices that stay.
struct NearestStaying {
  std::int32_t vertex = -1;
  double squared = kInfinity;  // its squared distance, in square mesh units
  std::int32_t count = 0;      // number of vertices that stay within the tolerance
};

/// Stores the vertices that stay, by the cells of a grid.
class StayingVertices {
 public:
  StayingVertices(const std::vector<Vec3>& positions, double tolerance)
      : positions_(positions), tolerance_(tolerance), cell_of_(positions.size()), next_(positions.size(), -1) {
    std::vector<PlacedVertex> placed;
    placed.reserve(positions.size());
    for (const Vec3& p : positions) placed.emplace_back(cell_at(p), std::int32_t(placed.size()));
    std::sort(placed.begin(), placed.end());
    for (const auto& [cell, v] : placed) {
      if (cells_.empty() || cells_.back() != cell) cells_.push_back(cell);
      cell_of_[v] = std::int32_t(cells_.size() - 1);
    }
    first_.assign(cells_.size(), -1);
  }

  void add(std::int32_t v) {
    std::int32_t& first = first_[cell_of_[v]];
    next_[v] = first;
    first = v;
    ++count_;
  }
  std::int32_t count() const { return count_; }

  /// Whether a vertex that stays is within the tolerance of v. Copies find such a vertex in their own cell, without
  /// searching other cells.
  bool covers(std::int32_t v) const {
    NearestStaying nearest;
    look_into(cell_of_[v], positions_[v], nearest);
    return nearest.count > 0 || find_nearest(v).count > 0;
  }

  /// The nearest vertex that stays, within the tolerance of v. Among equally near ones, the vertex with the smallest
  /// number wins.
  NearestStaying find_nearest(std::int32_t v) const {
    const Vec3& p = positions_[v];
    NearestStaying nearest;
    look_into(cell_of_[v], p, nearest);
    if (nearest.squared == 0) return nearest;  // for a copy, no other vertex that stays is within the tolerance
    nearest = {};
    const Vec3 reach = Vec3::Constant(kReach * tolerance_);
    const GridCell low = cell_at(p - reach), high = cell_at(p + reach);
    for (double x = low[0]; x <= high[0]; x = next_whole(x)) {
      for (double y = low[1]; y <= high[1]; y = next_whole(y)) {
        const auto begin = std::lower_bound(cells_.begin(), cells_.end(), GridCell{x, y, low[2]});
        const GridCell last{x, y, high[2]};
        for (auto at = begin; at != cells_.end() && *at <= last; ++at) look_into(at - cells_.begin(), p, nearest);
      }
    }
    return nearest;
  }

 private:
  GridCell cell_at(const Vec3& p) const {
    const auto number = [&](double x) { return std::floor(x / (kCellSide * tolerance_)); };
    return {number(p.x()), number(p.y()), number(p.z())};
  }

  void look_into(std::ptrdiff_t cell, const Vec3& p, NearestStaying& nearest) const {
    for (std::int32_t w = first_[cell]; w >= 0; w = next_[w]) {
      const double squared = (positions_[w] - p).squaredNorm();
      if (squared > tolerance_ * tolerance_) continue;
      ++nearest.count;
      if (squared > nearest.squared || (squared == nearest.squared && w > nearest.vertex)) continue;
      nearest.vertex = w;
      nearest.squared = squared;
    }
  }

  const std::vector<Vec3>& positions_;  // reads only the positions of vertices that stay
  double tolerance_;                    // mesh units
  std::vector<GridCell> cells_;         // ascending
  std::vector<std::int32_t> cell_of_;   // per vertex
  std::vector<std::int32_t> first_;     // per cell, the first vertex that stays in it; -1 for none
  std::vector<std::int32_t> next_;      // per vertex, the next vertex that stays in its cell; -1 for none
  std::int32_t count_ = 0;
};

[[noreturn]] void refuse_joining_all(double tolerance) {
  refuse_soup(fmt::format("welding within {:g} joins all vertices: choose a smaller tolerance", tolerance), -1);
}

/// Moves vertices as described at the head of this file. Adds a note if vertices had a choice, because the mesh is then
/// finer than the tolerance.
void move_to_staying(PolygonSoup& soup, const std::vector<char>& used, double tolerance) {
  StayingVertices staying(soup.positions, tolerance);
  std::vector<char> stays(soup.positions.size(), 0);
  for (std::int32_t v = 0; v < std::ssize(soup.positions); ++v) {
    if (!used[v] || staying.covers(v)) continue;
    staying.add(v);
    stays[v] = 1;
  }
  if (staying.count() == 1) refuse_joining_all(tolerance);
  std::int64_t between = 0;
  for (std::int32_t v = 0; v < std::ssize(soup.positions); ++v) {
    if (!used[v] || stays[v]) continue;
    const NearestStaying nearest = staying.find_nearest(v);
    between += nearest.count > 1;
    soup.positions[v] = Vec3(soup.positions[nearest.vertex]);
  }
  if (between == 0) return;
  soup.notes.push_back(
      fmt::format("welding within {:g}: {} several others within the tolerance, and {} joined only to the nearest. "
                  "Choose a smaller tolerance to join copies only",
                  tolerance, counted(between, "vertex had", "vertices had"), between == 1 ? "was" : "were"));
}

}  // namespace

void weld_soup(PolygonSoup& soup, double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance)) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("weld: the tolerance {:g} is not a finite number from 0 on", tolerance));
  }
  if (tolerance > 0 && tolerance < kSmallestWeld) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("weld: the tolerance {:g} is below {:g}; 0 joins exact copies", tolerance, kSmallestWeld));
  }
  soup.unwelded = true;
  soup.weld_tolerance = tolerance;
  const std::vector<char> used = find_used_vertices(soup);
  if (tolerance == 0 || std::ranges::find(used, 1) == used.end()) return;
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < used.size(); ++v) {
    const Vec3& p = soup.positions[v];
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kLargestCoordinate) return;  // `build_mesh` refuses this position
    if (used[v]) box.extend(p);
  }
  if (tolerance >= box.sizes().norm()) refuse_joining_all(tolerance);
  move_to_staying(soup, used, tolerance);
}

}  // namespace gvd
