#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/prefetch.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// A vertex, by its place on a curve that fills the mesh's bounding box.
using PlaceId = Id<struct PlaceTag>;

/// The faces round each vertex as a march reads them: one after the other in memory, and near vertices close together.
///
/// A `Mesh` has its elements in the order of its file, and walking round a fan in it is a chain of look-ups. On a mesh
/// that does not fit into the cache, these look-ups would take most of the time of a march. Memory: about 120 bytes a
/// face.
class MarchFans {
 public:
  /// An edge of a vertex, and the face on its left as seen from that vertex.
  struct Spoke {
    PlaceId end;        ///< the edge's other vertex
    double length;      ///< the edge's length, mesh units
    double rim;         ///< length of the face's side opposite the vertex
    double twice_area;  ///< twice the face's area; negative at the end of an open fan, which has no face there
    bool has_face() const { return twice_area >= 0; }
  };

  /// `progress` is called with the step "sampling" and the fraction 0, so that it can cancel. Cost: O(n).
  explicit MarchFans(const Mesh& mesh, const Progress& progress = {});

  PlaceId place(VertexId v) const { return place_[v]; }
  VertexId vertex(PlaceId p) const { return vertex_[p]; }

  /// The spokes of a vertex, counter-clockwise from `mesh.halfedge(v)`. The face of a spoke ends at the next spoke; in
  /// a closed fan, the face of the last spoke ends at the first.
  std::span<const Spoke> spokes(PlaceId p) const {
    return {spokes_.data() + first_[p.index()], spokes_.data() + first_[p.index() + 1]};
  }
  /// Prefetches the spokes of a vertex with up to kPrefetchedFaces faces.
  void prefetch(PlaceId p) const {
    const Spoke* const first = spokes_.data() + first_[p.index()];
    for (std::size_t i = 0; i <= kPrefetchedFaces; i += kSpokesOfLine) gvd::prefetch(first + i);
  }

 private:
  static constexpr std::size_t kPrefetchedFaces = 6;                // most vertices have no more
  static constexpr std::size_t kSpokesOfLine = 64 / sizeof(Spoke);  // in a cache line

  IdVector<VertexId, PlaceId> place_;
  IdVector<PlaceId, VertexId> vertex_;
  std::vector<Spoke> spokes_;
  std::vector<std::uint32_t> first_;  // index of each place's first spoke, and the end
};

}  // namespace gvd
