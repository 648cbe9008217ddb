#include "io/view_triangulate.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace gvd::io {
namespace {

/// Twice the area of a triangle in barycentric coordinates at or below which it is no ear: 1e-14 of twice the face's
/// area, a hundred times the rounding of products of coordinates in [0, 1]. What it leaves out can't be seen.
constexpr double kFlatEar = 1e-14;

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

class EarClipper {
 public:
  explicit EarClipper(const std::vector<Vec2>& corners) : corners_(corners), ring_(corners.size()) {
    for (std::size_t i = 0; i < ring_.size(); ++i) ring_[i] = i;
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    while (ring_.size() >= 3) {
      const std::size_t tip = best_ear();
      const std::array<std::size_t, 3> ear = around(tip);
      if (ear_area(ear) > kFlatEar) {
        triangles_.push_back({static_cast<std::uint32_t>(ear[0]), static_cast<std::uint32_t>(ear[1]),
                              static_cast<std::uint32_t>(ear[2])});
      }
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(tip));
    }
    return std::move(triangles_);
  }

 private:
  std::array<std::size_t, 3> around(std::size_t tip) const {
    const std::size_t n = ring_.size();
    return {ring_[(tip + n - 1) % n], ring_[tip], ring_[(tip + 1) % n]};
  }

  double ear_area(const std::array<std::size_t, 3>& ear) const {
    return twice_area(corners_[ear[0]], corners_[ear[1]], corners_[ear[2]]);
  }

  /// Area over squared sides: largest for the equilateral triangle, scale-free.
  double shape(const std::array<std::size_t, 3>& ear) const {
    const Vec2 &a = corners_[ear[0]], &b = corners_[ear[1]], &c = corners_[ear[2]];
    return ear_area(ear) / ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
  }

  /// A corner elsewhere on the ring that lies in the closed triangle would be cut off. One at the place of the ear's
  /// own corners is the same point met again, where the polygon touches itself, and does no harm.
  bool is_empty(const std::array<std::size_t, 3>& ear) const {
    const Vec2 &a = corners_[ear[0]], &b = corners_[ear[1]], &c = corners_[ear[2]];
    for (const std::size_t other : ring_) {
      const Vec2& p = corners_[other];
      if (p == a || p == b || p == c) continue;
      if (twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0) return false;
    }
    return true;
  }

  /// Position on the ring of the best shaped ear. Where rounding leaves none, the flattest corner goes: it covers
  /// least.
  std::size_t best_ear() const {
    std::size_t best = ring_.size(), flattest = 0;
    double best_shape = 0, least_area = 2;
    for (std::size_t tip = 0; tip < ring_.size(); ++tip) {
      const std::array<std::size_t, 3> ear = around(tip);
      const double area = ear_area(ear);
      if (std::abs(area) < least_area) {
        least_area = std::abs(area);
        flattest = tip;
      }
      if (area <= kFlatEar) continue;
      const double s = shape(ear);
      if (s > best_shape && is_empty(ear)) {
        best_shape = s;
        best = tip;
      }
    }
    return best < ring_.size() ? best : flattest;
  }

  const std::vector<Vec2>& corners_;
  std::vector<std::size_t> ring_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners) {
  return EarClipper(corners).run();
}

}  // namespace gvd::io
