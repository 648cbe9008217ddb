// Finds the faces and vertices that two working meshes of the same input have in common.
//
// Points are inserted edge by edge, then face by face, and flips stay inside one face of the input. So the order of a
// face's parts depends only on the points in the face and on its sides. If we leave out the parts of faces whose points
// differ, the appended parts of both meshes correspond one by one.
#include "mesh/common_elements.hpp"

#include <algorithm>
#include <cstdint>

namespace gvd {

CommonElements find_common_elements(const WorkingMesh& before, const WorkingMesh& after,
                                    const ChangedGenerators& changed) {
  const Mesh &input = after.input(), &old_mesh = before.mesh(), &mesh = after.mesh();
  IdVector<FaceId, std::uint8_t> differs(input.face_count(), 0);
  for (const SurfacePoint& point : changed.points) {
    if (point.kind() == SurfacePoint::Kind::vertex) continue;
    for (const FaceId f : faces_around(input, point)) differs[f] = 1;
  }
  CommonElements common{IdVector<FaceId, FaceId>(mesh.face_count()),
                        IdVector<FaceId, FaceId>(old_mesh.face_count()),
                        IdVector<VertexId, VertexId>(mesh.vertex_count()),
                        {},
                        {}};
  const auto is_common = [&](const WorkingMesh& working, FaceId f) { return differs[working.parent(f)] == 0; };
  FaceId old_face(input.face_count());  // the next appended part of `before`
  for (const FaceId f : mesh.faces()) {
    if (!is_common(after, f)) {
      common.only_after.push_back(f);
      continue;
    }
    FaceId other = f;
    if (f.value() >= input.face_count()) {
      while (!is_common(before, old_face)) old_face = FaceId(old_face.value() + 1);
      other = old_face;
      old_face = FaceId(old_face.value() + 1);
    }
    common.before[f] = other;
    common.after[other] = f;
  }
  for (const FaceId f : old_mesh.faces()) {
    if (!common.after[f].valid()) common.only_before.push_back(f);
  }
  for (const VertexId v : input.vertices()) common.vertex_before[v] = v;
  IdVector<GeneratorId, std::uint8_t> has_changed(after.generator_vertices().size(), 0);
  for (const GeneratorId g : changed.after) has_changed[g] = 1;
  for (const GeneratorId g : has_changed.ids()) {
    if (has_changed[g] == 0) common.vertex_before[after.vertex(g)] = before.vertex(g);
  }
  return common;
}

}  // namespace gvd
