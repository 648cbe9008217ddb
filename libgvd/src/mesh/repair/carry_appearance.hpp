#pragma once

#include "gvd/soup.hpp"

namespace gvd {

/// The appearance of the soup on the faces of the mesh that it became. The midpoint of a split edge has the texture
/// coordinates that are linear between the edge's ends. Cost: O(n), and O(k) for each corner of a polygon with k ones.
Appearance carry_appearance(const PolygonSoup& soup, const CheckedMesh& checked);

}  // namespace gvd
