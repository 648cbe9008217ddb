#include "mesh/reading/check_counts.hpp"

#include <fmt/format.h>

#include "gvd/error.hpp"

namespace gvd {

void check_counts(std::uint64_t vertices, std::uint64_t polygons, std::string_view name) {
  constexpr auto kMost = static_cast<std::uint64_t>(kMostVertices);
  if (vertices <= kMost && polygons <= kMost) return;
  throw Error(ErrorCode::precondition,
              fmt::format("{}: {} vertices and {} faces are more than 32-bit ids can count ({}); simplify the mesh",
                          name, vertices, polygons, kMost));
}

}  // namespace gvd
