#pragma once

#include "gvd/soup.hpp"

namespace gvd {

/// Carries the appearance of a soup to the faces of the mesh that it became. At the midpoint of a split edge, texture
/// coordinates are interpolated linearly. Cost: O(n), and O(k) for each corner of a polygon with k corners.
Appearance carry_appearance(const PolygonSoup& soup, const CheckedMesh& checked);

}  // namespace gvd
