#include "diagram/envelope/bisector_sample.hpp"

namespace gvd {
namespace {

constexpr int kNewtonSteps = 4;

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

}  // namespace gvd
