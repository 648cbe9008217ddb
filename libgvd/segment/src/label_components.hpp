#pragma once

#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The edge-connected components of the faces of each label.
struct LabelComponents {
  struct Component {
    GeneratorId label;
    double area = 0;  ///< square mesh units
  };
  std::vector<Component> components;         ///< in the order of their first face
  IdVector<FaceId, std::int32_t> component;  ///< of every face; -1 for a face without a label
};

/// Cost: O(n).
LabelComponents find_label_components(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label);

}  // namespace gvd
