#pragma once

#include <ostream>

#include "gvd/io/mesh_writer.hpp"

namespace gvd::io {

/// Binary STL, with the colours of labelled faces in their attributes.
/// The lengths of the arrays have been checked. Throws Error{unwritable_output}.
void write_stl(std::ostream& stream, const LabelledMesh& mesh);

}  // namespace gvd::io
