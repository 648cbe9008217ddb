#pragma once

#include <utility>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/io/view.hpp"

namespace gvd::io {

/// The pairs of regions with a common border in the picture: labels of faces with a common edge and, if faces are cut,
/// cells with a common bisector. Each pair occurs once, smaller label first, in ascending order. Cost: O(n log n).
std::vector<std::pair<GeneratorId, GeneratorId>> find_adjacent_regions(const ViewScene& scene);

/// The colours of each scene's labels: the scene's own colours if it has some, otherwise colours of the region palette
/// such that regions with a common border differ.
///
/// The scenes of a run's iterations belong together. From the last iteration back, each scene keeps the colours of the
/// scene after it and changes as few as it has to, so that the eye can follow a region along the slider.
/// Cost: O(n log n) time.
std::vector<std::vector<Rgb>> choose_scene_colors(const std::vector<ViewScene>& scenes);

}  // namespace gvd::io
