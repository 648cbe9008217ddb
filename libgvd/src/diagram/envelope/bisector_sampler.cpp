// How far a point or a segment is from the bisector of two generators, by the shortest paths of both.
//
// The distance from the bisector is the difference of the two distances, divided by the length of its gradient. Between
// samples a bisector is smooth, except where a path changes from one source to another: there it has a corner. Changes
// are found by the sources of neighbouring samples, and sampled unless the corner can't be high. Only sources visible
// from a band along the arc's chord are looked at.
#include "diagram/envelope/bisector_sampler.hpp"

#include <algorithm>

namespace gvd {
namespace {

constexpr int kNewtonSteps = 4;

/// Distance from the bisector allowed at a sample, as a fraction of the tolerance: samples at the quarters of a segment
/// show three quarters of the height of a curve, and half of that of a corner at least.
constexpr double kShown = 0.5;

/// Corners that are lower than this fraction of the tolerance are not looked for. A curve that passes the samples is at
/// most 2 / 3 of the tolerance high, so the sum stays below the tolerance.
constexpr double kHiddenCorner = 0.1;

/// A segment is split at most so often in search of changes: a thousandth of it is left.
constexpr int kMostSplits = 10;

/// Whether a path that changes from one source to another has a corner higher than `hidden`, mesh units. It has none
/// where the two are openings for one image: its distance is that of one straight path.
bool may_have_corner(const FaceSource& first, const FaceSource& second, double hidden) {
  return (first.image - second.image).norm() + std::abs(first.offset - second.offset) > hidden;
}

/// The change of the left or of the right path between two samples, whichever makes the higher corner.
PathChange highest_change(const BisectorSample& a, const BisectorSample& b, double hidden) {
  PathChange left, right;
  const PlaneSegment segment{a.point, b.point};
  if (a.left_source != b.left_source && may_have_corner(*a.left_source, *b.left_source, hidden)) {
    left = PathChange(segment, *a.left_source, a.left.distance, *b.left_source, b.left.distance);
  }
  if (a.right_source != b.right_source && may_have_corner(*a.right_source, *b.right_source, hidden)) {
    right = PathChange(segment, *a.right_source, a.right.distance, *b.right_source, b.right.distance);
  }
  return left.height() > right.height() ? left : right;
}

}  // namespace

double BisectorSample::distance_to_bisector(const Vec2& across, double precision) const {
  const Vec2 from_left = point - left.from, from_right = point - right.from;
  const double offset_difference = error() - from_left.norm() + from_right.norm();
  double s = 0;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Vec2 to_left = from_left + s * across, to_right = from_right + s * across;
    const double far_left = to_left.norm(), far_right = to_right.norm();
    const double slope = across.dot(to_left) / far_left - across.dot(to_right) / far_right;
    const double step = (offset_difference + far_left - far_right) / slope;
    s -= step;
    if (!(std::abs(step) > precision)) break;
  }
  return s;
}

// A ray past an end of an opening separates the visible from the hidden points. In the band, the side of the ray
// depends on the position along it. The distance from the chord changes it by at most a bound.
void collect_visible_sources(std::span<const FaceSource> sources, const SearchBand& band,
                             std::vector<VisibleSource>& visible) {
  visible.clear();
  for (const FaceSource& s : sources) {
    double first = -kInfinity, last = kInfinity;
    if (!s.is_corner && !band.is_all()) {
      const Vec2 start = band.from - s.image;
      for (const Vec2& ray : {Vec2(s.begin - s.image), Vec2(s.image - s.end)}) {
        // Points at position t may be visible where at_start + rate t + slack >= 0.
        const double at_start = cross(start, ray), rate = cross(band.along, ray);
        const double slack = band.width * std::abs(cross(band.across, ray));
        const double limit = -(at_start + slack) / rate;
        if (rate > 0) first = std::max(first, limit);
        if (rate < 0) last = std::min(last, limit);
      }
    }
    if (first <= std::min(last, band.length + band.width) && last >= -band.width) {
      visible.push_back({&s, first, last});
    }
  }
}

void BisectorSampler::enter(const SourceDistances& distances, const FaceArc& arc, const SearchBand& band) {
  band_ = band;
  collect_visible_sources(distances.sources(arc.left), band, left_);
  collect_visible_sources(distances.sources(arc.right), band, right_);
}

BisectorSample BisectorSampler::sample(const Vec2& p) const {
  const double position = band_.position(p);
  const auto left = nearest_visible(left_, position, p), right = nearest_visible(right_, position, p);
  return {p, left.path, right.path, left.source, right.source};
}

bool BisectorSampler::is_near(const BisectorSample& sample) const {
  return sample.is_known() &&
         std::abs(sample.error()) <= 8 * sample.rounding() + kShown * tolerance_ * sample.gradient().norm();
}

bool BisectorSampler::is_near_between(const BisectorSample& a, const BisectorSample& b) const {
  return is_near_between(a, b, kMostSplits);
}

bool BisectorSampler::is_near_between(const BisectorSample& a, const BisectorSample& b, int splits) const {
  if (a.left_source == b.left_source && a.right_source == b.right_source) return true;
  if (splits == 0 || (b.point - a.point).squaredNorm() <= tolerance_ * tolerance_) return true;
  // Two changes, of the left and of the right path, may add up.
  const double hidden = 0.5 * kHiddenCorner * tolerance_ * std::min(a.gradient().norm(), b.gradient().norm());
  PathChange change = highest_change(a, b, hidden);
  if (change.height() <= hidden) return true;
  const BisectorSample between = sample(a.point + change.find(hidden) * (b.point - a.point));
  return is_near(between) && is_near_between(a, between, splits - 1) && is_near_between(between, b, splits - 1);
}

}  // namespace gvd
