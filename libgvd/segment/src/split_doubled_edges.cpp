#include "split_doubled_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace gvd {
namespace {

using Triangle = std::array<VertexId, 3>;

/// The polygon of a side that lies between two polygons.
constexpr std::int32_t kBetween = -1;

/// A side of a triangle; its ends ascend.
struct Side {
  VertexId low;
  VertexId high;
  FaceId parent;
  std::int32_t polygon;
  bool operator<(const Side& other) const {
    return std::tie(low, high, parent, polygon) < std::tie(other.low, other.high, other.parent, other.polygon);
  }
  bool joins_same(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> collect_sides_of_cut_parents(const CutTriangles& cut) {
  std::vector<Side> sides;
  for (std::size_t first = 0, last = 0; first < cut.faces.size(); first = last) {
    last = end_of_parent(cut, first);
    if (last - first == 1) continue;
    for (std::size_t t = first; t < last; ++t) {
      const Triangle& f = cut.faces[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(f[i], f[(i + 1) % 3]);
        sides.push_back({low, high, cut.parent[FaceId(std::int64_t(t))], cut.polygon[FaceId(std::int64_t(t))]});
      }
    }
  }
  return sides;
}

/// Appends the edges inside parents among the sides `begin` to `end`, which have the same ends: diagonals of polygons,
/// and edges between two polygons.
void append_inner_edges(const Side* begin, const Side* end, std::vector<Side>& edges) {
  const Side* single = nullptr;
  for (const Side* side = begin; side != end; ++side) {
    if (side + 1 != end && side[1].parent == side->parent && side[1].polygon == side->polygon) {
      edges.push_back(*side++);
    } else if (single && single->parent == side->parent) {
      edges.push_back({side->low, side->high, side->parent, kBetween});
      single = nullptr;
    } else {
      single = side;
    }
  }
}

/// The edges inside parents whose two ends are those of sides of more than two triangles, sorted by parent. A diagonal
/// comes before an edge between two polygons with the same ends.
std::vector<Side> find_doubled_edges(const CutTriangles& cut) {
  std::vector<Side> sides = collect_sides_of_cut_parents(cut), doubled;
  std::sort(sides.begin(), sides.end());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].joins_same(sides[first])) ++last;
    if (last - first > 2) append_inner_edges(sides.data() + first, sides.data() + last, doubled);
  }
  std::sort(doubled.begin(), doubled.end(), [](const Side& a, const Side& b) {
    return std::tie(a.parent, a.low, a.high, b.polygon) < std::tie(b.parent, b.low, b.high, a.polygon);
  });
  return doubled;
}

class Splitter {
 public:
  Splitter(CutTriangles& cut, std::vector<Side> doubled) : cut_(cut), doubled_(std::move(doubled)) {}

  void run() {
    auto next = doubled_.begin();
    for (std::size_t first = 0, last = 0; first < cut_.faces.size(); first = last) {
      last = end_of_parent(cut_, first);
      const FaceId parent = cut_.parent[FaceId(std::int64_t(first))];
      const std::size_t begin = faces_.size();
      for (std::size_t t = first; t < last; ++t) {
        add(cut_.faces[t], parent, cut_.label[FaceId(std::int64_t(t))], cut_.polygon[FaceId(std::int64_t(t))]);
      }
      for (; next != doubled_.end() && next->parent == parent; ++next) split(*next, begin);
    }
    cut_.faces = std::move(faces_);
    cut_.parent = std::move(parent_);
    cut_.label = std::move(label_);
    cut_.polygon = std::move(polygon_);
  }

 private:
  void add(const Triangle& face, FaceId parent, GeneratorId label, std::int32_t polygon) {
    faces_.push_back(face);
    parent_.push_back(parent);
    label_.push_back(label);
    polygon_.push_back(polygon);
  }

  /// Halves the triangles from `begin` on that have the edge as a side; only those of its polygon if it is a diagonal.
  void split(const Side& edge, std::size_t begin) {
    const VertexId middle(cut_.positions.size());
    cut_.positions.push_back(0.5 * (cut_.positions[edge.low.index()] + cut_.positions[edge.high.index()]));
    const std::size_t end = faces_.size();
    for (std::size_t t = begin; t < end; ++t) {
      const std::int32_t polygon = polygon_[FaceId(std::int64_t(t))];
      if (edge.polygon != kBetween && edge.polygon != polygon) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const Triangle f = faces_[t];
        const VertexId from = f[i], to = f[(i + 1) % 3], apex = f[(i + 2) % 3];
        if (std::min(from, to) != edge.low || std::max(from, to) != edge.high) continue;
        faces_[t] = {from, middle, apex};
        add({middle, to, apex}, edge.parent, label_[FaceId(std::int64_t(t))], polygon);
        break;
      }
    }
  }

  CutTriangles& cut_;
  std::vector<Side> doubled_;
  std::vector<Triangle> faces_;
  IdVector<FaceId, FaceId> parent_;
  IdVector<FaceId, GeneratorId> label_;
  IdVector<FaceId, std::int32_t> polygon_;
};

}  // namespace

void split_doubled_edges(CutTriangles& cut) {
  std::vector<Side> doubled = find_doubled_edges(cut);
  if (!doubled.empty()) Splitter(cut, std::move(doubled)).run();
}

}  // namespace gvd
