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

// Texture coordinates for the regions of a cut mesh. Each connected part of a region becomes an island in the unit
// square.
namespace gvd {

/// Finds the regions of labelled faces that are not discs as meshes: they have several parts, an Euler characteristic
/// other than 1, or touch themselves at a vertex. Ascending. Throws Error{precondition} if there is not one label for
/// each face. Cost: O(n log n).
std::vector<GeneratorId> find_non_disc_regions(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label);

/// How a region is mapped to the plane.
enum class ChartMap {
  logmap,  ///< by the exact logarithmic map at its generator: length and direction of shortest paths
  flat,    ///< by a convex combination map: one-to-one, for regions that are discs
};
inline const Choices<ChartMap> kChartMapNames{{"logmap", ChartMap::logmap}, {"flat", ChartMap::flat}};

struct ChartOptions {
  ChartMap map = ChartMap::flat;
  int threads = 0;         ///< >= 1; 0: as many as there are cores. The result does not depend on it
  Progress progress = {};  ///< may be empty
};

/// A connected part of a region, mapped to the plane. All areas are areas of faces on the surface, in square mesh
/// units.
struct Chart {
  GeneratorId generator;    ///< of the region
  std::int64_t faces = 0;   ///< number of faces of the cut mesh
  double area = 0;          ///< of all its faces
  double flipped_area = 0;  ///< of placed faces that are not certainly counter-clockwise
  /// logmap: of faces whose corners have shortest paths on different sides of an obstacle (kTear).
  double torn_area = 0;
  double unplaced_area = 0;  ///< logmap: of faces without texture coordinates, because no path was found
  /// How much longer lengths are in the chart than on the surface, apart from the scale. In a face it is the root mean
  /// square over all directions; this is the mean over the area of the placed faces. 1 if the map is isometric.
  double stretch = 0;
  Eigen::AlignedBox2d box;  ///< of its texture coordinates; empty if it has none
  /// logmap: the texture coordinates of the generator.
  Vec2 origin = Vec2::Zero();
};

/// The texture coordinates of a cut mesh.
struct Charts {
  /// Three for each face, in [0, 1], u to the right and v upwards; NaN for a face without a chart. All corners of a
  /// chart at the same vertex have the same bits, except in torn faces.
  std::vector<Uv> texture;
  std::vector<Chart> charts;  ///< ascending by their first face
  double scale = 0;           ///< texture units per mesh unit, the same for all charts
  /// Faces that are counter-clockwise, but not once u and 1 - v are rounded to 32-bit floats, as a .glb has them.
  std::int64_t flipped_by_floats = 0;
  double covered = 0;  ///< area of the charts in the unit square, if they do not overlap themselves

  /// The share, in [0, 1], of an area of the charts in the area of all charts. `area_of` is a member such as
  /// &Chart::flipped_area.
  double share(double Chart::*area_of) const;
};

/// Free space on all sides of an island, as a share of the square's side: two texels of a texture of 1024 x 1024, so
/// that interpolation does not reach a neighbour. With more than 4096 islands it is an eighth of their mean side, which
/// is less.
inline constexpr double kChartMargin = 2.0 / 1024;

/// A face is torn if the logarithms of two of its corners are farther apart than this many times the length of the side
/// between them, because the shortest paths to the two corners pass on different sides of an obstacle. On a sphere, the
/// logarithm stretches by less than this up to 4/5 of the way to the opposite point.
inline constexpr double kTear = 4;

/// Maps the regions of a cut mesh into the unit square, all with the same scale.
///
/// `logmap`: a corner is placed at the distance and in the direction of the shortest path from its generator, which
/// stays in the cell. Angles at a vertex with curvature are scaled so that they sum to 2 pi. Distances from the
/// generator are exact. The map is isometric on faces whose paths bend nowhere; it flips faces where paths meet behind
/// curved parts, and flattens faces behind saddles to lines. A torn face is placed by the path to its centre alone, so
/// it keeps its shape and overlaps others. This map exists for every region, whether it is a disc or not.
/// `flat`: a convex combination map with mean value weights. Its border is placed by the exact distances from the
/// generator if that flips no face; for a flat region this map is isometric. Otherwise the border is the convex hull of
/// that shape, with its sides bent outwards, or a circle. Each island
/// has the area of its region. The map is one-to-one: each face is certainly counter-clockwise in the unit square. If
/// double precision can't achieve that, as for a limb many times longer than wide, `flipped_area` counts the other
/// faces. Islands are packed on shelves, sorted by height.
///
/// `mesh` and `diagram` are those from which `cut` got its labels; `mesh` may be separated into regions while `cut` is
/// cut from the original mesh.
/// Throws Error{no_valid_result} with the first region that is not a disc as its element, for `flat`;
/// Error{precondition} if the three arguments do not belong together; Error{interrupted} if the progress callback
/// cancels.
/// Cost: an ExactField, and for each chart a path to each vertex (`logmap`), or a path to each border vertex and up to
/// four sparse systems (`flat`).
Charts make_charts(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut, const ChartOptions& options = {});

/// Replaces the texture coordinates of an appearance by those of charts, and removes its materials, whose images do not
/// fit the new coordinates. Adds what was removed to `unread`.
void replace_texture(std::vector<Uv> charts, Appearance& appearance);

}  // namespace gvd
