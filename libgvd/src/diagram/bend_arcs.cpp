#include "diagram/bend_arcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
constexpr double kRounding = 1e-15;

/// A corner this near to an end of the piece, as a part of it, is not looked for: halving does not stand still.
constexpr double kNearEnd = 0.01;

/// And what may be lost of it in addition where a point's coordinates can't be told apart any more.
constexpr double kLost = 1e-13;

/// Looks count on what is seen this near to the arc, as a part of its length: on a tenth of the sources that a face
/// has. A bisector that leaves the strip is looked at once more, with all of them.
constexpr double kBeside = 0.05;

/// How the difference of the two distances changes at p, per mesh unit.
template <class View>
Vec2 gradient(const Vec2& p, const View& view) {
  return direction(p, view.left.from) - direction(p, view.right.from);
}
/// Along the bisector at p.
template <class View>
Vec2 way_at(const Vec2& p, const View& view) {
  return turned_left(gradient(p, view));
}

template <class View>
double rounding(const View& view) {
  return kRounding * view.left.distance;
}

/// How far the straight lines on from the two ends get from the chord. A bisector with one corner gets no farther, even
/// where an end is a corner too and says nothing of what follows.
template <class OnBisector>
double height_by_ends(const OnBisector& begin, const OnBisector& end) {
  const Vec2 chord = end.point - begin.point;
  return std::max(std::abs(cross(begin.way, chord)) / begin.way.norm(),
                  std::abs(cross(end.way, chord)) / end.way.norm());
}

/// Where on the line p + s across the straight paths of a view are equally long, looked for from s on.
template <class View>
double meeting_of_view(const Vec2& p, const Vec2& across, double s, const View& view, double precision) {
  const Vec2 left = p - view.left.from, right = p - view.right.from, start = p + s * across;
  const double lead = view.error() - (start - view.left.from).norm() + (start - view.right.from).norm();
  for (int step = 0; step < kStepsBetweenLooks; ++step) {
    const Vec2 to_left = left + s * across, to_right = right + s * across;
    const double far_left = to_left.norm(), far_right = to_right.norm();
    const double slope = across.dot(to_left) / far_left - across.dot(to_right) / far_right;
    const double move = (lead + far_left - far_right) / slope;
    s -= move;
    if (!(std::abs(move) > precision)) break;
  }
  return s;
}

}  // namespace

void ArcBender::bend(const FaceArc& arc, const Bary& begin, const Bary& end, std::vector<Bary>& points) {
  const Vec2 from = metric_.layout().at(begin), to = metric_.layout().at(end), chord = to - from;
  const double length = chord.norm();
  if (length <= tolerance_) return;
  points_ = &points;
  const std::size_t before = points.size();
  for (const double width : {kBeside * length, std::numeric_limits<double>::infinity()}) {
    strip_ = {from, chord / length, turned_left(chord) / length, length, width};
    find_seeing(arc.left, left_);
    find_seeing(arc.right, right_);
    points.resize(before);
    if (bend({from, way_at(from, look(from))}, {to, way_at(to, look(to))}, 0)) return;
  }
}

/// What sees something in the strip. A ray past an end of an opening parts the plane in what is seen past it and what
/// is not; on the strip that is a matter of the place along it, and of its width at the most.
void ArcBender::find_seeing(GeneratorId g, std::vector<Seeing>& seeing) const {
  seeing.clear();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const FaceSource& s : metric_.sources(g)) {
    double first = -infinity, last = infinity;
    if (!s.is_corner && std::isfinite(strip_.width)) {
      const Vec2 start = strip_.from - s.image;
      for (const Vec2& rim : {Vec2(s.begin - s.image), Vec2(s.image - s.end)}) {
        // Seen at place t where at_start + rate t + (slack at most) >= 0.
        const double at_start = cross(start, rim), rate = cross(strip_.along, rim);
        const double slack = strip_.width * std::abs(cross(strip_.across, rim));
        const double place = -(at_start + slack) / rate;
        if (rate > 0) first = std::max(first, place);
        if (rate < 0) last = std::min(last, place);
      }
    }
    if (first <= std::min(last, strip_.length) && last >= 0) seeing.push_back({&s, first, last});
  }
}

/// Appends the inner points between begin and end, if the straight piece between them is not near enough.
bool ArcBender::bend(const OnBisector& begin, const OnBisector& end, int halvings) {
  const Vec2 chord = end.point - begin.point, middle = 0.5 * (begin.point + end.point);
  const double length = chord.norm();
  if (halvings >= kMostHalvings || length <= tolerance_) return true;
  const bool is_flat = height_by_ends(begin, end) <= tolerance_;
  const Vec2 guess = is_flat ? middle : likely_corner(begin, end).value_or(middle);
  const auto height = [&](const Vec2& p) { return std::abs(cross(p - begin.point, chord)) / length; };
  const bool is_low = !is_flat && height(guess) <= tolerance_;
  if (is_low && is_near_quarters(begin.point, chord)) return true;
  const View view = look(guess);
  if (is_flat && is_near(view, middle)) return true;
  const auto on = moved_across(guess, view, chord / length);
  if (!on) return true;
  if (!strip_.contains(on->point)) return false;
  if (!is_low && height(on->point) <= kShown * tolerance_ && is_near_quarters(begin.point, chord)) return true;
  if (!bend(begin, *on, halvings + 1)) return false;
  points_->push_back(metric_.bary(on->point));
  return bend(*on, end, halvings + 1);
}

ArcBender::View ArcBender::look(const Vec2& p) const {
  const double place = strip_.place(p);
  return {nearest(left_, place, p), nearest(right_, place, p)};
}

FaceSource::Reach ArcBender::nearest(const std::vector<Seeing>& seeing, double place, const Vec2& p) {
  FaceSource::Reach best{std::numeric_limits<double>::infinity(), p};
  for (const Seeing& s : seeing) {
    if ((place < s.first) | (place > s.last)) continue;
    take_nearer(*s.source, p, best);
  }
  return best;
}

/// Whether the bisector passes by p, a sample of a straight piece, as the view from p shows.
bool ArcBender::is_near(const View& view, const Vec2& p) const {
  // The way to the bisector is the error by the gradient.
  return std::abs(view.error()) <= 8 * rounding(view) + kShown * tolerance_ * gradient(p, view).norm();
}

bool ArcBender::is_near_quarters(const Vec2& begin, const Vec2& chord) const {
  return std::all_of(kSamples.begin(), kSamples.end(), [&](double sample) {
    const Vec2 p = begin + sample * chord;
    return is_near(look(p), p);
  });
}

/// Where a bisector of two straight pieces has its corner: the straight lines on from its two ends meet there. Nothing
/// where they meet near an end, beyond it, far from the chord or outside of the face.
std::optional<Vec2> ArcBender::likely_corner(const OnBisector& begin, const OnBisector& end) const {
  const Vec2 chord = end.point - begin.point;
  const double t = cross(chord, end.way) / cross(begin.way, end.way);
  const Vec2 corner = begin.point + t * begin.way;
  const double where = (corner - begin.point).dot(chord) / chord.squaredNorm();
  const bool between =
      where > kNearEnd && where < 1 - kNearEnd && (corner - begin.point - where * chord).norm() < chord.norm();
  if (!between) return std::nullopt;
  const auto bary = metric_.bary(corner);
  if (*std::min_element(bary.begin(), bary.end()) < 0) return std::nullopt;
  return corner;
}

/// How far one can go from p along `way`, and against it, without leaving the face.
std::pair<double, double> ArcBender::room(const Vec2& p, const Vec2& way) const {
  const auto bary = metric_.bary(p), rate = metric_.layout().bary_rate(way);
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const double b = std::max(0.0, bary[i]);
    if (rate[i] > 0) low = std::max(low, -b / rate[i]);
    if (rate[i] < 0) high = std::min(high, -b / rate[i]);
  }
  return {low, high};
}

/// The point of the bisector straight across a chord along `along` from p, which has the given view; nothing where the
/// face ends before it.
std::optional<ArcBender::OnBisector> ArcBender::moved_across(const Vec2& p, View view, const Vec2& along) const {
  const Vec2 across = turned_left(along);  // where the left generator gains
  auto [low, high] = room(p, across);
  double s = 0;
  for (int step = 0; step < kSteps; ++step) {
    const Vec2 q = p + s * across;
    if (step > 0) view = look(q);
    const double slope = gradient(q, view).dot(across), error = std::abs(view.error());
    if (error <= 4 * rounding(view) + kOnBisector * tolerance_ * std::abs(slope)) return OnBisector{q, way_at(q, view)};
    (view.error() > 0 ? low : high) = s;
    double next = meeting_of_view(p, across, s, view, 0.1 * kOnBisector * tolerance_);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == s) {
      if (error > kLost * view.left.distance) return std::nullopt;
      return OnBisector{q, way_at(q, view)};
    }
    s = next;
  }
  return std::nullopt;
}

}  // namespace gvd
