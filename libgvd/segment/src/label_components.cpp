#include "label_components.hpp"

#include "adjacent_faces.hpp"

namespace gvd {

LabelComponents find_label_components(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label) {
  LabelComponents result;
  result.component.assign(label.size(), -1);
  std::vector<FaceId> stack;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const FaceId start(i);
    if (result.component[start] >= 0 || !label[start].valid()) continue;
    const auto number = static_cast<std::int32_t>(result.components.size());
    result.components.push_back({label[start]});
    result.component[start] = number;
    for (stack.assign(1, start); !stack.empty();) {
      const FaceId f = stack.back();
      stack.pop_back();
      result.components.back().area += mesh.area(f);
      for_each_adjacent_face(mesh, f, [&](FaceId g) {
        if (result.component[g] >= 0 || label[g] != label[f]) return;
        result.component[g] = number;
        stack.push_back(g);
      });
    }
  }
  return result;
}

}  // namespace gvd
