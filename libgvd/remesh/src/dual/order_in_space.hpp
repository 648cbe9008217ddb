#pragma once

#include <cstdint>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// The numbers of the points in an order in which those of each half of the list, of its halves and so on lie near each
/// other: the order for a BoxTreeOf. Deterministic. Cost: O(n log n).
std::vector<std::int32_t> order_in_space(const std::vector<Vec3>& points);

}  // namespace gvd
