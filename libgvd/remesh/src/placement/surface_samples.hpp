#pragma once

#include <vector>

#include "gvd/mesh.hpp"

namespace gvd {

/// A point of a surface that stands for a part of it.
struct SurfaceSample {
  Vec3 position;
  Vec3 normal;  ///< of the face
  FaceId face;
  double area = 0;  ///< square mesh units
};

/// Cuts each face into equal triangles, about `count` in all and at least one a face, and gives their centroids. Cost:
/// O(n + count).
std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double count);

}  // namespace gvd
