#pragma once

#include <vector>

#include "gvd/io/view.hpp"
#include "gvd/vec.hpp"

namespace gvd::io {

/// The page's coordinate system: position = origin + scale * page position, and distance = scale * page distance. It
/// keeps meshes of any size and place within the range and precision of 32-bit floats.
struct ViewFrame {
  Vec3 origin = Vec3::Zero();
  double scale = 1;
};

/// Centre and half the diagonal of the box around all scenes, of which there is at least one. Cost: O(n).
ViewFrame compute_view_frame(const std::vector<ViewScene>& scenes);

}  // namespace gvd::io
