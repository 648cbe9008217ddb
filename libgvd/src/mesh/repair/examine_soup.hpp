#pragma once

#include "gvd/soup.hpp"

namespace gvd {

/// Throws Error{precondition} unless every index is in range, there is a face, and every coordinate is finite and of a
/// size that can be computed with (kLargestCoordinate, kSmallestExtent). Cost: O(n).
void examine_soup(const PolygonSoup& soup);

}  // namespace gvd
