#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/io/view.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

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

/// The page's coordinate system: position = origin + scale * page position, and distance = scale * page distance. It
/// keeps meshes of any size and place within the range and precision of 32-bit floats.
struct ViewFrame {
  Vec3 origin = Vec3::Zero();
  double scale = 1;
};

/// Centre and half the diagonal of the box around all scenes, of which there is at least one. Cost: O(n).
ViewFrame compute_view_frame(const std::vector<ViewScene>& scenes);

/// The arrays of a page: little-endian, deflated, in Base64, equal ones stored once.
class ViewBlobs {
 public:
  /// Adds an array of 32-bit floats. Returns its reference for the manifest: {"blob", "type", "count"}.
  nlohmann::json add_floats(const std::vector<float>& values);

  /// Adds coordinates of points in the page's frame, three each, as multiples of 2^-20: a pixel of a screen 2,000
  /// pixels wide when zoomed in a thousand times. Neighbours in the list are near each other mostly, so differences are
  /// stored.
  /// Returns {"blob", "type", "count", "unit", "step": 3}.
  nlohmann::json add_coordinates(const std::vector<double>& values);

  /// Adds numbers from 0 to 1 as multiples of 1/65535, such that b and 1 - b stay complements. Returns {"blob", "type",
  /// "count", "unit"}.
  nlohmann::json add_shares(const std::vector<double>& values);

  /// Adds an array of unsigned integers in the narrowest of 8, 16 and 32 bits that holds the largest of them.
  nlohmann::json add_integers(const std::vector<std::uint32_t>& values);

  /// One element `<script type="application/octet-stream" id="blob-K">` for each array, in the order in which they were
  /// added.
  std::string html() const;

  /// The bytes of each array, by the number of its reference.
  const std::vector<const std::string*>& all() const { return blobs_; }

 private:
  nlohmann::json add(std::string bytes, const char* type, std::size_t count);

  std::map<std::string, std::size_t> index_of_;
  std::vector<const std::string*> blobs_;  ///< keys of index_of_, which do not move
};

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

/// What a page holds of its scenes, which have been checked: the manifest; the arrays go into `blobs`. Cost: that of
/// its entries.
nlohmann::json make_view_manifest(const std::vector<ViewScene>& scenes, const ViewFrame& frame,
                                  const ViewOptions& options, ViewBlobs& blobs);

/// Computes for each cell the integral of the squared distance to its generator, in mesh units to the fourth.
///
/// In each face the squared distance is a quadratic function of the barycentric coordinates. The distances of the
/// corners and the lengths of the edges give it: d^2 = sum b_i d_i^2 - sum b_i b_j l_ij^2. That is exact where straight
/// lines from one generator reach all three corners. Elsewhere, as in cut faces, whose corners may have another
/// generator, it is an approximation for pictures; `compute_cell_moments` of gvd/cell_moments.hpp is the exact one.
/// A face with a corner that no generator reaches counts nothing.
/// Throws nothing. Cost: O(n).
IdVector<GeneratorId, double> compute_cell_energies(const Mesh& mesh, const Diagram& diagram);

/// Throws Error{precondition} where a scene has no faces, an array has not the size of the mesh, or a value is out of
/// its range. Cost: O(n).
void check_view_scene(const ViewScene& scene);

/// The page without its data, which the build makes of web/ (cmake/embed_viewer.cmake). It holds each of the two marks
/// below once. It is empty where GVD_WITH_VIEWER is off.
std::string_view view_template();

inline constexpr std::string_view kViewTitleMark = "<!--gvd:title-->";
inline constexpr std::string_view kViewDataMark = "<!--gvd:data-->";

}  // namespace gvd::io
