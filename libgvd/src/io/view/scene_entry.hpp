#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "gvd/io/label_color.hpp"
#include "gvd/io/view.hpp"
#include "gvd/vec.hpp"
#include "io/view/view_blobs.hpp"

namespace gvd::io {

/// The page's coordinate system: position = origin + scale * page position, and distance = scale * page distance. With
/// it, 32-bit floats suffice for meshes of any size and place.
struct ViewFrame {
  Vec3 origin = Vec3::Zero();
  double scale = 1;
};

/// The centre and half the diagonal of the box around all scenes. There must be at least one scene. Cost: O(n).
ViewFrame compute_view_frame(const std::vector<ViewScene>& scenes);

/// Triangulates a polygon by ear clipping: the triangles of `triangulate_plane_polygon` that have a visible area, as
/// indices of the polygon's corners.
///
/// Inputs:  the corners of a simple polygon, counter-clockwise; sides may touch, corners may repeat
/// Returns: counter-clockwise triangles of positive area that cover it; none where it has no area
/// Cost:    O(n^2) worst, O(n log n) in practice, for n corners
std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners);

/// Makes the scene's entry in the manifest of the page, and adds its arrays to `blobs`. docs/developer/viewer.md lists
/// the members.
/// `colors`: the colours of the labels, from label 0 on.
/// Cost: O(n), plus the triangulation of the pieces.
nlohmann::json make_scene_entry(const ViewScene& scene, const std::vector<Rgb>& colors, const ViewFrame& frame,
                                ViewBlobs& blobs);

}  // namespace gvd::io
