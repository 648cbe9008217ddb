#pragma once

#include <random>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::test {

/// `count` different points: a third each on vertices, on edges and in faces. A vertex that was taken already is
/// replaced by a point in a face.
inline std::vector<SurfacePoint> random_generators(const Mesh& mesh, int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto real = [&] { return double(random()) / double(std::mt19937::max()); };
  std::vector<char> taken(static_cast<std::size_t>(mesh.vertex_count()), 0);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const FaceId f(below(mesh.face_count()));
    const VertexId v(below(mesh.vertex_count()));
    const double u = 0.01 + 0.98 * real(), w = (1 - u) * (0.01 + 0.98 * real());
    if (i % 3 == 0 && !taken[v.index()]) {
      taken[v.index()] = 1;
      points.push_back(vertex_point(mesh, v));
    } else if (i % 3 == 1) {
      points.push_back(edge_point(Mesh::halfedge(f, below(3)), u));
    } else {
      points.push_back(make_surface_point(f, {u, w, 1 - u - w}));
    }
  }
  return points;
}

/// `count` points evenly along a halfedge.
inline std::vector<SurfacePoint> along_edge(HalfedgeId h, int count) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) points.push_back(edge_point(h, (i + 0.5) / count));
  return points;
}

}  // namespace gvd::test
