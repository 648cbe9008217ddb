#include "diagram/bend_arcs.hpp"

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

/// And what may be lost of it in addition where a point's coordinates can't be told apart any more.
constexpr double kLost = 1e-13;

class ArcBender {
 public:
  ArcBender(const SourceMetric& metric, const FaceArc& arc, double tolerance, std::vector<FaceMetric::Bary>& points)
      : metric_(metric), left_(arc.left), right_(arc.right), tolerance_(tolerance), points_(points) {}

  /// Appends the inner points between begin and end.
  void bend(const Vec2& begin, const Vec2& end, int halvings) {
    if (halvings >= kMostHalvings || (end - begin).norm() <= tolerance_ || is_near(begin, end)) return;
    const auto middle = moved_across(0.5 * (begin + end), (end - begin).normalized());
    if (!middle) return;
    bend(begin, *middle, halvings + 1);
    points_.push_back(metric_.bary(*middle));
    bend(*middle, end, halvings + 1);
  }

 private:
  /// What the two generators look like from a point.
  struct View {
    FaceSource::Reach left, right;
    double error() const { return left.distance - right.distance; }
    double rounding() const { return kRounding * left.distance; }
  };
  View look(const Vec2& p) const { return {metric_.nearest(left_, p), metric_.nearest(right_, p)}; }

  /// How the difference of the two distances changes at p, per mesh unit.
  static Vec2 gradient(const Vec2& p, const View& view) {
    return direction(p, view.left.from) - direction(p, view.right.from);
  }

  bool is_near(const Vec2& begin, const Vec2& end) const {
    for (const double t : kSamples) {
      const Vec2 p = begin + t * (end - begin);
      const View view = look(p);
      // The way to the bisector is the error by the gradient.
      if (std::abs(view.error()) > view.rounding() + kShown * tolerance_ * gradient(p, view).norm()) {
        return false;
      }
    }
    return true;
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
  std::optional<Vec2> moved_across(const Vec2& p, const Vec2& along) const {
    const Vec2 across(-along.y(), along.x());  // to the left, where the left generator gains
    auto [low, high] = room(p, across);
    double s = 0;
    for (int step = 0; step < kSteps; ++step) {
      const Vec2 q = p + s * across;
      const View view = look(q);
      const double slope = gradient(q, view).dot(across);
      if (std::abs(view.error()) <= 4 * view.rounding() + kOnBisector * tolerance_ * std::abs(slope)) return q;
      (view.error() > 0 ? low : high) = s;
      double next = s - view.error() / slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (next == s) return std::abs(view.error()) <= kLost * view.left.distance ? std::optional(q) : std::nullopt;
      s = next;
    }
    return std::nullopt;
  }

  const SourceMetric& metric_;
  GeneratorId left_, right_;
  double tolerance_;
  std::vector<FaceMetric::Bary>& points_;
};

}  // namespace

void bend_arc(const SourceMetric& metric, const FaceArc& arc, const FaceMetric::Bary& begin, const FaceMetric::Bary& end,
              double tolerance, std::vector<FaceMetric::Bary>& points) {
  ArcBender(metric, arc, tolerance, points).bend(metric.layout().at(begin), metric.layout().at(end), 0);
}

}  // namespace gvd
