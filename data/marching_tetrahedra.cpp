#include "marching_tetrahedra.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace gvd::data {
namespace {

/// Crossings are kept this far, as a fraction of the tetrahedron's edge, from its ends: no two of them coincide.
constexpr double kEndMargin = 0.05;

/// The cube's six tetrahedra round the diagonal from corner 0 to corner 7; bit i of a corner is its step along axis i.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Polygoniser {
 public:
  Polygoniser(const std::function<double(const Vec3&)>& value, const Grid& grid) : grid_(grid) {
    for (int k = 0; k <= grid.cells[2]; ++k) {
      for (int j = 0; j <= grid.cells[1]; ++j) {
        for (int i = 0; i <= grid.cells[0]; ++i) {
          points_.push_back(grid.corner + grid.spacing * Vec3(i, j, k));
          values_.push_back(value(points_.back()));
        }
      }
    }
  }

  Triangles run() {
    for (int k = 0; k < grid_.cells[2]; ++k) {
      for (int j = 0; j < grid_.cells[1]; ++j) {
        for (int i = 0; i < grid_.cells[0]; ++i) polygonise_cube(i, j, k);
      }
    }
    return std::move(result_);
  }

 private:
  void polygonise_cube(int i, int j, int k) {
    for (const auto& corners : kTetrahedra) {
      std::array<int, 4> node;
      for (std::size_t c = 0; c < 4; ++c) {
        node[c] = index(i + (corners[c] & 1), j + (corners[c] >> 1 & 1), k + (corners[c] >> 2 & 1));
      }
      polygonise_tetrahedron(node);
    }
  }

  void polygonise_tetrahedron(const std::array<int, 4>& node) {
    std::vector<int> inside, outside;
    for (const int n : node) (values_[std::size_t(n)] < 0 ? inside : outside).push_back(n);
    if (inside.size() == 1 || outside.size() == 1) {
      const bool tip_inside = inside.size() == 1;
      const int tip = (tip_inside ? inside : outside).front();
      const auto& base = tip_inside ? outside : inside;
      add(inside, {crossing(tip, base[0]), crossing(tip, base[1]), crossing(tip, base[2])});
    } else if (inside.size() == 2) {
      const int a = crossing(inside[0], outside[0]), b = crossing(inside[0], outside[1]);
      const int c = crossing(inside[1], outside[1]), d = crossing(inside[1], outside[0]);
      add(inside, {a, b, c});
      add(inside, {a, c, d});
    }
  }

  /// Adds the triangle, turned so that its normal leads away from the nodes inside.
  void add(const std::vector<int>& inside, std::array<int, 3> face) {
    const Vec3 &a = result_.positions[std::size_t(face[0])], &b = result_.positions[std::size_t(face[1])],
               &c = result_.positions[std::size_t(face[2])];
    const Vec3 normal = (b - a).cross(c - a);
    if (normal.dot(points_[std::size_t(inside.front())] - a) > 0) std::swap(face[1], face[2]);
    result_.faces.push_back(face);
  }

  int crossing(int a, int b) {
    if (a > b) std::swap(a, b);
    const auto [it, fresh] = crossings_.try_emplace({a, b}, int(result_.positions.size()));
    if (fresh) {
      const double va = values_[std::size_t(a)], vb = values_[std::size_t(b)];
      const double t = std::clamp(va / (va - vb), kEndMargin, 1 - kEndMargin);
      result_.positions.push_back(points_[std::size_t(a)] + t * (points_[std::size_t(b)] - points_[std::size_t(a)]));
    }
    return it->second;
  }

  int index(int i, int j, int k) const { return (k * (grid_.cells[1] + 1) + j) * (grid_.cells[0] + 1) + i; }

  Grid grid_;
  std::vector<Vec3> points_;
  std::vector<double> values_;
  std::map<std::pair<int, int>, int> crossings_;
  Triangles result_;
};

}  // namespace

Triangles polygonise(const std::function<double(const Vec3&)>& value, const Grid& grid) {
  return Polygoniser(value, grid).run();
}

}  // namespace gvd::data
