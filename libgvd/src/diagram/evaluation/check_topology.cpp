#include "diagram/evaluation/check_topology.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <set>
#include <utility>

namespace gvd {
namespace {

void check_cells(const Diagram& diagram, Violations& violations) {
  for (const Cell& c : diagram.cells) {
    const auto i = c.generator.index();
    if (c.components != 1) violations.add(6, "cell", i, "is not connected");
    const std::int32_t twice_genus = 2 * c.components - c.boundary_loops - c.euler_characteristic;
    if (twice_genus >= 0 && twice_genus % 2 == 0) continue;
    violations.add(6, "cell", i, "no surface has its Euler characteristic and its number of boundary loops");
  }
}

std::int64_t reached_characteristic(const Mesh& mesh, const ReachedFaces& reached) {
  std::int64_t faces = 0, edges = 0, vertices = 0;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) faces += reached.contains(FaceId(i));
  for (std::int32_t i = 0; i < mesh.edge_count(); ++i) {
    edges += reached.contains(Mesh::face(mesh.halfedge(EdgeId(i))));
  }
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
    vertices += reached.contains(Mesh::face(mesh.halfedge(VertexId(i))));
  }
  return vertices - edges + faces;
}

/// The surface is the disjoint union of four: the cells' interiors, the bisectors without their ends (characteristic -1
/// each, 0 if closed), the branch points (+1 each) and the mesh's boundary. Along each loop of that boundary, its
/// pieces and the bisector ends on it cancel. The interior of a cell counts as much as the cell: its boundary loops
/// count 0.
void check_euler(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations) {
  std::int64_t cells = 0, open = 0;
  for (const Cell& c : diagram.cells) cells += c.euler_characteristic;
  for (const Bisector& b : diagram.bisectors) open += b.closed ? 0 : 1;
  const auto branches = static_cast<std::int64_t>(diagram.branch_points.size());
  const std::int64_t whole = reached_characteristic(mesh, reached);
  if (cells - open + branches == whole) return;
  violations.add(7, fmt::format("Euler's formula: cells {} - bisectors {} + branch points {} is not {}", cells, open,
                                branches, whole));
}

void check_neighbours(const Diagram& diagram, Violations& violations) {
  std::set<std::pair<GeneratorId, GeneratorId>> pairs, listed;
  for (const Bisector& b : diagram.bisectors) {
    pairs.emplace(b.left, b.right);
    pairs.emplace(b.right, b.left);
  }
  for (const Cell& c : diagram.cells) {
    for (const GeneratorId g : c.neighbours) listed.emplace(c.generator, g);
  }
  if (pairs != listed) violations.add(8, "the cells' neighbours are not the cells with a bisector in common");
}

}  // namespace

void check_topology(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations) {
  check_cells(diagram, violations);
  check_euler(mesh, diagram, reached, violations);
  check_neighbours(diagram, violations);
}

}  // namespace gvd
