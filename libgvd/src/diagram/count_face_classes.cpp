#include "diagram/count_face_classes.hpp"

#include <cstdint>

#include "diagram/graph/face_class.hpp"

namespace gvd {

FaceClassCounts count_face_classes(const Mesh& mesh, const IdVector<VertexId, GeneratorId>& label) {
  FaceClassCounts counts;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const FaceClass found = classify(mesh, label, FaceId(i));
    counts.trivial += found == FaceClass::trivial;
    counts.ordinary += found == FaceClass::ordinary;
    counts.branching += found == FaceClass::branching;
  }
  return counts;
}

}  // namespace gvd
