#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Points of a face whose barycentric coordinates differ by at most this are merged. A crossing computed from two sides
/// differs by about 1e-15.
inline constexpr double kCutWeld = 1e-12;

/// Positions are merged if their coordinates differ by at most this many units in the last place of the mesh's largest
/// coordinate. An interpolated position has four rounding errors: one for each of three terms, and one for the sum.
inline constexpr double kPositionUlps = 4;

/// The tolerance of positions in a mesh (kPositionUlps), mesh units.
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

  /// Returns the number of the border's corner with the same vertex, or of an inner corner that coincides in
  /// barycentric coordinates (kCutWeld) or in position (`tolerance`). Otherwise adds the corner.
  /// Cost: O(log n) to find, and O(1) for each corner with nearly the same coordinate along one axis; O(n) to add.
  std::size_t find_or_add(const Corner& corner);

  /// Adds a polygon of the face, counter-clockwise.
  void add(Polygon polygon) { polygons_.push_back(std::move(polygon)); }

  /// Splits segments at the corners that lie on them, so that adjacent polygons share whole segments. Then checks that
  /// the polygons tile the face: each segment belongs to two polygons, or to a polygon and the border. Returns false if
  /// they don't.
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
    /// The smallest number of a corner within `tolerance` of the coordinate that passes the test and is below `limit`;
    /// `limit` if there is none.
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
  /// The position of a corner along the face's longest side, from 0 to 1. Along this side, even a needle has only few
  /// corners between the ends of a segment that crosses it.
  double along(const Corner& corner) const { return interpolate(corner.bary, along_[0], along_[1], along_[2]); }
  std::vector<std::size_t> split_segments(const std::vector<std::size_t>& polygon, double tolerance) const;
  /// Appends the corners on the segment in order: corners on the same edge of the face, and corners within `tolerance`.
  void append_corners_between(std::size_t from, std::size_t to, double tolerance, std::vector<std::size_t>& out) const;
  bool on_one_edge(std::size_t a, std::size_t b, std::size_t c) const;
  bool tiles(const std::vector<Polygon>& polygons) const;

  std::vector<Corner> corners_;  // the border's corners come first
  std::size_t border_;
  double tolerance_;
  int axis_ = 0;  // the axis along which the face is longest
  Bary along_{};  // the positions of the face's corners
  SortedCorners by_along_, by_position_;
  std::vector<std::pair<VertexId, std::size_t>> by_vertex_;  // the border's corners, ascending
  std::vector<Polygon> polygons_;
};

}  // namespace gvd
