#pragma once

#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/remesh.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// The properties of an input's vertices and polygons for the vertices and faces of its remesh.
///
/// A vertex takes the values at its origin (`map.origins`):
/// - numbers with fractions, and colours of 8 or 16 bits, are interpolated by barycentric coordinates. Colours are
///   named `red`, `green`, `blue` or `alpha`, also after `diffuse_`;
/// - other integers, such as labels, and lists are those of the corner with the largest weight;
/// - the numbers `nx`, `ny` and `nz` are scaled to length 1 afterwards, if there are all three.
/// Midpoints of edges that the repair split have no value and do not count. A face takes the values of the polygon in
/// which its branch point is.
///
/// `properties` are those of the soup that `input` was built from. Those without a value for each of its vertices or
/// polygons are left out. `map` is that of `result`, a remesh of `input.mesh`. Cost: O(k) for k values of the result.
std::vector<MeshProperty> carry_properties(const CheckedMesh& input, const std::vector<MeshProperty>& properties,
                                           const RemeshResult& result, const RemeshMap& map);

/// The texture coordinates and materials of an input for the faces of its remesh.
///
/// A face takes the material of the face in which its branch point is. A chart consists of faces that are joined by
/// edges on whose both sides the coordinates are equal. A face of the remesh takes its coordinates from one chart, in
/// which its branch point is. A corner has those at its vertex's origin if that is in the chart or on its border.
/// Otherwise it has those at the nearest point of the chart. So no triangle goes across a seam; near one, the texture
/// is stretched. Without a chart at the branch point they are not finite.
///
/// `map` is that of `result`, a remesh of `input.mesh`. Cost: O(n log n).
Appearance carry_appearance(const CheckedMesh& input, const RemeshResult& result, const RemeshMap& map);

}  // namespace gvd
