#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/bucket_queue.hpp"
#include "geodesic/windows/block_list.hpp"
#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/parallel_windows.hpp"
#include "geodesic/windows/propagation/face_crossing.hpp"
#include "geodesic/windows/propagation/partition_exchange.hpp"
#include "geodesic/windows/propagation/propagation_state.hpp"
#include "geodesic/windows/propagation/pseudo_sources.hpp"
#include "geodesic/windows/propagation/waiting_windows.hpp"
#include "geodesic/windows/propagation/window_pruning.hpp"
#include "geodesic/windows/propagation/window_record.hpp"
#include "geodesic/windows/vertex_fan.hpp"
#include "geodesic/windows/window_filters.hpp"
#include "gvd/ids.hpp"

namespace gvd {

using VertexEventId = Id<struct VertexEventTag>;

/// An item in the queue of a partition: a halfedge with waiting windows, or a vertex event.
class QueueItem {
 public:
  explicit QueueItem(HalfedgeId h) : value_(h.value()) {}
  explicit QueueItem(VertexEventId event) : value_(~event.value()) {}

  bool is_halfedge() const { return value_ >= 0; }
  HalfedgeId halfedge() const { return HalfedgeId(value_); }
  VertexEventId event() const { return VertexEventId(~value_); }

 private:
  std::int32_t value_;  // a halfedge, or the complement of an event's id
};
static_assert(sizeof(QueueItem) == 4);

/// The vertex events that wait in the queue of a partition. The ids of events that were taken are reused.
class VertexEvents {
 public:
  VertexEventId add(const VertexEvent& event) {
    if (free_.empty()) free_.push_back(events_.push_back({}));
    const VertexEventId id = free_.back();
    free_.pop_back();
    events_[id] = event;
    return id;
  }
  VertexEvent take(VertexEventId id) {
    free_.push_back(id);
    return events_[id];
  }
  /// Frees the memory. No event may wait.
  void release() {
    events_ = {};
    free_ = {};
  }

 private:
  IdVector<VertexEventId, VertexEvent> events_;
  std::vector<VertexEventId> free_;
};

/// The propagation in one partition of the mesh: its queue, and the rules by which paths and windows enter it.
///
/// Paths and windows come from three helpers: FaceCrossing carries windows across a face, PseudoSources starts them at
/// a vertex, and PartitionExchange receives them from other partitions. Partitions may work on several threads, each
/// thread on one of them at a time. See propagate_windows.hpp.
/// `Recorder` sees each window that is carried, and may forbid windows to enter faces (window_record.hpp).
/// The class is long because the steps of the innermost loop share its members and are inlined into it.
template <class Recorder>
class RecordedPartition {
 public:
  /// `state` must outlive this object.
  RecordedPartition(PropagationState& state, PartitionId own, Recorder recorder = {})
      : recorder_(recorder),
        frames_(state.frames),
        labels_(state.labels),
        has_needles_(frames_.has_needles),
        has_thin_faces_(frames_.has_thin_faces),
        has_curves_(!state.on_curve.empty()),
        on_curve_(state.on_curve),
        exchange_(state.partitions, state.mailboxes, state.last_sent, own),
        sources_(*state.mesh, frames_, state.partitions, state.angles, own),
        crossing_(frames_, labels_, state.apex_path, state.angles, state.starts),
        queue_(state.bucket_width, state.bucket_count),
        waiting_(state.first_waiting, state.bucket_width),
        pruning_(state, exchange_) {}
  RecordedPartition(const RecordedPartition&) = delete;
  RecordedPartition& operator=(const RecordedPartition&) = delete;

  /// Makes a vertex copy a generator at this distance, unless it has a shorter path. To be called before the first
  /// round.
  void start_vertex(VertexCopyId v, GeneratorId g, double d) {
    if (!(d < labels_.distance[v])) return;
    labels_.distance[v] = d;
    labels_.label[v] = g;
    push_event({v, true, {d, g, {}}});
  }

  /// The same for a vertex of a curve at distance 0, which sends windows when `send_from_curve` is called.
  void start_curve_vertex(VertexCopyId v, GeneratorId g) {
    labels_.distance[v] = 0;
    labels_.label[v] = g;
  }
  /// Sends the windows of a curve: from a vertex through each sector between two segments, where the nearest point of
  /// the curve is the vertex, and the paths along the edges there.
  void send_from_curve(VertexCopyId v, std::span<const CurveSector> sectors) {
    sources_.send_from_curve(v, labels_.label[v], sectors, *this);
  }
  /// Sends the window of a segment into the face of its halfedge: the window waits, with key 0, as if it had come to
  /// the edge.
  void send_from_segment(HalfedgeId h) {
    const FaceFrame& f = frames_.frame[Mesh::face(h)];
    const std::size_t start = Mesh::corner(h);
    const Window w = window_from_segment(h, f.length[start], 0, labels_.label[f.vertex[start]]);
    if (waiting_.add(w, {0, 0, FaceId()}, f.length[start], 0)) queue_.push(0, QueueItem(h));
  }

  /// Takes the messages of the last round, and then everything that waits in the current bucket of the queue.
  /// `settled`: no window of the whole mesh that has not been carried yet holds a distance below it.
  void run_round(double settled) {
    settled_ = settled;
    exchange_.receive(*this);
    while (queue_.front_size() > 0) {
      const QueueItem item = queue_.pop();
      look_ahead();
      if (item.is_halfedge()) {
        cross_halfedge(item.halfedge());
      } else {
        send_from_vertex(item.event());
      }
    }
  }
  /// Advances by `steps` buckets; the buckets that are skipped must be empty. To be called only while no partition runs
  /// and no message for the current bucket is left. `settled` is as in run_round.
  void end_bucket(double settled, std::size_t steps) {
    pruning_.review_border(settled);
    // An empty queue frees its memory for other partitions, but only after much work, because releasing visits all
    // buckets.
    if (queue_.empty() && carried_ - carried_before_ > static_cast<std::int64_t>(queue_.bucket_count())) release();
    queue_.advance(steps);
  }

  /// Number of items in the current bucket, without messages.
  std::size_t waits_now() const { return queue_.front_size(); }
  /// Whether anything waits in the queue.
  bool waits() const { return !queue_.empty(); }
  /// Number of buckets to the next one that holds anything.
  std::size_t steps_to_next() const { return queue_.steps_to_next(); }
  /// The least key of the current bucket.
  double front() const { return queue_.front(); }
  /// Returns all windows of the partition that are kept. To be called after the last round.
  KeptWindows finish() { return pruning_.finish(); }
  std::int64_t carried() const { return carried_; }     ///< windows carried across a face
  std::int64_t events() const { return events_sent_; }  ///< vertices that sent windows

  /// FaceCrossing and PseudoSources call this with a path to a vertex. If it is better than the known one, it is sent
  /// to the other partitions with a copy of v, and if paths can bend at v, v will send windows.
  void reach_vertex(VertexCopyId v, const VertexPath& path) {
    if (!labels_.is_improved_by(v, path.distance, path.generator)) return;
    take_path(v, path);
    exchange_.send_path(v, path);
  }

  /// FaceCrossing, PseudoSources and the exchange call this with a window that comes to an edge. It is queued, or sent
  /// to the partition beyond the edge, unless the filters show that it holds no shortest path.
  [[gnu::always_inline]] void enqueue_on_edge(const Window& w, const WindowHistory& history, const WindowEdge& edge) {
    const bool by_start = is_beaten_by_start(w, labels_.distance[edge.start]);
    const bool by_end = is_beaten_by_end(w, labels_.distance[edge.end], edge.length);
    if (is_empty(w) | by_start | by_end) return;  // `|` and not `||`, because unpredictable branches cost more
    if (has_needles_ && is_left_to_ends(w, edge)) return;
    enqueue(w, history, edge, w.offset + w.least_image_distance());
  }
  /// The same for a parallel window. Its least distance is at one end of the interval, because distances are linear.
  void enqueue_parallel_on_edge(const Window& w, const WindowHistory& history, const WindowEdge& edge) {
    if (is_parallel_dropped(w, labels_.distance[edge.start], labels_.distance[edge.end], edge.length)) return;
    enqueue(w, history, edge, std::min(w.distance(w.begin), w.distance(w.end)));
  }

  void receive_multi_label_face(FaceId f) { pruning_.mark_own_face(f, settled_); }
  /// Receives a path to vertex copy v that another partition has found. Each copy takes the first, in the order of
  /// is_before, of the best paths of all copies, and the shortest of several paths from the same generator. In the end,
  /// all copies therefore agree to the last bit.
  void receive_path(VertexCopyId v, const VertexPath& path) {
    const bool is_shorter_by_rounding = path.generator == labels_.label[v] && path.distance < labels_.distance[v];
    if (is_shorter_by_rounding || labels_.is_improved_by(v, path.distance, path.generator)) take_path(v, path);
  }
  void receive_window(const PropagatedWindow& received) {
    const HalfedgeId h = received.window.halfedge;
    const FaceFrame& f = frames_.frame[Mesh::face(h)];
    const std::size_t start = Mesh::corner(h);
    const WindowEdge edge{f.length[start], f.vertex[start], f.vertex[(start + 1) % 3], h};
    if (received.window.is_parallel()) {
      enqueue_parallel_on_edge(received.window, received.history, edge);
    } else {
      enqueue_on_edge(received.window, received.history, edge);
    }
  }

 private:
  /// Queues a window that no filter drops, or sends it to another partition. No path in it is shorter than `key`.
  [[gnu::always_inline]] void enqueue(const Window& w, const WindowHistory& history, const WindowEdge& edge,
                                      double key) {
    // A curve is nearer to all points of its edges than anything that comes to them.
    if (has_curves_ && on_curve_[edge.behind] != 0) return;
    if (!recorder_.allows(w.halfedge)) return;
    if (!w.halfedge.valid()) {
      Window ending = w;
      ending.halfedge = edge.behind;
      KeepingEdge kept{edge.behind, edge.start, edge.end, pruning_.place(edge.behind)};
      keep({ending, history}, kept);
      return;
    }
    if (!exchange_.is_own(w.halfedge)) [[unlikely]] {
      exchange_.send_window(w, history, key);
    } else if (waiting_.add(w, history, edge.length, key)) {
      queue_.push(key, QueueItem(w.halfedge));
    }
  }

  /// Prefetches the data of the next items of the queue: first the addresses, then the data at these addresses.
  /// Otherwise half of the time would be spent waiting for memory.
  void look_ahead() const {
    constexpr std::size_t kFar = 8, kNear = 4;
    if (const QueueItem* far = queue_.ahead(kFar); far != nullptr && far->is_halfedge()) {
      const FaceFrame& f = frames_.frame[Mesh::face(far->halfedge())];
      waiting_.prefetch_list(far->halfedge());
      prefetch(f.length.data());
      prefetch(f.vertex.data());
    }
    if (const QueueItem* near = queue_.ahead(kNear); near != nullptr && near->is_halfedge()) {
      waiting_.prefetch_windows(near->halfedge());
      const FaceFrame& f = frames_.frame[Mesh::face(near->halfedge())];
      for (std::size_t i = 0; i < 3; ++i) {
        prefetch(&labels_.distance[f.vertex[i]]);
        if (f.twin[i].valid()) waiting_.prefetch_list(f.twin[i]);
      }
    }
  }

  void cross_halfedge(HalfedgeId h) {
    if (!waiting_.waits(h)) return;  // it was also queued with a smaller key
    const FaceEntry entry(frames_, h);
    const std::int32_t faces = frames_.frame.count();
    KeepingEdge kept{h, entry.frame.vertex[entry.start], entry.frame.vertex[entry.end], pruning_.place(h)};
    const auto cross = [&](const PropagatedWindow& entering) __attribute__((always_inline)) {
      if (has_thin_faces_ && enters_face_twice(entering.history, Mesh::face(h), faces)) return;
      keep(entering, kept);
      ++carried_;
      if (entering.window.is_parallel()) [[unlikely]] {
        crossing_.cross_parallel(entering, entry, *this);
      } else {
        crossing_.cross(entering, entry, *this);
      }
    };
    waiting_.take(h, cross);
  }

  void send_from_vertex(VertexEventId id) {
    const VertexEvent event = events_.take(id);
    const VertexCopyId v = event.vertex;
    // A better path has come since.
    if (event.path.distance > labels_.distance[v] || event.path.generator != labels_.label[v]) return;
    if (!exchange_.record_sending(v, event.path)) return;
    events_sent_ += sources_.is_first_copy(v) ? 1 : 0;
    sources_.send(event, *this);
  }

  void take_path(VertexCopyId v, const VertexPath& path) {
    labels_.distance[v] = path.distance;
    if (labels_.label[v] != path.generator) {
      if (labels_.label[v].valid()) pruning_.mark_vertex(path.back.halfedge, settled_);
      labels_.label[v] = path.generator;
    }
    if (!labels_.departure.empty()) labels_.departure[v] = path.departure;
    const VertexKind kind = frames_.kind[v];
    if (kind >= VertexKind::saddle) push_event({v, kind == VertexKind::ambiguous, path});
  }

  void push_event(const VertexEvent& event) { queue_.push(event.path.distance, QueueItem(events_.add(event))); }

  bool is_left_to_ends(const Window& w, const WindowEdge& edge) const {
    return (frames_.kind[edge.start] == VertexKind::ambiguous &&
            is_left_to_vertex(w.offset, labels_.distance[edge.start], w.end, w.squared_image_distance(w.end))) ||
           (frames_.kind[edge.end] == VertexKind::ambiguous &&
            is_left_to_vertex(w.offset, labels_.distance[edge.end], edge.length - w.begin,
                              w.squared_image_distance(w.begin)));
  }

  /// The edge of a halfedge whose windows are kept, and where.
  struct KeepingEdge {
    HalfedgeId halfedge;
    VertexCopyId start, end;
    WindowPruning::Place place;
  };

  /// Keeps a window on its edge, if the options ask for that.
  [[gnu::always_inline]] void keep(const PropagatedWindow& w, KeepingEdge& edge) {
    const GeneratorId generator = w.window.generator;
    const bool other_start = labels_.has_other_label(edge.start, generator);
    if (labels_.has_other_label(edge.end, generator) || other_start) {
      pruning_.mark_edge(edge.halfedge, settled_);
      edge.place = pruning_.place(edge.halfedge);
    }
    recorder_.record(edge.halfedge, w.window, settled_);
    pruning_.add(w.window, w.history.departure, edge.place, settled_);
  }

  void release() {
    waiting_.release();
    queue_.release();
    events_.release();
    carried_before_ = carried_;
  }

  [[no_unique_address]] Recorder recorder_;
  const FaceFrames& frames_;
  DistanceLabels& labels_;
  bool has_needles_;     // without needles, kinds of vertices are not looked up
  bool has_thin_faces_;  // without thin faces, faces that are entered twice are not looked for
  bool has_curves_;
  const IdVector<HalfedgeId, std::uint8_t>& on_curve_;
  PartitionExchange exchange_;
  PseudoSources sources_;
  FaceCrossing crossing_;
  BucketQueue<QueueItem> queue_;
  WaitingWindows waiting_;
  VertexEvents events_;
  WindowPruning pruning_;
  double settled_ = 0;
  std::int64_t carried_ = 0, events_sent_ = 0;
  std::int64_t carried_before_ = 0;  // carried_ at the last `release`
};

/// A partition whose windows are not recorded.
using PartitionPropagator = RecordedPartition<NoRecorder>;

}  // namespace gvd
