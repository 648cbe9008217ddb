#pragma once

#include "geodesic/field/generator_table.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// The generator tables that exact distances amount to: what the paper's growth asks for. A generator has a line in a
/// face's table where one of its windows, or a corner of its own, reaches the face; its distances at the corners come
/// from there.
/// Reports the step "tables". Cost: O(n + windows).
GeneratorTable make_generator_table(const Mesh& mesh, const WindowField& field, const Progress& progress = {});

}  // namespace gvd
