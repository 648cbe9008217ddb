// Checks a finished diagram from its public data alone.
//
// Ids come first, because every other check looks them up. Then each property of gvd/check.hpp is tested by itself: the
// partition of the surface into cells, generators, the points and ends of bisectors, branch points, and the topology of
// the cells. The checks read nothing that the tracer computed on its way, so that an error of the tracer can't hide.
// Cells partition the surface if the label or the pieces of every reached face cover it once, and each vertex has the
// label of all faces and pieces at it, because then cells fit each other across edges.
// Euler's formula finds errors that no local check sees: a missing cell, or a cell with a hole that has no bisector.
// Invariant: no check throws or stops at its first finding. Each finding names the number of its property. Faces and
// pieces are visited in one order, ascending by face, and areas are summed in that order.
#include "diagram/check_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/cell_parts.hpp"
#include "gvd/check.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/component_topology.hpp"

namespace gvd {
namespace {

template <class IdType>
bool is_below(IdType id, std::int32_t count) {
  return id.valid() && id.value() < count;
}

bool cells_fit(const Diagram& d, const Mesh& mesh) {
  bool fit = d.cells.size() == d.generators.size();
  for (const GeneratorId g : d.cells.ids()) fit = fit && d.cells[g].generator == g;
  return fit &&
         std::ranges::all_of(d.generators, [&](const SurfacePoint& p) { return is_below(p.face, mesh.face_count()); });
}

bool is_label(const Diagram& d, GeneratorId g) { return !g.valid() || is_below(g, d.cells.count()); }

bool labels_fit(const Diagram& d, const Mesh& mesh) {
  const auto is_known = [&](GeneratorId g) { return is_label(d, g); };
  const auto is_piece = [&](const FacePiece& p) {
    return is_below(p.face, mesh.face_count()) && is_below(p.generator, d.cells.count());
  };
  return d.vertex_label.count() == mesh.vertex_count() && d.vertex_distance.size() == d.vertex_label.size() &&
         d.face_label.count() == mesh.face_count() && std::ranges::all_of(d.vertex_label, is_known) &&
         std::ranges::all_of(d.face_label, is_known) && std::ranges::all_of(d.pieces, is_piece);
}

/// Relative tolerance of areas, which are sums of up to a million rounded terms.
constexpr double kAreaTolerance = 1e-9;

/// Change of a triangle's area by rounding of a corner's coordinates, relative to the largest coordinate times the
/// longest edge: one or two rounding steps a corner. It dominates for thin faces far from the origin.
constexpr double kCornerRounding = 1e-15;

/// The rounding error of the areas of all faces and pieces, whose corners are rounded independently.
double area_rounding(const Mesh& mesh, const Diagram& diagram) {
  double edges = 0;
  const auto longest = [&](FaceId f) { return std::ranges::max(mesh.shape(f).length); };
  for (const FaceId f : mesh.faces()) edges += longest(f);
  for (const FacePiece& piece : diagram.pieces) edges += longest(piece.face);
  return kCornerRounding * mesh.largest_coordinate() * edges;
}

/// Checks that labels and pieces cover the reached faces, and that cells have the area of their faces and pieces.
void check_areas(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations) {
  IdVector<GeneratorId, double> cell_area(diagram.cells.size(), 0.0);  // sum over its faces and pieces
  std::size_t next = 0;                                                // first piece that is not yet counted
  double total = 0;
  for (const FaceId f : mesh.faces()) {
    const GeneratorId whole = diagram.face_label[f];
    double share = whole.valid() ? 1 : 0;
    const auto has_piece = [&] { return next < diagram.pieces.size() && diagram.pieces[next].face == f; };
    if (whole.valid() && has_piece()) violations.add(2, "face", f.index(), "has a label and pieces");
    if (whole.valid()) cell_area[whole] += mesh.area(f);
    for (; has_piece(); ++next) {
      const double piece_share = area_share(diagram.pieces[next].corners);
      if (piece_share < -kAreaTolerance) violations.add(2, "piece", next, "its area is negative");
      share += piece_share;
      cell_area[diagram.pieces[next].generator] += piece_share * mesh.area(f);
    }
    const double expected = reached.contains(f) ? 1 : 0;
    if (std::abs(share - expected) > kAreaTolerance) {
      violations.add(2, "face", f.index(),
                     fmt::format("its label and pieces cover {:f} of its area instead of {}", share, int(expected)));
    }
    total += expected * mesh.area(f);
  }
  const double tolerance = kAreaTolerance * total + area_rounding(mesh, diagram);
  for (const Cell& c : diagram.cells) {
    if (std::abs(c.area - cell_area[c.generator]) <= tolerance) continue;
    violations.add(2, "cell", c.generator.index(), "its area is not that of its faces and pieces");
  }
  if (next < diagram.pieces.size()) violations.add(2, "piece", next, "pieces are not sorted by face");
}

/// The largest distance of a generator from its cell, relative to the bounding box's diagonal. It allows for rounding,
/// and is a thousand times the distance within which a generator is taken for a vertex.
constexpr double kDistanceTolerance = 1e-9;

/// Whether a piece contains a point of its face, within the tolerance.
bool contains(const Mesh& mesh, const FacePiece& piece, const SurfacePoint& p) {
  const Vec3 at = position(mesh, p);
  bool inside = false;
  for (std::size_t i = 0, n = piece.corners.size(); i < n; ++i) {
    const Bary &a = piece.corners[i], &b = piece.corners[(i + 1) % n];
    const Vec3 from = position(mesh, {piece.face, a}), along = position(mesh, {piece.face, b}) - from;
    if ((from + nearest_on_segment(from, along, at) * along - at).norm() <= kDistanceTolerance * mesh.bbox_diagonal())
      return true;
    // Count the sides that the ray from p along the second coordinate crosses.
    if ((a[2] > p.bary[2]) == (b[2] > p.bary[2])) continue;
    const double where = a[1] + (b[1] - a[1]) * (p.bary[2] - a[2]) / (b[2] - a[2]);
    if (where > p.bary[1]) inside = !inside;
  }
  return inside;
}

bool is_in_cell_within_face(const Mesh& mesh, const Diagram& diagram, const SurfacePoint& p, GeneratorId g) {
  if (diagram.face_label[p.face].valid()) return diagram.face_label[p.face] == g;
  return std::ranges::any_of(pieces_in(diagram, p.face),
                             [&](const FacePiece& piece) { return piece.generator == g && contains(mesh, piece, p); });
}

/// Whether a point lies in a cell. A point on an edge belongs to the faces on both sides: in a face without area, other
/// points have the same position, and the cell may reach the point only from the other side.
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

/// Lists for every branch point the cells whose sectors begin at the bisectors that end there.
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
    const std::int32_t twice = twice_genus(c.components, c.boundary_loops, c.euler_characteristic);
    if (twice >= 0 && twice % 2 == 0) continue;
    violations.add(6, "cell", i, "no surface has its Euler characteristic and its number of boundary loops");
  }
}

/// The surface is the disjoint union of four sets: the cells' interiors, the bisectors without their ends
/// (characteristic -1 each, 0 if closed), the branch points (+1 each) and the mesh's boundary. Along each loop of that
/// boundary, its pieces and the bisector ends on it cancel. The interior of a cell has the same characteristic as the
/// cell, because boundary loops have the characteristic 0.
void check_euler(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations) {
  std::int64_t cells = 0, open = 0;
  for (const Cell& c : diagram.cells) cells += c.euler_characteristic;
  for (const Bisector& b : diagram.bisectors) open += b.closed ? 0 : 1;
  const std::int64_t branches = diagram.branch_points.count();
  const std::int64_t whole = reached.euler_characteristic(mesh);
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

ReachedFaces::ReachedFaces(const Mesh& mesh, const std::vector<SurfacePoint>& generators)
    : component_(compute_face_components(mesh)) {
  std::int32_t count = 0;
  for (const std::int32_t c : component_) count = std::max(count, c + 1);
  has_generator_.assign(count, 0);
  for (const SurfacePoint& g : generators) has_generator_[component_[g.face]] = 1;
}

std::int64_t ReachedFaces::euler_characteristic(const Mesh& mesh) const {
  const std::vector<ComponentTopology> topologies = compute_topologies(mesh, component_);
  std::int64_t sum = 0;
  for (std::size_t c = 0; c < topologies.size(); ++c) {
    if (has_generator_[c]) sum += topologies[c].euler_characteristic;
  }
  return sum;
}

void check_ids(const Mesh& mesh, const Diagram& diagram, Violations& violations) {
  if (!cells_fit(diagram, mesh)) {
    violations.add(1, "cells are not numbered like the generators, or a generator lies in no face of the mesh");
  }
  if (!labels_fit(diagram, mesh)) {
    violations.add(2, "labels or pieces do not match the mesh in number, or name a cell or face that does not exist");
  }
  const auto is_point = [&](const SurfacePoint& p) { return is_below(p.face, mesh.face_count()); };
  const auto is_end = [&](BranchPointId e) { return !e.valid() || is_below(e, diagram.branch_points.count()); };
  for (const BisectorId id : diagram.bisectors.ids()) {
    const Bisector& b = diagram.bisectors[id];
    if (!is_label(diagram, b.left) || !is_label(diagram, b.right) || !std::ranges::all_of(b.points, is_point)) {
      violations.add(3, "bisector", id.index(), "names a cell or face that does not exist");
    }
    if (!std::ranges::all_of(b.ends, is_end)) {
      violations.add(4, "bisector", id.index(), "ends at a branch point that does not exist");
    }
  }
}

void check_partition(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations) {
  check_areas(mesh, diagram, reached, violations);
  for_each_cell_part(diagram, [&](const FacePart& part) {
    for (const Bary& corner : part.corners) {
      for (int k = 0; k < 3; ++k) {
        // This looks for the exact vertex, because a crossing may be as close to it as rounding allows.
        if (corner[(k + 1) % 3] != 0 || corner[(k + 2) % 3] != 0) continue;
        const VertexId v = mesh.vertices(part.face)[k];
        if (diagram.vertex_label[v] == part.generator) continue;
        violations.add(2, "vertex", v.index(), "its label is not that of a face or piece at it");
      }
    }
  });
}

void check_generators(const Mesh& mesh, const Diagram& diagram, Violations& violations) {
  for (const GeneratorId g : IdRange<GeneratorId>(diagram.generators.size())) {
    if (!is_in_cell(mesh, diagram, diagram.generators[g.index()], g))
      violations.add(1, "generator", g.index(), "lies outside its cell");
    // An area of 0 is valid, because the faces around the generator may have no area.
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
