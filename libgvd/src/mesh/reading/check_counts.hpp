#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

namespace gvd {

inline constexpr std::int64_t kMostVertices = std::numeric_limits<std::int32_t>::max();

/// Throws Error{precondition} where there are more vertices or polygons than 32-bit ids can count. `name` is the file's.
void check_counts(std::uint64_t vertices, std::uint64_t polygons, std::string_view name);

}  // namespace gvd
