// Uses the installed library as its README shows it: builds a mesh, prints its size, fails if it is wrong.
#include <array>
#include <cstdio>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

int main() {
  using gvd::Vec3;
  using gvd::VertexId;
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::array<VertexId, 3>> faces{{VertexId(0), VertexId(2), VertexId(1)},
                                                   {VertexId(0), VertexId(1), VertexId(3)},
                                                   {VertexId(1), VertexId(2), VertexId(3)},
                                                   {VertexId(2), VertexId(0), VertexId(3)}};
  const gvd::Mesh mesh(positions, faces);
  const gvd::MeshSummary summary = gvd::compute_mesh_summary(mesh);
  std::printf("vertices %d, faces %d, Euler characteristic %d\n", summary.vertices, summary.faces,
              summary.euler_characteristic);
  return summary.euler_characteristic == 2 ? 0 : 1;
}
