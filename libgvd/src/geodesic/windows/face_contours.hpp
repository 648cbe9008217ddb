#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/plane.hpp"
#include "geodesic/distance_field.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/windows/chord_check.hpp"
#include "geodesic/windows/path_directions.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Where a curve of equal distance crosses a side of a face, as seen from the face.
struct SideCrossing {
  std::int32_t id;
  std::int32_t side;  ///< 0, 1 or 2: that from corner `side` to the next one
  Vec2 at;            ///< in the layout of the face
  bool leaves;        ///< counter-clockwise round the face, the side leaves the near part here
};

/// A curve of equal distance inside a face: the nearer side is on its left.
struct FaceContour {
  std::int32_t from, to;     ///< ids of crossings of the sides; kClosed for a curve that closes inside the face
  std::vector<Vec2> points;  ///< between them; on the level

  static constexpr std::int32_t kClosed = -1;
};

/// The curves of equal distance in one face after the other. One object serves one thread, to save allocations.
///
/// Properties: (1) each crossing that leaves the near part begins one curve, and each of the others ends one, whatever
/// the numbers are; (2) the points are on the level, and the distance of no point between them differs from it by more
/// than the tolerance; (3) curves that close inside the face are found, unless the distance rises above the level by
/// less than the tolerance inside of them.
class FaceContours {
 public:
  /// `tolerance`: largest distance of a point of a polyline from its level, mesh units, > 0.
  explicit FaceContours(double tolerance) : tolerance_(tolerance) {}

  /// Starts a face. The least of the sources' distances is the distance. Cost: O(k^2) for k sources.
  void enter(const FaceLayout& layout, std::span<const FaceSource> sources);

  /// Appends the curves of one level. `is_near`: whether each corner is within the level. `crossings`: those of the
  /// sides, counter-clockwise from corner 0, numbered from 0; `leaves` alternates and agrees with `is_near`.
  /// Cost: mostly O(k^2 log k + points), where k sources reach the level in the face.
  void trace(double level, const std::array<bool, 3>& is_near, std::span<const SideCrossing> crossings,
             std::vector<FaceContour>& found);

 private:
  /// A circle, or a line, on which a part of a source's level set lies. The near side is on the left.
  struct Carrier {
    enum class Kind { none, circle, line } kind = Kind::none;
    Vec2 at = Vec2::Zero();     // centre, or a point of the line
    Vec2 along = Vec2::Zero();  // unit vector of the line
    double radius = 0;          // of the circle, mesh units

    static Carrier circle(const Vec2& centre, double radius) {
      return {radius > 0 ? Kind::circle : Kind::none, centre, Vec2::Zero(), radius};
    }
    static Carrier line(const Vec2& point, const Vec2& along) { return {Kind::line, point, along, 0}; }
  };
  /// The part of the plane within the level of one source: convex. Its boundary, counter-clockwise, has a part round
  /// the right end of the opening, the part that straight paths reach, and one round the left end.
  struct Region {
    const FaceSource* source;
    std::array<Carrier, 3> part;
  };
  /// A triangle inside the face, with the crossings of its sides, counter-clockwise from corner 0.
  struct Cell {
    std::array<Vec2, 3> corner;
    std::array<bool, 3> is_near;
    std::vector<SideCrossing> crossings;
    std::array<Vec2, 3> side = {};  // unit vectors

    const Vec2& after(std::size_t i) const { return corner[(i + 1) % 3]; }
    /// How far p lies outside, beyond the line of a side; negative inside.
    double outside(const Vec2& p) const {
      return std::max({cross(p - corner[0], side[0]), cross(p - corner[1], side[1]), cross(p - corner[2], side[2])});
    }
    double set_sides();
  };
  /// Indices of regions on the stack.
  struct Range {
    std::size_t begin, end;
  };
  /// A position on the boundary of a region, on the way round it.
  struct Place {
    std::int32_t region;
    std::size_t part;
    Vec2 at;
  };
  /// A point of a curve, and a region that it bounds there: its source is the nearest. -1: none.
  struct CurvePoint {
    Vec2 at;
    std::int32_t region;
  };
  enum class Stop { leaves_cell, enters_region, part_ends };
  class PartOfWay;

  template <class Visit>
  static void intersect(const Carrier& a, const Carrier& b, const Visit& visit);

  void visit(Cell cell, const Range& candidates);
  Range keep_relevant(const Cell& cell, const Range& candidates);
  bool has_no_hole(const Cell& cell, const Range& regions) const;
  std::vector<Directions> list_directions(const Cell& cell, const Range& regions) const;
  bool rises_one_way(const Cell& cell, const Range& regions) const;
  bool follow_all(const Cell& cell, const Range& regions);
  bool add_chords(const Cell& cell, const Range& regions, const CurvePoint& from, const CurvePoint& to, int halvings,
                  std::vector<Vec2>& points);
  bool is_on_level(const Range& regions, const PlaneSegment& chord);
  std::optional<Vec2> find_corner(const Cell& cell, const Range& regions, const CurvePoint& from,
                                  const CurvePoint& to) const;
  std::optional<CurvePoint> find_on_level(const Cell& cell, const Range& regions, CurvePoint p, double distance) const;
  bool follow(const Cell& cell, const Range& regions, const SideCrossing& start, FaceContour& piece);
  Stop advance(const Cell& cell, const Range& regions, Place& place, std::vector<Vec2>& points);
  bool end_at_crossing(const Cell& cell, const Vec2& start, const Vec2& exit, FaceContour& piece);
  void pair(const Cell& cell);
  void split(const Cell& cell, const Range& regions);
  std::vector<SideCrossing> cross_segment(const PlaneSegment& segment, bool near_at_begin, bool near_at_end,
                                          const Range& regions);
  void join_pieces(std::span<const SideCrossing> crossings, std::vector<FaceContour>& found);

  std::int32_t nearest(const Range& regions, const Vec2& p, double& distance) const;
  static std::size_t part_at(const Region& region, const Vec2& p);
  void append(std::vector<Vec2>& points, const Vec2& p) const {
    if (points.empty() || (points.back() - p).norm() > rounding_) points.push_back(p);
  }

  double tolerance_;
  const FaceLayout* layout_ = nullptr;
  std::vector<FaceSource> sources_;
  double longest_ = 0;  // side of the face

  // The state of one level:
  double level_ = 0, rounding_ = 0, chord_ = 0, join_ = 0;
  std::vector<Region> regions_;
  std::vector<std::int32_t> stack_;  // regions that matter in the cell and in those that contain it
  std::vector<FaceContour> pieces_;  // in cells, between crossings of their sides
  std::vector<Vec2> inner_;          // positions of the crossings between cells, whose ids follow those of the sides
  std::int32_t side_crossings_ = 0;  // their number
  std::vector<bool> is_taken_;       // [crossing of the cell]
  ChordCheck check_;
  std::vector<FaceSource::Path> paths_;  // to the middle of a cell
  std::vector<double> stops_;            // on the way round a region, or along a segment
};

}  // namespace gvd
