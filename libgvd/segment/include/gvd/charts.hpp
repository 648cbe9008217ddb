#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"
#include "gvd/segment.hpp"
#include "gvd/vec.hpp"

// Texture coordinates for the regions of a cut mesh: each connected part of a region is an island of the unit square.
namespace gvd {

/// The regions of labelled faces that are no discs as meshes: in several parts, of an Euler characteristic other than
/// 1, or touching themselves at a vertex. Ascending. Throws Error{precondition} where there is not one label for each
/// face. Cost: O(n log n).
std::vector<GeneratorId> find_non_disc_regions(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label);

/// How a region is laid into the plane.
enum class ChartMap {
  logmap,  ///< by the exact logarithm about its generator: distance and direction of shortest paths
  flat,    ///< by a convex combination map: one-to-one, for regions that are discs
};
inline const Choices<ChartMap> kChartMapNames{{"logmap", ChartMap::logmap}, {"flat", ChartMap::flat}};

struct ChartOptions {
  ChartMap map = ChartMap::flat;
  int threads = 0;         ///< >= 1; 0: as many as there are cores. No bit of the result depends on it.
  Progress progress = {};  ///< may be empty
};

/// A connected part of a region, laid into the plane. Areas are those of faces on the surface, square mesh units.
struct Chart {
  GeneratorId generator;     ///< of the region
  std::int64_t faces = 0;    ///< of the cut mesh
  double area = 0;           ///< of all its faces
  double flipped_area = 0;   ///< of faces that are not counter-clockwise for certain, without those that are not placed
  double torn_area = 0;      ///< logmap: of faces between corners whose shortest paths come from different sides
  double unplaced_area = 0;  ///< logmap: of faces without texture coordinates, where no path was found
  /// How much longer lengths are in the chart than on the surface, the scale apart: the root mean square over all
  /// directions in a face, and its mean over the area of the placed faces. 1 if the map is isometric.
  double stretch = 0;
  Eigen::AlignedBox2d box;  ///< of its texture coordinates; empty without any
  /// logmap: texture coordinates of the generator; the x axis is that of its tangent plane.
  Vec2 origin = Vec2::Zero();
};

/// Texture coordinates of a cut mesh.
struct Charts {
  /// Three for each face, in [0, 1], u to the right and v upwards; not a number without a chart. The corners of one
  /// chart at one vertex have the same bits, but for torn faces.
  std::vector<Uv> texture;
  std::vector<Chart> charts;  ///< ascending by their first face
  double scale = 0;           ///< texture units per mesh unit, the same for all charts
  /// Faces that are counter-clockwise, but not once u and 1 - v are rounded to 32-bit floats, as a .glb has them.
  std::int64_t flipped_by_floats = 0;
  double covered = 0;  ///< area of the charts in the unit square, if they do not overlap themselves

  /// Share of the area of all charts, in [0, 1], that `area_of` counts of each, such as &Chart::flipped_area.
  double share(double Chart::*area_of) const;
};

/// Free space on all sides of an island, as a share of the square's side: two texels of a texture of 1024 x 1024, so
/// that none of a neighbour is interpolated. Less where there are over 4096 islands: an eighth of their mean side.
inline constexpr double kChartMargin = 2.0 / 1024;

/// A face is torn where the logarithms of two of its corners are farther apart than this many times the length of the
/// side between them: the shortest paths to the two pass on different sides of something. On a sphere the logarithm
/// stretches by less up to 4/5 of the way to the opposite point.
inline constexpr double kTear = 4;

/// Lays the regions of a cut mesh into the unit square, all with one scale.
///
/// `logmap`: a corner is at the distance and in the direction of the shortest path that leads to it from its generator,
/// and stays in the cell. Angles at a vertex with curvature are scaled so that they sum to 2 pi. Distances from the
/// generator are exact; the map is isometric on faces whose paths bend nowhere, flips faces where paths meet behind
/// curved parts, and flattens those behind saddles to lines. Torn faces are laid by their centre's path alone, so that
/// each has its shape, and overlap others. Any region has one, discs or not.
/// `flat`: a convex combination map with mean value weights. Its border is laid by the exact distances from the
/// generator where that turns no face round, as is isometric for a flat region. Otherwise it is the convex hull of that
/// shape, with sides bent outwards, or a circle. Each island
/// has the area of its region. One-to-one: each face is counter-clockwise in the unit square, for certain. Where double
/// precision can't keep that, `flipped_area` counts what is not: a limb many times longer than wide becomes too small.
/// Islands are sorted by height and put on shelves.
///
/// `mesh` and `diagram`: what the labels of `cut` are made of; `cut` may be of the mesh that `mesh` was separated from.
/// Throws Error{no_valid_result} for `flat` that names the first region that is no disc, `element`; Error{precondition}
/// if the three do not belong together; Error{interrupted}. Cost: that of an ExactField, and for each chart of a path
/// to each of its vertices, or up to four sparse systems of them.
Charts make_charts(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut, const ChartOptions& options = {});

/// Puts the texture coordinates of charts in place of those of an appearance, and leaves out its materials: their
/// images do not fit other coordinates. `unread` names what was there.
void replace_texture(std::vector<Uv> charts, Appearance& appearance);

}  // namespace gvd
