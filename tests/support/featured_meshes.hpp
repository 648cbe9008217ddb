#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "gvd/creases.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "support/meshes.hpp"

// Meshes with what generators keep to or leave: ends of limbs, creases, holes.
namespace gvd::test {

/// A sphere of radius 1 with two pointed limbs of length 2 along the z axis. Their ends are vertices 0 and the last.
inline Mesh make_spindle() {
  constexpr int kAround = 12, kHalf = 30;
  constexpr double kStep = 0.1, kLength = kStep * kHalf;
  std::vector<Vec3> positions{{0, 0, -kLength}};
  for (int i = 1 - kHalf; i < kHalf; ++i) {
    const double z = kStep * i;
    const double radius = std::max(std::sqrt(std::max(0.0, 1 - z * z)), 0.15 * (kLength - std::abs(z)));
    for (int j = 0; j < kAround; ++j) {
      const double turn = 2 * std::numbers::pi * j / kAround;
      positions.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
    }
  }
  positions.emplace_back(0, 0, kLength);
  const auto at = [](int i, int j) { return VertexId(1 + i * kAround + j % kAround); };
  const int rings = 2 * kHalf - 1;
  std::vector<std::array<VertexId, 3>> faces;
  for (int j = 0; j < kAround; ++j) {
    faces.push_back({VertexId(0), at(0, j + 1), at(0, j)});
    faces.push_back({VertexId(positions.size() - 1), at(rings - 1, j), at(rings - 1, j + 1)});
    for (int i = 0; i + 1 < rings; ++i) {
      faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return {std::move(positions), std::move(faces)};
}

/// A closed box of 1 x 1 x 0.5 whose two large sides bulge by 0.15. Its creases are the box's edges, of length 10 in
/// all, with angles of 90 degrees or a little less.
inline Mesh make_domed_box() {
  const Mesh box = make_plate(16, 0.5);
  std::vector<Vec3> positions = box.positions();
  for (Vec3& p : positions) {
    const double bulge = 0.15 * 16 * p.x() * (1 - p.x()) * p.y() * (1 - p.y());
    p.z() += p.z() > 0 ? bulge : -bulge;
  }
  return {std::move(positions), box.face_vertices()};
}

/// A closed box of 1 x 1 x 0.5 whose edges are rounded with a radius of 0.08, over about four faces.
inline Mesh make_rounded_box() {
  const Mesh box = make_plate(40, 0.5);
  std::vector<Vec3> positions = box.positions();
  const Vec3 radius(0.08, 0.08, 0.08);
  Vec3 least = positions.front(), most = positions.front();
  for (const Vec3& p : positions) least = least.cwiseMin(p), most = most.cwiseMax(p);
  for (Vec3& p : positions) {
    const Vec3 core = p.cwiseMax(least + radius).cwiseMin(most - radius);
    p = core + 0.08 * (p - core).normalized();
  }
  return {std::move(positions), box.face_vertices()};
}

/// A closed cube of edge 1 whose edges and corners are cut off straight, `width` from where the edges would be.
inline Mesh make_bevelled_cube(double width) {
  // Corner k has the signs of its three bits, and a point on each of its three faces.
  const auto point = [](int corner, int axis) { return 3 * corner + axis; };
  std::vector<Vec3> positions;
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 p;
      for (int i = 0; i < 3; ++i) p[i] = (corner >> i & 1 ? 1 : -1) * (i == axis ? 0.5 : 0.5 - width);
      positions.push_back(p);
    }
  }
  std::vector<std::array<VertexId, 3>> faces;
  const auto add = [&](const std::vector<int>& polygon) {
    const auto at = [&](int i) { return positions[polygon[i]]; };
    const bool is_outward = (at(1) - at(0)).cross(at(2) - at(0)).dot(at(0)) > 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const VertexId a(polygon[0]), b(polygon[i]), c(polygon[i + 1]);
      faces.push_back(is_outward ? std::array{a, b, c} : std::array{a, c, b});
    }
  };
  for (int corner = 0; corner < 8; ++corner) add({point(corner, 0), point(corner, 1), point(corner, 2)});
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3, u = 1 << second, v = 1 << third;
    for (const int side : {0, 1 << axis}) {
      add({point(side, axis), point(side | u, axis), point(side | u | v, axis), point(side | v, axis)});
    }
    for (const int edge : {0, u, v, u | v}) {
      const int far = edge | 1 << axis;
      add({point(edge, second), point(edge, third), point(far, third), point(far, second)});
    }
  }
  return {std::move(positions), std::move(faces)};
}

/// A flat square of 24 x 24 unit squares without 16 of them: 17 boundary loops.
inline Mesh make_plane_with_holes() {
  const Mesh grid = make_grid(24, 24);
  std::vector<std::array<VertexId, 3>> faces;
  for (const FaceId f : grid.faces()) {
    const auto& [a, b, c] = grid.vertices(f);
    const Vec3 at = (grid.position(a) + grid.position(b) + grid.position(c)) / 3;
    const bool in_hole = int(std::floor(at.x())) % 6 == 3 && int(std::floor(at.y())) % 6 == 3;
    if (!in_hole) faces.push_back({a, b, c});
  }
  return {grid.positions(), std::move(faces)};
}

/// The mesh with a sliver along each edge whose faces meet at 40 degrees or more, folded over one of them: the edge and
/// the way round its sliver turn by 90 degrees and more, too. `depth`: of the slivers, relative to their edges.
inline Mesh fold_creases(const Mesh& mesh, double depth) {
  std::vector<Vec3> positions = mesh.positions();
  std::vector<std::array<VertexId, 3>> faces = mesh.face_vertices();
  std::map<std::pair<VertexId, VertexId>, std::size_t> face_of;  // by its halfedges
  const auto enter = [&](std::size_t f) {
    for (int i = 0; i < 3; ++i) face_of[{faces[f][i], faces[f][(i + 1) % 3]}] = f;
  };
  for (std::size_t f = 0; f < faces.size(); ++f) enter(f);
  for (const EdgeId e : find_creases(mesh, {40})) {
    const HalfedgeId h = mesh.halfedge(e);
    const VertexId a = mesh.from(h), b = mesh.to(h), added(positions.size());
    const Vec3 along = mesh.position(b) - mesh.position(a), normal = face_normal(mesh, Mesh::face(h));
    const Vec3 inwards = normal.cross(along);
    positions.push_back(mesh.position(a) + along / 2 + depth * (inwards + along.norm() / 2 * normal));
    const std::size_t right = face_of.at({b, a});
    VertexId opposite;
    for (const VertexId v : faces[right]) {
      if (v != a && v != b) opposite = v;
    }
    faces[right] = {b, added, opposite};
    faces.push_back({added, a, opposite});
    faces.push_back({b, a, added});
    enter(right), enter(faces.size() - 2), enter(faces.size() - 1);
  }
  return {std::move(positions), std::move(faces)};
}

}  // namespace gvd::test
