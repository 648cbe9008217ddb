#include "diagram/assembly/face_polygon.hpp"

#include <algorithm>
#include <cmath>

#include "diagram/assembly/face_distances.hpp"

namespace gvd {
namespace {

static_assert(kInsideExactly < kInsideFace);

/// Whether a, b, c go round counter-clockwise, but for c being up to `beyond` on the other side.
bool turns_left(const Bary& a, const Bary& b, const Bary& c, double beyond) {
  const double area = twice_signed_area(affine_point(a), affine_point(b), affine_point(c));
  return area >= 0 || area >= -beyond * std::max({apart(a, b), apart(b, c), apart(c, a)});
}

}  // namespace

Bary middle(const FacePolygon& polygon, std::size_t i) {
  return mix(polygon[i].bary, polygon[(i + 1) % polygon.size()].bary, 0.5);
}

Bary centre(const FacePolygon& polygon) {
  Bary sum{0, 0, 0};
  for (const PolygonCorner& c : polygon) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += c.bary[k] / static_cast<double>(polygon.size());
  }
  return sum;
}

bool is_convex(const std::vector<Bary>& polygon, double beyond) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (!turns_left(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n], beyond)) return false;
  }
  return true;
}

bool is_inside(const FacePolygon& polygon, const Bary& p, double beyond) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (!turns_left(polygon[i].bary, polygon[(i + 1) % n].bary, p, beyond)) return false;
  }
  return *std::min_element(p.begin(), p.end()) >= 0;
}

double apart(const Bary& p, const Bary& q) { return std::hypot(q[1] - p[1], q[2] - p[2]); }

}  // namespace gvd
