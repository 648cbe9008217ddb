#pragma once

#include <vector>

#include "geodesic/field/generator_table.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A connected set of faces whose tables hold three or more generators that are not dominated. Bisectors are traced up
/// to its rim, the edges with a face outside, and grow through its inside (section 4.3).
struct Gap {
  std::vector<FaceId> faces;  ///< ascending
  bool contains(FaceId f) const;
};

/// All gaps, ascending by their first face. Cost: O(n).
std::vector<Gap> find_gaps(const Mesh& mesh, const GeneratorTable& table);

}  // namespace gvd
