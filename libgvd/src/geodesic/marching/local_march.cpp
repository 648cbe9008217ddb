// Fast marching from one point, as far as the distances are below a bound.
//
// Idea: a vertex that improves updates the two other corners of each of its faces, by the local update across the side
// between. The vertex with the least distance is next; a vertex may improve again.
// A heap of all events would be slower. Instead, a ring of buckets keeps the events that are due later, and a heap
// keeps only the events of the open buckets, which end with the ring's current bucket. The order is the same.
// Source: Kimmel and Sethian (1998), with the local update by a circle or by a planar front.
// Invariant: the distance of a vertex only falls, at most 44 times in a run. It never falls below the smaller of the
// two distances from which it was updated.
#include "geodesic/marching/local_march.hpp"

#include <algorithm>
#include <cmath>

#include "base/prefetch.hpp"
#include "geodesic/marching/local_update.hpp"

namespace gvd {
namespace {

/// Least improvement of a distance that is propagated, relative to the distance; smaller ones are rounding. It doubles
/// with every improvement of a vertex, so that no vertex improves more than 44 times. Without that, every further
/// needle in a chain of needles would double the number of improvements. A vertex of an ordinary mesh improves less
/// than ten times.
constexpr double kLeastGain = 1e-13;

/// Events between two calls of the watch: some milliseconds.
constexpr std::size_t kWatchStride = std::size_t{1} << 13;

/// Width of a bucket in mean edge lengths. The exact value hardly matters: on 1.7 million faces, a fourth and a
/// sixty-fourth take as long.
constexpr double kRingBucketWidth = 1.0 / 16;

/// Largest number of buckets. Later events wait in the last bucket, which only costs time.
constexpr double kMostRingBuckets = 1 << 12;

/// The number of buckets for the distance that one update adds, which is at most the longest edge.
std::size_t count_buckets(const Mesh& mesh, double width) {
  return static_cast<std::size_t>(std::min(kMostRingBuckets, longest_edge(mesh) / width + 2));
}

/// The distance at D across the base A B or, if that is shorter, along an edge (`along`).
///
/// At a flat apex, an update can be less than both distances. In faces without area that are folded on each other, such
/// values would lower each other in turn; therefore the update counts as at least the smaller distance. If overflow in
/// a degenerate face makes the update not a number, `along` is returned, because it is the first argument of std::min.
[[gnu::always_inline]] inline double update_within(Front front, const UpdateTriangle& t,
                                                   const std::array<double, 2>& ends, double along) {
  return std::min(along, std::max(update_by(front, t, ends[0], ends[1]), std::min(ends[0], ends[1])));
}

}  // namespace

LocalMarch::LocalMarch(const Mesh& mesh, Front front, const Progress& progress)
    : mesh_(mesh),
      fans_(mesh, progress),
      front_(front),
      nodes_(mesh.vertex_count(), Node{0, 0, 0}),
      later_(kRingBucketWidth * mesh.mean_edge_length(),
             count_buckets(mesh, kRingBucketWidth * mesh.mean_edge_length())) {}

void LocalMarch::run(const SurfacePoint& start, double limit, const IdVector<PlaceId, double>* upper) {
  ++run_;
  limit_ = limit;
  upper_ = upper;
  reached_.clear();
  later_.restart();
  place_start(start);
  while (const auto event = next_event()) {
    if (++events_ % kWatchStride == 0 && watch_) watch_(reached_.size());
    if (!is_outdated(*event)) relax(event->place);
  }
}

/// Gives the corners of the faces that contain the start their straight distances. If the start is a vertex, its own
/// distance is enough, because the updates along its edges are straight.
void LocalMarch::place_start(const SurfacePoint& start) {
  start_faces_.clear();
  start_corners_.clear();
  start_position_ = position(mesh_, start);
  if (start.kind() == SurfacePoint::Kind::vertex) return place_corner(vertex(mesh_, start), 0);
  start_faces_ = faces_around(mesh_, start);
  for (const FaceId f : start_faces_) {
    for (const VertexId v : mesh_.vertices(f)) place_corner(v, (mesh_.position(v) - start_position_).norm());
  }
}

void LocalMarch::place_corner(VertexId v, double distance) {
  start_corners_.push_back(fans_.place(v));
  reach(start_corners_.back(), distance);
}

void LocalMarch::reach(PlaceId p, double distance) {
  Node& node = nodes_[p];
  if (node.run != run_) {
    node = {distance, run_, 0};
    reached_.push_back(p);
  } else if (distance < node.distance && distance < node.distance * (1 - std::ldexp(kLeastGain, node.improvements))) {
    node.distance = distance;
    ++node.improvements;
  } else {
    return;
  }
  const Event event{distance, p, fans_.vertex(p)};
  if (!later_.is_in_front(distance)) return later_.push(distance, event);
  soon_.push_back(event);
  std::push_heap(soon_.begin(), soon_.end());
}

/// Takes the event with the least distance. All events outside the heap lie behind the current bucket.
std::optional<LocalMarch::Event> LocalMarch::next_event() {
  while (!later_.empty() && (soon_.empty() || !later_.is_in_front(soon_.front().distance))) open_bucket();
  if (soon_.empty()) return {};
  std::pop_heap(soon_.begin(), soon_.end());
  const Event event = soon_.back();
  soon_.pop_back();
  return event;
}

/// Moves the events of the next bucket to the heap, except outdated ones.
void LocalMarch::open_bucket() {
  later_.advance(later_.steps_to_next());
  while (later_.front_size() > 0) {
    const Event event = later_.pop();
    if (is_outdated(event)) continue;
    fans_.prefetch(event.place);
    if (upper_ != nullptr) prefetch(&(*upper_)[event.place]);
    soon_.push_back(event);
  }
  std::make_heap(soon_.begin(), soon_.end());
}

/// Propagates the distance of p into its faces. A vertex that is not below its bound takes part in an update only
/// together with a neighbour that is below its own bound. The corners of the start's faces always propagate, because
/// the cell of a generator can leave its face through the inside of an edge.
void LocalMarch::relax(PlaceId p) {
  const double d = nodes_[p].distance;
  const bool propagates = is_below_bound(p, d) || std::ranges::find(start_corners_, p) != start_corners_.end();
  const auto spokes = fans_.spokes(p);
  for (std::size_t i = 0; i < spokes.size() && spokes[i].has_face(); ++i) {
    const MarchFans::Spoke &b = spokes[i], &c = spokes[i + 1 < spokes.size() ? i + 1 : 0];
    // These are infinite at vertices that the run has not reached. No update is below the smaller of the two distances
    // from which it is computed.
    const double to_b = distance(b.end), to_c = distance(c.end);
    if (to_c > std::min(d, to_b) && (propagates || is_below_bound(b.end, to_b))) {
      const UpdateTriangle t = make_update_triangle(b.length, c.length, b.rim, b.twice_area);
      reach(c.end, update_within(front_, t, {d, to_b}, d + c.length));
    }
    const double to_old_c = to_c < kInfinity ? nodes_[c.end].distance : to_c;
    if (to_b > std::min(d, to_old_c) && (propagates || is_below_bound(c.end, to_old_c))) {
      const UpdateTriangle t = make_update_triangle(c.length, b.rim, b.length, b.twice_area);
      reach(b.end, update_within(front_, t, {to_old_c, d}, d + b.length));
    }
  }
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
    if (distance_a < kInfinity && distance_b < kInfinity) {
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
