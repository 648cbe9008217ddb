// Windows against CGAL's exact shortest paths.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/verify.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_window_sources {

TEST_CASE("what reaches a point of an edge is a path, and the shortest one is among it") {
  constexpr double kExact = 1e-12;
  constexpr int kPlaces = 3;
  for (const auto& [name, mesh] : test::small_family()) {
    if (mesh.face_count() > 700) continue;
    INFO(name);
    const int n = mesh.vertex_count();
    const std::vector<VertexId> generators{VertexId(0), VertexId(n / 3), VertexId(n / 2), VertexId(n - 1)};
    const WindowField field = propagate_windows(mesh, generators, {KeepWindows::all, {}}, {});
    std::vector<SurfacePoint> points;
    for (int e = 0; e < mesh.edge_count(); ++e) {
      for (int i = 1; i <= kPlaces; ++i) points.push_back(edge_point(mesh.halfedge(EdgeId(e)), i / (kPlaces + 1.0)));
    }
    std::vector<DistanceQuery> queries;
    for (const VertexId v : generators) queries.push_back({vertex_point(mesh, v), points});
    const auto expected = compute_exact_distances(mesh, queries);
    const double tolerance = kExact * mesh.bbox_diagonal();
    double too_short = 0, worst = 0;
    std::vector<EdgeSource> sources;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const HalfedgeId h = mesh.halfedge(EdgeId(std::int64_t(i) / kPlaces));
      const double t = double(i % kPlaces + 1) / (kPlaces + 1) * mesh.length(h);
      double nearest = std::numeric_limits<double>::infinity(), found = nearest;
      for (const auto& row : expected) nearest = std::min(nearest, row[i]);
      collect_edge_sources(mesh, field, h, sources);
      for (const EdgeSource& source : sources) {
        found = std::min(found, source.distance(t));
        too_short = std::max(too_short, expected[source.generator.index()][i] - source.distance(t));
      }
      if (found != nearest) worst = std::max(worst, std::abs(found - nearest));
    }
    CHECK(too_short <= tolerance);
    CHECK(worst <= tolerance);
  }
}

}  // namespace gvd::test_window_sources
