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
#include "geodesic/windows/contour_way.hpp"
#include "geodesic/windows/path_directions.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Where a curve of equal distance crosses a side of a face, as seen from the face.
struct SideCrossing {
  std::int32_t id;
  std::int32_t side;  ///< 0, 1 or 2: the side from corner `side` to the next corner
  Vec2 at;            ///< in the layout of the face
  bool leaves;        ///< whether the side, counter-clockwise round the face, leaves the near part here
};

/// A curve of equal distance inside a face: the nearer side is on its left.
struct FaceContour {
  std::int32_t from, to;     ///< ids of crossings of the sides; kClosed for a curve that closes inside the face
  std::vector<Vec2> points;  ///< points on the level between the two crossings

  static constexpr std::int32_t kClosed = -1;
};

/// Finds the curves of equal distance in face after face. One object serves one thread; using it again saves
/// allocations.
///
/// Properties: (1) each crossing that leaves the near part begins one curve, and every other crossing ends one, however
/// numbers are rounded; (2) the points are on the level, and the distance of no point between them differs from it by
/// more than the tolerance; (3) curves that close inside the face are found, unless the distance rises above the level
/// by less than the tolerance inside of them.
class FaceContours {
 public:
  /// `tolerance`: largest distance of a point of a polyline from its level, mesh units, > 0.
  explicit FaceContours(double tolerance) : tolerance_(tolerance) {}

  /// Starts a face. The least of the sources' distances is the distance. Cost: O(k) for k sources.
  void enter(const FaceLayout& layout, std::span<const FaceSource> sources);

  /// Appends the curves of one level. `is_near` tells for each corner whether it is within the level. `crossings` are
  /// the crossings of the sides, counter-clockwise from corner 0, with ids from 0; their `leaves` alternates and agrees
  /// with `is_near`.
  /// Cost: mostly O(k points), where k sources reach the level in the face.
  void trace(double level, const std::array<bool, 3>& is_near, std::span<const SideCrossing> crossings,
             std::vector<FaceContour>& found);

 private:
  /// A triangle inside the face, with the crossings of its sides, counter-clockwise from corner 0.
  struct Triangle {
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
  /// A source that may be the nearest somewhere in a triangle.
  struct Candidate {
    std::int32_t source;              // index
    std::array<double, 3> at_corner;  // its distances at the triangle's corners
    double lowest;                    // no distance in the triangle is less

    /// No distance in the triangle is larger, because distances of one source are convex.
    double most() const { return std::max({at_corner[0], at_corner[1], at_corner[2]}); }
  };
  /// Candidates on the stack.
  struct Range {
    std::size_t begin, end;
  };
  /// A position on the boundary of a source's region.
  struct Place {
    std::int32_t source;
    std::size_t part;
    Vec2 at;
    double off;  // the largest distance of the last chord from the curve
  };
  /// Where a way leaves a triangle, or ends in it.
  struct Exit {
    double at;
    bool leaves_triangle;
  };
  enum class Stop { leaves_triangle, enters_region, part_ends };

  void visit(Triangle& triangle, const Range& candidates);
  Range keep_relevant(const std::array<Vec2, 3>& corner, const Range& candidates, double level);
  bool has_no_hole(const Triangle& triangle, const Range& candidates) const;
  std::vector<Directions> list_directions(const Triangle& triangle, const Range& candidates) const;
  bool rises_one_way(const Triangle& triangle, const Range& candidates) const;
  bool follow_all(const Triangle& triangle, const Range& candidates);
  bool follow(const Triangle& triangle, const Range& candidates, const SideCrossing& start, FaceContour& piece);
  void list_rivals(const Range& candidates, std::int32_t of, const StretchOfWay& stretch);
  void list_stops(const Triangle& triangle, const ContourWay& way, double end);
  Stop advance(const Triangle& triangle, const Range& candidates, Place& place);
  Exit find_exit(const Triangle& triangle, const ContourWay& way);
  bool pass_end(Place& place) const;
  /// Whether a curve that comes through the triangle may end at this crossing.
  bool is_open(const Triangle& triangle, std::size_t crossing) const {
    return !triangle.crossings[crossing].leaves && !is_taken_[crossing];
  }
  std::optional<std::size_t> crossing_at(const Triangle& triangle, const Vec2& exit) const;
  std::optional<std::size_t> cut_at_passed_crossing(const Triangle& triangle, std::vector<Vec2>& points) const;
  bool end_at_crossing(const Triangle& triangle, const Place& exit, FaceContour& piece);
  void pair(const Triangle& triangle);
  void split(const Triangle& triangle, const Range& candidates);
  std::vector<SideCrossing> cross_segment(const PlaneSegment& segment, bool near_at_begin, bool near_at_end,
                                          const Range& candidates);
  void join_pieces(std::span<const SideCrossing> crossings, std::vector<FaceContour>& found);

  std::int32_t nearest(const Range& candidates, const Vec2& p, double& distance) const;
  void keep_nearer(std::int32_t source, const Vec2& p, std::int32_t& best, double& distance) const;

  double tolerance_;
  const FaceLayout* layout_ = nullptr;
  std::span<const FaceSource> sources_;
  std::vector<Candidate> of_face_;
  std::vector<std::int32_t> beaten_corners_;  // corners to which a window also brings their distance
  double longest_ = 0;                        // longest side of the face

  // The state of one level:
  double level_ = 0, rounding_ = 0, chord_ = 0, join_ = 0;
  std::vector<Candidate> stack_;     // candidates of the triangle and of the triangles that contain it
  std::vector<FaceContour> pieces_;  // in triangles, between crossings of their sides
  std::vector<Vec2> inner_;  // positions of the crossings between triangles, whose ids follow those of the sides
  std::int32_t side_crossings_ = 0;  // number of crossings of the sides
  std::vector<bool> is_taken_;       // per crossing of the triangle: whether a curve ends there
  ChordChain chain_;
  std::vector<std::int32_t> rivals_;  // sources that may be as near as the level somewhere on the way
  std::vector<double> stops_;         // positions on the way round a region, or along a segment
};

}  // namespace gvd
