#include "gvd/error.hpp"
#include "gvd/segment.hpp"

namespace gvd {

IdVector<GeneratorId, RegionSize> measure_regions(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label,
                                                  std::size_t regions) {
  if (face_label.size() != static_cast<std::size_t>(mesh.face_count())) {
    throw Error(ErrorCode::precondition, "the labels were made for another mesh: the number of faces differs");
  }
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
