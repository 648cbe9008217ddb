#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geodesic/edge_windows.hpp"
#include "geodesic/face_frames.hpp"

namespace gvd {

/// Which windows are kept after they have done their work.
enum class KeepWindows {
  none,
  near_bisectors,  ///< those on the edges of faces that a bisector can meet
  all,
};

/// Keeps the windows that have done their work, and lets go of those that no bisector can need while the propagation
/// goes on, so that they never fill the memory.
///
/// A face is quiet where every distance in it is settled and has one label: the corners' labels are equal, and no window
/// with another label has ever stood on its sides. The windows on an edge are needed as long as one of its faces may turn
/// out not to be quiet, since points inside of a face see the windows on all of its sides.
class WindowRetention {
 public:
  WindowRetention(KeepWindows keep, const FaceFrames& frames, const IdVector<VertexId, double>& distance,
                  const IdVector<VertexId, std::int32_t>& label)
      : keep_(keep), frames_(frames), distance_(distance), label_(label) {
    if (keep == KeepWindows::near_bisectors) state_.assign(frames.frame.size(), State::open);
  }

  /// Window w stands on halfedge h.
  void add(const Window& w, std::int32_t h) {
    if (keep_ == KeepWindows::none) return;
    recent_.push_back({w.begin, w.end, w.x, w.depth, w.offset, w.generator, h});
  }

  /// A window whose label is not that of both ends of the edge stands on halfedge h.
  void mark_edge(std::int32_t h) {
    if (keep_ != KeepWindows::near_bisectors) return;
    mark_face(h / 3);
    const std::int32_t twin = twin_of(h);
    if (twin >= 0) mark_face(twin / 3);
  }
  void mark_face(std::int32_t face) {
    if (keep_ == KeepWindows::near_bisectors) state_[static_cast<std::size_t>(face)] = State::mixed;
  }

  bool is_due() const { return recent_.size() > limit_; }

  /// Lets go of what can go. `settled`: no window to come holds a distance below it.
  /// Cost: O(windows added since the last time + windows on edges not settled yet), which is amortised O(1) a window.
  void sweep(double settled) {
    if (keep_ != KeepWindows::near_bisectors) {
      kept_.append(recent_.begin(), recent_.end());
      recent_.clear();
      return;
    }
    auto left = recent_.begin();
    for (const KeptWindow& w : recent_) {
      const State state = look_at_edge(w.halfedge, settled);
      if (state == State::open) *left++ = w;
      if (state == State::mixed) kept_.push_back(w);
    }
    recent_.erase(left, recent_.end());
    limit_ = std::max(kLeastSweep, 3 * recent_.size());
  }

  EdgeWindows finish() {
    sweep(std::numeric_limits<double>::infinity());
    return EdgeWindows(std::move(kept_), frames_.frame.size());
  }

 private:
  enum class State : std::uint8_t { open, quiet, mixed };
  static constexpr std::size_t kLeastSweep = 4096;
  /// The queue's keys are floats; a distance counts as settled this part of itself later.
  static constexpr double kMargin = 1e-6;

  std::int32_t twin_of(std::int32_t h) const {
    return frames_.frame[FaceId(h / 3)].twin[static_cast<std::size_t>(h % 3)];
  }

  State look_at_edge(std::int32_t h, double settled) {
    const State here = look_at_face(h / 3, settled);
    if (here == State::mixed) return here;
    const std::int32_t twin = twin_of(h);
    if (twin < 0) return here;
    const State there = look_at_face(twin / 3, settled);
    if (there == State::mixed) return there;
    return here == State::quiet ? there : here;
  }

  /// A window that stands on a side later has distances above `settled` everywhere, and where that exceeds a corner's
  /// distance by the side's length, `is_beaten_by_start` drops it.
  State look_at_face(std::int32_t face, double settled) {
    State& state = state_[static_cast<std::size_t>(face)];
    if (state != State::open) return state;
    const FaceFrame& f = frames_.frame[FaceId(face)];
    const VertexId a(f.vertex[0]), b(f.vertex[1]), c(f.vertex[2]);
    const double farthest = std::max({distance_[a], distance_[b], distance_[c]});
    const double longest = std::max({f.length[0], f.length[1], f.length[2]});
    if (!((farthest + longest) * (1 + kMargin) < settled)) return state;
    state = label_[a] == label_[b] && label_[b] == label_[c] ? State::quiet : State::mixed;
    return state;
  }

  KeepWindows keep_;
  const FaceFrames& frames_;
  const IdVector<VertexId, double>& distance_;
  const IdVector<VertexId, std::int32_t>& label_;
  std::vector<State> state_;
  std::vector<KeptWindow> recent_;  // in the order in which they were added
  BlockList<KeptWindow> kept_;      // for good
  std::size_t limit_ = kLeastSweep;
};

}  // namespace gvd
