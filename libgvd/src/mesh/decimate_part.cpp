// Halfedge collapses in a part of a mesh, the cheapest first.
//
// A collapse moves all faces of a vertex to one of its neighbours, and removes those between the two. Its cost is the
// error quadric of the vertex at the neighbour (M. Garland and P. Heckbert, Surface simplification using quadric error
// metrics, 1997), and a little for the way: in flat parts, where planes cost nothing, this keeps edges about as long as
// each other. A heap holds the vertices; costs rise as vertices gather quadrics, and are looked up again at the top.
// Invariant: the topology stays, by the link condition (T. Dey et al., Topology preserving edge contraction, 1999):
// the neighbours of both vertices are those across from the edge. On the boundary, vertices collapse along it only.
#include "mesh/decimate_part.hpp"

#include <algorithm>
#include <cmath>

#include "base/lazy_max_heap.hpp"

namespace gvd {
namespace {

/// Cost of the way of a collapse, in squared lengths times the area that moves. Edges that turn by a radian cost .25.
constexpr double kWayCost = 1e-2;

/// Weight of the planes through boundary edges, which stand upright on their faces, beside a square on the edge.
constexpr double kBoundaryWeight = 1;

/// Least cosine of the angle by which a collapse may turn a face.
constexpr double kLeastCosine = 0.2;

/// Least `shape` of a face after a collapse; or a quarter of what it was before.
constexpr double kLeastShape = 0.05;

/// Where edges are limited, a collapse may make longer ones if the planes that it leaves are, in the mean of squares,
/// not farther than this fraction of the limit: flat parts and thin tubes need no short edges.
constexpr double kFlatShare = 0.025;

/// Neighbours that a vertex tries at most, from the cheapest. Each costs a look at all of its faces; a vertex that all
/// faces of a part share would take the square of their number. On ordinary meshes hardly a vertex has more neighbours.
constexpr std::size_t kMostChoices = 32;

constexpr double kNever = -kInfinity;

/// Collapses between two reports: they take a few milliseconds.
constexpr std::int64_t kCollapsesPerReport = 1024;

/// Twice the area, in squares of the longest side.
double shape(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

}  // namespace

PartDecimator::PartDecimator(const Mesh& mesh, std::span<const FaceId> faces, const IdVector<FaceId, PartPlace>& places)
    : left_(std::ssize(faces)) {
  IdVector<VertexId, std::int32_t> local(mesh.vertex_count(), -1);
  corner_.reserve(3 * faces.size());
  for (const FaceId f : faces) {
    for (const VertexId v : mesh.vertices(f)) {
      if (local[v] < 0) {
        local[v] = static_cast<std::int32_t>(vertex_.size());
        vertex_.push_back(v);
      }
      corner_.push_back(local[v]);
    }
  }
  vertices_left_ = std::ssize(vertex_);
  for (const VertexId v : vertex_) position_.push_back(mesh.position(v) - mesh.position(vertex_[0]));
  link(mesh, faces, places);
  add_quadrics();
  target_.assign(vertex_.size(), -1);
  best_.assign(vertex_.size(), -1);
  is_kept_.assign(vertex_.size(), 0);
  mark_.assign(vertex_.size(), 0);
}

void PartDecimator::link(const Mesh& mesh, std::span<const FaceId> faces, const IdVector<FaceId, PartPlace>& places) {
  is_locked_.assign(vertex_.size(), 0);
  leaving_.assign(vertex_.size(), -1);
  twin_.reserve(corner_.size());
  for (const FaceId f : faces) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      const auto here = static_cast<std::int32_t>(twin_.size());
      const HalfedgeId twin = mesh.twin(h);
      const PartPlace place = twin.valid() ? places[Mesh::face(twin)] : PartPlace{-1, -1};
      const bool is_inner = twin.valid() && place.part == places[f].part;
      twin_.push_back(is_inner ? 3 * place.place + Mesh::corner(twin) : -1);
      if (twin.valid() && !is_inner) is_locked_[from(here)] = is_locked_[to(here)] = 1;
      if (mesh.halfedge(mesh.from(h)) == h) leaving_[from(here)] = here;
    }
  }
}

void PartDecimator::add_quadrics() {
  quadric_.resize(vertex_.size());
  for (std::int32_t h = 0; h < std::ssize(corner_); ++h) {
    const Vec3 &p = position_[from(h)], &q = position_[to(h)], &r = position_[from(previous(h))];
    const Vec3 product = (q - p).cross(r - p);
    const double twice_area = product.norm();
    if (!(twice_area > 0)) continue;
    const Vec3 normal = product / twice_area;
    quadric_[from(h)].add_plane(normal, p, twice_area / 6);
    quadric_[from(h)].area += twice_area / 6;
    if (twin_[h] >= 0) continue;
    const Vec3 upright = (q - p).cross(normal);
    const double weight = kBoundaryWeight * upright.norm();
    for (const std::int32_t v : {from(h), to(h)}) quadric_[v].add_plane(upright.normalized(), p, weight * weight);
  }
}

template <class Visit>
void PartDecimator::for_each_edge(std::int32_t v, Visit visit) const {
  std::int32_t h = leaving_[v];
  do {
    visit(h);
    const std::int32_t last = previous(h);
    h = twin_[last];
    if (h < 0) visit(last);
  } while (h >= 0 && h != leaving_[v]);
}

double PartDecimator::find_best(std::int32_t v) {
  if (is_locked_[v] || is_kept_[v] || target_[v] >= 0) return kNever;
  choices_.clear();
  const bool on_boundary = is_boundary(v);
  for_each_edge(v, [&](std::int32_t h) {
    const std::int32_t w = other_end(v, h);
    if (is_locked_[w] || (on_boundary && twin_[h] >= 0)) return;
    if (!refused_.empty() && refused_.contains({v, w})) return;
    const double way = (position_[w] - position_[v]).squaredNorm();
    const double cost = std::max(0.0, quadric_[v].at(position_[w])) + kWayCost * quadric_[v].area * way;
    choices_.emplace_back(cost, h);
  });
  const auto tried = choices_.begin() + static_cast<std::ptrdiff_t>(std::min(kMostChoices, choices_.size()));
  std::partial_sort(choices_.begin(), tried, choices_.end());
  for (auto it = choices_.begin(); it != tried; ++it) {
    if (!is_legal(v, it->second)) continue;
    best_[v] = it->second;
    return -it->first;
  }
  return kNever;
}

bool PartDecimator::is_legal(std::int32_t v, std::int32_t halfedge) {
  const std::int32_t w = other_end(v, halfedge);
  return keeps_topology(v, w, halfedge) && keeps_shapes(v, w);
}

bool PartDecimator::is_refused_by_guard(std::int32_t v, std::int32_t halfedge) {
  const std::int32_t w = other_end(v, halfedge);
  moved_.clear();
  removed_.clear();
  for_each_edge(v, [&](std::int32_t h) {
    if (from(h) != v) return;
    const std::int32_t face = h / 3;
    std::array<VertexId, 3> corners;
    bool has_w = false;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t x = corner_[3 * face + i];
      has_w = has_w || x == w;
      corners[i] = vertex_[x == v ? w : x];
    }
    if (has_w) {
      removed_.push_back(face);
    } else {
      moved_.push_back({face, corners});
    }
  });
  if (guard_->allows(moved_, removed_)) return false;
  refused_.insert({v, w});
  return true;
}

bool PartDecimator::keeps_topology(std::int32_t v, std::int32_t w, std::int32_t halfedge) {
  const bool is_single = twin_[halfedge] < 0;
  if (is_single && twin_[next(halfedge)] < 0 && twin_[previous(halfedge)] < 0) return false;
  ++question_;
  int of_v = 0, of_w = 0, common = 0;
  for_each_edge(w, [&](std::int32_t h) {
    ++of_w;
    mark_[other_end(w, h)] = question_;
  });
  for_each_edge(v, [&](std::int32_t h) {
    ++of_v;
    common += mark_[other_end(v, h)] == question_;
  });
  const bool is_tetrahedron = of_v == 3 && of_w == 3 && !is_single;
  return common == (is_single ? 1 : 2) && !is_tetrahedron;
}

bool PartDecimator::lengthens(const Vec3& before, const Vec3& after, const Vec3& across) const {
  const double length = (across - after).norm();
  return length > longest_ && length > (across - before).norm();
}

bool PartDecimator::keeps_shapes(std::int32_t v, std::int32_t w) const {
  bool keeps = true;
  const Vec3 &before = position_[v], &after = position_[w];
  const double flat = kFlatShare * longest_;
  const bool is_limited = longest_ < kInfinity && quadric_[v].at(after) > flat * flat * quadric_[v].area;
  for_each_edge(v, [&](std::int32_t h) {
    if (!keeps || from(h) != v) return;
    const std::int32_t a = to(h), b = from(previous(h));
    if (a == w || b == w) return;
    const Vec3 &p = position_[a], &q = position_[b];
    const Vec3 old_normal = (p - before).cross(q - before), new_normal = (p - after).cross(q - after);
    const double old_norm = old_normal.norm(), new_norm = new_normal.norm();
    if (p == after || q == after) keeps = false;
    if (keeps && is_limited && lengthens(before, after, p)) keeps = false;
    if (old_norm > 0 && !(old_normal.dot(new_normal) > kLeastCosine * old_norm * new_norm)) keeps = false;
    if (keeps && is_strict_) keeps = shape(after, p, q) >= std::min(kLeastShape, 0.25 * shape(before, p, q));
  });
  return keeps;
}

void PartDecimator::collapse(std::int32_t v, std::int32_t halfedge) {
  const std::int32_t w = other_end(v, halfedge), twin = twin_[halfedge];
  const bool stays_inner = is_inner(w);
  // Counter-clockwise round w, the faces of v come after its own, or before them where the boundary runs from w to v.
  const std::int32_t first = leaving_[twin < 0 && from(halfedge) == w ? v : w];
  std::int32_t h = leaving_[v];
  do {
    corner_[h] = w;
    h = twin_[previous(h)];
  } while (h >= 0 && h != leaving_[v]);
  remove_face(halfedge, w);
  if (twin >= 0) remove_face(twin, w);
  if (corner_[first] >= 0) {
    leaving_[w] = first;
  } else if (!stays_inner) {
    leaving_[w] = first_of_fan(leaving_[w]);
  }
  target_[v] = w;
  --vertices_left_;
  quadric_[w].add(quadric_[v]);
}

void PartDecimator::remove_face(std::int32_t halfedge, std::int32_t kept) {
  const std::int32_t n = next(halfedge), p = previous(halfedge), across = from(p), tn = twin_[n], tp = twin_[p];
  if (tn >= 0) twin_[tn] = tp;
  if (tp >= 0) twin_[tp] = tn;
  for (const std::int32_t h : {halfedge, n, p}) corner_[h] = -1;
  --left_;
  // At the boundary, p had no twin then, and its first face begins with the halfedge that lost its own.
  if (leaving_[across] == p) leaving_[across] = tn >= 0 ? tn : next(tp);
  leaving_[kept] = tp >= 0 ? tp : next(tn);
}

std::int32_t PartDecimator::first_of_fan(std::int32_t halfedge) const {
  std::int32_t h = halfedge;
  while (twin_[h] >= 0) {
    h = next(twin_[h]);
    if (h == halfedge) break;
  }
  return h;
}

void PartDecimator::decimate(double share, const std::function<void(double)>& report) {
  std::int64_t held = 0;
  for (std::size_t h = 0; h < corner_.size(); h += 3) {
    held += is_locked_[corner_[h]] || is_locked_[corner_[h + 1]] || is_locked_[corner_[h + 2]];
  }
  const std::int64_t faces = held + static_cast<std::int64_t>(share * static_cast<double>(left_ - held));
  decimate_while([&] { return left_ - faces; }, report);
}

void PartDecimator::decimate_to(std::int64_t vertices, const std::function<void(double)>& report) {
  decimate_while([&] { return vertices_left_ - vertices; }, report);
}

void PartDecimator::decimate_while(const Excess& excess, const std::function<void(double)>& report) {
  collapse_while(excess, report);
  if (!guard_ || excess() <= 0) return;
  is_strict_ = false;
  collapse_while(excess, [&](double) {
    if (report) report(1);
  });
}

void PartDecimator::collapse_while(const Excess& excess, const std::function<void(double)>& report) {
  const double all = static_cast<double>(std::max<std::int64_t>(1, excess()));
  const auto key = [&](std::int32_t v) { return find_best(v); };
  LazyMaxHeap heap(static_cast<std::int32_t>(vertex_.size()), key);
  for (std::int64_t done = 0; excess() > 0 && !heap.empty(); ++done) {
    if (report && done % kCollapsesPerReport == 0) report(1 - static_cast<double>(excess()) / all);
    const auto& top = heap.top(key);
    if (!(top.key > kNever)) break;
    const std::int32_t v = top.id, halfedge = best_[v];
    // The next best one of the vertex then costs more: its key is looked up again.
    if (guard_ && is_refused_by_guard(v, halfedge)) continue;
    heap.pop();
    collapse(v, halfedge);
    if (guard_) guard_->collapsed();
  }
}

std::vector<std::array<VertexId, 3>> PartDecimator::faces() const {
  std::vector<std::array<VertexId, 3>> faces;
  for (std::size_t h = 0; h < corner_.size(); h += 3) {
    if (corner_[h] >= 0) faces.push_back({vertex_[corner_[h]], vertex_[corner_[h + 1]], vertex_[corner_[h + 2]]});
  }
  return faces;
}

std::vector<std::int32_t> PartDecimator::face_places() const {
  std::vector<std::int32_t> places;
  for (std::size_t h = 0; h < corner_.size(); h += 3) {
    if (corner_[h] >= 0) places.push_back(static_cast<std::int32_t>(h / 3));
  }
  return places;
}

void PartDecimator::keep(const std::function<bool(VertexId)>& is_kept) {
  for (std::size_t v = 0; v < vertex_.size(); ++v) is_kept_[v] = is_kept(vertex_[v]) ? 1 : 0;
}

void PartDecimator::enter_targets(IdVector<VertexId, VertexId>& target) const {
  for (std::size_t v = 0; v < target_.size(); ++v) {
    if (target_[v] >= 0) target[vertex_[v]] = vertex_[target_[v]];
  }
}

}  // namespace gvd
