#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/polygon_soup.hpp"

namespace gvd {

/// How `build_mesh` treats a defect.
enum class DefectPolicy {
  error,    ///< refuses any defect
  repair,   ///< repairs defects where that loses no part of the surface, refuses the others
  largest,  ///< repairs, then keeps only the component with the largest area (the first of equal ones)
};
inline const Choices<DefectPolicy> kDefectPolicyNames{
    {"error", DefectPolicy::error}, {"repair", DefectPolicy::repair}, {"largest", DefectPolicy::largest}};

enum class DefectKind {
  unwelded_vertices,         ///< in STL and GLB files and for `weld_soup`: welded where coordinates are equal (-0 is 0)
  zero_length_edges,         ///< a polygon edge between two vertices at one position: the two are welded
  degenerate_faces,          ///< fewer than three corners without the repeated ones: removed
  duplicate_faces,           ///< the corners of an earlier face, in either direction: removed
  crossing_quads,            ///< a quadrilateral that is folded or crosses itself: cut along a diagonal
  inconsistent_orientation,  ///< flipped, so that each component follows the majority of its faces
  nonmanifold_edges,         ///< three or more faces: cut apart
  nonmanifold_vertices,      ///< several fans of faces, at a vertex on no non-manifold edge: cut apart
  unused_vertices,           ///< in no face: removed
  dropped_components,        ///< those that the caller did not want, all but the largest or small ones: left out
  one_sided_edges,           ///< few edges that make a component one-sided: cut, the surface is open along them
  zero_area_components,      ///< components of faces without area: removed
};

/// The kind's name in reports, such as "nonmanifold_edges".
std::string_view name_of(DefectKind kind);

struct Defect {
  DefectKind kind{};
  std::int64_t count = 0;
  std::int64_t first = -1;  ///< input vertex for the kinds on vertices, input polygon for the others
  std::string message;      ///< one line: what, how many, where first, and what was done
};

/// The defects that a soup had, all of which have been repaired.
struct DefectReport {
  std::vector<Defect> defects;           ///< each kind at most once, and only with a count above 0
  std::int64_t zero_area_faces = 0;      ///< triangles of three different points on one line: legal, kept
  std::int64_t coincident_vertices = 0;  ///< boundary vertices at the position of another: legal, kept apart
  std::int64_t closable_edges = 0;       ///< boundary edges that welding vertices at equal positions would join
  std::int64_t split_edges = 0;          ///< non-manifold edges that could be cut only with a new midpoint
  /// For the user, one line each: the reader's notes and all of the above, with placeholders (gvd/placeholders.hpp).
  std::vector<std::string> messages;

  /// Number of defects of one kind.
  std::int64_t count(DefectKind kind) const;
};

/// A mesh, and the elements of the soup from which its elements come. `build_mesh` states the properties.
struct CheckedMesh {
  Mesh mesh;
  DefectReport defects;
  std::vector<VertexId> mesh_vertex;              ///< per input vertex; invalid if it was dropped
  IdVector<VertexId, std::int32_t> input_vertex;  ///< -1 for the midpoint of a split edge
  IdVector<FaceId, std::int32_t> input_polygon;
  Appearance appearance;  ///< the soup's appearance, for the faces of the mesh; corners keep their texture coordinates
};

/// Examines a soup, repairs it as `policy` says, triangulates it and builds the mesh.
///
/// Properties: (1) a soup of triangles without a defect becomes the mesh with the same vertices, faces and corners in
/// the same order; (2) otherwise vertices and faces keep their order, and copies of cut vertices follow at the end; (3)
/// no repair moves a vertex or removes area: under `repair` the surface consists of the same points; (4) a polygon,
/// convex or concave, is cut into triangles of its own orientation, without new vertices, and where possible along
/// diagonals that are not edges yet.
///
/// At an edge of three or more faces, two neighbours round the edge stay connected if the inside of the surface lies
/// between them; all other faces are cut apart. Bodies that touch along an edge therefore stay closed, and a fin is cut
/// off. Faces of zero area with three different corners are kept, because without them the surface would have a hole. A
/// component of such faces alone is removed.
///
/// Throws Error{precondition} that names the first offending element, 0-based in the soup. Under `error`, any defect
/// offends. Under the other policies, only a defect that can't be repaired does: a component with one side only, where
/// neighbours disagree about the orientation at 1 % of its edges or more (a coarse Moebius strip; under `largest` only
/// if it is the largest), a polygon that is folded or crosses itself, a coordinate beyond kLargestCoordinate, a mesh
/// smaller than kSmallestExtent or so thin that rounding hides most triangles, or no face left. If `name`, the name of
/// the file, is given, messages begin with it. Cost: O(n log n) time for n corners, O(n) memory.
CheckedMesh build_mesh(const PolygonSoup& soup, DefectPolicy policy = DefectPolicy::repair, std::string_view name = {});

/// Asks `build_mesh` to weld copies of a vertex: vertices at the same position and, if `tolerance` (mesh units) is
/// above 0, vertices near each other, which this call moves to one position. Vertices keep their numbers. Vertices in
/// no polygon are neither moved nor welded to.
///
/// The rule: in the order of their numbers, a vertex stays unless a vertex that stays is at most `tolerance` away. Then
/// every other vertex moves to the nearest vertex that stays, or, of equally near ones, to the one with the smallest
/// number.
/// Properties: (1) no vertex moves farther than the tolerance; (2) different positions are farther than the tolerance
/// apart afterwards, so that welding twice is welding once; (3) vertices at one position stay together; (4) copies that
/// are within the tolerance of each other, and farther than it from all others, become one, whatever their order. Being
/// near is not transitive: in a chain of near vertices, several may stay. A note counts the vertices that were near
/// more than one vertex that stays, because then the tolerance exceeds the spacing of vertices.
/// Vertices that are welded because of this call are no defect: DefectPolicy::error accepts them.
/// Throws Error{invalid_option} if the tolerance is negative, not finite, or above 0 and below kSmallestWeld, and
/// Error{precondition} if it joins all vertices. Cost: O(n log n) time, whatever the tolerance; O(n) memory.
void weld_soup(PolygonSoup& soup, double tolerance = 0);

/// Wraps a mesh that is its own input, so that each element comes from itself. Cost: O(n).
CheckedMesh as_input(Mesh mesh);

/// The limits keep squared areas, products of four lengths, in the range of a double (1e-308 to 1e308).
inline constexpr double kLargestCoordinate = 1e75;  ///< absolute, in mesh units
inline constexpr double kSmallestExtent = 1e-75;    ///< largest side of the bounding box, in mesh units
/// The smallest tolerance of `weld_soup` above 0, in mesh units: below the rounding of any mesh of the smallest extent.
inline constexpr double kSmallestWeld = 1e-100;

}  // namespace gvd
