#pragma once

#include <ostream>

#include "gvd/io/mesh_writer.hpp"

namespace gvd::io {

/// VTK PolyData in XML, arrays in Base64: faces with labels, bisectors as lines.
/// The lengths of the arrays have been checked. Throws Error{unwritable_output}.
void write_vtp(std::ostream& stream, const LabelledMesh& mesh);

}  // namespace gvd::io
