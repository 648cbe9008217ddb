#pragma once

#include <cstdint>

#include "gvd/mesh.hpp"

namespace gvd::paper {

/// The same faces with vertices moved towards random neighbours, until `percent_below_30` of all triangles have an
/// angle below 30 degrees or kMostJitterRounds are over. A move that turns a normal by more than 60 degrees, or that
/// makes a triangle of Q below 0.1, is left out. Equal seeds give equal meshes.
Mesh jitter(const Mesh& mesh, double percent_below_30, std::uint64_t seed);

inline constexpr int kMostJitterRounds = 20;

}  // namespace gvd::paper
