#include "diagram/bend_arcs.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace gvd {
namespace {

/// Where a straight piece is compared with the bisector, as parts of it. The quarters show three quarters of a curve's
/// height, and of a corner's, wherever it lies between its ends, at least half on one of the two sides.
constexpr std::array<double, 2> kSamples{0.25, 0.75};
constexpr double kShown = 0.5;

/// No piece is halved more often than this: a tenth of the digits of a double are left for its length.
constexpr int kMostHalvings = 40;

constexpr int kSteps = 60;

/// An inner point lies this near to the bisector, as a part of the tolerance.
constexpr double kOnBisector = 1e-3;

/// Rounding of a difference of two distances, as a part of them.
constexpr double kRounding = 1e-15;

/// A corner this near to an end of the piece, as a part of it, is not looked for: halving does not stand still.
constexpr double kNearEnd = 0.01;

/// And what may be lost of it in addition where a point's coordinates can't be told apart any more.
constexpr double kLost = 1e-13;

class ArcBender {
 public:
  ArcBender(const SourceMetric& metric, const FaceArc& arc, double tolerance, std::vector<FaceMetric::Bary>& points)
      : metric_(metric),
        left_(metric.sources(arc.left)),
        right_(metric.sources(arc.right)),
        tolerance_(tolerance),
        points_(points) {}

  void bend(const Vec2& begin, const Vec2& end) {
    if ((end - begin).norm() <= tolerance_) return;
    bend({begin, way_at(begin, look(begin))}, {end, way_at(end, look(end))}, 0);
  }

 private:
  /// What the two generators look like from a point.
  struct View {
    FaceSource::Reach left, right;
    double error() const { return left.distance - right.distance; }
    double rounding() const { return kRounding * left.distance; }
  };
  View look(const Vec2& p) const {
    return {SourceMetric::nearest(left_, p).reach, SourceMetric::nearest(right_, p).reach};
  }

  /// How the difference of the two distances changes at p, per mesh unit.
  static Vec2 gradient(const Vec2& p, const View& view) {
    return direction(p, view.left.from) - direction(p, view.right.from);
  }
  /// Along the bisector at p.
  static Vec2 way_at(const Vec2& p, const View& view) { return turned_left(gradient(p, view)); }

  /// A point of the bisector, and the way that it runs there.
  struct OnBisector {
    Vec2 point, way;
  };

  /// Appends the inner points between begin and end, if the straight piece between them is not near enough.
  void bend(const OnBisector& begin, const OnBisector& end, int halvings) {
    if (halvings >= kMostHalvings || is_near(begin, end)) return;
    const auto on = moved_across(likely_corner(begin, end), (end.point - begin.point).normalized());
    if (!on) return;
    bend(begin, *on, halvings + 1);
    points_.push_back(metric_.bary(on->point));
    bend(*on, end, halvings + 1);
  }

  /// Where a bisector of two straight pieces has its corner: the straight lines on from its two ends meet there. The
  /// middle of the chord where they meet near an end, beyond it, far from the chord or outside of the face.
  Vec2 likely_corner(const OnBisector& begin, const OnBisector& end) const {
    const Vec2 chord = end.point - begin.point, middle = 0.5 * (begin.point + end.point);
    const double t = cross(chord, end.way) / cross(begin.way, end.way);
    const Vec2 corner = begin.point + t * begin.way;
    const double where = (corner - begin.point).dot(chord) / chord.squaredNorm();
    const bool between =
        where > kNearEnd && where < 1 - kNearEnd && (corner - begin.point - where * chord).norm() < chord.norm();
    if (!between) return middle;
    const auto bary = metric_.bary(corner);
    return *std::min_element(bary.begin(), bary.end()) >= 0 ? corner : middle;
  }

  /// Whether the straight piece is near enough to the bisector: where its ends say so, its middle is looked at.
  bool is_near(const OnBisector& begin, const OnBisector& end) const {
    const Vec2 chord = end.point - begin.point;
    if (chord.norm() <= tolerance_) return true;
    if (height_by_ends(begin, end) <= tolerance_) return passes_by(begin.point + 0.5 * chord);
    return passes_by(begin.point + kSamples[0] * chord) && passes_by(begin.point + kSamples[1] * chord);
  }

  /// How far the straight lines on from the two ends get from the chord. A bisector with one corner gets no farther,
  /// even where an end is a corner too and says nothing of what follows.
  static double height_by_ends(const OnBisector& begin, const OnBisector& end) {
    const Vec2 chord = end.point - begin.point;
    return std::max(std::abs(cross(begin.way, chord)) / begin.way.norm(),
                    std::abs(cross(end.way, chord)) / end.way.norm());
  }

  /// Whether the bisector passes by p, a sample of a straight piece.
  bool passes_by(const Vec2& p) const {
    const View view = look(p);
    // The way to the bisector is the error by the gradient.
    return std::abs(view.error()) <= 8 * view.rounding() + kShown * tolerance_ * gradient(p, view).norm();
  }

  /// How far one can go from p along `way`, and against it, without leaving the face.
  std::pair<double, double> room(const Vec2& p, const Vec2& way) const {
    const auto bary = metric_.bary(p), rate = metric_.layout().bary_rate(way);
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const double b = std::max(0.0, bary[i]);
      if (rate[i] > 0) low = std::max(low, -b / rate[i]);
      if (rate[i] < 0) high = std::min(high, -b / rate[i]);
    }
    return {low, high};
  }

  /// The point of the bisector straight across a chord along `along` from p; nothing where the face ends before it.
  std::optional<OnBisector> moved_across(const Vec2& p, const Vec2& along) const {
    const Vec2 across = turned_left(along);  // where the left generator gains
    auto [low, high] = room(p, across);
    double s = 0;
    for (int step = 0; step < kSteps; ++step) {
      const Vec2 q = p + s * across;
      const View view = look(q);
      const double slope = gradient(q, view).dot(across), error = std::abs(view.error());
      if (error <= 4 * view.rounding() + kOnBisector * tolerance_ * std::abs(slope))
        return OnBisector{q, way_at(q, view)};
      (view.error() > 0 ? low : high) = s;
      double next = s - view.error() / slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (next == s) {
        if (error > kLost * view.left.distance) return std::nullopt;
        return OnBisector{q, way_at(q, view)};
      }
      s = next;
    }
    return std::nullopt;
  }

  const SourceMetric& metric_;
  std::span<const FaceSource> left_, right_;
  double tolerance_;
  std::vector<FaceMetric::Bary>& points_;
};

}  // namespace

void bend_arc(const SourceMetric& metric, const FaceArc& arc, const FaceMetric::Bary& begin,
              const FaceMetric::Bary& end, double tolerance, std::vector<FaceMetric::Bary>& points) {
  ArcBender(metric, arc, tolerance, points).bend(metric.layout().at(begin), metric.layout().at(end));
}

}  // namespace gvd
