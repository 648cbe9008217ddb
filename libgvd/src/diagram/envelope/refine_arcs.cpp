#include "diagram/envelope/refine_arcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/segment.hpp"

namespace gvd {
namespace {

/// Where a straight piece is compared with the bisector, as parts of it. The quarters show three quarters of a curve's
/// height, and of a corner's, wherever it lies between its ends, at least half on one of the two sides.
constexpr std::array<double, 2> kSamples{0.25, 0.75};
constexpr double kShown = 0.5;

/// No piece is halved more often than this: a tenth of the digits of a double are left for its length.
constexpr int kMostHalvings = 40;

constexpr int kSteps = 60, kStepsBetweenLooks = 4;

/// An inner point lies this near to the bisector, as a part of the tolerance.
constexpr double kOnBisector = 1e-3;

/// Rounding of a difference of two distances, as a part of them.
constexpr double kDistanceRounding = 1e-15;

/// A corner this near to an end of the piece, as a part of it, is not looked for: halving does not stand still.
constexpr double kNearEnd = 0.01;

/// And what may be lost of it in addition where a point's coordinates can't be told apart any more.
constexpr double kLost = 1e-13;

/// Looks are right this near to the arc, as a part of its length; they pass over what sees nothing of the strip next to
/// the point. Twice as wide, they have 2 or 3 % more sources; less than half as wide (0.02), three to five times as
/// many bisectors leave the strip and are followed once more, with all sources.
constexpr double kBeside = 0.05;

}  // namespace

double ArcRefiner::View::rounding() const { return kDistanceRounding * left.distance; }

double ArcRefiner::View::way_to_meeting(const Vec2& across, double precision) const {
  const Vec2 left_way = point - left.from, right_way = point - right.from;
  const double lead = error() - left_way.norm() + right_way.norm();
  double s = 0;
  for (int step = 0; step < kStepsBetweenLooks; ++step) {
    const Vec2 to_left = left_way + s * across, to_right = right_way + s * across;
    const double far_left = to_left.norm(), far_right = to_right.norm();
    const double slope = across.dot(to_left) / far_left - across.dot(to_right) / far_right;
    const double move = (lead + far_left - far_right) / slope;
    s -= move;
    if (!(std::abs(move) > precision)) break;
  }
  return s;
}

/// How far the straight lines on from the two ends get from the chord. A bisector with one corner gets no farther, even
/// where an end is a corner too and says nothing of what follows.
double ArcRefiner::height_by_ends(const OnBisector& begin, const OnBisector& end) {
  const Vec2 chord = end.point - begin.point;
  return std::max(std::abs(cross(begin.way, chord)) / begin.way.norm(),
                  std::abs(cross(end.way, chord)) / end.way.norm());
}

void ArcRefiner::refine(const FaceArc& arc, const Bary& begin, const Bary& end, std::vector<Bary>& points) {
  const Vec2 from = distances_.layout().at(begin), to = distances_.layout().at(end), chord = to - from;
  const double length = chord.norm();
  if (length <= tolerance_) return;
  points_ = &points;
  const std::size_t before = points.size();
  for (const double width : {kBeside * length, std::numeric_limits<double>::infinity()}) {
    band_ = {from, chord / length, turned_left(chord) / length, length, width};
    collect_visible_sources(arc.left, left_);
    collect_visible_sources(arc.right, right_);
    points.resize(before);
    const View first = look(from), last = look(to);
    if (first.is_known() && last.is_known() && refine(OnBisector(first), OnBisector(last), 0)) return;
  }
}

/// What sees something in the strip. A ray past an end of an opening parts the plane in what is seen past it and what
/// is not; on the strip that is a matter of the place along it, and of its width at the most.
void ArcRefiner::collect_visible_sources(GeneratorId g, std::vector<VisibleSource>& seeing) const {
  seeing.clear();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const FaceSource& s : distances_.sources(g)) {
    double first = -infinity, last = infinity;
    if (!s.is_corner && !band_.is_all()) {
      const Vec2 start = band_.from - s.image;
      for (const Vec2& rim : {Vec2(s.begin - s.image), Vec2(s.image - s.end)}) {
        // Seen at place t where at_start + rate t + (slack at most) >= 0.
        const double at_start = cross(start, rim), rate = cross(band_.along, rim);
        const double slack = band_.width * std::abs(cross(band_.across, rim));
        const double place = -(at_start + slack) / rate;
        if (rate > 0) first = std::max(first, place);
        if (rate < 0) last = std::min(last, place);
      }
    }
    if (first <= std::min(last, band_.length + band_.width) && last >= -band_.width) {
      seeing.push_back({&s, first, last});
    }
  }
}

/// Appends the inner points between begin and end, if the straight piece between them is not near enough. False where
/// the bisector leaves the strip.
bool ArcRefiner::refine(const OnBisector& begin, const OnBisector& end, int halvings) {
  const Vec2 chord = end.point - begin.point, middle = 0.5 * (begin.point + end.point);
  const double length = chord.norm();
  if (halvings >= kMostHalvings || length <= tolerance_) return true;
  const bool is_flat = height_by_ends(begin, end) <= tolerance_;
  const Vec2 guess = is_flat ? middle : likely_corner(begin, end).value_or(middle);
  const auto height = [&](const Vec2& p) { return std::abs(cross(p - begin.point, chord)) / length; };
  const bool is_low = !is_flat && height(guess) <= tolerance_;
  if (is_low && is_near_quarters(begin.point, chord)) return true;
  const View view = look(guess);
  if (is_flat && is_near(view)) return true;
  const auto on = moved_across(view, chord / length);
  if (!on) return band_.is_all();
  if (!band_.contains(on->point)) return false;
  if (!is_low && height(on->point) <= kShown * tolerance_ && is_near_quarters(begin.point, chord)) return true;
  if (!refine(begin, *on, halvings + 1)) return false;
  points_->push_back(distances_.bary(on->point));
  return refine(*on, end, halvings + 1);
}

ArcRefiner::View ArcRefiner::look(const Vec2& p) const {
  const double place = band_.place(p);
  return {p, nearest(left_, place, p), nearest(right_, place, p)};
}

FaceSource::Path ArcRefiner::nearest(const std::vector<VisibleSource>& seeing, double place, const Vec2& p) {
  FaceSource::Path best{std::numeric_limits<double>::infinity(), p};
  for (const VisibleSource& s : seeing) {
    if ((place < s.first) | (place > s.last)) continue;
    take_nearer(*s.source, p, best);
  }
  return best;
}

/// Whether the bisector passes by a sample of a straight piece, as the view from there shows.
bool ArcRefiner::is_near(const View& view) const {
  // The way to the bisector is the error by the gradient.
  return std::abs(view.error()) <= 8 * view.rounding() + kShown * tolerance_ * view.gradient().norm();
}

bool ArcRefiner::is_near_quarters(const Vec2& begin, const Vec2& chord) const {
  return std::all_of(kSamples.begin(), kSamples.end(),
                     [&](double sample) { return is_near(look(begin + sample * chord)); });
}

/// Where a bisector of two straight pieces has its corner: the straight lines on from its two ends meet there. Nothing
/// where they meet near an end, beyond it, far from the chord or outside of the face.
std::optional<Vec2> ArcRefiner::likely_corner(const OnBisector& begin, const OnBisector& end) const {
  const Vec2 chord = end.point - begin.point;
  const double t = intersect_lines(begin.point, begin.way, end.point, end.way).s;
  const Vec2 corner = begin.point + t * begin.way;
  const double where = (corner - begin.point).dot(chord) / chord.squaredNorm();
  const bool between =
      where > kNearEnd && where < 1 - kNearEnd && (corner - begin.point - where * chord).norm() < chord.norm();
  if (!between) return std::nullopt;
  const auto bary = distances_.bary(corner);
  if (*std::min_element(bary.begin(), bary.end()) < 0) return std::nullopt;
  return corner;
}

/// How far one can go from p along `way`, and against it, without leaving the face.
std::pair<double, double> ArcRefiner::room(const Vec2& p, const Vec2& way) const {
  const auto bary = distances_.bary(p), rate = distances_.layout().bary_rate(way);
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const double b = std::max(0.0, bary[i]);
    if (rate[i] > 0) low = std::max(low, -b / rate[i]);
    if (rate[i] < 0) high = std::min(high, -b / rate[i]);
  }
  return {low, high};
}

/// The point of the bisector straight across a chord along `along` from the point of a view; nothing where the face
/// ends before it.
std::optional<ArcRefiner::OnBisector> ArcRefiner::moved_across(View view, const Vec2& along) const {
  const Vec2 start = view.point, across = turned_left(along);  // where the left generator gains
  auto [low, high] = room(start, across);
  double s = 0;
  for (int step = 0; step < kSteps; ++step) {
    if (!view.is_known()) return std::nullopt;
    const double slope = view.gradient().dot(across), error = std::abs(view.error());
    if (error <= 4 * view.rounding() + kOnBisector * tolerance_ * std::abs(slope)) return OnBisector(view);
    (view.error() > 0 ? low : high) = s;
    double next = s + view.way_to_meeting(across, 0.1 * kOnBisector * tolerance_);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == s) {
      if (error > kLost * view.left.distance) return std::nullopt;
      return OnBisector(view);
    }
    s = next;
    view = look(start + s * across);
  }
  return std::nullopt;
}

}  // namespace gvd
