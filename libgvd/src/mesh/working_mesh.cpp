// Turns generators into vertices: first the generators on edges, edge by edge, then the generators inside faces, face
// by face.
//
// A point splits the edge or the face in which it lies, and Lawson's flips (C. L. Lawson, Software for C1 surface
// interpolation, 1977) make the triangles inside a parent face Delaunay again. Each child stores the barycentric
// coordinates of its corners in its parent. Predicates use these coordinates, because needles have no area in space.
// A generator that coincides with a vertex takes this vertex. Two generators that coincide are refused with their
// numbers.
// Cost: O(n) for the copy; k generators in one face cost O(k^2) at worst, because each generator is looked up in all
// children.
// Invariant: edges of the input are split but never flipped, so the surface stays the same.
#include "mesh/working_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/mesh_editor.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// A new point splits an edge instead of the face if the lines from both ends of the edge to the point make smaller
/// angles with the edge than this, in radians. A split of the face would leave a triangle with these two angles.
constexpr double kOnEdge = 1e-9;

/// A flip must gain more than this, relative to the product of four edge lengths, so that rounding can't cause endless
/// flips. Dimensionless.
constexpr double kFlipGain = 1e-10;

/// Number of inserted generators between two reports of progress.
constexpr std::size_t kInsertionStride = 1 << 6;

/// Twice the signed area of a, b, c in the affine plane of two barycentric coordinates. The largest coordinate is left
/// out, because near a corner of the face it has lost digits that the other two still have.
double signed_area(const Bary& a, const Bary& b, const Bary& c) {
  const auto largest = std::max_element(a.begin(), a.end()) - a.begin();
  const auto i = (largest + 1) % 3, k = (largest + 2) % 3;
  return twice_signed_area({a[i], a[k]}, {b[i], b[k]}, {c[i], c[k]});
}

void check_points(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  if (points.empty()) throw Error(ErrorCode::precondition, "there is no generator; give at least one");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FaceId f = points[i].face;
    if (!std::ranges::all_of(points[i].bary, [](double b) { return std::isfinite(b); })) {
      throw Error(ErrorCode::precondition, fmt::format("generator {} has a coordinate that is no number", i), i);
    }
    if (f.valid() && f.value() < mesh.face_count()) continue;
    throw Error(ErrorCode::precondition,
                fmt::format("generator {} lies in face {}, and the mesh has {}", i, f.value(),
                            counted(mesh.face_count(), "face", "faces")),
                i);
  }
}

PointOnEdge on_first_halfedge(const Mesh& mesh, const SurfacePoint& p, PointId id) {
  const SurfacePoint point = canonical(mesh, p);
  const HalfedgeId h = halfedge(point);
  return {h, point.bary[Mesh::corner(Mesh::next(h))], id};
}

}  // namespace

SortedPoints sort_points(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  check_points(mesh, points);
  SortedPoints sorted;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointId id(i);
    switch (points[i].kind()) {
      case SurfacePoint::Kind::vertex:
        sorted.on_vertices.emplace_back(vertex(mesh, points[i]), id);
        break;
      case SurfacePoint::Kind::edge:
        sorted.on_edges.push_back(on_first_halfedge(mesh, points[i], id));
        break;
      case SurfacePoint::Kind::face:
        sorted.in_faces[points[i].face].push_back(id);
        break;
    }
  }
  std::ranges::sort(sorted.on_edges, {}, [](const PointOnEdge& p) { return std::tuple(p.halfedge, p.t, p.point); });
  return sorted;
}

WorkingMesh::WorkingMesh(const Mesh& input, std::size_t generators)
    : input_(&input),
      generator_vertex_(generators),
      vertex_generator_(input.vertex_count()),
      coincidence_(coincidence(input)) {}

WorkingMesh::WorkingMesh(const Mesh& input, const std::vector<SurfacePoint>& generators, const Progress& progress)
    : WorkingMesh(input, generators.size()) {
  insert(generators, progress);
  if (coincident_) throw *coincident_;
}

OrError<WorkingMesh> WorkingMesh::try_to_build(const Mesh& input, const std::vector<SurfacePoint>& generators,
                                               const Progress& progress) {
  WorkingMesh working(input, generators.size());
  working.insert(generators, progress);
  if (working.coincident_) return *std::move(working.coincident_);
  return working;
}

/// Turns all points into vertices, as far as no two coincide.
void WorkingMesh::insert(const std::vector<SurfacePoint>& points, const Progress& progress) {
  const SortedPoints sorted = sort_points(*input_, points);
  for (const auto& [v, point] : sorted.on_vertices) claim(v, point);
  if (coincident_ || (sorted.on_edges.empty() && sorted.in_faces.empty())) return;
  report_progress(progress, steps::kWorkingMesh, 0);
  copy_input();
  insert_on_edges(sorted.on_edges, progress);
  for (const auto& [face, ids] : sorted.in_faces) {
    if (coincident_) return;
    insert_in_face(face, ids, points, progress);
  }
  check_inserted();
  vertex_generator_.resize(mesh().vertex_count());
}

void WorkingMesh::report_inserted(const Progress& progress) {
  if (++inserted_ % kInsertionStride != 0) return;
  report_progress(progress, steps::kWorkingMesh,
                  double(inserted_) / double(std::max(generator_vertex_.size(), owner_.size())));
}

void WorkingMesh::copy_input() {
  split_ = true;
  const std::size_t points = std::max(generator_vertex_.size(), owner_.size());
  MeshEditor(copy_).copy(*input_, points);
  parent_.reserve(input_->face_count() + 2 * points);
  for (const FaceId f : input_->faces()) parent_.push_back(f);
  child_slot_.reserve(parent_.size() + 2 * points);
  child_slot_.assign(parent_.size(), -1);
}

void WorkingMesh::claim(VertexId v, PointId point) {
  if (!point_vertex_.empty()) point_vertex_[point] = v;
  claim_for(v, owner_.empty() ? GeneratorId(point.value()) : owner_[point]);
}

/// Gives vertex v to generator g. A vertex that belongs to another generator stays with that one, and the two are noted
/// as coincident; points of one curve may coincide.
void WorkingMesh::claim_for(VertexId v, GeneratorId g) {
  if (v.index() >= vertex_generator_.size()) vertex_generator_.resize(v.index() + 1);
  GeneratorId& known = vertex_generator_[v];
  if (known.valid() && (owner_.empty() || known != g)) {
    const auto [first, second] = std::minmax({known.value(), g.value()});
    const Vec3& at = (split_ ? copy_ : *input_).position(v);
    if (coincident_) return;
    coincident_.emplace(
        ErrorCode::precondition,
        owner_.empty()
            ? fmt::format("generators {} and {} coincide; remove one\1+, or add |merge_coincident\2", first, second)
            : fmt::format("curves {} and {} meet at ({:.6g}, {:.6g}, {:.6g}); give both a point there, which "
                          "makes them one curve, or move one away",
                          first, second, at.x(), at.y(), at.z()),
        second);
    return;
  }
  known = g;
  if (!generator_vertex_[g].valid()) generator_vertex_[g] = v;
}

/// Finds inserted generators that coincide with a neighbour. On insertion a generator was compared only with the
/// corners of its face, but two generators on different edges near a common vertex can be nearer to each other than to
/// the vertex.
void WorkingMesh::check_inserted() {
  for (std::int32_t i = input_->vertex_count(); i < copy_.vertex_count(); ++i) {
    const VertexId v(i);
    for_each_neighbour(copy_, v, [&](VertexId u, HalfedgeId h) {
      if (generator(u).valid() && copy_.length(h) <= coincidence_) claim_for(u, generator(v));
    });
  }
}

void WorkingMesh::set_corners(FaceId f, FaceId parent, const Corners& corners) {
  if (f.index() >= parent_.size()) {
    parent_.resize(f.index() + 1);
    child_slot_.resize(f.index() + 1, -1);
  }
  parent_[f] = parent;
  if (child_slot_[f] < 0) {
    child_slot_[f] = std::int32_t(child_corners_.size());
    child_corners_.push_back(corners);
  } else {
    child_corners_[child_slot_[f]] = corners;
  }
}

void WorkingMesh::insert_on_edges(const std::vector<PointOnEdge>& points, const Progress& progress) {
  HalfedgeId current, rest;  // the input's halfedge, and the copy's halfedge for the rest that is not split yet
  double done = 0;           // the parameter at which `rest` begins
  std::vector<FaceId> touched;
  for (const auto& [h, t, id] : points) {
    report_inserted(progress);
    if (h != current) {
      current = h;
      rest = find_copied(h);
      done = 0;
    }
    const Vec3 p = position(*input_, edge_point(h, t));
    // The input's corners are tested, too, because after splits of other edges they need not be opposite `rest` any
    // more.
    const VertexId corner = vertex_at(copy_, p, rest), v = corner.valid() ? corner : vertex_at(*input_, p, h);
    if (v.valid()) {
      claim(v, id);
      continue;
    }
    const auto parent_bary_at = [&](HalfedgeId side, double at) {
      return parent_bary(Mesh::face(side), edge_point(side, at).bary);
    };
    const double local = (t - done) / (1 - done);
    const HalfedgeId twin = copy_.twin(rest);
    const auto changed =
        split_edge(rest, id, p, parent_bary_at(rest, local), twin.valid() ? parent_bary_at(twin, 1 - local) : Bary{});
    touched.insert(touched.end(), changed.begin(), changed.end());
    rest = Mesh::halfedge(changed[1], 0);
    done = t;
  }
  make_delaunay(touched);
}

/// The corner of the two faces at h that coincides with the point p on h's edge; invalid if none does. In a face
/// without area the corner opposite an edge can lie on the edge, and a split there would leave an edge of length 0.
VertexId WorkingMesh::vertex_at(const Mesh& mesh, const Vec3& p, HalfedgeId h) const {
  const HalfedgeId twin = mesh.twin(h);
  const VertexId beyond = twin.valid() ? mesh.opposite(twin) : mesh.from(h);
  for (const VertexId v : {mesh.from(h), mesh.to(h), mesh.opposite(h), beyond}) {
    if ((mesh.position(v) - p).norm() <= coincidence_) return v;
  }
  return VertexId();
}

/// The copy's halfedge for the input's halfedge h, whose edge is not split yet. Splits of other edges may have moved it
/// to another child of its face.
HalfedgeId WorkingMesh::find_copied(HalfedgeId h) const {
  const VertexId from = input_->from(h), to = input_->to(h);
  HalfedgeId found = h;
  for_each_outgoing(copy_, from, [&](HalfedgeId x) {
    if (copy_.to(x) == to && parent(Mesh::face(x)) == Mesh::face(h)) found = x;
  });
  return found;
}

/// Splits the edge of h for a point at p. Its coordinates are `here` in the parent of h's face and `there` in that
/// of its twin's. Returns h's face and the face appended beside it, and the same two faces on the side of the twin if h
/// has one.
std::vector<FaceId> WorkingMesh::split_edge(HalfedgeId h, PointId id, const Vec3& p, const Bary& here,
                                            const Bary& there) {
  std::vector<FaceId> changed;
  FaceId appended(copy_.face_count());
  const HalfedgeId twin = copy_.twin(h);
  claim(MeshEditor(copy_).split_edge(h, p), id);
  for (const auto& [side, middle] : {std::pair(h, here), std::pair(twin, there)}) {
    if (!side.valid()) continue;
    const FaceId f = Mesh::face(side);
    const Corners c = corners(f);  // before the split
    const int i = Mesh::corner(side);
    set_corners(f, parent(f), {c[i], middle, c[(i + 2) % 3]});
    set_corners(appended, parent(f), {middle, c[(i + 1) % 3], c[(i + 2) % 3]});
    changed.insert(changed.end(), {f, appended});
    appended = FaceId(appended.value() + 1);
  }
  return changed;
}

void WorkingMesh::insert_in_face(FaceId parent_face, const std::vector<PointId>& ids,
                                 const std::vector<SurfacePoint>& points, const Progress& progress) {
  std::vector<FaceId> children{parent_face};
  // Earlier splits of edges may have appended children, which are found across the edges inside the parent.
  for (std::size_t i = 0; i < children.size(); ++i) {
    for (const HalfedgeId h : Mesh::halfedges(children[i])) {
      const HalfedgeId twin = copy_.twin(h);
      if (!twin.valid() || parent(Mesh::face(twin)) != parent_face) continue;
      if (std::find(children.begin(), children.end(), Mesh::face(twin)) == children.end()) {
        children.push_back(Mesh::face(twin));
      }
    }
  }
  for (const PointId id : ids) {
    report_inserted(progress);
    insert_point(children, id, points[id.index()]);
  }
  make_delaunay(children);
}

WorkingMesh::Location WorkingMesh::locate(const std::vector<FaceId>& children, const Bary& bary) const {
  Location best;
  for (const FaceId f : children) {
    const Bary local = bary_by_areas(corners(f), bary, signed_area);
    const double smallest = *std::min_element(local.begin(), local.end());
    if (smallest > best.smallest) best = {f, local, smallest};
  }
  return best;
}

/// Whether a point in the face of `side` should split this edge, which must lie inside a parent: whether the point lies
/// on the edge up to kOnEdge or to rounding. The distance from the edge is not enough to decide, because near an end of
/// the edge it is small in all directions. The split must leave four triangles that do not overlap.
bool WorkingMesh::splits_edge(HalfedgeId side, const Vec3& p, const Bary& bary) const {
  const HalfedgeId twin = copy_.twin(side);
  if (!twin.valid() || parent(Mesh::face(twin)) != parent(Mesh::face(side))) return false;
  const Vec3 a = copy_.position(copy_.from(side)) - p, b = copy_.position(copy_.to(side)) - p;
  const double nearer = std::min(a.stableNorm(), b.stableNorm());
  const double height = a.cross(b).stableNorm() / (b - a).stableNorm();
  if (!(height <= std::max(kOnEdge * nearer, kCoordinateRounding * input_->largest_coordinate()))) return false;
  const Corners here = corners(Mesh::face(side)), there = corners(Mesh::face(twin));
  const int i = Mesh::corner(side), k = Mesh::corner(twin);
  const Bary &from = here[i], &to = here[(i + 1) % 3], &beyond = there[(k + 2) % 3];
  return signed_area(bary, beyond, to) > 0 && signed_area(bary, from, beyond) > 0;
}

void WorkingMesh::insert_point(std::vector<FaceId>& children, PointId id, const SurfacePoint& point) {
  const auto [child, local, smallest] = locate(children, point.bary);
  const Vec3 p = position(*input_, point);
  for (const VertexId v : copy_.vertices(child)) {
    if ((copy_.position(v) - p).norm() <= coincidence_) return claim(v, id);
  }
  const auto thin = std::min_element(local.begin(), local.end()) - local.begin();
  const HalfedgeId side = Mesh::next(HalfedgeId(3 * child.value() + thin));
  // In space, all points of a face without area lie on its sides, but not in its own coordinates.
  if (smallest < kOnEdge && splits_edge(side, p, point.bary)) {
    if (const VertexId v = vertex_at(copy_, p, side); v.valid()) return claim(v, id);
    const auto changed = split_edge(side, id, p, point.bary, point.bary);
    children.insert(children.end(), {changed[1], changed[3]});
  } else {
    const auto [second, third] = split_face(child, id, p, point.bary);
    children.insert(children.end(), {second, third});
  }
}

/// Splits face f for a point at p, which has the coordinates `bary` in its parent. Returns the two appended faces.
std::pair<FaceId, FaceId> WorkingMesh::split_face(FaceId f, PointId id, const Vec3& p, const Bary& bary) {
  const FaceId parent_face = parent(f);
  const Corners c = corners(f);
  const FaceId second(copy_.face_count()), third(second.value() + 1);
  claim(MeshEditor(copy_).split_face(f, p), id);
  set_corners(f, parent_face, {c[0], c[1], bary});
  set_corners(second, parent_face, {c[1], c[2], bary});
  set_corners(third, parent_face, {c[2], c[0], bary});
  return {second, third};
}

void WorkingMesh::make_delaunay(const std::vector<FaceId>& children) {
  std::vector<HalfedgeId> stack;
  for (const FaceId f : children) {
    for (const HalfedgeId h : Mesh::halfedges(f)) stack.push_back(h);
  }
  while (!stack.empty()) {
    const HalfedgeId h = stack.back();
    stack.pop_back();
    if (!flip_if_not_delaunay(h)) continue;
    const FaceId f = Mesh::face(h), g = Mesh::face(copy_.twin(Mesh::halfedge(f, 2)));
    for (int corner = 0; corner < 2; ++corner) {
      stack.push_back(Mesh::halfedge(f, corner));
      stack.push_back(Mesh::halfedge(g, corner));
    }
  }
}

/// The two faces at an edge, and the corners of the quadrilateral that they form. The edge runs from a to b; c is
/// opposite the edge in `face`, and d is opposite it in `other`.
struct WorkingMesh::Quadrilateral {
  FaceId face, other, parent;
  Bary a{}, b{}, c{}, d{};
  /// Whether the edge can be flipped to the diagonal from d to c.
  bool is_convex() const { return signed_area(d, b, c) > 0 && signed_area(c, a, d) > 0; }
};

/// The quadrilateral at h; nothing if the edge does not lie inside a face of the input.
std::optional<WorkingMesh::Quadrilateral> WorkingMesh::quadrilateral(HalfedgeId h) const {
  const HalfedgeId t = copy_.twin(h);
  const FaceId f = Mesh::face(h);
  if (!t.valid() || parent(f) != parent(Mesh::face(t))) return std::nullopt;
  const int i = Mesh::corner(h), j = Mesh::corner(t);
  const Corners &cf = corners(f), &cg = corners(Mesh::face(t));
  return Quadrilateral{f, Mesh::face(t), parent(f), cf[i], cf[(i + 1) % 3], cf[(i + 2) % 3], cg[(j + 2) % 3]};
}

void WorkingMesh::flip(HalfedgeId h, const Quadrilateral& quad) {
  MeshEditor(copy_).flip_edge(h);
  set_corners(quad.face, quad.parent, {quad.d, quad.b, quad.c});
  set_corners(quad.other, quad.parent, {quad.c, quad.a, quad.d});
}

bool WorkingMesh::flip_if_convex(HalfedgeId h) {
  const auto quad = quadrilateral(h);
  if (!quad || !quad->is_convex()) return false;
  flip(h, *quad);
  return true;
}

bool WorkingMesh::flip_if_not_delaunay(HalfedgeId h) {
  const auto quad = quadrilateral(h);
  if (!quad || !quad->is_convex()) return false;
  const auto& [face, other, parent_face, a, b, c, d] = *quad;
  const auto at = [&, f = parent_face](const Bary& bary) { return position(*input_, {f, bary}); };
  const Vec3 ca = at(a) - at(c), cb = at(b) - at(c), da = at(a) - at(d), db = at(b) - at(d);
  // The edge is not Delaunay if the two opposite angles sum to more than pi, that is, if sin(c + d) < 0. `gain` is
  // -sin(c + d) times four lengths.
  const double gain = -(ca.cross(cb).norm() * da.dot(db) + da.cross(db).norm() * ca.dot(cb));
  if (gain <= kFlipGain * ca.norm() * cb.norm() * da.norm() * db.norm()) return false;
  flip(h, *quad);
  return true;
}

}  // namespace gvd
