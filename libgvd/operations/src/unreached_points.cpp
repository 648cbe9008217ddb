// Why distances are infinite: sources and points in different components, or what parts a component.

#include "gvd/unreached_points.hpp"

namespace gvd {

std::string UnreachedPoints::inside() const {
  if (!parted_.is_parted()) return "beyond \1max_distance\2";
  return has_limit_ ? "in another region, in another part of its region, or beyond \1max_distance\2"
                    : "in another region, or in another part of its region";
}

void UnreachedPoints::find_faces() {
  if (!table_.targets.empty()) {
    for (const SurfacePoint& target : table_.targets) face_.push_back(target.face);
    is_left_out_.assign(face_.size(), 1);
    for (const std::int32_t point : targets_.point) is_left_out_[std::size_t(point)] = 0;
    return;
  }
  IdVector<VertexId, char> is_measured(input_.mesh.vertex_count(), 0);
  for (const FaceId f : input_.mesh.faces()) {
    if (parted_.is_left_out(f)) continue;
    for (const VertexId v : input_.mesh.vertices(f)) is_measured[v] = 1;
  }
  for (const VertexId v : input_.mesh_vertex) {
    face_.push_back(v.valid() ? Mesh::face(input_.mesh.halfedge(v)) : FaceId());
    is_left_out_.push_back(v.valid() && !is_measured[v] ? 1 : 0);
  }
}

Barrier UnreachedPoints::find(std::size_t row, std::size_t point) {
  if (!barriers_) {
    barriers_.emplace(input_);
    find_faces();
  }
  if (!face_[point].valid()) return Barrier::no_face;
  if (is_left_out_[point]) return Barrier::left_out;
  if (row_ != row) {
    std::vector<FaceId> sources;
    for (std::size_t i = 0; i < table_.sources.size(); ++i) {
      if (!table_.nearest.empty() || i == row) sources.push_back(table_.sources[i].face);
    }
    origin_ = barriers_->from(sources);
    row_ = row;
  }
  return barriers_->between(origin_, face_[point]);
}

}  // namespace gvd
