#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/soup.hpp"
#include "gvd/vec.hpp"
#include "mesh/visit_edges.hpp"

// The steps of `build_mesh`, and the data that they hand on: polygons, then triangles, and the log of defects.
namespace gvd {

/// Throws Error{precondition}. `element` is the polygon or the vertex of the soup that the message names.
[[noreturn]] inline void refuse_soup(const std::string& message, std::int64_t element) {
  throw Error(ErrorCode::precondition, message, element);
}

/// Collects the defects of a soup in a report. Under DefectPolicy::error it throws on the first one.
class DefectLog {
 public:
  explicit DefectLog(DefectPolicy policy) : policy_(policy) {}

  /// Adds a defect. `what` says what is wrong and where first, `action` how it was repaired. Does nothing where `count`
  /// is 0.
  void add(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& what, const std::string& action);
  /// Adds what the user asked for, which no policy refuses. Does nothing where `count` is 0.
  void add_asked(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& message);
  DefectPolicy policy() const { return policy_; }
  DefectReport& report() { return report_; }

 private:
  DefectPolicy policy_;
  DefectReport report_;
};

/// A position and its vertex, to sort vertices by their positions, then by their numbers.
using PlacedVertex = std::pair<std::array<double, 3>, std::int32_t>;

/// Per vertex whether it is a corner of a polygon. Corners that are no vertices, which `build_mesh` refuses, are
/// skipped. Cost: O(n).
std::vector<char> find_used_vertices(const PolygonSoup& soup);

/// The polygons of a soup while they are cleaned. Corners are vertices of the soup.
struct WorkPolygons {
  std::vector<std::int32_t> corners;         ///< of all polygons, one after the other
  std::vector<std::size_t> first_corner{0};  ///< per polygon, and the number of corners at the end
  std::vector<std::int32_t> origin;          ///< per polygon, its polygon in the soup

  std::size_t count() const { return origin.size(); }
  std::span<const std::int32_t> polygon(std::size_t p) const {
    return {corners.data() + first_corner[p], first_corner[p + 1] - first_corner[p]};
  }
  /// Makes a polygon of the corners that were appended last; `from` is its polygon in the soup.
  void close(std::int32_t from) {
    first_corner.push_back(corners.size());
    origin.push_back(from);
  }
};

/// Triangles while they are oriented and cut. Halfedge 3 f + i runs from corner i of face f to the next corner.
struct WorkFaces {
  std::vector<std::array<std::int32_t, 3>> faces;  ///< vertices of the soup, until `cut_vertices` appends copies
  std::vector<std::int32_t> origin;                ///< per face, its polygon in the soup
  std::vector<std::int32_t> twin;                  ///< per halfedge, -1 where there is none
  std::vector<std::int32_t> source;  ///< after `cut_vertices`: per vertex, its vertex in the soup, -1 for a midpoint
  std::vector<Vec3> positions;       ///< after `cut_vertices`: per vertex, in mesh units

  std::int32_t from(std::int32_t h) const { return faces[h / 3][h % 3]; }
  std::int32_t to(std::int32_t h) const { return from(next(h)); }
  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t previous(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::int32_t face_count() const { return static_cast<std::int32_t>(faces.size()); }
  std::int32_t halfedge_count() const { return 3 * face_count(); }
  /// Makes two halfedges each other's twins.
  void link(std::int32_t a, std::int32_t b) {
    twin[a] = b;
    twin[b] = a;
  }
};

/// Edges of three or more faces: the halfedges of each, ascending, whatever their direction.
using EdgeTable = std::vector<std::vector<std::int32_t>>;

// The steps of `build_mesh` in their order. Each one logs the defects that it repairs, and the log throws under
// DefectPolicy::error. All of them are deterministic. `positions` are those of the soup.

/// Welds vertices at one position: all that polygons have in an STL or after `weld_soup`, elsewhere those that a
/// polygon edge joins.
/// Returns per input vertex the vertex that replaces it: itself, or an earlier one at the same position.
/// Cost: O(n log n) for an STL, else O(n).
std::vector<std::int32_t> weld_vertices(const PolygonSoup& soup, DefectLog& log);

/// Takes repeated corners out of every polygon and drops polygons of fewer than three corners. `weld` is the table of
/// `weld_vertices`. Throws Error{precondition} where no polygon is left. Cost: O(n).
WorkPolygons remove_degenerate_faces(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, DefectLog& log);

/// Drops polygons with the corners of an earlier one, in either direction. Two faces back to back that no other face
/// touches stay: they are a closed surface. Cost: O(n) where degrees are bounded, O(n log n) at worst.
void remove_duplicate_faces(WorkPolygons& polygons, std::size_t vertex_count, DefectLog& log);

/// Cuts polygons into triangles: quadrilaterals along their better diagonal, larger ones by clipping ears. `twin` is
/// left empty. A quadrilateral that is folded or crosses itself is a defect, and is cut where a diagonal leaves two
/// triangles with area. Throws Error{precondition} for any other such polygon, and for one too complex.
/// Cost: O(n log n + n r) for each polygon of n corners, r of them not convex.
WorkFaces triangulate_polygons(WorkPolygons polygons, const std::vector<Vec3>& positions, DefectLog& log);

/// The corners of a polygon in space, and their projection to a plane.
struct ProjectedPolygon {
  std::vector<Vec3> space;  ///< relative to the first corner, scaled so that the largest coordinate is 1
  std::vector<Vec2> plane;  ///< of `space`, along the polygon's normal; all y are 0 where it lies on a line
  bool is_on_line = false;
  /// Whether the projection turns by 2 pi once round, as that of every simple polygon does. False where there is no
  /// normal either, although the corners do not lie on a line: then the polygon crosses itself.
  bool turns_once = false;
};

/// Projects a polygon along its normal by Newell's formula, so that the orientation becomes counter-clockwise.
/// Input: three or more corners, indices into `positions`, not all at one position. Cost: O(n).
ProjectedPolygon project_polygon(std::span<const std::int32_t> polygon, const std::vector<Vec3>& positions);

/// Sets `twin` of the two halfedges of each edge with two faces, whatever their direction. Returns the edges of three
/// or more faces, in the order of `visit_edges`. Cost: that of `visit_edges`.
EdgeTable pair_halfedges(WorkFaces& work, std::size_t vertex_count);

/// Cuts components with one side only open, where the orientations of two faces disagree at fewer than 1 % of the
/// component's edges: along those of these edges where no flip of faces helps. Faces keep their orientations. Returns
/// the ends of the cut edges: the vertices that `cut_vertices` shall not count. Cost: O(n), and O(k log k) for k such
/// edges.
std::vector<std::int32_t> cut_twists(WorkFaces& work, DefectLog& log);

/// Flips faces so that each component follows the majority of its faces. The halfedges in `nonmanifold_edges` follow
/// the flips. Returns per face 1 where its component has one side only; DefectPolicy::error and ::repair refuse that
/// with Error{precondition}. Cost: O(n).
std::vector<char> orient_faces(WorkFaces& work, EdgeTable& nonmanifold_edges, DefectLog& log);

/// Pairs halfedges at edges of three or more faces: neighbours round the edge stay together where the inside of the
/// surface lies between them. Halfedges without a partner stay cut apart. Faces of a component with one side only are
/// left out. `one_sided` is the result of `orient_faces`. Returns per vertex whether it is on such an edge.
/// Cost: O(n log n) for n halfedges of such edges.
std::vector<char> cut_edges(WorkFaces& work, const EdgeTable& nonmanifold_edges, const std::vector<Vec3>& positions,
                            const std::vector<char>& one_sided, DefectLog& log);

/// Under DefectPolicy::largest: drops the faces of all components but the one with the largest area. `one_sided` is the
/// result of `orient_faces`. Throws Error{precondition} where the largest one has one side only. Cost: O(n).
void keep_largest_component(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& one_sided,
                            DefectLog& log);

/// Gives every fan of faces a vertex of its own: the first fan keeps the vertex, the others get copies at the end.
/// Fills `source` and `positions`. A vertex counts as a defect unless it is `on_cut_edge`, the result of `cut_edges`.
/// Cost: O(n).
void cut_vertices(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& on_cut_edge,
                  DefectLog& log);

/// Splits edges that were cut apart and still have both ends in common: all copies but the first get a midpoint.
///
/// A body may touch itself along an edge whose two ends have all their faces connected round them. Then each end has
/// one fan and stays one vertex. A mesh that identifies an edge by its two vertices would take the copies for one edge.
/// Splitting them changes no point of the surface.
/// Throws Error{precondition} where an edge is too short for a midpoint. Cost: O(n log n).
void split_touching_edges(WorkFaces& work, DefectLog& log);

/// Drops the components of which no face has area: nothing else hangs on them. Where no component has
/// an area, all are kept. Comes after the cuts, which may leave such components behind. Cost: O(n).
void drop_zero_area_components(WorkFaces& work, DefectLog& log);

/// The appearance of the soup on the faces of the mesh that it became. The midpoint of a split edge has the texture
/// coordinates that are linear between the edge's ends. Cost: O(n), and O(k) for each corner of a polygon with k ones.
Appearance carry_appearance(const PolygonSoup& soup, const CheckedMesh& checked);

/// Counts the copies of vertices along open edges of the mesh, and the edges that welding would close, and notes them.
/// `weld_tolerance`: of `weld_soup`, if it was called; where that has joined nothing, a note says so. Cost: O(n log n)
/// for n open edges.
void examine_open_edges(CheckedMesh& checked, std::optional<double> weld_tolerance);

}  // namespace gvd
