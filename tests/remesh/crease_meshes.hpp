#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "gvd/creases.hpp"
#include "gvd/surface_point.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

// Meshes with creases and corners, and what holds where a dual follows them.
namespace gvd::test {

inline Mesh make_cube(int n) { return make_plate(n, 1); }

/// A closed cylinder of radius 1: two circles are its creases. Its caps are fans.
inline Mesh make_can(int around, double height) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < around; ++i) {
    const double a = 2 * std::numbers::pi * i / around;
    positions.emplace_back(std::cos(a), std::sin(a), 0);
    positions.emplace_back(std::cos(a), std::sin(a), height);
  }
  positions.emplace_back(0, 0, 0);
  positions.emplace_back(0, 0, height);
  for (int i = 0; i < around; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % around);
    faces.insert(faces.end(), {{a, b, b + 1}, {a, b + 1, a + 1}, {b, a, 2 * around}, {a + 1, b + 1, 2 * around + 1}});
  }
  return make_mesh(std::move(positions), faces);
}

/// A flat sector of a disc with radius 1: its tip is a corner of the boundary.
inline Mesh make_sector(int around, double angle) {
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i <= around; ++i) {
    positions.emplace_back(std::cos(angle * i / around), std::sin(angle * i / around), 0);
    if (i > 0) faces.push_back({0, i, i + 1});
  }
  return make_mesh(std::move(positions), faces);
}

/// The prism over an L with sides of length 2: two of its edges bend inwards.
inline Mesh make_corner_block() {
  const std::vector<std::array<double, 2>> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  std::vector<Vec3> positions;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : outline) positions.emplace_back(x, y, z);
  }
  std::vector<std::array<int, 3>> faces;
  for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    faces.insert(faces.end(), {{a, c, b}, {a + 6, b + 6, c + 6}});
  }
  for (int i = 0; i < 6; ++i) {
    const int k = (i + 1) % 6;
    faces.insert(faces.end(), {{i, k, k + 6}, {i, k + 6, i + 6}});
  }
  return make_mesh(std::move(positions), faces);
}

/// Meshes with open, closed and acute creases and boundaries, with names.
inline std::vector<std::pair<const char*, Mesh>> creased_meshes() {
  return {{"cube", make_cube(4)},         {"can", make_can(24, 0.5)},       {"flat can", make_can(24, 0.1)},
          {"block", make_corner_block()}, {"sector", make_sector(20, 4.5)}, {"sharp sector", make_sector(8, 0.4)},
          {"plate", make_plate(6, 0.05)}, {"ring", make_ring(24, 3)}};
}

/// The generators on a curve in order, by comparing positions; the first one again at the end of a closed curve.
inline std::vector<std::size_t> generators_along(const Mesh& mesh, const CreaseCurve& curve,
                                                 const std::vector<SurfacePoint>& generators) {
  std::vector<std::pair<double, std::size_t>> order;
  double passed = 0;
  for (std::size_t k = 0; k < curve.edges.size(); ++k) {
    const Vec3 &a = mesh.position(curve.vertices[k]), &b = mesh.position(curve.vertices[k + 1]);
    for (std::size_t i = 0; i < generators.size(); ++i) {
      const Vec3 p = position(mesh, generators[i]);
      const double from = (p - a).norm(), to = (p - b).norm();
      if (std::abs(from + to - (b - a).norm()) < 1e-12 && (from > 0 || k == 0)) order.emplace_back(passed + from, i);
    }
    passed += (b - a).norm();
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> along;
  for (const auto& [at, i] : order) along.push_back(i);
  return along;
}

/// Whether two vertices have an edge in common.
inline bool are_joined(const Mesh& mesh, std::size_t a, std::size_t b) {
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& corners = mesh.vertices(FaceId(f));
    const auto has = [&](std::size_t v) {
      return std::find(corners.begin(), corners.end(), VertexId(v)) != corners.end();
    };
    if (has(a) && has(b)) return true;
  }
  return false;
}

}  // namespace gvd::test
