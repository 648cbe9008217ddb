#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "base/plane.hpp"
#include "gvd/error.hpp"
#include "gvd/remesh.hpp"

namespace gvd {

/// The faces of a remesh that stand for one branch point: a regular polygon in the plane, cut into triangles.
///
/// A map to the plane that is affine on each triangle takes the faces to it. Corner i stands for the i-th cell round
/// the branch point, counter-clockwise.
struct DualPolygon {
  struct Triangle {
    FaceId face;
    std::array<std::size_t, 3> corners{};  ///< of the polygon, in the order of the face's
  };
  std::vector<GeneratorId> cells;
  std::vector<Triangle> triangles;
  Vec2 centre = Vec2::Zero();  ///< the image of the branch point: inside, or on a side at the boundary
  /// Parameters at which the bisectors cross the sides, from 0 at a corner to 1 at the next one.
  std::vector<double> crossings;

  Vec2 corner(std::size_t i) const {
    return unit_vector(2 * std::numbers::pi * double(i % cells.size()) / double(cells.size()));
  }
  /// The point where the bisector crosses the side from corner i to the next one.
  Vec2 crossing(std::size_t i) const { return corner(i) + crossings[i] * (corner(i + 1) - corner(i)); }
  /// The number of a cell; cells.size() if it is none of them.
  std::size_t find(GeneratorId cell) const { return std::find(cells.begin(), cells.end(), cell) - cells.begin(); }
  /// The point of the remesh that the map takes to `point`, which is in the polygon up to rounding.
  SurfacePoint on_remesh(const Vec2& point) const;
};

/// The polygons of a remesh, one for each vertex of the cut surface at which three or more cells meet.
class DualPolygons {
 public:
  /// Vertex i of `remesh` stands for the cell with label i. Refers to `remesh`, which must outlive it.
  /// Returns Error{no_valid_result} unless every face of the remesh belongs to exactly one polygon.
  /// Cost: O(n), and O(k^2) for k cells round a vertex.
  static OrError<DualPolygons> try_to_build(const Mesh& cut, const IdVector<FaceId, GeneratorId>& label,
                                            const Mesh& remesh);

  /// The polygon of a vertex; null if fewer than three cells meet there.
  const DualPolygon* at(VertexId v) const { return number_[v] < 0 ? nullptr : &polygons_[number_[v]]; }

  /// Sets where the bisector between two cells crosses the remesh's edge, if it begins or ends at v. The polygon's side
  /// goes from cell a to cell b, `t` from 0 to 1.
  void set_crossing(VertexId v, GeneratorId a, double t) {
    if (number_[v] < 0) return;
    DualPolygon& polygon = polygons_[number_[v]];
    polygon.crossings[polygon.find(a)] = t;
  }

  const Mesh& remesh() const { return remesh_; }

 private:
  DualPolygons(std::int32_t vertices, const Mesh& remesh)
      : remesh_(remesh), number_(vertices, -1), is_used_(remesh.face_count(), 0) {}

  /// Adds the polygon of vertex v. Returns what is wrong with its cells; null if nothing is.
  const char* add(const Mesh& cut, VertexId v, std::vector<GeneratorId> cells);
  const char* fill(DualPolygon& polygon);
  /// Invalid if there is none.
  HalfedgeId find_halfedge(GeneratorId from, GeneratorId to) const;

  const Mesh& remesh_;
  std::vector<DualPolygon> polygons_;
  IdVector<VertexId, std::int32_t> number_;  ///< of the polygon; -1 for none
  IdVector<FaceId, char> is_used_;           ///< per face of the remesh
};

}  // namespace gvd
