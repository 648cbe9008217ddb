#pragma once

#include <ostream>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Writes the diagram as `gvd-diagram/1`: generators, branch points, bisectors, cells, each by id, one a line; then the
/// labels and distances of the vertices, null where no generator reaches.
///
/// Surface points refer to the faces of `mesh`. Numbers have the digits that bring the same double back. The stream is
/// flushed and checked. Throws Error{unwritable_output}. Cost: O(n) time, O(1) memory.
void write_diagram_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
