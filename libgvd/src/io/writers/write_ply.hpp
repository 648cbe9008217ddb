#pragma once

#include <ostream>

#include "gvd/io/mesh_writer.hpp"

namespace gvd::io {

/// PLY, binary or text: positions as doubles, distances as floats where these hold them, labels, and their colours.
/// The lengths of the arrays have been checked. Throws Error{unwritable_output}.
void write_ply(std::ostream& stream, const LabelledMesh& mesh);

}  // namespace gvd::io
