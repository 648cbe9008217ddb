#pragma once

#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"

namespace gvd {

/// Distances of a mesh's points from another surface, mesh units: at its vertices and, in large faces, on a lattice.
struct DistanceSamples {
  IdVector<VertexId, double> at_vertex;
  /// The number k of parts that each side of a face is cut into, in [1, kMaxSteps]; faces with 1 have no lattice.
  IdVector<FaceId, std::int32_t> steps;
  /// The distances at the (k + 1) (k + 2) / 2 points of each lattice, corners included, face by face in the order of
  /// their ids. Row i = 0 ... k has the points at which corner 0 has the weight i / k; at point j = 0 ... k - i of a
  /// row, corner 2 has the weight j / k.
  std::vector<double> lattice;

  static constexpr std::int32_t kMaxSteps = 64;
  /// The number of points in the lattice of a face with k steps; 0 for k = 1.
  static std::int64_t lattice_size(std::int64_t k) { return k < 2 ? 0 : (k + 1) * (k + 2) / 2; }
};

}  // namespace gvd
