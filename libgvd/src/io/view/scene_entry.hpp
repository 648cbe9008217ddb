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

/// The page's coordinate system: position = origin + scale * page position, and distance = scale * page distance. It
/// keeps meshes of any size and place within the range and precision of 32-bit floats.
struct ViewFrame {
  Vec3 origin = Vec3::Zero();
  double scale = 1;
};

/// Centre and half the diagonal of the box around all scenes, of which there is at least one. Cost: O(n).
ViewFrame compute_view_frame(const std::vector<ViewScene>& scenes);

/// Triangles of a polygon by ear clipping, as indices of its corners: those of triangulate_plane_polygon with a visible
/// area.
///
/// Inputs:  the corners of a simple polygon, counter-clockwise; sides may touch, corners may repeat
/// Returns: counter-clockwise triangles of positive area that cover it; none where it has no area
/// Cost:    O(n^2) worst, O(n log n) in practice, for n corners
std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners);

/// The scene's entry in the manifest of the page; its arrays go into `blobs`. docs/developer/viewer.md lists the
/// members.
/// `colors`: of the labels, from 0 on.
/// Cost: O(n), and the triangulation of the pieces.
nlohmann::json make_scene_entry(const ViewScene& scene, const std::vector<Rgb>& colors, const ViewFrame& frame,
                                ViewBlobs& blobs);

}  // namespace gvd::io
