#pragma once

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The paper's classes of faces, by the nearest generators of their corners (section 3, figure 2).
enum class FaceClass {
  unreached,  ///< no generator reaches a corner
  trivial,    ///< one generator
  ordinary,   ///< two
  branching,  ///< three
};

/// Cost: O(1).
FaceClass classify(const Mesh& mesh, const IdVector<VertexId, GeneratorId>& label, FaceId f);

}  // namespace gvd
