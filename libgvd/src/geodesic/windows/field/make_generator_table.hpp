#pragma once

#include "geodesic/field/generator_table.hpp"
#include "geodesic/windows/field/window_field.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// The generator tables that correspond to exact distances: the input of the paper's growth. A generator has a line in
/// a face's table if one of its windows, or a corner with its label, reaches the face. Its distances at the corners are
/// computed from these.
/// Reports the step "tables". Cost: O(n + windows).
GeneratorTable make_generator_table(const Mesh& mesh, const WindowField& field, const Progress& progress = {});

}  // namespace gvd
