// Refines the straight arcs of a face to polylines along the bisectors of their two generators.
//
// A bisector consists of pieces of hyperbolas, which are straight where the two offsets are equal. It has a corner
// wherever the nearest source of a generator changes. A segment that is too far from the bisector is split at a point
// of the bisector; the tangents at its ends and a few samples tell whether it is too far. The distance of a sample from
// the bisector is the difference of the two shortest paths, divided by the gradient of the difference. All of this
// happens in a narrow band along the arc, with the sources that are visible from the band. If the bisector leaves the
// band, the arc is refined again with all sources.
// Source: not in the paper, whose bisectors are straight inside a face. Its refinement of crossings on edges is in
// growth/refine_bisectors.cpp.
#include "diagram/envelope/refine_arcs.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace gvd {
namespace {

constexpr int kNewtonSteps = 4;

/// Distance from the bisector that is allowed at a sample, as a fraction of the tolerance. Samples at the quarters of a
/// segment show three quarters of the height of a curve, and at least half of the height of a corner.
constexpr double kShown = 0.5;

/// Corners between two samples are looked for only if the height of the curve plus those of the corners may exceed this
/// fraction of the tolerance. The height of the curve is estimated as this many times the samples' distance, which is
/// exact at the quarters of a parabola.
constexpr double kWithCorners = 0.95, kCurveHeight = 4.0 / 3;

/// The height that is allowed for corners even if the samples use up that fraction. This happens at the ends of an arc,
/// which lie beside the bisector if the distances of two faces disagree.
constexpr double kLowCorner = 0.05;

/// Where a segment is compared with the bisector, as fractions of the segment. The quarters show three quarters of the
/// height of a curve. Wherever a corner lies between the ends, one of the two shows at least half of its height.
constexpr std::array<double, 2> kSegmentSamples{0.25, 0.75};
constexpr double kShownHeight = 0.5;

/// Largest number of halvings of an arc. After these, a tenth of a double's digits is left for the length of a segment.
constexpr int kMostArcHalvings = 40;

constexpr int kMostSteps = 60;

/// Largest distance of an inner point from the bisector, as a fraction of the tolerance.
constexpr double kOnBisector = 1e-3;

/// A corner nearer than this to an end of the segment, as a fraction of the segment, is not used, because the segment
/// must become shorter.
constexpr double kNearEnd = 0.01;

/// Error that is accepted when the search can't move the point any more, as a fraction of the distance.
constexpr double kIndistinguishable = 1e-13;

/// Half width of the first search band, as a fraction of the arc's length. Samples in the band only look at the sources
/// that are visible from it. A wider band has more sources; more bisectors leave a narrower band, and are traced again
/// with all sources.
constexpr double kBandWidth = 0.05;

/// Largest number of steps of the search for the corner at which a path changes.
constexpr int kMostChangeSteps = 8;

/// A line through a point, with a direction.
struct PlaneRay {
  Vec2 origin, direction;
};

/// The change of a path between two samples; none if both have the same source.
PathChange change_between(const PlaneSegment& segment, const NearestSource& a, const NearestSource& b) {
  return a.source == b.source ? PathChange() : PathChange(segment, a, b);
}

}  // namespace

double BisectorSample::distance_to_bisector(const Vec2& across, double precision) const {
  const Vec2 from_left = point - left.path.from, from_right = point - right.path.from;
  const double offset_difference = error() - from_left.norm() + from_right.norm();
  double s = 0;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Vec2 to_left = from_left + s * across, to_right = from_right + s * across;
    const double far_left = to_left.norm(), far_right = to_right.norm();
    const double rate = across.dot(to_left) / far_left - across.dot(to_right) / far_right;
    const double step = (offset_difference + far_left - far_right) / rate;
    s -= step;
    if (!(std::abs(step) > precision)) break;
  }
  return s;
}

// A ray past an end of an opening separates visible from hidden points. On which side of the ray a point of the band
// lies depends on its position along the band, and on its distance from the chord, whose effect has a bound.
void collect_visible_sources(std::span<const FaceSource> sources, const SearchBand& band,
                             std::vector<VisibleSource>& visible) {
  visible.clear();
  for (const FaceSource& s : sources) {
    double first = -kInfinity, last = kInfinity;
    if (!s.is_corner() && !band.is_all()) {
      // The rays past the ends of the opening, each given by a point and its direction.
      const std::array<PlaneRay, 2> rays =
          s.is_parallel() ? std::array{PlaneRay{s.begin, s.direction()}, PlaneRay{s.end, -s.direction()}}
                          : std::array{PlaneRay{s.image, s.begin - s.image}, PlaneRay{s.image, s.image - s.end}};
      for (const auto& [origin, ray] : rays) {
        const Vec2 start = band.from - origin;
        // Points at position t may be visible if at_start + rate t + slack >= 0.
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

double PathChange::position() const {
  const double sum = before_.weight + after_.weight;
  const double share = sum > 0 ? before_.weight / sum : 0.5;
  return before_.position + share * (after_.position - before_.position);
}

/// Uses the Illinois variant of the secant method: without halved weights, one of the two ends would stay in place.
double PathChange::find(double least) {
  const Excess* last = nullptr;
  for (int step = 0; step < kMostChangeSteps && height() > least; ++step) {
    const double t = position();
    const Vec2 p = segment_.from + t * (segment_.to - segment_.from);
    const double excess = second_->distance(p) - first_->distance(p);
    Excess &moved = excess > 0 ? before_ : after_, &kept = excess > 0 ? after_ : before_;
    moved = {t, std::abs(excess)};
    if (std::exchange(last, &moved) == &moved) kept.weight *= 0.5;
  }
  return position();
}

BisectorSample ArcRefiner::sample(const Vec2& p) const {
  const double position = band_.position(p);
  return {p, nearest_visible(left_, position, p), nearest_visible(right_, position, p)};
}

/// Whether the bisector is within half of the tolerance of a sample. Its distance is the error divided by the gradient.
bool ArcRefiner::is_near(const BisectorSample& sample) const {
  return sample.is_known() && std::abs(sample.error()) <= 8 * sample.rounding() + kShown * tolerance_ * sample.slope;
}

/// The same for the segment between two samples that are near enough. The bisector has a corner where a path changes
/// from one source to another, so the segment is sampled where paths change, unless the corners can't be high because
/// no distance is larger than the distances from the sources at the two ends.
/// Cost: two paths for each change, and samples where the corners may be high.
bool ArcRefiner::is_near_between(const BisectorSample& a, const BisectorSample& b, int splits) const {
  if (a.left.source == b.left.source && a.right.source == b.right.source) return true;
  if (splits == 0 || (b.point - a.point).squaredNorm() <= tolerance_ * tolerance_) return true;
  const double whole = tolerance_ * std::min(a.slope, b.slope);
  const double curve = kCurveHeight * std::max(std::abs(a.error()), std::abs(b.error()));
  const double hidden = std::max(kWithCorners * whole - curve, kLowCorner * whole);
  const PathChange left = change_between({a.point, b.point}, a.left, b.left);
  const PathChange right = change_between({a.point, b.point}, a.right, b.right);
  const double left_height = left.height(), right_height = right.height();
  if (left_height + right_height <= hidden) return true;
  PathChange change = left_height > right_height ? left : right;
  const BisectorSample between = sample(a.point + change.find(0.25 * hidden) * (b.point - a.point));
  return is_near(between) && is_near_between(a, between, splits - 1) && is_near_between(between, b, splits - 1);
}

bool ArcRefiner::is_near_quarters(const BisectorSample& begin, const BisectorSample& end) const {
  BisectorSample last = begin;
  for (const double fraction : kSegmentSamples) {
    const BisectorSample next = sample(begin.point + fraction * (end.point - begin.point));
    if (!is_near(next) || !is_near_between(last, next)) return false;
    last = next;
  }
  return is_near_between(last, end);
}

/// Distance from the chord to the lines along the tangents at its ends. A bisector with one corner stays within this
/// distance, even if an end is a corner, too, whose tangent says nothing about the curve beyond it.
double ArcRefiner::height_by_tangents(const BisectorPoint& begin, const BisectorPoint& end) {
  const Vec2 chord = end.point - begin.point;
  return std::max(std::abs(cross(begin.tangent, chord)) / begin.tangent.norm(),
                  std::abs(cross(end.tangent, chord)) / end.tangent.norm());
}

void ArcRefiner::refine(const SourceDistances& distances, const FaceArc& arc, const Bary& begin, const Bary& end,
                        std::vector<Bary>& points) {
  layout_ = &distances.layout();
  points_ = &points;
  const Vec2 from = layout_->at(begin), to = layout_->at(end), chord = to - from;
  const double length = chord.norm();
  if (length <= tolerance_) return;
  const std::size_t before = points.size();
  for (const double width : {kBandWidth * length, kInfinity}) {
    band_ = {from, chord / length, turned_left(chord) / length, length, width};
    collect_visible_sources(distances.sources(arc.left), band_, left_);
    collect_visible_sources(distances.sources(arc.right), band_, right_);
    points.resize(before);
    const BisectorSample first = sample(from), last = sample(to);
    if (first.is_known() && last.is_known() && refine(BisectorPoint(first), BisectorPoint(last), 0)) return;
  }
}

/// Appends the inner points between begin and end if the segment between them is not near enough to the bisector.
/// Returns false if the bisector leaves the search band.
bool ArcRefiner::refine(const BisectorPoint& begin, const BisectorPoint& end, int halvings) {
  const Vec2 chord = end.point - begin.point, middle = 0.5 * (begin.point + end.point);
  const double length = chord.norm();
  if (halvings >= kMostArcHalvings || length <= tolerance_) return true;
  const bool is_flat = height_by_tangents(begin, end) <= tolerance_;
  const Vec2 guess = is_flat ? middle : likely_corner(begin, end).value_or(middle);
  const auto height = [&](const Vec2& p) { return std::abs(cross(p - begin.point, chord)) / length; };
  const bool is_low = !is_flat && height(guess) <= tolerance_;
  if (is_low && is_near_quarters(begin.sample, end.sample)) return true;
  const BisectorSample at_guess = sample(guess);
  if (is_flat && is_near(at_guess) && is_near_between(begin.sample, at_guess) &&
      is_near_between(at_guess, end.sample)) {
    return true;
  }
  const auto split = find_across(at_guess, chord / length);
  if (!split) return band_.is_all();
  if (!band_.contains(split->point)) return false;
  if (!is_low && height(split->point) <= kShownHeight * tolerance_ && is_near_quarters(begin.sample, end.sample))
    return true;
  if (!refine(begin, *split, halvings + 1)) return false;
  points_->push_back(layout_->bary(split->point));
  return refine(*split, end, halvings + 1);
}

/// The corner of a bisector that is straight on both sides of the corner: the intersection of the tangents at the two
/// ends. Nothing if it is near an end or beyond it, far from the chord, or outside the face.
std::optional<Vec2> ArcRefiner::likely_corner(const BisectorPoint& begin, const BisectorPoint& end) const {
  const Vec2 chord = end.point - begin.point;
  const double t = intersect_lines(begin.point, begin.tangent, end.point, end.tangent).s;
  const Vec2 corner = begin.point + t * begin.tangent;
  const double fraction = (corner - begin.point).dot(chord) / chord.squaredNorm();
  const bool is_between =
      fraction > kNearEnd && fraction < 1 - kNearEnd && (corner - begin.point - fraction * chord).norm() < chord.norm();
  if (!is_between) return std::nullopt;
  const auto bary = layout_->bary(corner);
  if (*std::min_element(bary.begin(), bary.end()) < 0) return std::nullopt;
  return corner;
}

/// How far p can move along `direction` without leaving the face: from <= 0 to >= 0, in units of its length.
std::pair<double, double> ArcRefiner::feasible_interval(const Vec2& p, const Vec2& direction) const {
  const auto bary = layout_->bary(p), rate = layout_->bary_rate(direction);
  double low = -kInfinity, high = kInfinity;
  for (int i = 0; i < 3; ++i) {
    const double b = std::max(0.0, bary[i]);
    if (rate[i] > 0) low = std::max(low, -b / rate[i]);
    if (rate[i] < 0) high = std::min(high, -b / rate[i]);
  }
  return {low, high};
}

/// Finds the first point of the bisector on the line through a sample perpendicular to the chord direction `along`, by
/// Newton's method. Nothing if the line leaves the face before.
///
/// Another arc of the same two generators may cross the line behind the first point. As long as no bracket is known, a
/// step that does not lead nearer is therefore replaced by a short step.
std::optional<ArcRefiner::BisectorPoint> ArcRefiner::find_across(BisectorSample at, const Vec2& along) const {
  const Vec2 start = at.point, across = turned_left(along);  // towards the left generator
  auto [low, high] = feasible_interval(start, across);
  bool knows_low = false, knows_high = false;  // whether the error has the expected sign there
  double s = 0;
  for (int step = 0; step < kMostSteps && at.is_known(); ++step) {
    const double slope = at.gradient.dot(across), error = std::abs(at.error());
    if (error <= 4 * at.rounding() + kOnBisector * tolerance_ * std::abs(slope)) return BisectorPoint(at);
    const bool is_low = at.error() > 0;
    (is_low ? low : high) = s;
    (is_low ? knows_low : knows_high) = true;
    double next = s + at.distance_to_bisector(across, 0.1 * kOnBisector * tolerance_);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == s) {
      if (error > kIndistinguishable * at.left.path.distance) return std::nullopt;
      return BisectorPoint(at);
    }
    BisectorSample ahead = sample(start + next * across);
    const bool is_nearer = std::abs(ahead.error()) <= 0.5 * error || (ahead.error() > 0) != is_low;
    if (!(knows_low && knows_high) && !is_nearer) {
      next = is_low ? std::min(s + error, 0.5 * (s + high)) : std::max(s - error, 0.5 * (s + low));
      ahead = sample(start + next * across);
    }
    s = next;
    at = ahead;
  }
  return std::nullopt;
}

}  // namespace gvd
