#include "gvd/error.hpp"
#include "gvd/segment.hpp"

namespace gvd {
namespace {

void check_label_count(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label) {
  if (face_label.size() == static_cast<std::size_t>(mesh.face_count())) return;
  throw Error(ErrorCode::precondition, "the labels were made for another mesh: the number of faces differs");
}

}  // namespace

double compute_border_length(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label) {
  check_label_count(mesh, face_label);
  double sum = 0;
  for (std::int32_t e = 0; e < mesh.edge_count(); ++e) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e)), twin = mesh.twin(h);
    if (twin.valid() && face_label[Mesh::face(h)] != face_label[Mesh::face(twin)]) sum += mesh.length(h);
  }
  return sum;
}

IdVector<GeneratorId, RegionSize> measure_regions(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label,
                                                  std::size_t regions) {
  check_label_count(mesh, face_label);
  IdVector<GeneratorId, RegionSize> sizes(regions);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const GeneratorId label = face_label[FaceId(f)];
    if (!label.valid()) continue;
    if (label.index() >= regions) {
      throw Error(ErrorCode::precondition, "a face has a label that no region has; give the number of generators", f);
    }
    ++sizes[label].faces;
    sizes[label].area += mesh.area(FaceId(f));
  }
  return sizes;
}

}  // namespace gvd
