#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "gvd/io/view.hpp"
#include "io/view/view_blobs.hpp"

namespace gvd::io {

/// Where the page's coordinates lie: position = origin + scale * page position, so that no mesh is too small, too large
/// or too far away for 32-bit floats. Distances are divided by `scale` too.
struct ViewFrame {
  Vec3 origin = Vec3::Zero();
  double scale = 1;
};

/// Throws Error{precondition} where the scene's parts do not fit together.
void check_view_scene(const ViewScene& scene);

/// Centre and half the diagonal of the box round all scenes.
ViewFrame compute_view_frame(const std::vector<ViewScene>& scenes);

/// The scene's entry in the manifest; its arrays go into `blobs`. docs/developer/viewer.md lists the fields.
nlohmann::json make_scene_entry(const ViewScene& scene, const ViewFrame& frame, ViewBlobs& blobs);

}  // namespace gvd::io
