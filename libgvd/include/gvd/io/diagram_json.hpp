#pragma once

#include <ostream>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Writes the diagram as `gvd-diagram/1`: generators, branch points, bisectors, cells, in this order and in that of
/// their ids, one a line. Surface points refer to the faces of `mesh`; numbers have the digits that bring the same
/// double back. The stream is flushed and checked. Throws Error{unwritable_output}. Cost: O(n) time, O(1) memory.
void write_diagram_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
