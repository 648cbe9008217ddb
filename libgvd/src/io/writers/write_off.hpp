#pragma once

#include <ostream>

#include "gvd/io/mesh_writer.hpp"

namespace gvd::io {

/// OFF, or COFF with colours of vertices and faces where there are labels.
/// The lengths of the arrays have been checked. Throws Error{unwritable_output}.
void write_off(std::ostream& stream, const LabelledMesh& mesh);

}  // namespace gvd::io
