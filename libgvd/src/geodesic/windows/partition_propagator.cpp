#include "geodesic/windows/partition_propagator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/bucket_queue.hpp"
#include "base/prefetch.hpp"
#include "geodesic/windows/mesh_partitions.hpp"
#include "geodesic/windows/partition_messages.hpp"
#include "geodesic/windows/vertex_fan.hpp"
#include "geodesic/windows/waiting_windows.hpp"
#include "geodesic/windows/window_filters.hpp"
#include "geodesic/windows/window_pruning.hpp"

namespace gvd {
namespace {

/// Carries windows across faces, splits them at corners, and lets vertices send windows; see window_propagation.hpp.
class PartitionPropagator final : public PartitionPropagation {
 public:
  PartitionPropagator(PropagationState& state, std::int32_t part)
      : mesh_(state.mesh),
        frames_(state.frames),
        field_(state.field),
        partitions_(state.parts),
        partition_(part),
        mail_(state.mail),
        sent_(state.sent),
        fan_(frames_),
        has_needles_(frames_.has_needles),
        has_thin_faces_(frames_.has_thin_faces),
        drift_(kRounding / frames_.least_sine),
        queue_(state.bucket_width, state.bucket_count),
        waiting_(state.first_waiting, state.bucket_width),
        apex_path_(state.apex_path),
        pruning_(state, part) {}

  void start_vertex(std::int32_t place, GeneratorId g, double d) override {
    if (!(d < distance(place))) return;
    distance(place) = d;
    field_.label[VertexId(place)] = g;
    push_event({place, g.value(), true, d, {}});
  }

  void run_round(double settled) override {
    settled_ = settled;
    mail_.for_each_received(partition_, [&](PartitionMessages& mail) {
      for (const std::int32_t face : mail.multi_label_faces) pruning_.mark_own_face(face);
      for (const PartitionMessages::Path& path : mail.paths) receive_path(path);
    });
    mail_.for_each_received(partition_, [&](PartitionMessages& mail) {
      for (const PartitionMessages::SentWindow& window : mail.windows) receive_window(window);
      mail.clear();
    });
    while (queue_.front_size() > 0) {
      const std::int32_t item = queue_.pop();
      look_ahead();
      if (item >= 0) {
        cross_halfedge(item);
      } else {
        send_from_vertex(~item);
      }
    }
  }

  void end_bucket(double settled, std::size_t steps) override {
    pruning_.review_border(settled);
    // The front has passed, and other parts can use the memory. What waits is queued, so nothing does. Only after much
    // work, beside which looking at all buckets counts for nothing.
    if (queue_.empty() && carried_ - carried_before_ > static_cast<std::int64_t>(queue_.bucket_count())) release();
    queue_.advance(steps);
  }
  std::size_t waits_now() const override { return queue_.front_size(); }
  bool waits() const override { return !queue_.empty(); }
  std::size_t steps_to_next() const override { return queue_.steps_to_next(); }
  double front() const override { return queue_.front(); }
  BlockList<KeptWindow> finish() override { return pruning_.finish(); }
  std::int64_t carried() const override { return carried_; }
  std::int64_t events() const override { return events_sent_; }

 private:
  /// Half of the time would go by waiting for memory: gets what the next items in the queue will need into the cache,
  /// first where it lies and then what lies there.
  void look_ahead() const {
    constexpr std::size_t kFar = 6, kNear = 3;
    if (const std::int32_t* far = queue_.ahead(kFar); far != nullptr && *far >= 0) {
      waiting_.prefetch_list(*far);
      prefetch(fan_.face(*far).length.data());
      prefetch(fan_.face(*far).vertex.data());
    }
    if (const std::int32_t* near = queue_.ahead(kNear); near != nullptr && *near >= 0) {
      waiting_.prefetch_windows(*near);
      const FaceFrame& f = fan_.face(*near);
      for (std::size_t i = 0; i < 3; ++i) {
        prefetch(&field_.distance[VertexId(f.vertex[i])]);
        if (f.twin[i] >= 0) waiting_.prefetch_list(f.twin[i]);
      }
    }
  }

  /// A pseudo-source that was reached, or a generator: it will send windows.
  struct VertexEvent {
    std::int32_t vertex;
    std::int32_t generator;
    bool all_round;  // a generator, or a ambiguous vertex
    double distance;
    FanRay back;  // towards where the path came from
  };

  /// Side `end` of a face: from corner `end` to corner `start` of a window that leaves by it.
  struct Side {
    std::int32_t base;  // the face's first halfedge
    const FaceFrame* face;
    std::size_t end, start;
  };

  /// An edge that a window stands on, in the window's frame.
  struct Edge {
    double length;
    std::int32_t start, end;  // places of vertices
    std::int32_t into, from;  // halfedges: that it crosses next, or -1; of the face that it leaves
  };

  void release() {
    waiting_.release();
    queue_.release();
    events_ = std::vector<VertexEvent>();
    free_events_ = std::vector<std::int32_t>();
    carried_before_ = carried_;
  }

  double& distance(std::int32_t v) { return field_.distance[VertexId(v)]; }
  std::int32_t label(std::int32_t v) const { return field_.label[VertexId(v)].value(); }
  VertexKind kind(std::int32_t v) const { return frames_.kind[VertexId(v)]; }
  bool is_flat(std::int32_t v) const { return kind(v) == VertexKind::flat; }

  void push_event(const VertexEvent& event) {
    if (free_events_.empty()) {
      free_events_.push_back(static_cast<std::int32_t>(events_.size()));
      events_.emplace_back();
    }
    const std::int32_t place = free_events_.back();
    free_events_.pop_back();
    events_[static_cast<std::size_t>(place)] = event;
    queue_.push(event.distance, ~place);
  }

  /// A path to vertex v. Where it is news and paths can bend at v, v will send windows.
  void reach_vertex(std::int32_t v, double d, std::int32_t generator, const FanRay& back) {
    if (!is_before(d, generator, distance(v), label(v))) return;
    take_path(v, d, generator, back);
    const std::int32_t shared = partitions_.shared(v);
    if (shared >= 0) [[unlikely]]
      send_path(shared, d, generator, back);
  }

  void send_path(std::int32_t shared, double d, std::int32_t generator, const FanRay& back) {
    for (const MeshPartitions::Place& place : partitions_.places(shared)) {
      if (place.part == partition_) continue;
      PartitionMessages& mail = mail_.to_send(partition_, place.part);
      mail.paths.push_back({place.vertex, generator, d, back});
      mail.least_key = std::min(mail.least_key, d);
    }
  }

  /// A path to vertex v that another part found. All places of a vertex take the first one, in that order, of all paths
  /// that ever came first in one of them, and of one generator's the shortest: in the end they agree to the last bit.
  void receive_path(const PartitionMessages::Path& path) {
    const std::int32_t v = path.vertex;
    const bool is_shorter_by_rounding = path.generator == label(v) && path.distance < distance(v);
    if (is_shorter_by_rounding || is_before(path.distance, path.generator, distance(v), label(v))) {
      take_path(v, path.distance, path.generator, path.back);
    }
  }

  void take_path(std::int32_t v, double d, std::int32_t generator, const FanRay& back) {
    distance(v) = d;
    if (label(v) != generator) {
      if (label(v) >= 0) pruning_.mark_vertex(fan_, back.halfedge);
      field_.label[VertexId(v)] = GeneratorId(generator);
    }
    if (kind(v) >= VertexKind::saddle) push_event({v, generator, kind(v) == VertexKind::ambiguous, d, back});
  }

  void receive_window(const PartitionMessages::SentWindow& window) {
    const std::int32_t h = window.halfedge;
    const FaceFrame& f = fan_.face(h);
    const auto i = static_cast<std::size_t>(h % 3);
    enqueue_on_edge(window.rays, window.origin, {f.length[i], f.vertex[i], f.vertex[(i + 1) % 3], h, -1});
  }

  void send_from_vertex(std::int32_t place) {
    const VertexEvent event = events_[static_cast<std::size_t>(place)];
    free_events_.push_back(place);
    if (event.distance > distance(event.vertex) || event.generator != label(event.vertex))
      return;  // another came since
    if (const std::int32_t shared = partitions_.shared(event.vertex); shared >= 0) {
      // What another part found may be shorter by rounding alone, and no news.
      SentPath& sent = sent_[static_cast<std::size_t>(shared)];
      if (!is_shorter_beyond_rounding(event.distance, sent.distance) && event.generator == sent.generator) return;
      sent = {event.distance, event.generator};
    }
    events_sent_ += static_cast<std::int64_t>(event.vertex < mesh_.vertex_count());  // once for all places of a vertex
    if (event.all_round) {
      send_all_round(event);
      return;
    }
    const FanRay left = fan_.straight_left(event.back), right = fan_.straight_right(event.back);
    if (kind(event.vertex) == VertexKind::saddle) {
      if (left.valid() && right.valid()) {
        send_between(event, left, right);
      } else {
        send_all_round(event);  // rounding hides where straight on is
      }
    } else {
      if (left.valid()) send_between(event, left, {});
      if (right.valid()) send_between(event, {}, right);
    }
  }

  void send_all_round(const VertexEvent& event) {
    const std::int32_t start = mesh_.halfedge(partitions_.vertex(event.vertex)).value();
    std::int32_t h = start;
    do {
      send(event, h, nullptr, nullptr);
      h = fan_.left_of(h);
    } while (h >= 0 && h != start);
  }

  /// Sends windows from `first` counter-clockwise to `last`; an invalid ray stands for the boundary.
  void send_between(const VertexEvent& event, const FanRay& first, const FanRay& last) {
    if (first.valid()) {
      for (std::int32_t h = first.halfedge; h >= 0; h = fan_.left_of(h)) {
        const bool ends = last.valid() && h == last.halfedge;
        send(event, h, h == first.halfedge ? &first.angle : nullptr, ends ? &last.angle : nullptr);
        if (ends) return;
      }
    } else {
      for (std::int32_t h = last.halfedge; h >= 0; h = fan_.right_of(h)) {
        send(event, h, nullptr, h == last.halfedge ? &last.angle : nullptr);
      }
    }
  }

  /// Sends a window across the face of `outgoing`, and distances along those of its sides that lie between the rays.
  /// The faces of other parts are left to the events that these have of the same vertex.
  void send(const VertexEvent& event, std::int32_t outgoing, const Rotation* first, const Rotation* last) {
    if (partitions_.of_halfedge(outgoing) != partition_) return;
    const FaceFrame& f = fan_.face(outgoing);
    const auto c = static_cast<std::size_t>(outgoing % 3), p = (c + 1) % 3, q = (c + 2) % 3;
    const std::int32_t generator = event.generator, base = outgoing - static_cast<std::int32_t>(c);
    if (!first || first->is_grazing()) {
      reach_vertex(f.vertex[p], event.distance + f.length[c], generator,
                   {base + static_cast<std::int32_t>(p), {f.cosine[p], f.sine[p]}});
    }
    if (!last || (fan_.corner(outgoing) - *last).is_grazing()) {
      reach_vertex(f.vertex[q], event.distance + f.length[q], generator, {base + static_cast<std::int32_t>(q), {}});
    }
    const int joins =
        (!last && is_flat(f.vertex[q]) ? Origin::kAtBegin : 0) | (!first && is_flat(f.vertex[p]) ? Origin::kAtEnd : 0);
    add_window(send_rays(f, c, first, last), {event.distance, generator, 1, base / 3, static_cast<std::uint8_t>(joins)},
               {base, &f, p, q});
  }

  /// Puts a window that leaves a face on the edge, unless it can hold no shortest path.
  void add_window(const Rays& w, const Origin& origin, const Side& side) {
    const FaceFrame& f = *side.face;
    enqueue_on_edge(w, origin,
                    {f.length[side.end], f.vertex[side.start], f.vertex[side.end], f.twin[side.end],
                     side.base + static_cast<std::int32_t>(side.end)});
  }

  void enqueue_on_edge(const Rays& w, const Origin& origin, const Edge& edge) {
    const bool by_start = is_beaten_by_start(w, origin.offset, distance(edge.start));
    const bool by_end = is_beaten_by_end(w, origin.offset, distance(edge.end), edge.length);
    if (is_empty(w) | by_start | by_end) return;  // no shortcuts: branches that can't be foretold cost more
    if (has_needles_ && is_left_to_ends(w, origin, edge)) return;
    if (edge.into < 0) {
      keep(w, origin, edge.from, edge.start, edge.end);
      return;
    }
    const double key = origin.offset + w.least_reach();
    const std::int32_t part = partitions_.of_halfedge(edge.into);
    if (part != partition_) [[unlikely]] {
      PartitionMessages& mail = mail_.to_send(partition_, part);
      mail.windows.push_back({w, origin, edge.into});
      mail.least_key = std::min(mail.least_key, key);
    } else if (waiting_.add(edge.into, w, origin, edge.length, key)) {
      queue_.push(key, edge.into);
    }
  }

  bool is_left_to_ends(const Rays& w, const Origin& origin, const Edge& edge) {
    return (kind(edge.start) == VertexKind::ambiguous &&
            is_left_to_vertex(origin.offset, distance(edge.start), w.end, w.squared_reach(w.end))) ||
           (kind(edge.end) == VertexKind::ambiguous &&
            is_left_to_vertex(origin.offset, distance(edge.end), edge.length - w.begin, w.squared_reach(w.begin)));
  }

  [[gnu::always_inline]] void keep(const Rays& w, const Origin& origin, std::int32_t h, std::int32_t start,
                                   std::int32_t end) {
    const bool foreign_start = is_foreign(start, origin.generator), foreign_end = is_foreign(end, origin.generator);
    if (foreign_start || foreign_end) pruning_.mark_edge(h);
    pruning_.add(w, origin, h, settled_);
  }

  /// A vertex that is not reached yet takes the label for the time being, so that reach_vertex sees when another one
  /// comes.
  bool is_foreign(std::int32_t v, std::int32_t generator) {
    GeneratorId& known = field_.label[VertexId(v)];
    if (!known.valid()) known = GeneratorId(generator);
    return known.value() != generator;
  }

  void cross_halfedge(std::int32_t h) {
    const FaceFrame& f = fan_.face(h);
    const auto i = static_cast<std::size_t>(h % 3);
    waiting_.take(h, [&](const Rays& rays, const Origin& origin) {
      if (has_thin_faces_ && is_crossed_twice(origin, h / 3, mesh_.face_count())) return;
      keep(rays, origin, h, f.vertex[i], f.vertex[(i + 1) % 3]);
      cross_face(rays, origin, f, h - static_cast<std::int32_t>(i), i);
    });
  }

  void cross_face(const Rays& w, const Origin& origin, const FaceFrame& f, std::int32_t base, std::size_t i) {
    ++carried_;
    const std::size_t right = (i + 1) % 3, top = (i + 2) % 3;
    const ApexView apex(w, f.length[top] * f.cosine[i], f.length[top] * f.sine[i]);
    Exits exits{!apex.all_right(), !apex.all_left()};
    if (apex.covered() || is_grazed(w, apex, f.length[i]) || (has_thin_faces_ && is_in_gap(w, apex, drift_))) {
      const double reach = std::sqrt(apex.squared_reach(w));
      reach_apex(w, origin, {base, &f, top, i}, apex, reach);
      if (has_needles_ && apex.covered()) exits = split_at_apex(w, origin, {base, &f, top, i}, apex, reach);
    }
    if (std::isinf(distance(f.vertex[top]))) reach_apex_along_sides(f, base, i);
    // Where the apex splits the window, the two parts may join again behind it.
    const int split = is_flat(f.vertex[top]) ? Origin::kAtBegin | Origin::kAtEnd : 0;
    Origin next = origin;
    if (has_thin_faces_ && is_cycle_check_step(++next.crossed)) next.cycle_check_face = base / 3;
    if (exits.left) {
      const int at_end = apex.all_left() ? origin.joins : split;
      next.joins = static_cast<std::uint8_t>((origin.joins & Origin::kAtBegin) | (at_end & Origin::kAtEnd));
      add_window(cross_left(w, f, i, apex), next, {base, &f, top, i});
    }
    if (exits.right) {
      const int at_begin = apex.all_right() ? origin.joins : split;
      next.joins = static_cast<std::uint8_t>((at_begin & Origin::kAtBegin) | (origin.joins & Origin::kAtEnd));
      add_window(cross_right(w, f, i, apex), next, {base, &f, right, top});
    }
  }

  /// The sides of the face that a window which covers the apex goes on to.
  /// `left`: that from the apex to the start of the window's edge; so in `reach_apex`.
  Exits split_at_apex(const Rays& w, const Origin& origin, const Side& left, const ApexView& apex, double reach) {
    const ApexPath own{origin.offset + reach, w.x + (apex.x - w.x) * w.depth / (w.depth + apex.y)};
    const double tolerance = kSameImage * reach + kRounding * left.face->length[left.start];
    return exits_beside(apex_path_[static_cast<std::size_t>(left.base) + left.start], own, tolerance);
  }

  void reach_apex(const Rays& w, const Origin& origin, const Side& left, const ApexView& apex, double reach) {
    const FaceFrame& f = *left.face;
    const std::size_t top = left.end, i = left.start;
    const double d = origin.offset + reach;
    if (!is_before(d, origin.generator, distance(f.vertex[top]), label(f.vertex[top]))) return;
    // The way back, turned from the side towards the edge's start.
    const double back_x = (w.x - apex.x) / reach, back_y = (-w.depth - apex.y) / reach;
    const Rotation angle{-f.cosine[i] * back_x - f.sine[i] * back_y, -f.cosine[i] * back_y + f.sine[i] * back_x};
    reach_vertex(f.vertex[top], d, origin.generator, {left.base + static_cast<std::int32_t>(top), angle});
  }

  /// Paths along the sides, so that no window ever stands on an edge with an end that is not reached: it would have
  /// nothing to be beaten by. What the propagation does ends for that reason, whatever rounding does.
  void reach_apex_along_sides(const FaceFrame& f, std::int32_t base, std::size_t i) {
    const std::size_t right = (i + 1) % 3, top = (i + 2) % 3;
    const std::int32_t start = f.vertex[i], end = f.vertex[right], outgoing = base + static_cast<std::int32_t>(top);
    reach_vertex(f.vertex[top], distance(start) + f.length[top], label(start), {outgoing, {}});
    reach_vertex(f.vertex[top], distance(end) + f.length[right], label(end), {outgoing, {f.cosine[top], f.sine[top]}});
  }

  const Mesh& mesh_;
  const FaceFrames& frames_;
  WindowField& field_;
  const MeshPartitions& partitions_;
  std::int32_t partition_;
  Mailboxes& mail_;
  std::vector<SentPath>& sent_;
  VertexFan fan_;
  bool has_needles_;                 // so that meshes without needles look no kinds up
  bool has_thin_faces_;              // so that other meshes count no faces and look for no gaps
  double drift_;                     // of the directions of paths, by rounding, in radians
  BucketQueue<std::int32_t> queue_;  // halfedges where windows wait, and ~places of vertex events
  WaitingWindows waiting_;
  std::vector<ApexPath>& apex_path_;  // [halfedge that windows cross into the face]
  WindowPruning pruning_;
  std::vector<VertexEvent> events_;
  std::vector<std::int32_t> free_events_;
  double settled_ = 0;
  std::int64_t carried_ = 0, events_sent_ = 0;
  std::int64_t carried_before_ = 0;  // carried_ at the last `release`
};

}  // namespace

std::unique_ptr<PartitionPropagation> make_partition_propagation(PropagationState& state, std::int32_t part) {
  return std::make_unique<PartitionPropagator>(state, part);
}

}  // namespace gvd
