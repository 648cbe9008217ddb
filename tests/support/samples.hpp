#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "geodesic/marching/local_march.hpp"
#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "mesh/find_coincident.hpp"
#include "support/catch.hpp"

namespace gvd::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The samplings that take a number of generators.
inline const std::vector<Sampling> kCounted{Sampling::farthest, Sampling::random, Sampling::poisson};

inline std::vector<SurfacePoint> sample(const Mesh& mesh, Sampling kind, std::int32_t count, std::uint64_t seed = 0) {
  SamplingOptions options;
  options.kind = kind;
  options.count = count;
  options.seed = seed;
  return sample_generators(mesh, options);
}

inline std::vector<SurfacePoint> cover(const Mesh& mesh, double radius) {
  SamplingOptions options;
  options.kind = Sampling::covering_radius;
  options.radius = radius;
  return sample_generators(mesh, options);
}

inline ErrorCode error_of(const Mesh& mesh, const SamplingOptions& options) {
  try {
    sample_generators(mesh, options);
  } catch (const Error& error) {
    return error.code();
  }
  FAIL("no error");
  return ErrorCode::interrupted;
}

inline bool all_distinct(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  const auto first = find_coincident(mesh, points);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != static_cast<std::int32_t>(i)) return false;
  }
  return true;
}

/// Distances along edges, and straight in the faces of the generators: real paths, so never below the geodesic
/// distance.
inline std::vector<double> edge_distances(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  std::vector<double> distance(static_cast<std::size_t>(mesh.vertex_count()), kInfinity);
  const auto reach = [&](VertexId v, double d) {
    if (!(d < distance[v.index()])) return;
    distance[v.index()] = d;
    queue.push({d, v.value()});
  };
  for (const SurfacePoint& g : generators) {
    for (const VertexId v : mesh.vertices(g.face)) reach(v, (mesh.position(v) - position(mesh, g)).norm());
  }
  std::vector<std::vector<HalfedgeId>> leaving(distance.size());
  for (int h = 0; h < mesh.halfedge_count(); ++h) leaving[mesh.from(HalfedgeId(h)).index()].emplace_back(h);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    for (const HalfedgeId h : leaving[v]) {
      reach(mesh.to(h), d + mesh.length(h));
      reach(mesh.opposite(h), d + mesh.length(Mesh::previous(h)));
    }
  }
  return distance;
}

/// Least distance between two of the points, by one march each.
inline double least_spacing(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  LocalMarch march(mesh, Front::circle);
  double least = kInfinity;
  for (std::size_t i = 0; i < points.size(); ++i) {
    march.run(points[i], kInfinity);
    for (std::size_t k = i + 1; k < points.size(); ++k) least = std::min(least, march.distance(points[k]));
  }
  return least;
}

}  // namespace gvd::test
