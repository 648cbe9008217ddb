#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Two points of a face are one below this distance, in barycentric coordinates: the same crossing, computed from two
/// sides, differs by some 1e-15.
inline constexpr double kCutWeld = 1e-12;

/// Two positions are one where they lie within this many rounding steps of the mesh's largest coordinate from each
/// other: a point between two others is rounded by one step in each of the three terms, and once for their sum.
inline constexpr double kPlaceSteps = 4;

/// kPlaceSteps for the coordinates of a mesh, mesh units.
double place_reach(const Mesh& mesh);

inline bool same_place(const Vec3& p, const Vec3& q, double reach) { return (p - q).cwiseAbs().maxCoeff() <= reach; }

/// The corners and polygons of one face that is cut.
class FaceTiling {
 public:
  struct Corner {
    std::array<double, 3> bary;
    Vec3 position;
    VertexId vertex;  ///< invalid for a corner inside the face that no mesh has yet
  };
  struct Polygon {
    GeneratorId generator;
    std::vector<std::size_t> corners;
  };

  /// `border`: the face's three corners and the points on its edges, counter-clockwise from its first corner.
  /// `reach`: see place_reach.
  FaceTiling(std::vector<Corner> border, double reach);

  /// The corner on the border with this vertex, or one inside within kCutWeld or at the same place; a new one
  /// otherwise. Cost: O(log n) to look, with those that are nearly as far along one axis; O(n) to add, as a sorted list
  /// moves up.
  std::size_t find_or_add(const Corner& corner);

  /// Adds a polygon of the face, counter-clockwise.
  void add(Polygon polygon) { polygons_.push_back(std::move(polygon)); }

  /// Makes the polygons share whole segments: a corner that lies on another's segment splits it. Then checks that they
  /// tile the face, each segment between two of them or once on the border. False where they don't.
  /// Cost: O(n log n), as long as only a few segments are long.
  bool fit();

  /// Forgets all polygons and corners inside: the face is one polygon.
  void leave_whole(GeneratorId generator);

  std::vector<Corner>& corners() { return corners_; }
  const std::vector<Polygon>& polygons() const { return polygons_; }
  /// Where a corner is drawn: two barycentric coordinates, an affine picture of the face.
  Vec2 place(std::size_t corner) const { return {corners_[corner].bary[1], corners_[corner].bary[2]}; }

 private:
  /// Corners in the order of one of their coordinates.
  class Order {
   public:
    void insert(double coordinate, std::size_t corner);
    /// The corners with a coordinate from `low` to `high`.
    std::span<const std::pair<double, std::size_t>> between(double low, double high) const;

   private:
    std::vector<std::pair<double, std::size_t>> corners_;
  };

  void enter(std::size_t corner);
  /// The least of the corners near one coordinate of theirs that passes the test, and is less than `found`.
  template <class Test>
  static std::size_t find_near(const Order& order, double coordinate, double reach, std::size_t found,
                               const Test& passes);
  std::vector<std::size_t> split_segments(const std::vector<std::size_t>& polygon, double reach) const;
  /// The corners on the segment: those on the same edge of the face, and those within `reach`.
  void append_corners_between(std::size_t from, std::size_t to, double reach, std::vector<std::size_t>& out) const;
  bool on_one_edge(std::size_t a, std::size_t b, std::size_t c) const;
  bool tiles(const std::vector<Polygon>& polygons) const;
  double twice_area(const std::vector<std::size_t>& polygon) const;

  std::vector<Corner> corners_;  ///< the border first
  std::size_t border_;
  double reach_;
  int axis_ = 0;  ///< along which the face is longest
  Order by_bary_, by_position_;
  std::vector<Polygon> polygons_;
};

}  // namespace gvd
