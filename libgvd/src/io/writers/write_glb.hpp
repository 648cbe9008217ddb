#pragma once

#include <ostream>

#include "gvd/io/mesh_writer.hpp"

namespace gvd::io {

/// Binary glTF 2.0: a primitive with vertices and normals of its own and a material for each region, the bisectors as
/// line segments.
/// The lengths of the arrays have been checked. Throws Error{unwritable_output}.
/// The file can't exceed 4 GiB.
void write_glb(std::ostream& stream, const LabelledMesh& mesh);

}  // namespace gvd::io
