#pragma once

#include <cstdint>

#include "gvd/mesh.hpp"

namespace gvd {

/// Edges longer than this many even spacings are split before sampling: then a generator fits between their ends, and
/// a face holds only a few candidates.
inline constexpr double kMaxEdgeSpacings = 2;

/// The largest number of vertices that splitting long edges may add. The number is proportional to the mesh and to the
/// generators. It bounds the memory where faces are thin, and takes effect nowhere else.
std::int64_t max_splits(const Mesh& mesh, std::int64_t count);

}  // namespace gvd
