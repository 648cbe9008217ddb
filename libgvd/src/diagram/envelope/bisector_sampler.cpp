#include "diagram/envelope/bisector_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "diagram/envelope/path_change.hpp"

namespace gvd {
namespace {

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

void BisectorSampler::enter(const FaceArc& arc, const SearchBand& band) {
  band_ = band;
  collect_visible_sources(distances_.sources(arc.left), band, left_);
  collect_visible_sources(distances_.sources(arc.right), band, right_);
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
