#pragma once

#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The findings of `check_diagram`.
struct DiagramCheck {
  /// One line per violation: the number of the property, the element that violates it, and what is wrong with it.
  std::vector<std::string> violations;
  bool ok() const { return violations.empty(); }
};

/// Tests every invariant of a diagram, from its public data alone.
///
/// Properties:
///  (1) every generator lies in its own cell, whose area is not negative;
///  (2) every face of a component with a generator has one label, or pieces whose areas sum up to its area; other faces
///      have neither; a cell's area is that of its faces and pieces; vertices have the labels of their faces and
///      pieces;
///  (3) a bisector separates two cells, and consecutive points of it lie in a common face;
///  (4) every end of a bisector is a branch point or lies on the mesh's boundary;
///  (5) at every branch point at least three bisectors end, between the cells that it names;
///  (6) every cell is connected, and its Euler characteristic is 2 - 2 genus - boundary loops for some genus >= 0;
///  (7) Euler's formula: the sum of the cells' characteristics, minus the number of bisectors that are not closed, plus
///      the number of branch points, is the characteristic of the components with a generator;
///  (8) the neighbours of a cell are the cells with a bisector in common.
/// If sizes or ids don't match the mesh, this violates the property that they belong to, and nothing else is tested.
/// Never throws on a violation. Cost: O(n log n).
DiagramCheck check_diagram(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
