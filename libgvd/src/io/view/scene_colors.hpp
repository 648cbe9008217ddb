#pragma once

#include <utility>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/io/view.hpp"

namespace gvd::io {

/// Pairs of regions with a common border in the picture: of faces with a common edge and, where faces are cut, of cells
/// with a common bisector. Each pair once, smaller label first, ascending. Cost: O(n log n).
std::vector<std::pair<GeneratorId, GeneratorId>> find_adjacent_regions(const ViewScene& scene);

/// The colours of the labels of each scene, of the region palette, such that regions with a common border differ: those
/// that the scene names, if it does.
///
/// Scenes of several iterations belong together: from the last iteration back, each one keeps the colours of the one
/// after it, and changes as few as it has to. A region can be followed over the slider so.
/// Cost: O(n log n) time.
std::vector<std::vector<Rgb>> choose_scene_colors(const std::vector<ViewScene>& scenes);

}  // namespace gvd::io
