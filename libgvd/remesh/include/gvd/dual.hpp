#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_normal.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// The dual of a diagram: generators become vertices, bisectors edges, branch points faces.

namespace gvd {

/// What keeps the dual of a diagram from being a proper mesh. The numbers are those of check_dual's properties.
enum class DualProperty {
  component_reached = 1,
  cell_is_disc = 2,
  one_boundary_run = 3,
  bisector_has_face = 4,
  one_bisector = 5,
  one_branch_point = 6,
  enough_neighbours = 7,
  different_cells = 8,
  polygon_fits = 9,
  not_flipped = 10,
};

/// The first place where a property fails for a cell, a pair or triple of cells, or a branch point.
struct DualDefect {
  DualProperty property{};
  std::string message;             ///< one line: the property's number, the elements and the position
  std::vector<GeneratorId> cells;  ///< the cells that are concerned
  std::int32_t component = -1;     ///< of the mesh, for component_reached; numbered as compute_face_components does
  BisectorId bisector;             ///< where one is concerned
  BranchPointId branch_point;      ///< where one is concerned
};

/// Whether the dual of a diagram is a proper mesh, from the public data alone.
///
/// Properties:
///  (1) every component of the mesh has a generator;
///  (2) every cell is a disc: connected, of Euler characteristic 1;
///  (3) every cell meets the mesh's boundary nowhere or in one run;
///  (4) every bisector ends in a branch point at one end at least: its dual edge has a face;
///  (5) two cells meet in at most one bisector;
///  (6) two branch points do not join the same cells;
///  (7) every cell has at least three neighbours, two where it touches the mesh's boundary;
///  (8) the cells round a branch point are all different;
///  (9) a branch point of k > 3 cells can be cut into k - 2 triangles whose new edges are no edges yet.
/// Where they hold, the dual is a mesh with the topology of the surface: the cells' complex is regular enough for its
/// dual to be a simplicial complex. Property (10), no triangle flipped, is `find_flipped_faces`'s.
/// The diagram must be sound (see check_diagram). Ascending by property. Never throws on a finding.
/// Cost: O(k log k) for k bisectors and branch points, O(n) for the mesh.
std::vector<DualDefect> check_dual(const Mesh& mesh, const Diagram& diagram);

/// The dual as triangles.
struct DualMesh {
  std::vector<std::array<GeneratorId, 3>> faces;  ///< counter-clockwise, in the order of their branch points
  std::vector<BranchPointId> branch_points;       ///< of each face
};

/// Cuts the branch points' polygons into triangles, ear by ear: of the ears whose new edge is no edge yet, the one with
/// the best Q (see quality.hpp) goes first. A polygon that can't be cut so loses the rest of its triangles: check_dual
/// names it. Cost: O(k log k).
DualMesh build_dual(const Mesh& mesh, const Diagram& diagram);

/// How far from flat on one's face a triangle may lie: least cosine between its normal and the surface's, and least
/// area as a part of its longest edge squared. Both only keep rounding from deciding: 1e-9 is a million times that.
inline constexpr double kFlipTolerance = 1e-9;

/// Faces of a remesh that are turned against the surface or have no area, ascending.
///
/// A face is flipped where the cosine between its normal and the mean of the surface's unit normals at its three
/// generators and at its branch point is not above kFlipTolerance (gvd/surface_normal.hpp).
/// `generators` are the vertices, `face_points` the branch point of every face. Cost: O(k).
std::vector<FaceId> find_flipped_faces(const Mesh& surface, const Mesh& remesh,
                                       const std::vector<SurfacePoint>& generators,
                                       const std::vector<SurfacePoint>& face_points);

}  // namespace gvd
