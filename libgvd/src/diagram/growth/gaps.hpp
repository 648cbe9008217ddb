#pragma once

#include <functional>
#include <vector>

#include "geodesic/generator_table.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A connected set of faces where three or more generators may compete. Bisectors are traced up to its rim, the edges
/// with a face outside, and grow through its inside (section 4.3).
struct Gap {
  std::vector<FaceId> faces;  ///< ascending
  bool contains(FaceId f) const;
};

/// The connected sets of the faces that `is_in_gap` names, ascending by their first face. Cost: O(n).
std::vector<Gap> connect_gaps(const Mesh& mesh, const std::function<bool(FaceId)>& is_in_gap);

/// The gaps of the faces whose tables hold three or more generators that are not dominated.
std::vector<Gap> find_gaps(const Mesh& mesh, const GeneratorTable& table);

}  // namespace gvd
