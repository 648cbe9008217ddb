// Vertices within a tolerance of each other move to one place, where the repair makes one vertex of them.
//
// Points are sorted into boxes whose side is the tolerance over the root of 3, so that two points of one box are within
// the tolerance, and points within the tolerance at most two boxes apart. The boxes are in the order of x, y and z.
// The boxes near a box lie in 25 rows along z, and by symmetry the 13 rows that do not come before it suffice. Where a
// row begins moves forward only, as the boxes do, so that each row costs one walk over all boxes. Invariant: union-find
// unites exactly the pairs within the tolerance, and their chains, whatever their order.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/union_find.hpp"
#include "gvd/text.hpp"
#include "mesh/repair/repair_steps.hpp"

namespace gvd {
namespace {

/// The side of a box, in tolerances: below 1 / sqrt(3) = .57735 by far more than the rounding of a box's number.
constexpr double kBoxSide = 0.577;
/// Points within the tolerance are fewer than 1 / kBoxSide + 1 < 3 boxes apart along each axis.
constexpr int kReach = 2;

/// Box numbers are whole, but may be too large for an integer. From 2^53 on, neighbours of a double are farther apart
/// than the tolerance, and only equal points share a box.
using Box = std::array<double, 3>;

struct Boxes {
  std::vector<Box> box;                // ascending
  std::vector<std::size_t> first;      // per box its first entry in `vertices`, and the number of all at the end
  std::vector<std::int32_t> vertices;  // box by box, ascending in each
};

Boxes sort_into_boxes(const std::vector<Vec3>& positions, double tolerance) {
  const double side = kBoxSide * tolerance;
  std::vector<PlacedVertex> placed;
  placed.reserve(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto number = [&](int axis) { return std::floor(positions[v][axis] / side) + 0.0; };
    placed.push_back({{number(0), number(1), number(2)}, std::int32_t(v)});
  }
  std::sort(placed.begin(), placed.end());
  Boxes boxes;
  boxes.vertices.reserve(placed.size());
  for (const auto& [box, v] : placed) {
    if (boxes.box.empty() || boxes.box.back() != box) {
      boxes.box.push_back(box);
      boxes.first.push_back(boxes.vertices.size());
    }
    boxes.vertices.push_back(v);
  }
  boxes.first.push_back(boxes.vertices.size());
  return boxes;
}

/// Unites vertices of two boxes where one pair is within the tolerance: each box is in one set already.
void unite_boxes(const std::vector<Vec3>& positions, double tolerance, const Boxes& boxes, std::size_t a, std::size_t b,
                 UnionFind& welded) {
  if (welded.find(boxes.vertices[boxes.first[a]]) == welded.find(boxes.vertices[boxes.first[b]])) return;
  for (std::size_t i = boxes.first[a]; i < boxes.first[a + 1]; ++i) {
    for (std::size_t j = boxes.first[b]; j < boxes.first[b + 1]; ++j) {
      const std::int32_t v = boxes.vertices[i], w = boxes.vertices[j];
      if (!((positions[v] - positions[w]).stableNorm() <= tolerance)) continue;
      welded.unite(v, w);
      return;
    }
  }
}

/// Unites each box with those at most kReach away along z in the row that is dx and dy away.
void unite_row(const std::vector<Vec3>& positions, double tolerance, const Boxes& boxes, int dx, int dy,
               UnionFind& welded) {
  std::size_t begin = 0;
  for (std::size_t a = 0; a < boxes.box.size(); ++a) {
    const auto& [x, y, z] = boxes.box[a];
    const Box low{x + dx, y + dy, z - kReach}, high{x + dx, y + dy, z + kReach};
    while (begin < boxes.box.size() && boxes.box[begin] < low) ++begin;
    for (std::size_t b = begin; b < boxes.box.size() && boxes.box[b] <= high; ++b) {
      if (a != b) unite_boxes(positions, tolerance, boxes, a, b, welded);
    }
  }
}

UnionFind find_clusters(const std::vector<Vec3>& positions, double tolerance) {
  UnionFind welded(positions.size());
  const Boxes boxes = sort_into_boxes(positions, tolerance);
  for (std::size_t a = 0; a < boxes.box.size(); ++a) {
    for (std::size_t i = boxes.first[a]; i < boxes.first[a + 1]; ++i) {
      welded.unite(boxes.vertices[boxes.first[a]], boxes.vertices[i]);
    }
  }
  for (int dx = 0; dx <= kReach; ++dx) {
    for (int dy = dx == 0 ? 0 : -kReach; dy <= kReach; ++dy) unite_row(positions, tolerance, boxes, dx, dy, welded);
  }
  return welded;
}

/// Moves each vertex to the first one of its cluster, and notes chains of pairs that are longer than the tolerance.
void join_clusters(PolygonSoup& soup, double tolerance) {
  UnionFind welded = find_clusters(soup.positions, tolerance);
  std::int64_t far = 0;
  double farthest = 0;
  std::int32_t clusters = 0;
  for (std::int32_t v = 0; v < std::ssize(soup.positions); ++v) {
    const std::int32_t first = welded.find(v);
    clusters += first == v;
    const double moved = (soup.positions[v] - soup.positions[first]).stableNorm();
    far += moved > tolerance;
    farthest = std::max(farthest, moved);
    soup.positions[v] = Vec3(soup.positions[first]);  // a first vertex stays where it is
  }
  if (clusters <= 1) {
    refuse_soup(fmt::format("welding within {:g} joins all vertices: choose a smaller tolerance", tolerance), -1);
  }
  if (far == 0) return;
  soup.notes.push_back(
      fmt::format("welding within {:g} joins chains of vertices, and moves {} farther than that, by up to {:.4g}: a "
                  "smaller tolerance keeps them apart",
                  tolerance, counted(far, "vertex", "vertices"), farthest));
}

}  // namespace

void weld_soup(PolygonSoup& soup, double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance)) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("weld: the tolerance {:g} is not a finite number from 0 on", tolerance));
  }
  soup.unwelded = true;
  soup.weld_tolerance = tolerance;
  const bool is_finite =
      std::all_of(soup.positions.begin(), soup.positions.end(), [](const Vec3& p) { return p.allFinite(); });
  if (tolerance > 0 && is_finite && !soup.positions.empty())
    join_clusters(soup, tolerance);  // build_mesh refuses others
}

}  // namespace gvd
