#pragma once

#include <cstdint>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// The numbers of the points in an order for a BoxTreeOf: the points of each half of the list lie near each other, and
/// so do the points of each quarter, and so on. Deterministic. Cost: O(n log n).
std::vector<std::int32_t> order_in_space(const std::vector<Vec3>& points);

}  // namespace gvd
