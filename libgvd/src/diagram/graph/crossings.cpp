// The crossings of all edges as one sorted list.
//
// A crossing is stored once, on its edge; both faces read it from there (BoundaryCrossing reverses it if the face runs
// through the edge backwards). Two faces therefore can't disagree about a bisector, whatever the distances are. A
// tracer that crosses some edges again replaces all their crossings at once, which changes the ids of crossings.
// The list costs 24 bytes a crossing and 4 bytes an edge; most edges have none. Replacing costs one pass over the list.
#include "diagram/graph/crossings.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gvd {

void Crossings::replace(const std::vector<EdgeId>& edges, const std::vector<Crossing>& replacements) {
  std::vector<Crossing> kept, all;
  std::copy_if(items().begin(), items().end(), std::back_inserter(kept),
               [&](const Crossing& c) { return !std::binary_search(edges.begin(), edges.end(), c.edge); });
  std::merge(kept.begin(), kept.end(), replacements.begin(), replacements.end(), std::back_inserter(all),
             [](const Crossing& a, const Crossing& b) { return a.edge < b.edge; });
  *this = Crossings(first_.count(), std::move(all));
}

IdVector<FaceId, std::int32_t> count_by_face(const Mesh& mesh, const Crossings& crossings) {
  IdVector<FaceId, std::int32_t> counts(mesh.face_count(), 0);
  for (const Crossing& c : crossings.items()) {
    const HalfedgeId h = mesh.halfedge(c.edge), twin = mesh.twin(h);
    ++counts[Mesh::face(h)];
    if (twin.valid()) ++counts[Mesh::face(twin)];
  }
  return counts;
}

std::vector<FaceId> crossed_faces(const IdVector<FaceId, std::int32_t>& counts) {
  std::vector<FaceId> faces;
  std::copy_if(counts.ids().begin(), counts.ids().end(), std::back_inserter(faces),
               [&](FaceId f) { return counts[f] > 0; });
  return faces;
}

std::vector<FaceId> crossed_faces(const Mesh& mesh, const Crossings& crossings) {
  return crossed_faces(count_by_face(mesh, crossings));
}

}  // namespace gvd
