#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/dual.hpp"
#include "gvd/ids.hpp"
#include "gvd/vec.hpp"

// Descriptions of the defects of a dual.

namespace gvd {

/// A defect of these cells, near a point. `what` says what is wrong with what.
DualDefect make_defect(DualProperty property, std::vector<GeneratorId> cells, const std::string& what, const Vec3& at);

/// A triangle of a dual, by index, as a defect. `what` follows "the triangle of the generators a, b and c".
DualDefect triangle_defect(const Diagram& diagram, const DualMesh& dual, std::size_t triangle, const std::string& what,
                           DualProperty property = DualProperty::not_flipped);

}  // namespace gvd
