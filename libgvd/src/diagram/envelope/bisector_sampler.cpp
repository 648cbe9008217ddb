#include "diagram/envelope/bisector_sampler.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "base/plane.hpp"

namespace gvd {
namespace {

/// Distance from the bisector allowed at a sample, as a fraction of the tolerance: samples at the quarters of a segment
/// show three quarters of the height of a curve, and half of that of a corner at least.
constexpr double kShown = 0.5;

/// A path that changes this near to an end of a segment, as a fraction of it, changes at the end, where a sample is.
constexpr double kAtEnd = 1e-3;

/// A segment is split at most so often in search of changes: a thousandth of it is left.
constexpr int kMostSplits = 10;

/// The positions at which the rays past the ends of a source's opening cross the line from a (0) to b (1).
std::array<double, 2> ray_positions(const FaceSource& s, const Vec2& a, const Vec2& b) {
  const auto position = [&](const Vec2& end) {
    return cross(s.image - a, end - s.image) / cross(b - a, end - s.image);
  };
  return {position(s.begin), position(s.end)};
}

/// A position between a (0) and b (1) where the path of a generator may change from one source to another: where a ray
/// past an end of an opening crosses, or in the middle, for sources that tie. Nothing where the rays of both sources
/// cross at the same end.
std::optional<double> change_position(const FaceSource& first, const FaceSource& second, const Vec2& a, const Vec2& b) {
  std::array<int, 2> at_begin{}, at_end{};
  for (std::size_t i = 0; i < 2; ++i) {
    const FaceSource& source = i == 0 ? first : second;
    if (source.is_corner) at_begin[i] = at_end[i] = 1;  // it has no rays, and may be the nearest from anywhere on
    for (const double t : ray_positions(source, a, b)) {
      if (t > kAtEnd && t < 1 - kAtEnd) return t;
      at_begin[i] += std::abs(t) <= kAtEnd ? 1 : 0;
      at_end[i] += std::abs(t - 1) <= kAtEnd ? 1 : 0;
    }
  }
  if ((at_begin[0] > 0 && at_begin[1] > 0) || (at_end[0] > 0 && at_end[1] > 0)) return std::nullopt;
  return 0.5;
}

/// A position to sample between a and b; nothing where their paths change at the ends only, or not at all.
std::optional<double> split_position(const BisectorSample& a, const BisectorSample& b) {
  if (a.left_source != b.left_source) {
    if (const auto t = change_position(*a.left_source, *b.left_source, a.point, b.point)) return t;
  }
  if (a.right_source == b.right_source) return std::nullopt;
  return change_position(*a.right_source, *b.right_source, a.point, b.point);
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
  if (splits == 0 || (b.point - a.point).norm() <= tolerance_) return true;
  const auto t = split_position(a, b);
  if (!t) return true;
  const BisectorSample between = sample(a.point + *t * (b.point - a.point));
  return is_near(between) && is_near_between(a, between, splits - 1) && is_near_between(between, b, splits - 1);
}

}  // namespace gvd
