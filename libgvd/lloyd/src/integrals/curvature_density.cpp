// Sizes from curvature: estimated, limited to a range, and with a limited gradation.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "gvd/density.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

using VertexValues = IdVector<VertexId, double>;

/// Share of the vertices whose size may be below the range: a few corners must not decide about all others.
constexpr double kBelowRange = 0.05;

/// The largest curvature of the edges at each vertex.
VertexValues largest_curvatures(const Mesh& mesh) {
  IdVector<VertexId, Vec3> normal;
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
    normal.push_back(surface_normal(mesh, vertex_point(mesh, VertexId(i))));
  }
  VertexValues curvature(normal.size(), 0);
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
    const VertexId v(i);
    for_each_neighbour(mesh, v, [&](VertexId w, HalfedgeId) {
      const Vec3 way = mesh.position(w) - mesh.position(v);
      const double of_edge = std::abs((normal[w] - normal[v]).dot(way)) / way.squaredNorm();
      if (std::isfinite(of_edge)) curvature[v] = std::max(curvature[v], of_edge);
    });
  }
  return curvature;
}

VertexValues averaged_over_rings(const Mesh& mesh, const VertexValues& values) {
  VertexValues means;
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
    double sum = values[VertexId(i)];
    int count = 1;
    for_each_neighbour(mesh, VertexId(i), [&](VertexId w, HalfedgeId) {
      sum += values[w];
      ++count;
    });
    means.push_back(sum / count);
  }
  return means;
}

/// The inverse curvatures within the range. All are 1 on a flat surface.
VertexValues sizes_in_range(const VertexValues& curvature, double range) {
  std::vector<double> sorted(curvature.begin(), curvature.end());
  const auto at = static_cast<std::ptrdiff_t>((1 - kBelowRange) * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
  const double largest = sorted[at];
  VertexValues sizes;
  for (const double c : curvature) {
    sizes.push_back(largest > 0 ? largest / std::clamp(c, largest / range, largest) : 1);
  }
  return sizes;
}

/// Lowers sizes, as Dijkstra's algorithm lowers distances, until none exceeds a neighbour's by more than the gradation.
void limit_gradation(const Mesh& mesh, double gradation, VertexValues& sizes) {
  using Item = std::pair<double, VertexId>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) queue.emplace(sizes[VertexId(i)], VertexId(i));
  while (!queue.empty()) {
    const double size = queue.top().first;
    const VertexId v = queue.top().second;
    queue.pop();
    if (size > sizes[v]) continue;
    for_each_neighbour(mesh, v, [&](VertexId w, HalfedgeId h) {
      const double most = sizes[v] + gradation * mesh.length(h);
      if (!(most < sizes[w])) return;
      sizes[w] = most;
      queue.emplace(most, w);
    });
  }
}

}  // namespace

Density make_curvature_density(const Mesh& mesh, const CurvatureDensityOptions& options) {
  const auto refuse = [](const char* message) { throw Error(ErrorCode::invalid_option, message); };
  if (!(options.gradation > 0) || !std::isfinite(options.gradation)) refuse("the gradation must be above 0");
  if (!(options.range >= 1) || !std::isfinite(options.range)) refuse("the range of sizes must be 1 or more");
  const VertexValues curvature = averaged_over_rings(mesh, largest_curvatures(mesh));
  VertexValues sizes = sizes_in_range(curvature, options.range);
  // A size of 1 is the smallest radius of curvature. In mesh units, a size grows by `gradation` per length.
  const double smallest = 1 / *std::max_element(curvature.begin(), curvature.end());
  if (std::isfinite(smallest)) limit_gradation(mesh, options.gradation / smallest, sizes);
  std::vector<double> values;
  for (const double size : sizes) values.push_back(std::pow(size, -4));
  return make_vertex_density(mesh, values);
}

}  // namespace gvd
