#include "figure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gvd::data {
namespace {

/// A sphere of this radius round a point of a limb's axis.
struct Knot {
  double x, y, z, radius;
};

/// The union of the rounded cones between consecutive knots; x: nose, y: up, z: left.
using Limb = std::vector<Knot>;

const std::vector<Limb>& limbs() {
  static const std::vector<Limb> kLimbs = {
      {{-0.90, 1.04, 0, 0.38}, {-0.20, 1.10, 0, 0.40}, {0.65, 1.10, 0, 0.46}},            // trunk
      {{0.74, 1.22, 0, 0.34}, {1.02, 1.62, 0, 0.26}, {1.24, 2.00, 0, 0.27}},              // neck and crown
      {{1.30, 2.00, 0, 0.27}, {1.52, 1.92, 0, 0.20}, {1.82, 1.80, 0, 0.15}},              // muzzle
      {{1.18, 2.16, 0.13, 0.12}, {1.06, 2.46, 0.25, 0.11}, {0.96, 2.64, 0.33, 0.07}},     // left ear
      {{1.18, 2.16, -0.13, 0.12}, {1.06, 2.46, -0.25, 0.11}, {0.96, 2.64, -0.33, 0.07}},  // right ear
      {{0.60, 0.95, 0.26, 0.25}, {0.72, 0.52, 0.34, 0.16}, {0.66, 0.11, 0.36, 0.12}, {0.80, 0.08, 0.37, 0.11}},
      {{0.58, 0.95, -0.26, 0.25}, {0.54, 0.52, -0.34, 0.16}, {0.44, 0.11, -0.36, 0.12}, {0.58, 0.08, -0.37, 0.11}},
      {{-0.84, 0.95, 0.24, 0.29}, {-0.95, 0.52, 0.34, 0.17}, {-0.86, 0.11, 0.36, 0.12}, {-0.72, 0.08, 0.37, 0.11}},
      {{-0.84, 0.95, -0.24, 0.29}, {-1.04, 0.52, -0.34, 0.17}, {-1.10, 0.11, -0.36, 0.12}, {-0.96, 0.08, -0.37, 0.11}},
      // The tail: up from the rump, round, and back into the spine.
      {{-1.10, 1.20, 0, 0.16},
       {-1.44, 1.46, 0, 0.12},
       {-1.60, 1.80, 0, 0.11},
       {-1.50, 2.12, 0, 0.105},
       {-1.24, 2.32, 0, 0.10},
       {-0.94, 2.32, 0, 0.10},
       {-0.68, 2.14, 0, 0.10},
       {-0.54, 1.84, 0, 0.11},
       {-0.50, 1.45, 0, 0.13}},
  };
  return kLimbs;
}

/// How far two limbs flow into each other, in mesh units: less than the gap between any two that must not touch.
constexpr double kBlend = 0.16;
/// Step of the central differences, in mesh units: well above rounding, well below the smallest radius.
constexpr double kDifference = 1e-4;

double cone_value(const Knot& from, const Knot& to, const Vec3& x) {
  const Vec3 p(from.x, from.y, from.z), q(to.x, to.y, to.z);
  const Vec3 axis = q - p;
  const double t = std::clamp((x - p).dot(axis) / axis.dot(axis), 0.0, 1.0);
  return (x - (p + t * axis)).norm() - (from.radius + t * (to.radius - from.radius));
}

double limb_value(const Limb& limb, const Vec3& x) {
  double value = cone_value(limb[0], limb[1], x);
  for (std::size_t i = 2; i < limb.size(); ++i) value = std::min(value, cone_value(limb[i - 1], limb[i], x));
  return value;
}

/// Minimum of a and b, rounded where they differ by less than kBlend.
double smooth_minimum(double a, double b) {
  const double h = std::max(kBlend - std::abs(a - b), 0.0) / kBlend;
  return std::min(a, b) - h * h * kBlend / 4;
}

}  // namespace

double figure_value(const Vec3& p) {
  double value = limb_value(limbs().front(), p);
  for (std::size_t i = 1; i < limbs().size(); ++i) value = smooth_minimum(value, limb_value(limbs()[i], p));
  return value;
}

Vec3 figure_gradient(const Vec3& p) {
  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 forward = p, back = p;
    forward[axis] += kDifference;
    back[axis] -= kDifference;
    gradient[axis] = (figure_value(forward) - figure_value(back)) / (2 * kDifference);
  }
  return gradient;
}

Vec3 project_to_figure(Vec3 p) {
  constexpr int kSteps = 4;
  for (int step = 0; step < kSteps; ++step) {
    const Vec3 gradient = figure_gradient(p);
    p -= figure_value(p) / gradient.dot(gradient) * gradient;
  }
  return p;
}

}  // namespace gvd::data
