#pragma once

#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The faces of the mesh's components that have a generator: those that cells have to cover. Cost: O(n).
class ReachedFaces {
 public:
  /// Every generator must lie in a face of the mesh.
  ReachedFaces(const Mesh& mesh, const std::vector<SurfacePoint>& generators);

  bool contains(FaceId f) const { return has_generator_[component_[f]] != 0; }

 private:
  IdVector<FaceId, std::int32_t> component_;
  std::vector<char> has_generator_;  // per component
};

}  // namespace gvd
