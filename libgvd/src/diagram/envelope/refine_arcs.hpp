#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "base/plane.hpp"
#include "diagram/envelope/source_distances.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// The shortest paths of two generators to a point, compared: how far the point is from their bisector. Mesh units.
struct BisectorSample {
  /// Bound on the rounding error of a difference of two distances, as a fraction of the distances.
  static constexpr double kDifferenceRounding = 1e-15;

  Vec2 point;
  NearestSource left, right;
  Vec2 gradient;  ///< gradient of the error
  double slope;   ///< length of the gradient

  BisectorSample(const Vec2& p, const NearestSource& to_left, const NearestSource& to_right)
      : point(p),
        left(to_left),
        right(to_right),
        gradient(direction(p, to_left.path.from) - direction(p, to_right.path.from)),
        slope(gradient.norm()) {}

  /// Whether both generators have a path.
  bool is_known() const { return std::isfinite(left.path.distance) && std::isfinite(right.path.distance); }
  /// The difference of the distances: 0 on the bisector, < 0 on its left.
  double error() const { return left.path.distance - right.path.distance; }
  /// The part of the error that may be rounding.
  double rounding() const { return kDifferenceRounding * left.path.distance; }
  /// Direction of the bisector, with the left generator's cell on its left. It is not a unit vector.
  Vec2 tangent() const { return turned_left(gradient); }
  /// How far along the unit vector `across` the two straight paths are equally long. Newton's method finds it to
  /// `precision`. The images stay the same on the way, so that the result may miss the bisector beyond a corner.
  double distance_to_bisector(const Vec2& across, double precision) const;
};

/// A band along a chord, in which a bisector is searched: all points within `width` of it, and up to `width` beyond its
/// two ends. Mesh units.
struct SearchBand {
  Vec2 from;           ///< beginning of the chord
  Vec2 along, across;  ///< unit vectors, the second one to the left of the first
  double length;       ///< length of the chord
  double width;        ///< infinity for a band that is the whole plane

  double position(const Vec2& p) const { return (p - from).dot(along); }
  bool contains(const Vec2& p) const {
    const double at = position(p);
    return std::abs((p - from).dot(across)) <= width && at >= -width && at <= length + width;
  }
  bool is_all() const { return std::isinf(width); }
};

/// A source with the interval of positions along a band in which it may see a point of the band.
struct VisibleSource {
  const FaceSource* source;
  double first, last;  ///< mesh units along the chord
};

/// Replaces `visible` by the sources that may see a point of the band. Cost: O(sources).
void collect_visible_sources(std::span<const FaceSource> sources, const SearchBand& band,
                             std::vector<VisibleSource>& visible);

/// The shortest path to p, which lies at `position` along the band, over the sources that may see it; infinite if there
/// are none.
[[gnu::always_inline]] inline NearestSource nearest_visible(const std::vector<VisibleSource>& visible, double position,
                                                            const Vec2& p) {
  NearestSource best{nullptr, {kInfinity, p}};
  for (const VisibleSource& s : visible) {
    if ((position < s.first) | (position > s.last)) continue;
    if (take_nearer(*s.source, p, best.path)) best.source = s.source;
  }
  return best;
}

/// The change of a generator's shortest path along a segment from one source to another. The distance has a corner
/// there, because it is the smaller one of two distances.
///
/// Both distances count as linear between two positions. They are then equal where their differences divide the way.
class PathChange {
 public:
  /// No change.
  PathChange() = default;
  /// The change from the shortest path to the segment's start to the shortest path to its end. The sources must outlive
  /// this object.
  PathChange(const PlaneSegment& segment, const NearestSource& first, const NearestSource& second)
      : first_(first.source),
        second_(second.source),
        segment_(segment),
        before_(0, second_->distance(segment.from) - first.path.distance),
        after_(1, first_->distance(segment.to) - second.path.distance) {}

  /// How far the distance at the corner lies above the line through its values at the two ends, mesh units.
  double height() const {
    const double sum = before_.excess + after_.excess;
    return sum > 0 ? before_.excess * (after_.excess / sum) : 0;
  }

  /// Finds the position of the corner, as a fraction of the segment. The search ends when no corner higher than `least`
  /// is left on either side of the position, or after eight steps. `height` must be > 0. Cost: two paths a step.
  double find(double least);

 private:
  /// By how much the farther of the two sources is farther at a position.
  struct Excess {
    double position = 0, excess = 0;
    double weight = 0;  ///< weight of the excess in the secant; halved if the position stays twice
    Excess() = default;
    Excess(double at, double by) : position(at), excess(by), weight(by) {}
  };
  double position() const;

  const FaceSource *first_ = nullptr, *second_ = nullptr;
  PlaneSegment segment_{};
  Excess before_, after_;
};

/// Refines the straight arcs of a face to polylines along the bisectors of their two generators, by adding inner
/// points. One object is used for face after face, to save allocations.
class ArcRefiner {
 public:
  /// No segment will be farther than `tolerance` (mesh units, > 0) from the bisector.
  explicit ArcRefiner(double tolerance) : tolerance_(tolerance) {}

  /// Appends the inner points of the arc from `begin` to `end` to `points`, in the face that the distances have
  /// entered.
  /// Cost: O(points) samples over the sources that are visible from near the arc; three samples if the bisector is
  /// straight.
  void refine(const SourceDistances& distances, const FaceArc& arc, const Bary& begin, const Bary& end,
              std::vector<Bary>& points);

 private:
  /// A point of the bisector, and the bisector's direction there.
  struct BisectorPoint {
    BisectorSample sample;
    Vec2 point, tangent;
    explicit BisectorPoint(const BisectorSample& at) : sample(at), point(at.point), tangent(at.tangent()) {}
  };

  BisectorSample sample(const Vec2& p) const;
  bool is_near(const BisectorSample& sample) const;
  bool is_near_between(const BisectorSample& a, const BisectorSample& b, int splits = kMostSplits) const;
  bool is_near_quarters(const BisectorSample& begin, const BisectorSample& end) const;

  bool refine(const BisectorPoint& begin, const BisectorPoint& end, int halvings);
  static double height_by_tangents(const BisectorPoint& begin, const BisectorPoint& end);
  std::optional<Vec2> likely_corner(const BisectorPoint& begin, const BisectorPoint& end) const;
  std::optional<BisectorPoint> find_across(BisectorSample sample, const Vec2& along) const;
  std::pair<double, double> feasible_interval(const Vec2& p, const Vec2& direction) const;

  /// A segment is split at most this often in search of changes, after which a thousandth of it is left.
  static constexpr int kMostSplits = 10;

  double tolerance_;
  const FaceLayout* layout_ = nullptr;       // layout of the current face
  SearchBand band_{};                        // along the current arc
  std::vector<VisibleSource> left_, right_;  // sources of its generators, visible from the band
  std::vector<Bary>* points_ = nullptr;
};

}  // namespace gvd
