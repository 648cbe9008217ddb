#pragma once

#include <vector>

#include "gvd/io/label_color.hpp"
#include "gvd/io/view.hpp"

namespace gvd::io {

/// The colours of the labels of each scene, of the region palette, such that regions with a common border differ.
///
/// Scenes of several iterations belong together: from the last iteration back, each one keeps the colours of the one
/// after it, and changes as few as it has to. A region can be followed over the slider so.
/// Cost: O(n log n) time.
std::vector<std::vector<Rgb>> choose_scene_colors(const std::vector<ViewScene>& scenes);

}  // namespace gvd::io
