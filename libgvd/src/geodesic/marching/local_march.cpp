// Distances from one point, marched as far as they are below a bound.
//
// Idea: a vertex that improves updates the two other corners of each of its faces, by the local update across the side
// between. The queue is ordered by distance; a vertex may improve again, so the order changes no result.
// Source: fast marching of Kimmel and Sethian (1998), label-correcting, with the updates of local_update.hpp.
// Invariant: within a run a vertex's distance only falls, at most 44 times. It is at least the smaller of the two
// distances that it was updated from.
#include "geodesic/marching/local_march.hpp"

#include <algorithm>
#include <cmath>

#include "geodesic/marching/local_update.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Least improvement of a distance that is propagated, relative to the distance: less is rounding. It doubles with
/// every improvement of a vertex, so that no vertex has more than 44. Without that, updates in a chain of needles lower
/// each other twice as often with each needle. A vertex of an ordinary mesh has less than ten improvements.
constexpr double kLeastGain = 1e-13;

/// Events between two calls of the watch: some milliseconds.
constexpr std::size_t kWatchStride = std::size_t{1} << 13;

}  // namespace

void LocalMarch::run(const SurfacePoint& start, double limit, const IdVector<VertexId, double>* upper) {
  ++run_;
  limit_ = limit;
  upper_ = upper;
  reached_.clear();
  heap_.clear();
  place_start(start);
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Event event = heap_.back();
    heap_.pop_back();
    if (++events_ % kWatchStride == 0 && watch_) watch_(reached_.size());
    if (event.distance == nodes_[event.vertex].distance) relax(event.vertex);  // else outdated by an improvement
  }
}

/// Gives the corners of the faces that contain the start their straight distances. A start at a vertex needs no more
/// than its own: the updates along its edges are straight.
void LocalMarch::place_start(const SurfacePoint& start) {
  start_faces_.clear();
  start_corners_.clear();
  start_position_ = position(mesh_, start);
  if (start.kind() == SurfacePoint::Kind::vertex) {
    start_corners_.push_back(vertex(mesh_, start));
    reach(start_corners_.front(), 0);
    return;
  }
  start_faces_ = faces_around(mesh_, start);
  for (const FaceId f : start_faces_) {
    for (const VertexId v : mesh_.vertices(f)) {
      start_corners_.push_back(v);
      reach(v, (mesh_.position(v) - start_position_).norm());
    }
  }
}

void LocalMarch::reach(VertexId v, double distance) {
  Node& node = nodes_[v];
  if (node.run != run_) {
    node = {distance, run_, 0};
    reached_.push_back(v);
  } else if (distance < node.distance * (1 - std::ldexp(kLeastGain, node.improvements))) {
    node.distance = distance;
    ++node.improvements;
  } else {
    return;
  }
  heap_.push_back({distance, v});
  std::push_heap(heap_.begin(), heap_.end());
}

double LocalMarch::update(HalfedgeId h) const {
  const UpdateTriangle t = make_update_triangle(mesh_.shape(Mesh::face(h)), Mesh::corner(h));
  const double distance_a = nodes_[mesh_.from(h)].distance, distance_b = nodes_[mesh_.to(h)].distance;
  // At a flat apex the update can be less than both distances. In faces without area, folded on each other, such values
  // would lower each other in turn. So the result is at least the smaller distance; not-a-number is kept.
  return std::max(update_by(front_, t, distance_a, distance_b), std::min(distance_a, distance_b));
}

/// Propagates the distance of v into its faces. A vertex that is not below its bound only updates together with a
/// neighbour that is below its own. The corners of the start's faces always propagate: the cell of a generator can
/// leave its face through the inside of an edge.
void LocalMarch::relax(VertexId v) {
  const auto is_below_bound = [this](VertexId u) {
    const double d = distance(u);
    return d < limit_ && (upper_ == nullptr || d < (*upper_)[u]);
  };
  const bool propagates =
      is_below_bound(v) || std::find(start_corners_.begin(), start_corners_.end(), v) != start_corners_.end();
  for_each_outgoing(mesh_, v, [&](HalfedgeId h) {
    const HalfedgeId before = Mesh::previous(h);  // from c to v
    const VertexId b = mesh_.to(h), c = mesh_.from(before);
    const bool has_b = nodes_[b].run == run_, has_c = nodes_[c].run == run_;
    const double d = nodes_[v].distance;
    // The edge is the first argument of std::min, so that it wins over an update that is not a number (overflow, in a
    // degenerate face).
    const double along_b = d + mesh_.length(h), along_c = d + mesh_.length(before);
    if (has_b && (propagates || is_below_bound(b))) {
      reach(c, std::min(along_c, update(h)));
    } else if (propagates) {
      reach(c, along_c);
    }
    if (has_c && (propagates || is_below_bound(c))) {
      reach(b, std::min(along_b, update(before)));
    } else if (propagates) {
      reach(b, along_b);
    }
  });
}

double LocalMarch::distance(const SurfacePoint& point) const {
  const Vec3 p = position(mesh_, point);
  if (std::find(start_faces_.begin(), start_faces_.end(), point.face) != start_faces_.end()) {
    return (p - start_position_).norm();
  }
  double best = kInfinity;
  const FaceShape& s = mesh_.shape(point.face);
  for (int i = 0; i < 3; ++i) {
    const HalfedgeId h = Mesh::halfedge(point.face, i);
    const VertexId a = mesh_.from(h), b = mesh_.to(h);
    const double to_a = (p - mesh_.position(a)).norm(), to_b = (p - mesh_.position(b)).norm();
    const double distance_a = distance(a), distance_b = distance(b);
    if (nodes_[a].run == run_ && nodes_[b].run == run_) {
      const double twice_area = s.twice_area * point.bary[(i + 2) % 3];
      best = std::min(
          best, update_by(front_, make_update_triangle(s.length[i], to_a, to_b, twice_area), distance_a, distance_b));
    } else {
      best = std::min({best, distance_a + to_a, distance_b + to_b});
    }
  }
  return best;
}

}  // namespace gvd
