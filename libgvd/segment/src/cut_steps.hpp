#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "gvd/diagram.hpp"
#include "gvd/segment.hpp"

// The steps of `cut_faces`: the pieces of one face fitted together, and repairs of the triangles of all faces.

namespace gvd {

// face_tiling.cpp

/// Points of a face whose barycentric coordinates differ by at most this are merged. A crossing computed from two sides
/// differs by some 1e-15.
inline constexpr double kCutWeld = 1e-12;

/// Positions are merged if their coordinates differ by at most this many units in the last place of the mesh's largest
/// coordinate. An interpolated position has four rounding errors: one for each of three terms, and one for the sum.
inline constexpr double kPositionUlps = 4;

/// The tolerance of positions (kPositionUlps) for a mesh, mesh units.
double position_tolerance(const Mesh& mesh);

inline bool coincide(const Vec3& p, const Vec3& q, double tolerance) {
  return (p - q).cwiseAbs().maxCoeff() <= tolerance;
}

/// The corners and polygons of one cut face.
class FaceTiling {
 public:
  struct Corner {
    Bary bary;
    Vec3 position;
    VertexId vertex;  ///< invalid for a corner inside the face that is not yet a vertex
  };
  struct Polygon {
    GeneratorId generator;
    std::vector<std::size_t> corners;
  };

  /// `border`: the face's three corners and the points on its edges, counter-clockwise from its first corner.
  /// `tolerance`: see position_tolerance.
  FaceTiling(std::vector<Corner> border, double tolerance);

  /// The number of the corner: of the border's corner with the same vertex, or of one inside that coincides in
  /// barycentric coordinates (kCutWeld) or in position (`tolerance`). Otherwise it becomes a new one.
  /// Cost: O(log n) to find, and O(1) for each corner with nearly the same coordinate along one axis; O(n) to add.
  std::size_t find_or_add(const Corner& corner);

  /// Adds a polygon of the face, counter-clockwise.
  void add(Polygon polygon) { polygons_.push_back(std::move(polygon)); }

  /// Splits segments at the corners that lie on them, so that adjacent polygons share whole segments. Then checks that
  /// the polygons tile the face: each segment belongs to two polygons, or to one and the border. False if they don't.
  /// Cost: O(n log n) if only a few segments are long.
  bool fit();

  /// Removes all polygons and the corners inside; the face becomes one polygon.
  void leave_whole(GeneratorId generator);

  std::vector<Corner>& corners() { return corners_; }
  const std::vector<Polygon>& polygons() const { return polygons_; }
  /// A corner in the plane of two barycentric coordinates.
  Vec2 plane_point(std::size_t corner) const { return affine_point(corners_[corner].bary); }

 private:
  /// Corners sorted by a coordinate.
  class SortedCorners {
   public:
    void insert(double coordinate, std::size_t corner) {
      const std::pair item(coordinate, corner);
      corners_.insert(std::lower_bound(corners_.begin(), corners_.end(), item), item);
    }
    /// The corners with a coordinate from `low` to `high`.
    std::span<const std::pair<double, std::size_t>> between(double low, double high) const;
    /// The smallest number below `limit` of a corner that passes the test, among those within `tolerance` of the
    /// coordinate; `limit` if there is none.
    template <class Test>
    std::size_t find(double coordinate, double tolerance, std::size_t limit, const Test& passes) const;

   private:
    std::vector<std::pair<double, std::size_t>> corners_;
  };

  void index(std::size_t corner) {
    by_along_.insert(along(corners_[corner]), corner);
    by_position_.insert(corners_[corner].position[axis_], corner);
  }
  std::size_t find_vertex(VertexId vertex) const;
  /// Position of a corner along the face's longest side, from 0 to 1: there, few corners of a needle lie between the
  /// ends of a segment that crosses it.
  double along(const Corner& corner) const { return interpolate(corner.bary, along_[0], along_[1], along_[2]); }
  std::vector<std::size_t> split_segments(const std::vector<std::size_t>& polygon, double tolerance) const;
  /// Appends the corners on the segment in order: those on the same edge of the face, and those within `tolerance`.
  void append_corners_between(std::size_t from, std::size_t to, double tolerance, std::vector<std::size_t>& out) const;
  bool on_one_edge(std::size_t a, std::size_t b, std::size_t c) const;
  bool tiles(const std::vector<Polygon>& polygons) const;

  std::vector<Corner> corners_;  // the border first
  std::size_t border_;
  double tolerance_;
  int axis_ = 0;  // the axis along which the face is longest
  Bary along_{};  // the positions of the face's corners
  SortedCorners by_along_, by_position_;
  std::vector<std::pair<VertexId, std::size_t>> by_vertex_;  // the border's corners, ascending
  std::vector<Polygon> polygons_;
};

// cut_faces.cpp

/// A triangle of a cut mesh.
struct CutTriangle {
  std::array<VertexId, 3> corners;
  FaceId parent;
  GeneratorId label = {};
  std::int32_t polygon = 0;  ///< the polygon that contains the triangle, numbered over all parents
  bool operator==(const CutTriangle&) const = default;
};

/// The triangles of a cut mesh before it is built. The triangles of a parent are consecutive, and so are those of a
/// polygon.
struct CutTriangles {
  std::vector<Vec3> positions;
  std::vector<CutTriangle> triangles;
};

/// Calls visit(triangles) for each parent, with the span of its triangles.
template <class Visit>
void for_each_parent(std::span<const CutTriangle> all, Visit visit) {
  while (!all.empty()) {
    const auto is_other = [parent = all[0].parent](const CutTriangle& t) { return t.parent != parent; };
    const std::size_t count = std::ranges::find_if(all, is_other) - all.begin();
    visit(all.first(count));
    all = all.subspan(count);
  }
}

/// Splits each edge inside a parent at its midpoint if another edge joins the same two vertices: inside another parent,
/// on the border of a parent, or inside another polygon. Each split adds one vertex, and two triangles after those of
/// the parent. Cost: O(k log k) for the k triangles of parents that are cut, and O(n) in all.
void split_doubled_edges(CutTriangles& cut);

/// Moves corners of a triangle apart that have the same position, by a small multiple of `tolerance` (mesh units; see
/// position_tolerance).
///
/// In a face without area, cuts through two of its sides can have the same position but are different vertices, one on
/// each side. Vertices from `first_added` on may move, each along the longest edge of its parent; the vertices of the
/// input do not. Returns the number of rounds that moved a vertex; with kMaxSeparationRounds some may still coincide.
/// Cost: O(k) for k triangles in each of a few rounds.
int separate_coincident_corners(CutTriangles& cut, std::size_t first_added, double tolerance);

/// Each round moves by twice the length of the one before. It separates vertices that the last one moved onto each
/// other or onto a third. The last round moves by 2^19 times the tolerance, 5e-10 of the largest coordinate; a longer
/// move would change the shape.
inline constexpr int kMaxSeparationRounds = 20;

// part_touching_regions.cpp

/// Parts regions that touch themselves at a vertex: round it, the faces of a label are not consecutive.
///
/// All but one of the sectors of a label give their corners at the vertex, a tiny part of their faces, to a region
/// beside them, or the region between two sectors gives its corner to these if they are not connected otherwise.
/// `cells` are those of the diagram: a corner goes to a cell only that has a bisector with its own. `tolerance`: see
/// position_tolerance. Faces that are cut stay in the order of their parents, with new vertices behind the others.
/// Regions still touch themselves where only labels without such a bisector surround them, or where two labels
/// alternate that both are connected already.
/// Cost: O(n) where no label changes four times round a vertex, otherwise O(n log n) for each of a few rounds.
void part_touching_regions(const IdVector<GeneratorId, Cell>& cells, double tolerance, CutMesh& cut);

}  // namespace gvd
