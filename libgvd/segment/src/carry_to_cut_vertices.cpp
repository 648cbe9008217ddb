#include <cstddef>
#include <limits>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/segment.hpp"

namespace gvd {
namespace {

/// Of two labels of faces at a vertex: the smaller one, and any before none.
GeneratorId smaller_label(GeneratorId a, GeneratorId b) { return !a.valid() || (b.valid() && b < a) ? b : a; }

}  // namespace

CutVertices carry_to_cut_vertices(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut) {
  const auto given = static_cast<std::size_t>(mesh.vertex_count());
  if (diagram.vertex_label.size() != given || diagram.vertex_distance.size() != given ||
      cut.mesh.vertex_count() < mesh.vertex_count()) {
    throw Error(ErrorCode::precondition, "the diagram or the cut mesh was made of another mesh");
  }
  CutVertices result{diagram.vertex_label, diagram.vertex_distance};
  const auto count = static_cast<std::size_t>(cut.mesh.vertex_count());
  result.label.resize(count);
  result.distance.resize(count, std::numeric_limits<double>::infinity());
  for (std::int32_t i = 0; i < cut.mesh.face_count(); ++i) {
    for (const VertexId v : cut.mesh.vertices(FaceId(i))) {
      if (v.index() >= given) result.label[v] = smaller_label(result.label[v], cut.label[FaceId(i)]);
    }
  }
  for (std::size_t i = given; i < count; ++i) {
    const VertexId v(i);
    const FaceId parent = cut.parent[Mesh::face(cut.mesh.halfedge(v))];
    const SurfacePoint point = closest_point_on_face(mesh, parent, cut.mesh.position(v)).point;
    result.distance[v] = interpolate_at(mesh, diagram.vertex_distance, point);
  }
  return result;
}

}  // namespace gvd
