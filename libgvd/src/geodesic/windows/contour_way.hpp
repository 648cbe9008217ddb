#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "base/plane.hpp"
#include "geodesic/distance_field.hpp"
#include "gvd/vec.hpp"

namespace gvd {

// The region of a face that a source reaches within a level is convex. Its boundary has three parts, in
// counter-clockwise order: part 0 lies round the right end of the opening, straight paths reach part 1, and part 2 lies
// round the left end. The region of a corner has only part 1.

/// A circle, or a line, on which a part of a source's level set lies. The near side is on the left.
struct Carrier {
  enum class Kind { none, circle, line } kind = Kind::none;
  Vec2 at = Vec2::Zero();     ///< centre, or a point of the line
  Vec2 along = Vec2::Zero();  ///< unit vector of the line
  double radius = 0;          ///< the circle's radius, mesh units

  static Carrier circle(const Vec2& centre, double radius) {
    return {radius > 0 ? Kind::circle : Kind::none, centre, Vec2::Zero(), radius};
  }
  static Carrier line(const Vec2& point, const Vec2& along) { return {Kind::line, point, along, 0}; }
};

inline Carrier carrier_of(const FaceSource& s, std::size_t part, double level) {
  if (part == 1) {
    return s.is_parallel()
               ? Carrier::line(s.begin + (level - s.distance_begin) * s.direction(), turned_left(s.direction()))
               : Carrier::circle(s.image, level - s.offset);
  }
  if (s.is_corner()) return {};
  return part == 0 ? Carrier::circle(s.end, level - s.distance_end)
                   : Carrier::circle(s.begin, level - s.distance_begin);
}

/// The part of the boundary of a source's region on which p lies.
inline std::size_t part_at(const FaceSource& s, const Vec2& p) {
  if (s.is_corner() || (s.beside(p, s.begin) >= 0 && s.beside(p, s.end) <= 0)) return 1;
  return s.beside(p, s.begin) < 0 ? 2 : 0;
}

/// If the square of the common chord of two circles is negative, the circles count as touching up to this fraction of
/// the radius' square. A superfluous point only costs time: it is tried, and the curve does not turn there.
inline constexpr double kTouching = 1e-9;

/// Calls visit(p) for the common points of two carriers, or for their nearest points if they almost touch.
template <class Visit>
void intersect(const Carrier& a, const Carrier& b, const Visit& visit) {
  using Kind = Carrier::Kind;
  if (a.kind == Kind::none || b.kind == Kind::none) return;
  if (a.kind == Kind::line && b.kind == Kind::line) {
    const double denominator = cross(a.along, b.along);
    if (denominator != 0) visit(Vec2(a.at + cross(b.at - a.at, b.along) / denominator * a.along));
    return;
  }
  if (b.kind == Kind::line) return intersect(b, a, visit);
  // A line and a circle, or two circles. Two circles intersect where the first of them intersects the line of the
  // common chord. `foot` is the chord's middle, `along` its direction.
  const bool is_line = a.kind == Kind::line;
  const Vec2 way = b.at - a.at;
  const double square_apart = way.squaredNorm(), sum = a.radius + b.radius, difference = a.radius - b.radius;
  if (!is_line) {  // most circles are far apart, or one is inside the other
    const double slack = kTouching * sum * sum;
    if (square_apart == 0 || square_apart > sum * sum + slack || square_apart < difference * difference - slack) return;
  }
  const double apart = std::sqrt(square_apart);
  const Vec2 along = is_line ? a.along : Vec2(turned_left(way) / apart);
  const double radius = is_line ? b.radius : a.radius;
  const double from_centre = is_line ? cross(a.along, way) : 0.5 * (apart + difference * (sum / apart));
  const double square = (radius - from_centre) * (radius + from_centre);
  if (!(square >= -kTouching * radius * radius)) return;
  const Vec2 foot = is_line ? Vec2(a.at + way.dot(along) * along) : Vec2(a.at + from_centre / apart * way);
  const double half = std::sqrt(std::max(0.0, square));
  visit(Vec2(foot - half * along));
  visit(Vec2(foot + half * along));
}

/// The way along a part of a region's boundary, counter-clockwise from a point of it to its end. Positions are angles
/// on a circle and lengths on a line.
class ContourWay {
 public:
  ContourWay(const FaceSource& s, std::size_t part, double level, const Vec2& from)
      : carrier_(carrier_of(s, part, level)), from_(from) {
    if (carrier_.kind == Carrier::Kind::line) {
      // Along the front, to the path through the left end.
      end_ = std::max(0.0, (s.begin - from).dot(carrier_.along));
      return;
    }
    arm_ = from - carrier_.at;
    const double length = arm_.norm();
    arm_ = length > 0 ? Vec2(carrier_.radius / length * arm_) : Vec2(carrier_.radius, 0);
    if (s.is_corner() || part == 2) {
      end_ = s.is_corner() ? kFullTurn : std::numbers::pi;
      return;
    }
    const Vec2 through_end = s.is_parallel() ? s.direction() : Vec2((part == 0 ? s.end : s.begin) - s.image);
    end_ = turn(arm_, through_end);
    if (end_ > std::numbers::pi) end_ = 0;  // by rounding: the way is at its end already
  }

  const Carrier& carrier() const { return carrier_; }
  double end() const { return end_; }
  Vec2 at(double t) const {
    if (carrier_.kind == Carrier::Kind::line) return from_ + t * carrier_.along;
    return carrier_.at + std::cos(t) * arm_ + std::sin(t) * turned_left(arm_);
  }
  double position(const Vec2& p) const {
    return carrier_.kind == Carrier::Kind::line ? (p - from_).dot(carrier_.along) : turn(arm_, p - carrier_.at);
  }
  /// The number of equal chords that the way up to t needs to stay within `sagitta` of the arc.
  int chords(double t, double sagitta) const {
    if (carrier_.kind == Carrier::Kind::line) return 1;
    const double widest = 2 * std::acos(std::max(0.0, 1 - sagitta / carrier_.radius));
    return std::max(1, static_cast<int>(std::ceil(t / std::min(widest, kWidestChord))));
  }
  /// The largest distance of a chord that spans t from its arc.
  double sagitta(double t) const {
    return carrier_.kind == Carrier::Kind::line ? 0 : carrier_.radius * (1 - std::cos(0.5 * t));
  }

 private:
  static constexpr double kFullTurn = 2 * std::numbers::pi;  // radians
  /// The largest angle that a chord spans, in radians, so that a small circle does not become a triangle.
  static constexpr double kWidestChord = std::numbers::pi / 6;

  /// The angle from a to b, counter-clockwise, in [0, 2 pi).
  static double turn(const Vec2& a, const Vec2& b) {
    const double angle = std::atan2(cross(a, b), a.dot(b));
    return angle < 0 ? angle + kFullTurn : angle;
  }

  Carrier carrier_;
  Vec2 from_, arm_ = Vec2::Zero();  // arm_: from the centre to the beginning
  double end_ = 0;
};

/// The beginning of a ContourWay up to a position, on which it bounds the distances of sources from below.
///
/// The distance of one source is a convex function on the plane, so that its tangent plane at any point is a lower
/// bound.
class StretchOfWay {
 public:
  StretchOfWay(const ContourWay& way, double length) : middle_(way.at(0.5 * length)) {
    hull_ = {way.at(0), middle_, way.at(length)};
    if (way.carrier().kind == Carrier::Kind::line) {
      along_ = way.carrier().along;
      half_ = 0.5 * length;
      return;
    }
    const double radius = way.carrier().radius, half = 0.5 * length;
    outwards_ = (middle_ - way.carrier().at) / radius;
    along_ = turned_left(outwards_);
    half_ = radius * (half < 0.5 * std::numbers::pi ? std::sin(half) : 1);
    sagitta_ = radius * (1 - std::cos(half));
    // Where the tangents of both ends meet.
    is_short_ = half < kShort;
    if (is_short_) hull_[1] = middle_ + radius * (1 / std::cos(half) - 1) * outwards_;
  }

  /// Whether straight paths of the source may reach the stretch; never false if they do. Paths that pass the stretch at
  /// less than `slack` count, too. No image is farther from the stretch than `farthest`. Mesh units.
  bool may_see(const FaceSource& s, double slack, double farthest) const {
    if (s.is_corner() || !is_short_) return true;
    const double least = slack * (s.is_parallel() ? 1 : farthest);
    const auto is_beyond_begin = [&](const Vec2& p) { return s.beside(p, s.begin) < -least; };
    const auto is_beyond_end = [&](const Vec2& p) { return s.beside(p, s.end) > least; };
    return !std::ranges::all_of(hull_, is_beyond_begin) && !std::ranges::all_of(hull_, is_beyond_end);
  }

  /// Whether the source may have a path of at most `limit` to a point of the stretch. Never false if it has.
  bool may_reach(const FaceSource& s, double limit) const {
    // Distances change at most as fast as points move, and no path is shorter than the straight line from the image.
    const double farthest = half_ + sagitta_, left = limit + farthest - s.offset;
    if (left < 0 || (!s.is_parallel() && (middle_ - s.image).squaredNorm() > left * left)) return false;
    const FaceSource::Path path = s.shortest_path(middle_);
    if (path.distance > limit + farthest) return false;
    const Vec2 last = middle_ - path.from;
    const double fall = sagitta_ * std::max(0.0, last.dot(outwards_)) + half_ * std::abs(last.dot(along_));
    return (path.distance - limit) * last.norm() <= fall;
  }

 private:
  /// An arc is enclosed in a triangle only if half its angle is at most this many radians.
  static constexpr double kShort = 1;

  Vec2 middle_, along_ = Vec2::Zero(), outwards_ = Vec2::Zero();
  std::array<Vec2, 3> hull_;  // a triangle that contains the stretch
  bool is_short_ = true;
  double half_ = 0, sagitta_ = 0;  // how far points of the stretch are from its middle, along it and inwards
};

inline double distance_to_segment(const PlaneSegment& segment, const Vec2& p) {
  const Vec2 way = segment.to - segment.from;
  return (p - segment.from - nearest_on_segment(segment.from, way, p) * way).norm();
}

/// The straight pieces that approximate a curve. The end of an arc that is not a corner is left out if a single piece
/// without it is near enough to the curve.
class ChordChain {
 public:
  /// Begins a chain. `tolerance` is the largest distance of a piece from the curve; points nearer than `same` count as
  /// one. Mesh units.
  void begin(const Vec2& from, double tolerance, double same) {
    points_.assign(1, from);
    tolerance_ = tolerance;
    same_ = same;
    is_corner_ = true;
  }
  /// Continues the chain to p. `off` is the largest distance of the new piece from the curve. If `is_corner`, p must be
  /// kept.
  void add(const Vec2& p, double off, bool is_corner) {
    const std::size_t n = points_.size();
    if ((points_.back() - p).norm() <= same_) {
      is_corner_ = is_corner_ || is_corner;
      return;
    }
    // Every point of the curve is near a point of the two pieces, which is near a point of the single piece.
    const double without =
        is_corner_ ? kInfinity : distance_to_segment({points_[n - 2], p}, points_[n - 1]) + std::max(off_, off);
    if (without <= tolerance_) {
      points_.back() = p;
      off_ = without;
    } else {
      points_.push_back(p);
      off_ = off;
    }
    is_corner_ = is_corner;
  }
  std::vector<Vec2>& points() { return points_; }

 private:
  std::vector<Vec2> points_;
  double tolerance_ = 0, same_ = 0;
  double off_ = 0;          // largest distance of the last piece from the curve
  bool is_corner_ = false;  // whether the last point is one
};

}  // namespace gvd
