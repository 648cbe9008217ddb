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
/// - the numbers `nx`, `ny` and `nz` are scaled to length 1 afterwards, if all three are there.
///
/// The repair of a soup may split edges; the midpoints have no value, and are left out of the interpolation. A face
/// takes the values of the polygon that contains its branch point.
///
/// `properties` are those of the soup that `input` was built from. A property is left out unless it has a value for
/// each vertex, or for each polygon, of the soup. `map` is that of `result`, a remesh of `input.mesh`.
///
/// Properties: (1) the results are in the order of `properties`; (2) a vertex whose origin is a vertex of the soup
/// takes its values bit by bit, scaled normals excepted; (3) deterministic.
/// Cost: O(k) for k values of the result.
std::vector<MeshProperty> carry_properties(const CheckedMesh& input, const std::vector<MeshProperty>& properties,
                                           const RemeshResult& result, const RemeshMap& map);

/// The texture coordinates and materials of an input for the faces of its remesh.
///
/// A face takes the material of the input face that contains its branch point. A chart is a set of faces joined by
/// edges on whose two sides the coordinates agree. All three corners of a face take their coordinates from the chart
/// that contains the branch point: a corner takes the coordinates at its vertex's origin if the origin is in the chart
/// or on its border, and otherwise the coordinates at the nearest point of the chart. So no triangle crosses a seam;
/// near one, the texture is stretched. If there is no chart at the branch point, the coordinates are not finite.
///
/// `map` is that of `result`, a remesh of `input.mesh`.
///
/// Properties: (1) the corners of a face have coordinates of one chart; (2) a corner whose origin is a vertex of this
/// chart takes the coordinates there bit by bit; (3) deterministic.
/// Cost: O(n log n).
Appearance carry_appearance(const CheckedMesh& input, const RemeshResult& result, const RemeshMap& map);

}  // namespace gvd
