#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "gvd/mesh.hpp"
#include "support/random.hpp"

namespace gvd::test {

inline Mesh make_mesh(std::vector<Vec3> positions, const std::vector<std::array<int, 3>>& faces) {
  std::vector<std::array<VertexId, 3>> ids;
  for (const auto& [a, b, c] : faces) ids.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return Mesh(std::move(positions), std::move(ids));
}

/// One face.
inline Mesh make_triangle() { return make_mesh({{0, 0, 0}, {2, 0, 0}, {0.5, 1.5, 0}}, {{0, 1, 2}}); }

/// Two faces, back to back: closed, a sphere.
inline Mesh make_pillow() { return make_mesh({{0, 0, 0}, {2, 0, 0}, {0.5, 1.5, 0}}, {{0, 1, 2}, {0, 2, 1}}); }

inline Mesh make_tetrahedron() {
  return make_mesh({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
}

/// A tube of radius 1 that is cut open along a line parallel to its axis: a disc whose two banks coincide in space.
/// Vertex (across + 1) i + j lies in column i and row j; columns 0 and `around` are the banks.
inline Mesh make_cut_tube(int around, int across, double height) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i <= around; ++i) {
    const double angle = 2 * std::acos(-1.0) * (i % around) / around;
    for (int j = 0; j <= across; ++j) {
      positions.emplace_back(std::cos(angle), std::sin(angle), height * j / across);
      if (i == around || j == across) continue;
      const int a = i * (across + 1) + j, b = a + across + 1;
      faces.push_back({a, b, b + 1});
      faces.push_back({a, b + 1, a + 1});
    }
  }
  return make_mesh(std::move(positions), faces);
}

/// A closed pyramid over a regular polygon: `total_angle` degrees at the apex, vertex 0, and lateral edges of length 1.
/// Its last vertex is the centre of the base. Two sides are a flat wedge, front and back, without a base.
inline Mesh make_pyramid(double total_angle, int sides) {
  const double half = 0.5 * total_angle * std::acos(-1.0) / 180 / sides, slice = 2 * std::acos(-1.0) / sides;
  const double radius = std::sin(half) / std::sin(0.5 * slice), height = std::sqrt(1 - radius * radius);
  std::vector<Vec3> positions{{0, 0, height}};
  for (int i = 0; i < sides; ++i) {
    positions.emplace_back(radius * std::cos(slice * i), radius * std::sin(slice * i), 0);
  }
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < sides; ++i) faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
  if (sides == 2) return make_mesh(std::move(positions), faces);
  positions.emplace_back(0, 0, 0);
  for (int i = 0; i < sides; ++i) faces.push_back({sides + 1, 1 + (i + 1) % sides, 1 + i});
  return make_mesh(std::move(positions), faces);
}

/// The same mesh, `scale` times as large.
inline Mesh scaled(const Mesh& mesh, double scale) {
  std::vector<Vec3> positions = mesh.positions();
  for (Vec3& p : positions) p *= scale;
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
  return Mesh(std::move(positions), std::move(faces));
}

/// Triangles without a common point.
inline Mesh make_loose_triangles(int parts) {
  std::vector<Vec3> corners;
  std::vector<std::array<VertexId, 3>> faces;
  for (int i = 0; i < parts; ++i) {
    corners.insert(corners.end(), {{3.0 * i, 0, 0}, {3.0 * i + 1, 0, 0}, {3.0 * i, 1, 0}});
    faces.push_back({VertexId(3 * i), VertexId(3 * i + 1), VertexId(3 * i + 2)});
  }
  return {std::move(corners), std::move(faces)};
}

/// The mesh with its coordinates times these factors, of which none is negative.
inline Mesh stretched(const Mesh& mesh, const Vec3& factors) {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (const VertexId v : mesh.vertices()) positions.push_back(mesh.position(v).cwiseProduct(factors));
  for (const FaceId f : mesh.faces()) faces.push_back(mesh.vertices(f));
  return {std::move(positions), std::move(faces)};
}

/// A flat rectangle nx x ny whose inner vertices are moved within the plane by up to `shift` <= 0.2 along each axis, so
/// that no triangle is reversed. Many triangles are obtuse.
inline Mesh make_jittered_grid(int nx, int ny, double shift, unsigned seed) {
  Random random(seed);
  std::vector<Vec3> positions;
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      const bool inner = i > 0 && j > 0 && i < nx && j < ny;
      const double x = random.real(-shift, shift), y = random.real(-shift, shift);
      positions.emplace_back(i + (inner ? x : 0), j + (inner ? y : 0), 0);
    }
  }
  std::vector<std::array<int, 3>> faces;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  }
  return make_mesh(std::move(positions), faces);
}

}  // namespace gvd::test
