// The faces that meet some cells of a diagram, as a mesh of their own.
//
// Faces keep their corners, so points go there and back by their face alone. Vertices are numbered anew, one for each
// fan of connected faces: a vertex at which two fans meet would be no manifold. The fringe is what the part has in
// common with other cells: faces that they meet too, and faces at an edge where the part ends and the mesh does not.

#include "repair/mesh_part.hpp"

#include <array>
#include <utility>

#include "mesh/vertex_ring.hpp"

namespace gvd {

CellFlags grow_rings(const Diagram& diagram, const std::vector<GeneratorId>& cells, int rings) {
  CellFlags flags(diagram.cells.size(), 0);
  std::vector<GeneratorId> last = cells;
  for (const GeneratorId g : cells) flags[g] = 1;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<GeneratorId> next;
    for (const GeneratorId g : last) {
      for (const GeneratorId n : diagram.cells[g].neighbours) {
        if (flags[n]) continue;
        flags[n] = 1;
        next.push_back(n);
      }
    }
    last = std::move(next);
  }
  return flags;
}

MeshPart::MeshPart(const Mesh& mesh, const Diagram& diagram, const CellFlags& in_part) : part_face_(mesh.face_count()) {
  choose_faces(mesh, diagram, in_part);
  build(mesh);
}

void MeshPart::choose_faces(const Mesh& mesh, const Diagram& diagram, const CellFlags& in_part) {
  IdVector<FaceId, char> meets(part_face_.size(), 0), meets_others(part_face_.size(), 0);
  for (const FaceId f : mesh.faces()) {
    const GeneratorId g = diagram.face_label[f];
    if (g.valid()) meets[f] = in_part[g];
  }
  for (const FacePiece& piece : diagram.pieces) {
    (in_part[piece.generator] ? meets : meets_others)[piece.face] = 1;
  }
  for (const FaceId f : mesh.faces()) {
    if (!meets[f]) continue;
    bool is_fringe = meets_others[f] != 0;
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, corner));
      is_fringe |= twin.valid() && !meets[Mesh::face(twin)];
    }
    part_face_[f] = whole_face_.push_back(f);
    fringe_.push_back(is_fringe ? 1 : 0);
  }
}

void MeshPart::build(const Mesh& mesh) {
  std::vector<std::array<VertexId, 3>> faces(whole_face_.size());
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      if (faces[i][corner].valid()) continue;
      const HalfedgeId h = Mesh::halfedge(whole_face_[FaceId(i)], corner);
      number_fan(mesh, h, VertexId(std::ssize(positions)), faces);
      positions.push_back(mesh.position(mesh.from(h)));
    }
  }
  part_ = Mesh(std::move(positions), std::move(faces));
}

/// Gives the corners of the part's faces round the start of `outgoing` their vertex, as far as they are connected.
void MeshPart::number_fan(const Mesh& mesh, HalfedgeId outgoing, VertexId v,
                          std::vector<std::array<VertexId, 3>>& faces) const {
  const auto number = [&](HalfedgeId h) {
    if (!h.valid() || !part_face_[Mesh::face(h)].valid()) return false;
    VertexId& corner = faces[part_face_[Mesh::face(h)].index()][Mesh::corner(h)];
    if (corner.valid()) return false;
    corner = v;
    return true;
  };
  HalfedgeId h = outgoing;
  while (number(h)) h = next_outgoing(mesh, h);
  h = previous_outgoing(mesh, outgoing);
  while (number(h)) h = previous_outgoing(mesh, h);
}

std::optional<SurfacePoint> MeshPart::to_part(const SurfacePoint& point) const {
  const FaceId f = part_face_[point.face];
  if (!f.valid()) return std::nullopt;
  return SurfacePoint{f, point.bary};
}

}  // namespace gvd
