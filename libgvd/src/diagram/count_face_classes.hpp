#pragma once

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// How many faces have each class: n1, n2 and n3 of section 4.4 of the paper. Cost: O(n).
FaceClassCounts count_face_classes(const Mesh& mesh, const IdVector<VertexId, GeneratorId>& label);

}  // namespace gvd
