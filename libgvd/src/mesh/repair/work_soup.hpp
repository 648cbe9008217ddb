#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/soup.hpp"
#include "mesh/visit_edges.hpp"

// The data that the repair steps hand on: polygons, then triangles, and the log of defects.
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
  DefectPolicy policy() const { return policy_; }
  DefectReport& report() { return report_; }

 private:
  DefectPolicy policy_;
  DefectReport report_;
};

/// A position and its vertex.
using PlacedVertex = std::pair<std::array<double, 3>, std::int32_t>;

/// Vertices in the order of their positions, then of their numbers. Cost: O(n log n).
std::vector<PlacedVertex> sort_by_position(const std::vector<Vec3>& positions);

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

/// `visit_edges` for the faces at work.
template <class Visit>
void visit_edges(const WorkFaces& work, std::size_t vertex_count, const Visit& visit) {
  visit_edges(
      work.faces, vertex_count, [](std::int32_t v) { return static_cast<std::uint64_t>(v); }, visit);
}

/// Edges of three or more faces: the halfedges of each, ascending, whatever their direction.
using EdgeTable = std::vector<std::vector<std::int32_t>>;

}  // namespace gvd
