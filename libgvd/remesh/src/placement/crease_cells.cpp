#include "placement/crease_cells.hpp"

#include <cmath>
#include <numbers>

#include "gvd/surface_normal.hpp"

namespace gvd {

IdVector<GeneratorId, char> find_crease_cells(const Mesh& mesh, const Diagram& diagram) {
  const double least_cosine = std::cos(kSharpAngle * std::numbers::pi / 180);
  IdVector<FaceId, char> at_crease(static_cast<std::size_t>(mesh.face_count()), 0);
  for (std::int32_t e = 0; e < mesh.edge_count(); ++e) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e)), twin = mesh.twin(h);
    const FaceId f = Mesh::face(h);
    const bool sharp = !twin.valid() || face_normal(mesh, f).dot(face_normal(mesh, Mesh::face(twin))) < least_cosine;
    if (!sharp) continue;
    at_crease[f] = 1;
    if (twin.valid()) at_crease[Mesh::face(twin)] = 1;
  }
  IdVector<GeneratorId, char> has_crease(diagram.generators.size(), 0);
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const GeneratorId g = diagram.face_label[FaceId(i)];
    if (g.valid() && at_crease[FaceId(i)]) has_crease[g] = 1;
  }
  for (const FacePiece& piece : diagram.pieces) {
    if (at_crease[piece.face]) has_crease[piece.generator] = 1;
  }
  return has_crease;
}

}  // namespace gvd
