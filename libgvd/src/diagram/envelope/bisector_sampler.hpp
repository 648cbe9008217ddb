#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "base/plane.hpp"
#include "base/segment.hpp"
#include "diagram/envelope/source_distances.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "geodesic/field/distance_field.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The shortest paths of two generators to a point, compared: how far the point is from their bisector. Mesh units.
struct BisectorSample {
  /// Rounding of a difference of two distances, as a fraction of them.
  static constexpr double kDifferenceRounding = 1e-15;

  Vec2 point;
  FaceSource::Path left, right;
  const FaceSource *left_source = nullptr, *right_source = nullptr;  ///< of the two paths

  /// Whether both generators have a path.
  bool is_known() const { return std::isfinite(left.distance) && std::isfinite(right.distance); }
  /// The difference of the distances: 0 on the bisector, < 0 on its left.
  double error() const { return left.distance - right.distance; }
  /// The part of the error that may be rounding.
  double rounding() const { return kDifferenceRounding * left.distance; }
  /// The gradient of the error.
  Vec2 gradient() const { return direction(point, left.from) - direction(point, right.from); }
  /// Direction of the bisector, with the left generator's cell on its left; not a unit vector.
  Vec2 tangent() const { return turned_left(gradient()); }
  /// How far along `across`, a unit vector, the two straight paths are equally long, by Newton's method to `precision`.
  /// Their images stay the same on the way, so that this may leave the bisector at a corner.
  double distance_to_bisector(const Vec2& across, double precision) const;
};

/// A band along a chord, in which a bisector is searched: all points within `width` of it, and up to `width` beyond its
/// two ends. Mesh units.
struct SearchBand {
  Vec2 from;           ///< beginning of the chord
  Vec2 along, across;  ///< unit vectors, the second one to the left of the first
  double length;       ///< of the chord
  double width;        ///< infinite for a band that is the whole plane

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

/// The shortest path to p, at a position along the band, over the sources that may see it; infinite where none does.
inline SourceDistances::Nearest nearest_visible(const std::vector<VisibleSource>& visible, double position,
                                                const Vec2& p) {
  SourceDistances::Nearest best{nullptr, {kInfinity, p}};
  for (const VisibleSource& s : visible) {
    if ((position < s.first) | (position > s.last)) continue;
    if (take_nearer(*s.source, p, best.path)) best.source = s.source;
  }
  return best;
}

/// The change of one generator's shortest path along a segment, from one source to another. There the distance has a
/// corner: it is the lesser one of two distances.
///
/// Both distances count as linear between two positions. Then they are equal where their differences divide the way.
class PathChange {
 public:
  /// No change.
  PathChange() = default;
  /// From the source that is the nearest at the segment's start, at this distance, to the one at its end.
  /// Both must outlive this.
  PathChange(const PlaneSegment& segment, const FaceSource& first, double at_start, const FaceSource& second,
             double at_end)
      : first_(&first),
        second_(&second),
        segment_(segment),
        before_{0, second.distance(segment.from) - at_start},
        after_{1, first.distance(segment.to) - at_end} {}

  /// How far the distance at the corner lies above the line through its values at the two ends, mesh units.
  double height() const {
    const double sum = before_.excess + after_.excess;
    return sum > 0 ? before_.excess * (after_.excess / sum) : 0;
  }

  /// The position of the corner, as a fraction of the segment: so near that no corner higher than `least` is left on
  /// either side of it, or after eight steps. Call it while `height` > 0. Cost: two paths a step.
  double find(double least) {
    for (int step = 0; step < kMostSteps && height() > least; ++step) {
      const double t = position();
      const Vec2 p = segment_.from + t * (segment_.to - segment_.from);
      const double excess = second_->distance(p) - first_->distance(p);
      if (excess > 0) {
        before_ = {t, excess};
      } else {
        after_ = {t, -excess};
      }
    }
    return position();
  }

 private:
  static constexpr int kMostSteps = 8;

  /// By how much the farther one of the two sources is farther at a position.
  struct Excess {
    double position = 0, excess = 0;
  };
  double position() const {
    const double sum = before_.excess + after_.excess;
    const double share = sum > 0 ? before_.excess / sum : 0.5;
    return before_.position + share * (after_.position - before_.position);
  }

  const FaceSource *first_ = nullptr, *second_ = nullptr;
  PlaneSegment segment_{};
  Excess before_, after_;
};

/// Samples the bisector of an arc's two generators in a band of a face, and tells whether segments are near enough.
class BisectorSampler {
 public:
  /// `tolerance` in mesh units, > 0.
  explicit BisectorSampler(double tolerance) : tolerance_(tolerance) {}

  /// Takes the sources of the arc's generators that may see a point of the band. The distances must stay in their face
  /// while samples are taken.
  void enter(const SourceDistances& distances, const FaceArc& arc, const SearchBand& band);

  const SearchBand& band() const { return band_; }
  BisectorSample sample(const Vec2& p) const;

  /// Whether the bisector is within half of the tolerance of a sample: its distance is the error divided by the
  /// gradient.
  bool is_near(const BisectorSample& sample) const;
  /// The same for the segment between two samples that are near enough. The bisector has a corner where a path changes
  /// from one source to another. So the segment is sampled where paths change, unless the corner can't be high.
  /// Cost: a few paths for each change. A corner that may be high takes one sample or more, over all sources that may
  /// see the band.
  bool is_near_between(const BisectorSample& a, const BisectorSample& b) const;

 private:
  bool is_near_between(const BisectorSample& a, const BisectorSample& b, int splits) const;

  double tolerance_;
  SearchBand band_{};
  std::vector<VisibleSource> left_, right_;
};

}  // namespace gvd
