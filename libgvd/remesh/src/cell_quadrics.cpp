// Measures what the surface in a cell asks of the cell's vertex: the quadric of its faces, and the creases in it.
//
// A quadric sums square distances from planes and lines. Its minimum is the corner of a cell that has one, and a point
// of the crease in a cell that has a crease; elsewhere it is free along the surface. The sharp edges in a cell tell
// whether its triangles should meet a crease. Small groups of such cells do not count, because coarse, curved surfaces
// have them. Source: M. Garland and P. Heckbert, Surface simplification using quadric error metrics, 1997.

#include "cell_quadrics.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/angles.hpp"
#include "base/barycentric.hpp"
#include "base/union_find.hpp"
#include "diagram/cell_parts.hpp"
#include "edge_labels.hpp"
#include "mesh/creases.hpp"
#include "repair/cell_topology.hpp"

namespace gvd {

Vec3 Quadric::minimize(double truncation) const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  Vec3 offset(0, 0, 0);
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    if (!(value > 0) || value < truncation * solver.eigenvalues()[2]) continue;
    const Vec3 direction = solver.eigenvectors().col(i);
    offset += direction.dot(vector) / value * direction;
  }
  return offset;
}

IdVector<GeneratorId, Quadric> compute_cell_quadrics(const Mesh& mesh, const Diagram& diagram) {
  IdVector<GeneratorId, Quadric> quadrics(diagram.generators.size());
  IdVector<GeneratorId, Vec3> origin;
  for (const SurfacePoint& p : diagram.generators) origin.push_back(position(mesh, p));
  for_each_cell_part(diagram, [&](const FacePart& part) {
    const double area = std::max(0.0, area_share(part.corners)) * mesh.area(part.face);
    const Vec3& corner = mesh.position(mesh.vertices(part.face)[0]);
    quadrics[part.generator].add_plane(face_normal(mesh, part.face), corner - origin[part.generator], area);
    quadrics[part.generator].area += area;
  });
  for (const BoundaryArc& arc : list_boundary_arcs(mesh, diagram)) {
    Quadric& quadric = quadrics[arc.cell];
    for (const BoundaryArc::Segment& segment : arc.segments) {
      const Vec3& from = mesh.position(mesh.from(segment.halfedge));
      const Vec3 edge = mesh.position(mesh.to(segment.halfedge)) - from;
      const double length = (segment.end - segment.begin) * edge.norm();
      quadric.add_line(edge.normalized(), from - origin[arc.cell], length * std::sqrt(quadric.area));
    }
  }
  return quadrics;
}

namespace {

/// The parts of a crease have a common direction if this fraction of their length is along it.
constexpr double kLeastAlignment = 0.9;

/// Sums over the parts of edges in a cell.
struct EdgeSum {
  double bending = 0;                                    // length times angle
  double sharp_bending = 0;                              // of sharp edges
  double length = 0;                                     // of sharp and boundary edges
  bool has_boundary = false;                             // a part of a boundary edge
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();  // of sharp and boundary edges, by their lengths
};

void add_edge(const Mesh& mesh, EdgeId e, const std::vector<LabelInterval>& labels,
              IdVector<GeneratorId, EdgeSum>& sums) {
  const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
  const bool is_boundary = !twin.valid();
  const Vec3 here = face_normal(mesh, Mesh::face(h)), there = is_boundary ? here : face_normal(mesh, Mesh::face(twin));
  const double angle = angle_between(here, there);
  const bool is_sharp = CreaseTest(kSharpAngle)(here, there);
  const Vec3 along = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).normalized();
  for (const LabelInterval& label : labels) {  // two for each part of an inner edge
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

/// Whether a point of an edge or a vertex has faces that make a sharp edge.
bool is_on_crease(const Mesh& mesh, const SurfacePoint& point) {
  const CreaseTest meet_at_crease(kSharpAngle);
  const std::vector<FaceId> faces = faces_around(mesh, point);
  for (const FaceId f : faces) {
    for (const FaceId g : faces) {
      if (meet_at_crease(face_normal(mesh, f), face_normal(mesh, g))) return true;
    }
  }
  return false;
}

/// Clears the creases of small groups of neighbouring cells.
void keep_large_groups(const Mesh& remesh, IdVector<GeneratorId, char>& chosen) {
  UnionFind groups(chosen.size());
  const auto is_chosen = [&](VertexId v) { return chosen[GeneratorId(v.value())] != 0; };
  for (const EdgeId e : remesh.edges()) {
    const HalfedgeId h = remesh.halfedge(e);
    if (is_chosen(remesh.from(h)) && is_chosen(remesh.to(h))) {
      groups.unite(remesh.from(h).value(), remesh.to(h).value());
    }
  }
  std::vector<std::int64_t> sizes(chosen.size(), 0);
  for (const VertexId v : remesh.vertices()) {
    if (is_chosen(v)) ++sizes[groups.find(v.value())];
  }
  const std::int64_t least = std::min<std::int64_t>(kLeastCreaseCells, remesh.vertex_count() / 8);
  for (const GeneratorId g : chosen.ids()) {
    if (sizes[groups.find(g.value())] < least) chosen[g] = 0;
  }
}

}  // namespace

IdVector<GeneratorId, CreaseCell> find_crease_cells(const Mesh& surface, const Diagram& diagram, const Mesh& remesh) {
  IdVector<GeneratorId, EdgeSum> sums(diagram.generators.size());
  for (const EdgeId e : surface.edges()) add_edge(surface, e, label_edge(surface, diagram, e), sums);
  IdVector<GeneratorId, char> has_crease;
  for (const EdgeSum& sum : sums) {
    has_crease.push_back(sum.sharp_bending > 0 && sum.sharp_bending >= kLeastBendingShare * sum.bending);
  }
  keep_large_groups(remesh, has_crease);
  IdVector<GeneratorId, CreaseCell> cells(sums.size());
  for (const GeneratorId g : sums.ids()) {
    const bool is_inset = sums[g].has_boundary && !is_on_boundary(surface, diagram.generators[g.index()]);
    cells[g].is_creased = has_crease[g] || is_inset;
    cells[g].is_met = cells[g].is_creased && is_on_crease(surface, diagram.generators[g.index()]);
    if (cells[g].is_creased) cells[g].direction = find_direction(sums[g]);
  }
  return cells;
}

}  // namespace gvd
