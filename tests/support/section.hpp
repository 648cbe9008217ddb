#pragma once

#include <optional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// A bisector along the curve normal . p = offset of the surface, between the generators `left` (on the side where
/// normal . p is less) and `right`: closed, or from boundary to boundary. The one that starts at the least halfedge;
/// nothing where the plane misses the mesh. A vertex in the plane counts as above it.
std::optional<Bisector> make_section(const Mesh& mesh, const Vec3& normal, double offset, GeneratorId left,
                                     GeneratorId right);

}  // namespace gvd::test
