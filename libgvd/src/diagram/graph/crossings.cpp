#include "diagram/graph/crossings.hpp"

#include <algorithm>
#include <iterator>

namespace gvd {

void Crossings::replace(const std::vector<EdgeId>& edges, const std::vector<Crossing>& replacements) {
  std::vector<Crossing> kept, all;
  std::copy_if(items().begin(), items().end(), std::back_inserter(kept),
               [&](const Crossing& c) { return !std::binary_search(edges.begin(), edges.end(), c.edge); });
  std::merge(kept.begin(), kept.end(), replacements.begin(), replacements.end(), std::back_inserter(all),
             [](const Crossing& a, const Crossing& b) { return a.edge < b.edge; });
  *this = Crossings(static_cast<std::int32_t>(first_.size()), std::move(all));
}

IdVector<FaceId, std::int32_t> count_by_face(const Mesh& mesh, const Crossings& crossings) {
  IdVector<FaceId, std::int32_t> counts(static_cast<std::size_t>(mesh.face_count()), 0);
  for (const Crossing& c : crossings.items()) {
    const HalfedgeId h = mesh.halfedge(c.edge), twin = mesh.twin(h);
    ++counts[Mesh::face(h)];
    if (twin.valid()) ++counts[Mesh::face(twin)];
  }
  return counts;
}

std::vector<FaceId> crossed_faces(const IdVector<FaceId, std::int32_t>& counts) {
  std::vector<FaceId> faces;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const FaceId f(i);
    if (counts[f] > 0) faces.push_back(f);
  }
  return faces;
}

std::vector<FaceId> crossed_faces(const Mesh& mesh, const Crossings& crossings) {
  return crossed_faces(count_by_face(mesh, crossings));
}

}  // namespace gvd
