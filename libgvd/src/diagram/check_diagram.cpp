// Check of a finished diagram, from its public data alone.
//
// Ids come first, because every other check looks them up. Then each property of gvd/check.hpp is tested by itself:
// generators and areas, the points and ends of bisectors, branch points, and the topology of the cells. Nothing that
// the tracer computed on its way is read, so an error of the tracer can't hide itself.
// Invariant: no check throws or stops at its first finding. Each finding names the number of its property.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/check_parts.hpp"
#include "gvd/check.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

class IdCheck {
 public:
  IdCheck(const Mesh& mesh, const Diagram& diagram, Violations& violations)
      : mesh_(mesh), diagram_(diagram), violations_(violations) {}

  void run() {
    check_cells();
    check_labels();
    for (const BisectorId b : diagram_.bisectors.ids()) check_bisector(b);
  }

 private:
  template <class IdType>
  static bool below(IdType id, std::int32_t count) {
    return id.valid() && id.value() < count;
  }
  template <class Items, class Test>
  static bool all(const Items& items, Test test) {
    return std::all_of(items.begin(), items.end(), test);
  }
  bool is_cell(GeneratorId g) const { return below(g, diagram_.cells.count()); }
  bool is_cell_or_none(GeneratorId g) const { return !g.valid() || is_cell(g); }
  bool is_face(FaceId f) const { return below(f, mesh_.face_count()); }

  void check_cells() {
    const Diagram& d = diagram_;
    bool cells_fit = d.cells.size() == d.generators.size();
    for (const GeneratorId g : d.cells.ids()) cells_fit = cells_fit && d.cells[g].generator == g;
    if (cells_fit && all(d.generators, [&](const SurfacePoint& p) { return is_face(p.face); })) return;
    violations_.add(1, "cells are not numbered like the generators, or a generator lies in no face of the mesh");
  }

  void check_labels() {
    const Diagram& d = diagram_;
    const auto is_label = [&](GeneratorId g) { return is_cell_or_none(g); };
    const auto is_piece = [&](const FacePiece& p) { return is_face(p.face) && is_cell(p.generator); };
    if (d.vertex_label.count() != mesh_.vertex_count() || d.vertex_distance.size() != d.vertex_label.size() ||
        d.face_label.count() != mesh_.face_count() || !all(d.vertex_label, is_label) || !all(d.face_label, is_label) ||
        !all(d.pieces, is_piece)) {
      violations_.add(2,
                      "labels or pieces do not match the mesh in number, or name a cell or face that does not exist");
    }
  }

  void check_bisector(BisectorId id) {
    const Bisector& b = diagram_.bisectors[id];
    const auto is_end = [&](BranchPointId e) { return !e.valid() || below(e, diagram_.branch_points.count()); };
    if (!is_cell_or_none(b.left) || !is_cell_or_none(b.right) ||
        !all(b.points, [&](const SurfacePoint& p) { return is_face(p.face); })) {
      violations_.add(3, "bisector", id.index(), "names a cell or face that does not exist");
    }
    if (!all(b.ends, is_end)) violations_.add(4, "bisector", id.index(), "ends at a branch point that does not exist");
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  Violations& violations_;
};

/// The largest distance of a generator from its cell, relative to the bounding box's diagonal: rounding, and a thousand
/// times the distance within which a generator is taken for a vertex.
constexpr double kDistanceTolerance = 1e-9;

/// Whether a piece contains a point of its face, within the tolerance.
bool contains(const Mesh& mesh, const FacePiece& piece, const SurfacePoint& p) {
  const Vec3 at = position(mesh, p);
  bool inside = false;
  for (std::size_t i = 0, n = piece.corners.size(); i < n; ++i) {
    const Bary &a = piece.corners[i], &b = piece.corners[(i + 1) % n];
    const Vec3 from = position(mesh, {piece.face, a}), along = position(mesh, {piece.face, b}) - from;
    const double t = along.squaredNorm() > 0 ? std::clamp((at - from).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
    if ((from + t * along - at).norm() <= kDistanceTolerance * mesh.bbox_diagonal()) return true;
    // Count the sides that the ray from p along the second coordinate crosses.
    if ((a[2] > p.bary[2]) == (b[2] > p.bary[2])) continue;
    const double where = a[1] + (b[1] - a[1]) * (p.bary[2] - a[2]) / (b[2] - a[2]);
    if (where > p.bary[1]) inside = !inside;
  }
  return inside;
}

bool is_in_cell_within_face(const Mesh& mesh, const Diagram& diagram, const SurfacePoint& p, GeneratorId g) {
  if (diagram.face_label[p.face].valid()) return diagram.face_label[p.face] == g;
  const auto pieces = std::equal_range(diagram.pieces.begin(), diagram.pieces.end(), FacePiece{p.face, g, {}},
                                       [](const FacePiece& a, const FacePiece& b) { return a.face < b.face; });
  return std::any_of(pieces.first, pieces.second,
                     [&](const FacePiece& piece) { return piece.generator == g && contains(mesh, piece, p); });
}

/// A point on an edge belongs to the faces on both sides. In a face without area other points lie at the same position,
/// and the cell may reach the point only from the other side.
bool is_in_cell(const Mesh& mesh, const Diagram& diagram, const SurfacePoint& p, GeneratorId g) {
  if (p.kind() == SurfacePoint::Kind::vertex) return diagram.vertex_label[vertex(mesh, p)] == g;
  if (is_in_cell_within_face(mesh, diagram, p, g)) return true;
  if (p.kind() != SurfacePoint::Kind::edge) return false;
  const HalfedgeId h = halfedge(p), twin = mesh.twin(h);
  return twin.valid() && is_in_cell_within_face(mesh, diagram, edge_point(twin, p.bary[Mesh::corner(h)]), g);
}

bool share_face(const Mesh& mesh, const SurfacePoint& p, const SurfacePoint& q) {
  const auto faces_p = faces_around(mesh, p), faces_q = faces_around(mesh, q);
  return std::find_first_of(faces_p.begin(), faces_p.end(), faces_q.begin(), faces_q.end()) != faces_p.end();
}

void check_points(const Mesh& mesh, const Bisector& b, std::size_t i, Violations& violations) {
  const std::size_t n = b.points.size();
  for (std::size_t k = 0; k + (b.closed ? 0 : 1) < n; ++k) {
    if (share_face(mesh, b.points[k], b.points[(k + 1) % n])) continue;
    violations.add(3, "bisector", i, fmt::format("its points {} and {} have no face in common", k, (k + 1) % n));
    return;
  }
}

void check_ends(const Mesh& mesh, const Bisector& b, std::size_t i, Violations& violations) {
  for (const int end : {0, 1}) {
    const SurfacePoint& p = end == 0 ? b.points.front() : b.points.back();
    if (b.closed || b.ends[end].valid() || is_on_boundary(mesh, p)) continue;
    violations.add(4, "bisector", i, "ends neither at a branch point nor on the boundary of the mesh");
  }
}

/// Lists for every branch point the cells whose sector begins at a bisector that ends there.
IdVector<BranchPointId, std::vector<GeneratorId>> cells_at_branch_points(const Diagram& diagram) {
  IdVector<BranchPointId, std::vector<GeneratorId>> cells(diagram.branch_points.size());
  for (const Bisector& b : diagram.bisectors) {
    if (b.ends[0].valid()) cells[b.ends[0]].push_back(b.right);
    if (b.ends[1].valid()) cells[b.ends[1]].push_back(b.left);
  }
  return cells;
}

void check_branch_points(const Diagram& diagram, Violations& violations) {
  auto cells = cells_at_branch_points(diagram);
  for (const BranchPointId id : diagram.branch_points.ids()) {
    auto named = diagram.branch_points[id].generators;
    if (cells[id].size() < 3) violations.add(5, "branch point", id.index(), "fewer than three bisectors end at it");
    std::sort(named.begin(), named.end());
    std::sort(cells[id].begin(), cells[id].end());
    if (named != cells[id])
      violations.add(5, "branch point", id.index(), "its generators are not those of its bisectors");
  }
}

void check_components(const Diagram& diagram, Violations& violations) {
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
  for (const FaceId f : mesh.faces()) faces += reached.contains(f);
  for (const EdgeId e : mesh.edges()) edges += reached.contains(Mesh::face(mesh.halfedge(e)));
  for (const VertexId v : mesh.vertices()) vertices += reached.contains(Mesh::face(mesh.halfedge(v)));
  return vertices - edges + faces;
}

/// The surface is the disjoint union of four sets: the cells' interiors, the bisectors without their ends
/// (characteristic -1 each, 0 if closed), the branch points (+1 each) and the mesh's boundary. Along each loop of that
/// boundary, its pieces and the bisector ends on it cancel. The interior of a cell counts as much as the cell: its
/// boundary loops count 0.
void check_euler(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations) {
  std::int64_t cells = 0, open = 0;
  for (const Cell& c : diagram.cells) cells += c.euler_characteristic;
  for (const Bisector& b : diagram.bisectors) open += b.closed ? 0 : 1;
  const std::int64_t branches = diagram.branch_points.count();
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

void check_ids(const Mesh& mesh, const Diagram& diagram, Violations& violations) {
  IdCheck(mesh, diagram, violations).run();
}

void check_generators(const Mesh& mesh, const Diagram& diagram, Violations& violations) {
  for (const GeneratorId g : IdRange<GeneratorId>(diagram.generators.size())) {
    if (!is_in_cell(mesh, diagram, diagram.generators[g.index()], g))
      violations.add(1, "generator", g.index(), "lies outside its cell");
    // An area of 0 is sound: the faces around the generator may have none.
    if (!(diagram.cells[g].area >= 0)) violations.add(1, "cell", g.index(), "its area is negative or not a number");
  }
}

void check_bisectors(const Mesh& mesh, const Diagram& diagram, Violations& violations) {
  for (const BisectorId id : diagram.bisectors.ids()) {
    const Bisector& b = diagram.bisectors[id];
    const std::size_t i = id.index();
    if (b.points.size() < 2 || !b.left.valid() || !b.right.valid() || b.left == b.right) {
      violations.add(3, "bisector", i, "does not separate two cells, or has fewer than two points");
      continue;
    }
    check_points(mesh, b, i, violations);
    check_ends(mesh, b, i, violations);
  }
  check_branch_points(diagram, violations);
}

void check_topology(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations) {
  check_components(diagram, violations);
  check_euler(mesh, diagram, reached, violations);
  check_neighbours(diagram, violations);
}

DiagramCheck check_diagram(const Mesh& mesh, const Diagram& diagram) {
  Violations violations;
  check_ids(mesh, diagram, violations);
  if (!violations.empty()) return {violations.take()};
  const ReachedFaces reached(mesh, diagram.generators);
  check_partition(mesh, diagram, reached, violations);
  check_generators(mesh, diagram, violations);
  check_bisectors(mesh, diagram, violations);
  check_topology(mesh, diagram, reached, violations);
  return {violations.take()};
}

}  // namespace gvd
