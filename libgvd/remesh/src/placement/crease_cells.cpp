#include "placement/crease_cells.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/union_find.hpp"
#include "creases/edge_labels.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

/// The parts of a crease have one direction if so much of their length is along it.
constexpr double kLeastAlignment = 0.9;

/// Sums over the parts of edges in a cell.
struct EdgeSum {
  double bending = 0;                                    // length times angle
  double sharp_bending = 0;                              // of sharp edges
  double length = 0;                                     // of sharp and boundary edges
  bool has_boundary = false;                             // a part of a boundary edge
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();  // of sharp and boundary edges, by their lengths
};

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

void add_edge(const Mesh& mesh, EdgeId e, const std::vector<EdgeLabel>& labels, IdVector<GeneratorId, EdgeSum>& sums) {
  const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
  const bool is_boundary = !twin.valid();
  const double angle =
      is_boundary ? 0 : angle_between(face_normal(mesh, Mesh::face(h)), face_normal(mesh, Mesh::face(twin)));
  const bool is_sharp = angle > kSharpAngle * std::numbers::pi / 180;
  const Vec3 along = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).normalized();
  for (const EdgeLabel& label : labels) {  // two for each part of an inner edge
    const double length = (label.end - label.begin) * mesh.length(h) * (is_boundary ? 1 : 0.5);
    EdgeSum& sum = sums[label.cell];
    sum.bending += length * angle;
    if (is_sharp) sum.sharp_bending += length * angle;
    if (!is_sharp && !is_boundary) continue;
    sum.length += length;
    sum.has_boundary |= is_boundary;
    sum.directions += length * along * along.transpose();
  }
}

Vec3 find_direction(const EdgeSum& sum) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum.directions);
  return solver.eigenvalues()[2] >= kLeastAlignment * sum.length ? Vec3(solver.eigenvectors().col(2)) : Vec3(0, 0, 0);
}

/// Takes small groups of neighbouring cells out.
void keep_large_groups(const Mesh& remesh, IdVector<GeneratorId, char>& chosen) {
  UnionFind groups(chosen.size());
  const auto is_chosen = [&](VertexId v) { return chosen[GeneratorId(v.value())] != 0; };
  for (std::int32_t e = 0; e < remesh.edge_count(); ++e) {
    const HalfedgeId h = remesh.halfedge(EdgeId(e));
    if (is_chosen(remesh.from(h)) && is_chosen(remesh.to(h))) {
      groups.unite(remesh.from(h).value(), remesh.to(h).value());
    }
  }
  std::vector<std::int64_t> sizes(chosen.size(), 0);
  for (std::int32_t v = 0; v < remesh.vertex_count(); ++v) {
    if (is_chosen(VertexId(v))) ++sizes[groups.find(v)];
  }
  const std::int64_t least = std::min<std::int64_t>(kLeastCreaseCells, remesh.vertex_count() / 8);
  for (std::int32_t v = 0; v < remesh.vertex_count(); ++v) {
    if (sizes[groups.find(v)] < least) chosen[GeneratorId(v)] = 0;
  }
}

}  // namespace

IdVector<GeneratorId, CreaseCell> find_crease_cells(const Mesh& surface, const Diagram& diagram, const Mesh& remesh) {
  IdVector<GeneratorId, EdgeSum> sums(diagram.generators.size());
  const EdgeLabels labels(surface, diagram);
  for (std::int32_t e = 0; e < surface.edge_count(); ++e) add_edge(surface, EdgeId(e), labels.of(EdgeId(e)), sums);
  IdVector<GeneratorId, char> has_crease;
  for (const EdgeSum& sum : sums) {
    has_crease.push_back(sum.sharp_bending > 0 && sum.sharp_bending >= kLeastBendingShare * sum.bending);
  }
  keep_large_groups(remesh, has_crease);
  IdVector<GeneratorId, CreaseCell> cells(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const GeneratorId g(i);
    const bool is_inset = sums[g].has_boundary && !is_on_boundary(surface, diagram.generators[i]);
    cells[g].is_creased = has_crease[g] || is_inset;
    if (cells[g].is_creased) cells[g].direction = find_direction(sums[g]);
  }
  return cells;
}

}  // namespace gvd
