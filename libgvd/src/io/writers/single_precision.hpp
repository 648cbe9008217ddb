#pragma once

#include <string_view>

#include "gvd/mesh.hpp"

namespace gvd::io {

/// Throws Error{unwritable_output} where 32-bit floats can't hold the mesh: a coordinate is too large for one, or the
/// whole mesh lies between two of them. `format` is the name of the file format, for the message. Cost: O(n).
void check_single_precision(const Mesh& mesh, std::string_view format);

}  // namespace gvd::io
