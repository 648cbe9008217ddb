#include "diagram/assembly/face_polygon.hpp"

#include <algorithm>
#include <cmath>

namespace gvd {
namespace {

/// Whether a, b, c are counter-clockwise, with c up to `inversion` on the wrong side.
bool turns_left(const Bary& a, const Bary& b, const Bary& c, double inversion) {
  const double area = twice_signed_area(affine_point(a), affine_point(b), affine_point(c));
  return area >= 0 || area >= -inversion * std::max({bary_distance(a, b), bary_distance(b, c), bary_distance(c, a)});
}

}  // namespace

Bary midpoint(const FacePolygon& polygon, std::size_t i) {
  return mix(polygon[i].bary, polygon[(i + 1) % polygon.size()].bary, 0.5);
}

Bary centre(const FacePolygon& polygon) {
  Bary sum{0, 0, 0};
  for (const PolygonCorner& c : polygon) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += c.bary[k] / static_cast<double>(polygon.size());
  }
  return sum;
}

bool is_convex(const std::vector<Bary>& polygon, double inversion) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (!turns_left(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n], inversion)) return false;
  }
  return true;
}

bool is_inside(const FacePolygon& polygon, const Bary& p, double inversion) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (!turns_left(polygon[i].bary, polygon[(i + 1) % n].bary, p, inversion)) return false;
  }
  return *std::min_element(p.begin(), p.end()) >= 0;
}

double bary_distance(const Bary& p, const Bary& q) { return std::hypot(q[1] - p[1], q[2] - p[2]); }

}  // namespace gvd
