#pragma once

#include <ostream>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Writes the diagram as `gvd-diagram/1`: generators, branch points, bisectors and cells, one per line in the order of
/// their ids, then the labels and distances of the vertices, which are null for a vertex that no generator reaches.
///
/// Surface points refer to the faces of `mesh`. Numbers have enough digits to read back as the same double. The stream
/// is flushed and checked. Throws Error{unwritable_output} if the stream fails. Cost: O(n) time, O(1) memory.
void write_diagram_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
