#pragma once

#include <vector>

#include "gvd/mesh_property.hpp"
#include "gvd/remesh.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// The properties of an input's vertices and polygons for the vertices and faces of its remesh.
///
/// A vertex takes the values at its generator: numbers with fractions, and colours of 8 or 16 bits (`red`, `green`,
/// `blue`, `alpha`, also after `diffuse_`), by barycentric coordinates; other integers, such as labels, of the corner
/// with the largest weight. The three numbers `nx`, `ny` and `nz` are scaled to length 1. Corners without weight do not
/// count. Midpoints of edges that the repair split do not count either. A face takes the values of the polygon in which
/// its branch point is.
///
/// `properties` are those of the soup that `input` was built from. Those without a value for each of its vertices or
/// polygons are left out. `result` is a remesh of `input.mesh`. Cost: O(k) for k values of the result.
std::vector<MeshProperty> carry_properties(const CheckedMesh& input, const std::vector<MeshProperty>& properties,
                                           const RemeshResult& result);

}  // namespace gvd
