#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd::test {

/// The Voronoi diagram of points in a rectangle [0, width] x [0, height], by brute force.
class PlanarVoronoi {
 public:
  struct Corner {
    Vec2 point;
    std::vector<int> generators;  ///< three, ascending
  };

  PlanarVoronoi(std::vector<Vec2> generators, double width, double height)
      : generators_(std::move(generators)), width_(width), height_(height) {}

  double nearest_distance(const Vec2& p) const {
    double least = (generators_.front() - p).norm();
    for (const Vec2& g : generators_) least = std::min(least, (g - p).norm());
    return least;
  }

  /// All circumcentres in the rectangle that no fourth generator is nearer to.
  std::vector<Corner> corners() const {
    std::vector<Corner> result;
    const int n = static_cast<int>(generators_.size());
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) {
        for (int k = j + 1; k < n; ++k) {
          const Vec2 p = circumcentre(at(i), at(j), at(k));
          if (!p.allFinite() || p.x() < 0 || p.y() < 0 || p.x() > width_ || p.y() > height_) continue;
          if (nearest_distance(p) > (at(i) - p).norm() * (1 - 1e-9)) result.push_back({p, {i, j, k}});
        }
      }
    }
    return result;
  }

  /// How much farther the fourth generator is from a corner than its three: how clear it is who meets there.
  double lead(const Corner& corner) const {
    double fourth = std::numeric_limits<double>::infinity();
    for (int i = 0; i < static_cast<int>(generators_.size()); ++i) {
      const bool own = std::find(corner.generators.begin(), corner.generators.end(), i) != corner.generators.end();
      if (!own) fourth = std::min(fourth, (at(i) - corner.point).norm());
    }
    return fourth - nearest_distance(corner.point);
  }

  /// Area of the cell of generator i: the rectangle, clipped by every perpendicular bisector.
  double cell_area(int i) const {
    std::vector<Vec2> polygon{{0, 0}, {width_, 0}, {width_, height_}, {0, height_}};
    for (const Vec2& other : generators_) {
      if (other != at(i)) polygon = clip(polygon, other - at(i), 0.5 * (other.squaredNorm() - at(i).squaredNorm()));
    }
    double twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
  }

 private:
  const Vec2& at(int i) const { return generators_[i]; }

  static Vec2 circumcentre(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 u = b - a, v = c - a;
    const double d = 2 * (u.x() * v.y() - u.y() * v.x());
    return a +
           Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(), u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
               d;
  }

  /// The part of a convex polygon where normal . p <= offset.
  static std::vector<Vec2> clip(const std::vector<Vec2>& polygon, const Vec2& normal, double offset) {
    std::vector<Vec2> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      const double da = normal.dot(a) - offset, db = normal.dot(b) - offset;
      if (da <= 0) kept.push_back(a);
      if ((da < 0 && db > 0) || (da > 0 && db < 0)) kept.push_back(a + da / (da - db) * (b - a));
    }
    return kept;
  }

  std::vector<Vec2> generators_;
  double width_, height_;
};

}  // namespace gvd::test
