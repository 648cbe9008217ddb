#pragma once

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The paper's classes of faces, by the nearest generators of their corners (section 3, figure 2).
enum class FaceClass {
  unreached,  ///< a corner that no generator reaches
  trivial,    ///< one generator
  ordinary,   ///< two
  branching,  ///< three
};

/// The class of a face, by the labels of its vertices. Cost: O(1).
FaceClass classify(const Mesh& mesh, const IdVector<VertexId, GeneratorId>& label, FaceId f);

}  // namespace gvd
