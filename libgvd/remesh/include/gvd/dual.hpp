#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// The dual of a diagram: generators become vertices, bisectors edges, branch points faces.

namespace gvd {

/// The properties that the dual of a diagram must have to be a proper mesh, with the numbers of check_dual.
enum class DualProperty {
  component_reached = 1,
  cell_is_disc = 2,
  one_boundary_arc = 3,
  bisector_has_face = 4,
  one_bisector = 5,
  one_branch_point = 6,
  enough_neighbours = 7,
  different_cells = 8,
  polygon_fits = 9,
  not_flipped = 10,
  no_self_intersection = 11,
};

/// A property that fails for a cell, a pair or triple of cells, or a branch point. Two triangles that intersect are two
/// defects, one for each branch point.
struct DualDefect {
  DualProperty property{};
  std::string message;             ///< one line: the property's number, the elements and the position
  std::vector<GeneratorId> cells;  ///< the cells involved
  std::int32_t component = -1;     ///< of the mesh, for component_reached; numbered as compute_face_components does
  BisectorId bisector;             ///< valid if the property is about a bisector
  BranchPointId branch_point;      ///< valid if the property is about a branch point
};

/// The dual as triangles.
struct DualMesh {
  std::vector<std::array<GeneratorId, 3>> faces;  ///< counter-clockwise, in the order of their branch points
  std::vector<BranchPointId> branch_points;       ///< of each face
};

/// Builds the dual: one triangle for each branch point of three cells, and k - 2 triangles for each one of k cells.
///
/// The polygon of k > 3 cells is cut by ear clipping. An ear is allowed if its new edge is not an edge yet; the allowed
/// ear with the best Q (see quality.hpp) is cut first. If a polygon has no allowed ear left, the rest of its triangles
/// is missing, and check_dual reports it.
///
/// Properties: (1) no cut adds an edge that a bisector or an earlier cut has made; (2) deterministic. Cost: O(k log k).
DualMesh build_dual(const Mesh& mesh, const Diagram& diagram);

/// Checks whether the dual of a diagram is a proper mesh: a simplicial complex with the topology of the surface.
///
/// Properties:
///  (1) every component of the mesh has a generator;
///  (2) every cell is a disc: connected, of Euler characteristic 1;
///  (3) every cell touches the mesh's boundary nowhere or in one arc;
///  (4) every bisector has a branch point at one of its ends, so that its dual edge has a face;
///  (5) two cells share at most one bisector;
///  (6) two branch points do not have the same cells;
///  (7) every cell has at least three neighbours, or two if it touches the mesh's boundary;
///  (8) the cells round a branch point are all different;
///  (9) the polygon of a branch point of k > 3 cells can be cut into k - 2 triangles along edges that are new.
///
/// If all hold, the dual is a simplicial complex with the topology of the surface. `find_flipped_faces` checks property
/// (10), that no triangle is flipped, and `find_self_intersections` (11), that no two triangles intersect.
///
/// The diagram must be sound (see check_diagram), and `dual` must be the result of build_dual for it. The defects are
/// sorted by property. A defect never causes an exception. Cost: O(k log k) for k bisectors and branch points, O(n) for
/// the mesh.
std::vector<DualDefect> check_dual(const Mesh& mesh, const Diagram& diagram, const DualMesh& dual);

/// A triangle is flipped unless the cosine of the angle between its normal and the surface's exceeds this value, and
/// degenerate unless twice its area exceeds this fraction of its longest edge squared. The value is a million times the
/// rounding of these quotients.
inline constexpr double kFlipTolerance = 1e-9;

/// A face with a smaller Q is a sliver. The apex of an isosceles triangle with this Q is 6e-4 of the base's length away
/// from the base, so that its normal is meaningless in single precision. Ordinary remeshes stay far above: the least Q
/// of nine models with 100 to 2000 vertices is 0.17.
inline constexpr double kSliverQ = 1e-3;

/// The faces of a remesh that are flipped against the surface or degenerate, ascending. A triangle of the surface
/// itself never counts, because decimated components keep triangles of the input as they are (RemeshResult::decimated).
///
/// The surface's normal is the mean of its unit normals at the face's three generators and at its branch point
/// (gvd/surface_point.hpp); see kFlipTolerance. `generators` has a generator for every vertex of `remesh`, and
/// `face_points` the branch point of every face. Cost: O(k).
std::vector<FaceId> find_flipped_faces(const Mesh& surface, const Mesh& remesh,
                                       const std::vector<SurfacePoint>& generators,
                                       const std::vector<SurfacePoint>& face_points);

/// The same for the triangles of a dual, as indices, ascending. The dual may have other defects. Cost: O(k).
std::vector<std::size_t> find_flipped_triangles(const Mesh& surface, const Diagram& diagram, const DualMesh& dual);

}  // namespace gvd
