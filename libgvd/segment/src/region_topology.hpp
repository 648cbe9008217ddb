#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {

using FaceLabelling = IdVector<FaceId, GeneratorId>;

/// Calls visit(g) for every face g that shares an edge with f; twice if it shares two edges.
template <class Visit>
void for_each_adjacent_face(const Mesh& mesh, FaceId f, Visit visit) {
  for (const HalfedgeId h : Mesh::halfedges(f)) {
    if (mesh.twin(h).valid()) visit(Mesh::face(mesh.twin(h)));
  }
}

/// Calls visit(face) for each face around v until one call returns false. Returns whether all calls returned true.
template <class Visit>
bool for_each_face_round(const Mesh& mesh, VertexId v, Visit visit) {
  const HalfedgeId start = mesh.halfedge(v);
  HalfedgeId h = start;
  do {
    if (!visit(Mesh::face(h))) return false;
    h = next_outgoing(mesh, h);
  } while (h.valid() && h != start);
  return true;
}

/// Searches through the faces of one label.
class RegionSearch {
 public:
  /// Refers to both arguments, which must outlive this object.
  RegionSearch(const Mesh& mesh, const FaceLabelling& label) : mesh_(mesh), label_(label) {}

  /// Whether the faces `targets`, at least one and all with the same label, are connected through edges between faces
  /// with this label. Cost: O(n) for a region of n faces, less if the targets are near each other.
  bool connects(std::span<const FaceId> targets);

  std::int64_t visited_faces() const { return visited_faces_; }  ///< by all searches so far

 private:
  const Mesh& mesh_;
  const FaceLabelling& label_;
  std::vector<FaceId> queue_;
  IdVector<FaceId, std::int32_t> last_search_;  // the last search that visited each face
  std::int32_t searches_ = 0;
  std::int64_t visited_faces_ = 0;
};

/// A face and its new label.
struct FaceChange {
  FaceId face;
  GeneratorId label;
};

/// Changes labels if that keeps the topology of all regions.
///
/// Properties of an allowed change: (1) the faces of every label stay connected, and no label vanishes; (2) the Euler
/// characteristic of every open region does not change, so discs stay discs; (3) no region touches itself at a vertex
/// more often than before.
class RegionTopology {
 public:
  /// Refers to both arguments, which must outlive this object. Nothing else may change `label` meanwhile.
  RegionTopology(const Mesh& mesh, FaceLabelling& label) : mesh_(mesh), label_(label), search_(mesh, label) {}

  /// Whether face f alone can change to another label. Cost: O(1), O(log n) at a vertex with many faces.
  bool allows(FaceId f, GeneratorId to);

  /// Changes the label of a face, whether or not that is allowed. Cost: as for `allows`.
  void relabel(FaceId f, GeneratorId to);

  /// Changes the labels of all these faces together if the result has the same topology, even if single steps would
  /// lose it. Returns whether it changed them. Refuses if one of their vertices has more than kLongestFan faces, and
  /// after all calls together have searched through the mesh kMostSearches times.
  /// Cost: O(k log k) for k faces, and a search through each region that changes.
  bool relabel_together(std::span<const FaceChange> changes);

 private:
  struct Fan {
    std::int32_t faces = 0, with_label = 0;
  };
  struct Patch;

  Fan count_faces_round(VertexId v, GeneratorId g);
  void describe(Patch& patch) const;
  bool is_connected(const Patch& patch);

  const Mesh& mesh_;
  FaceLabelling& label_;
  RegionSearch search_;
  // For vertices with many faces, the number of faces of each label.
  std::map<VertexId, std::map<GeneratorId, std::int32_t>> large_fans_;
};

/// For vertices with more faces, a count of each label is kept up to date, because walking around the tip of a cone for
/// each of its n faces would take O(n^2).
inline constexpr int kLongestFan = 256;

/// The limit on searches, in faces of the whole mesh, which keeps the cost linear for hostile meshes.
inline constexpr std::int64_t kMostSearches = 16;

}  // namespace gvd
