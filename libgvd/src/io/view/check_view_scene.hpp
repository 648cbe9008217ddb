#pragma once

#include "gvd/io/view.hpp"

namespace gvd::io {

/// Throws Error{precondition} where a scene has no faces, an array has not the size of the mesh, or a value is out of
/// its range. Cost: O(n).
void check_view_scene(const ViewScene& scene);

}  // namespace gvd::io
