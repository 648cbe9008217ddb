#include "triangulate_polygon.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace gvd {
namespace {

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Corners are on one line where twice their area is below this part of the square of the triangle's longest side:
/// far above the rounding of coordinates in [0, 1] that were made on one line. Dimensionless.
constexpr double kOnLine = 1e-12;

double longest_square(const Vec2& a, const Vec2& b, const Vec2& c) {
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

/// Inside the triangle or on its border.
bool contains(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  const double slack = -kOnLine * longest_square(a, b, c);
  return twice_area(a, b, p) >= slack && twice_area(b, c, p) >= slack && twice_area(c, a, p) >= slack;
}

class EarClipper {
 public:
  explicit EarClipper(const std::vector<Vec2>& corners) : corners_(corners), left_(corners.size()) {
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }

  std::vector<std::array<std::size_t, 3>> run() {
    std::vector<std::array<std::size_t, 3>> triangles;
    while (left_.size() >= 3) {
      const std::size_t ear = left_.size() == 3 ? 1 : best_ear();
      triangles.push_back({left_[before(ear)], left_[ear], left_[after(ear)]});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
  }

 private:
  std::size_t before(std::size_t i) const { return i == 0 ? left_.size() - 1 : i - 1; }
  std::size_t after(std::size_t i) const { return i + 1 == left_.size() ? 0 : i + 1; }
  const Vec2& corner(std::size_t i) const { return corners_[left_[i]]; }

  bool is_ear(std::size_t i) const {
    const std::size_t a = before(i), c = after(i);
    for (std::size_t k = 0; k < left_.size(); ++k) {
      if (k != a && k != i && k != c && contains(corner(a), corner(i), corner(c), corner(k))) return false;
    }
    return true;
  }

  /// The ear that leaves the roundest triangle: area over the square of its longest side.
  std::size_t best_ear() const {
    std::size_t best = 0;
    double best_shape = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const Vec2 &a = corner(before(i)), &b = corner(i), &c = corner(after(i));
      const double area = twice_area(a, b, c);
      const double longest = longest_square(a, b, c);
      // Corners that are no ear come behind every ear, for the polygons that rounding has folded.
      const double shape = area > kOnLine * longest && is_ear(i) ? area / longest : area - 4;
      if (shape > best_shape) {
        best_shape = shape;
        best = i;
      }
    }
    return best;
  }

  const std::vector<Vec2>& corners_;
  std::vector<std::size_t> left_;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners) {
  return EarClipper(corners).run();
}

}  // namespace gvd
