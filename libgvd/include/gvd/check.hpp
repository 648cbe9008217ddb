#pragma once

#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// What `check_diagram` found.
struct DiagramCheck {
  std::vector<std::string> violations;  ///< one line each: the property's number, and the first element that breaks it
  bool ok() const { return violations.empty(); }
};

/// States every invariant of a diagram and tests it, from the public data alone.
///
/// Properties:
///  (1) every generator lies in its own cell;
///  (2) every face belongs to one cell or is cut into pieces whose areas add up to the face's, so that the cells
///  partition the
///      area of the components that a generator reaches; a cell's area is that of its faces and pieces; faces and
///      pieces at a vertex have its label;
///  (3) consecutive points of a bisector lie in one face, and a bisector separates two cells;
///  (4) every end of a bisector is a branch point or lies on the mesh's boundary: no end is unresolved;
///  (5) every branch point joins at least three bisector ends and as many cells;
///  (6) every cell is connected, and its Euler characteristic agrees with its boundary loops: 2 - 2 genus - loops;
///  (7) Euler: the sum of the cells' characteristics, less the number of bisectors that have ends, plus the number of
///  branch
///      points, is that of the components that a generator reaches; genus and boundary included;
///  (8) neighbours are mutual, and are those with a bisector in common.
/// Sizes and ids that do not fit the mesh are findings too, under the property that they stand for; nothing else is
/// looked at then. Never throws on a finding. Cost: O(n).
DiagramCheck check_diagram(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
