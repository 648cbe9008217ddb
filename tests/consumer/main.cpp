// Uses the installed library: builds a mesh, measures it, computes a diagram, fails where a result is wrong.
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#ifdef CONSUMER_HAS_VERIFY
#include "gvd/verify.hpp"
#endif

namespace {

gvd::Mesh make_tetrahedron() {
  using gvd::VertexId;
  const std::vector<gvd::Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::array<VertexId, 3>> faces{{VertexId(0), VertexId(2), VertexId(1)},
                                                   {VertexId(0), VertexId(1), VertexId(3)},
                                                   {VertexId(1), VertexId(2), VertexId(3)},
                                                   {VertexId(2), VertexId(0), VertexId(3)}};
  return gvd::Mesh(positions, faces);
}

}  // namespace

int main() {
  const gvd::Mesh mesh = make_tetrahedron();
  const gvd::MeshSummary summary = gvd::compute_mesh_summary(mesh);
  std::printf("faces %d, Euler characteristic %d\n", summary.faces, summary.euler_characteristic);
  if (summary.euler_characteristic != 2) return 1;
  const gvd::Diagram diagram = gvd::compute_diagram(
      mesh, {gvd::vertex_point(mesh, gvd::VertexId(0)), gvd::vertex_point(mesh, gvd::VertexId(1))});
  std::printf("cells %d, bisectors %d\n", static_cast<int>(diagram.cells.size()),
              static_cast<int>(diagram.bisectors.size()));
  if (diagram.cells.size() != 2 || diagram.bisectors.size() != 1) return 1;
#ifdef CONSUMER_HAS_VERIFY
  const gvd::DistanceQuery query{gvd::vertex_point(mesh, gvd::VertexId(0)),
                                 {gvd::vertex_point(mesh, gvd::VertexId(1))}};
  const double distance = gvd::compute_exact_distances(mesh, {query}).front().front();
  std::printf("distance along an edge of length 1: %g\n", distance);
  if (std::abs(distance - 1) > 1e-12) return 1;
#endif
  return 0;
}
