#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/soup.hpp"
#include "mesh/visit_edges.hpp"

namespace gvd {

/// Keeps the account of defects; under DefectPolicy::error it throws on the first.
class DefectLog {
 public:
  explicit DefectLog(DefectPolicy policy) : policy_(policy) {}

  /// `what` says what there is and where first, `action` what is done about it. Nothing happens where count is 0.
  void add(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& what, const std::string& action);
  DefectPolicy policy() const { return policy_; }
  DefectReport& report() { return report_; }

 private:
  DefectPolicy policy_;
  DefectReport report_;
};

/// "1 face" or "3 faces".
std::string counted(std::int64_t count, const std::string& singular, const std::string& plural);

[[noreturn]] inline void refuse_soup(const std::string& message, std::int64_t element) {
  throw Error(ErrorCode::precondition, message, element);
}

/// The polygons of a soup while they are cleaned; `origin` is each one's polygon in the soup.
struct WorkPolygons {
  std::vector<std::int32_t> corners;
  std::vector<std::size_t> first_corner{0};
  std::vector<std::int32_t> origin;

  std::size_t count() const { return origin.size(); }
  std::span<const std::int32_t> polygon(std::size_t p) const {
    return {corners.data() + first_corner[p], first_corner[p + 1] - first_corner[p]};
  }
  void close(std::int32_t from) {
    first_corner.push_back(corners.size());
    origin.push_back(from);
  }
};

/// Triangles while they are oriented and cut. Halfedge 3 f + i runs from corner i of face f to the next corner.
struct WorkFaces {
  std::vector<std::array<std::int32_t, 3>> faces;  ///< input vertices, until `cut_vertices` numbers its copies
  std::vector<std::int32_t> origin;                ///< per face its polygon in the soup
  std::vector<std::int32_t> twin;                  ///< per halfedge, -1 where there is none
  std::vector<std::int32_t> source;  ///< once vertices are cut: per vertex its input vertex, -1 for a midpoint
  std::vector<Vec3> positions;       ///< once vertices are cut: per vertex

  std::int32_t from(std::int32_t h) const {
    return faces[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)];
  }
  std::int32_t to(std::int32_t h) const { return from(next(h)); }
  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t previous(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::int32_t halfedge_count() const { return static_cast<std::int32_t>(3 * faces.size()); }
};

template <class Visit>
void visit_edges(const WorkFaces& work, std::size_t vertex_count, const Visit& visit) {
  visit_edges(
      work.faces, vertex_count, [](std::int32_t v) { return static_cast<std::uint64_t>(v); }, visit);
}

/// The halfedges of one edge: `halfedges[begin, end)` of an EdgeTable, ascending.
struct EdgeGroup {
  std::size_t begin, end;
  std::size_t size() const { return end - begin; }
};

/// Edges with their halfedges, whatever their direction.
struct EdgeTable {
  std::vector<std::int32_t> halfedges;
  std::vector<EdgeGroup> edges;

  void add(const EdgeHalfedges& edge) {
    edges.push_back({halfedges.size(), halfedges.size() + edge.size()});
    for (std::size_t i = 0; i < edge.size(); ++i) halfedges.push_back(edge[i]);
  }
};

// The steps of `build_mesh`, in the order in which it takes them; each in a file of its own.

/// Indices in range, coordinates finite and of a size that can be computed with.
void examine_soup(const PolygonSoup& soup);
/// Per input vertex the vertex that it becomes, itself or an earlier one at the same position.
std::vector<std::int32_t> weld_vertices(const PolygonSoup& soup, DefectLog& log);
/// Takes repeated corners out and drops polygons of fewer than three. `weld` is the table of `weld_vertices`.
WorkPolygons remove_degenerate_faces(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, DefectLog& log);
void remove_duplicate_faces(WorkPolygons& polygons, std::size_t vertex_count, DefectLog& log);
/// Throws Error{precondition} for a polygon that crosses itself.
WorkFaces triangulate_polygons(WorkPolygons polygons, const std::vector<Vec3>& positions);
/// Pairs the two halfedges of every edge of two faces, whatever their direction. Returns the edges of three or more, in
/// the order of visit_edges.
EdgeTable pair_halfedges(WorkFaces& work, std::size_t vertex_count);
/// Flips faces; `crowded`, the edges of three or more faces, follows the flips. Returns per face 1 where its component
/// has one side only; under `error` and `repair` that is refused.
std::vector<char> orient_faces(WorkFaces& work, EdgeTable& crowded, DefectLog& log);
/// Pairs halfedges at edges of three or more faces; what it leaves alone is cut. Faces of a component with one side
/// only are left out. Returns per vertex whether it is on such an edge.
std::vector<char> cut_edges(WorkFaces& work, const EdgeTable& crowded, const std::vector<Vec3>& positions,
                            const std::vector<char>& one_sided, DefectLog& log);
/// Under `largest`: drops the faces of all other components. `one_sided` as from `orient_faces`.
void keep_largest_component(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& one_sided,
                            DefectLog& log);
/// Gives every fan of faces a vertex of its own. Fills `source` and `positions`.
void cut_vertices(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& on_cut_edge,
                  DefectLog& log);
/// Splits edges that are cut, and yet have both ends in common with another edge.
void split_touching_edges(WorkFaces& work, DefectLog& log);

}  // namespace gvd
