#include "diagram/graph/face_class.hpp"

namespace gvd {

FaceClass classify(const Mesh& mesh, const IdVector<VertexId, GeneratorId>& label, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  if (!label[a].valid() || !label[b].valid() || !label[c].valid()) return FaceClass::unreached;
  const int equal = (label[a] == label[b]) + (label[b] == label[c]) + (label[c] == label[a]);
  if (equal == 3) return FaceClass::trivial;
  return equal == 1 ? FaceClass::ordinary : FaceClass::branching;
}

}  // namespace gvd
