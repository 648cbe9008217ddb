#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "gvd/io/label_color.hpp"
#include "gvd/io/view.hpp"
#include "io/view/view_blobs.hpp"
#include "io/view/view_frame.hpp"

namespace gvd::io {

/// The scene's entry in the manifest of the page; its arrays go into `blobs`. docs/developer/viewer.md lists the
/// members.
/// `colors`: of the labels, from 0 on.
/// Cost: O(n), and the triangulation of the pieces.
nlohmann::json make_scene_entry(const ViewScene& scene, const std::vector<Rgb>& colors, const ViewFrame& frame,
                                ViewBlobs& blobs);

}  // namespace gvd::io
