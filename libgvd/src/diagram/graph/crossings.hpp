#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

using CrossingId = Id<struct CrossingTag>;

/// Least distance of crossings from each other and from the ends of their edge, relative to the edge: a hundred times
/// the symbolic offset of marched distances, and far above rounding.
inline constexpr double kCrossingGap = 1e-7;

/// The point where a bisector crosses an edge. It is stored once, on the edge, so that the two faces can't disagree.
struct Crossing {
  EdgeId edge;
  double t;            ///< parameter along the edge's halfedge, strictly between 0 and 1
  GeneratorId before;  ///< the cell on the side of the halfedge's first vertex
  GeneratorId after;   ///< the cell on the side of its second vertex
};

/// All crossings, ascending by edge and parameter.
/// Properties: (1) along an edge, `after` of a crossing is `before` of the next one; (2) the first `before` and the
/// last `after` are the labels of the edge's vertices; (3) `before` and `after` differ.
class Crossings {
 public:
  Crossings() = default;
  /// `items` must be ascending by (edge, t).
  Crossings(std::int32_t edge_count, std::vector<Crossing> items) : items_(std::move(items)), first_(edge_count, -1) {
    for (std::int32_t i = items_.count(); i-- > 0;) first_[items_.raw()[i].edge] = i;
  }

  std::size_t size() const { return items_.size(); }
  Crossing& operator[](CrossingId id) { return items_[id]; }
  const Crossing& operator[](CrossingId id) const { return items_[id]; }
  std::vector<Crossing>& items() { return items_.raw(); }
  const std::vector<Crossing>& items() const { return items_.raw(); }

  /// The crossings on edge e have the ids first(e) .. first(e) + count(e) - 1, ascending in t. `first` is invalid if
  /// there are none.
  CrossingId first(EdgeId e) const { return CrossingId(first_[e]); }
  std::int32_t count(EdgeId e) const {
    if (first_[e] < 0) return 0;
    std::int32_t i = first_[e];
    while (i < items_.count() && items()[i].edge == e) ++i;
    return i - first_[e];
  }

  /// Replaces the crossings of these edges, which must ascend, by other crossings of the same edges, ascending by
  /// (edge, t).
  void replace(const std::vector<EdgeId>& edges, const std::vector<Crossing>& replacements);

 private:
  IdVector<CrossingId, Crossing> items_;
  IdVector<EdgeId, std::int32_t> first_;
};

/// The point of a face's boundary at parameter t along the halfedge of a corner; the corner itself for 0.
inline Bary bary_on_side(int corner, double t) {
  Bary result{0, 0, 0};
  result[corner] = 1 - t;
  result[(corner + 1) % 3] = t;
  return result;
}

/// A crossing on the boundary of a face, as the face sees it counter-clockwise.
struct BoundaryCrossing {
  CrossingId id;
  int corner;            ///< it lies on the halfedge of this corner
  double t;              ///< parameter along that halfedge
  GeneratorId previous;  ///< the cell before it, counter-clockwise
  GeneratorId next;      ///< the cell after it

  /// Barycentric coordinates in the face.
  Bary bary() const { return bary_on_side(corner, t); }
};

/// The crossings on the boundary of f, counter-clockwise from its corner 0. `result` is overwritten; loops over faces
/// reuse it to save allocations.
inline void boundary_crossings(const Mesh& mesh, const Crossings& crossings, FaceId f,
                               std::vector<BoundaryCrossing>& result) {
  result.clear();
  for (int corner = 0; corner < 3; ++corner) {
    const HalfedgeId h = Mesh::halfedge(f, corner);
    const EdgeId e = mesh.edge(h);
    const std::int32_t count = crossings.count(e);
    const bool along = mesh.halfedge(e) == h;
    for (std::int32_t k = 0; k < count; ++k) {
      const CrossingId id(crossings.first(e).value() + (along ? k : count - 1 - k));
      const Crossing& c = crossings[id];
      result.push_back(along ? BoundaryCrossing{id, corner, c.t, c.before, c.after}
                             : BoundaryCrossing{id, corner, 1 - c.t, c.after, c.before});
    }
  }
}

inline std::vector<BoundaryCrossing> boundary_crossings(const Mesh& mesh, const Crossings& crossings, FaceId f) {
  std::vector<BoundaryCrossing> result;
  boundary_crossings(mesh, crossings, f, result);
  return result;
}

/// The number of crossings on the boundary of every face.
IdVector<FaceId, std::int32_t> count_by_face(const Mesh& mesh, const Crossings& crossings);

/// The faces that have a crossing on their boundary, ascending.
std::vector<FaceId> crossed_faces(const IdVector<FaceId, std::int32_t>& counts);
std::vector<FaceId> crossed_faces(const Mesh& mesh, const Crossings& crossings);

}  // namespace gvd
