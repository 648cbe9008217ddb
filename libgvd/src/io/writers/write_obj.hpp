#pragma once

#include <ostream>
#include <string>

#include "gvd/io/mesh_writer.hpp"

namespace gvd::io {

/// OBJ: a group for each region, and the bisectors as lines. `material_library` is the file name of the .mtl; empty for
/// none. The lengths of the arrays have been checked. Throws Error{unwritable_output}.
void write_obj(std::ostream& stream, const LabelledMesh& mesh, const std::string& material_library);

}  // namespace gvd::io
