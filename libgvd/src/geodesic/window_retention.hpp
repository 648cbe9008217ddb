#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geodesic/saddle_fan.hpp"
#include "geodesic/window_field.hpp"

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
/// A face is quiet where every distance in it is settled and has one label: the corners' labels are equal, and no
/// window with another label has ever stood on its sides. The windows on an edge are needed as long as one of its faces
/// may turn out not to be quiet, since points inside of a face see the windows on all of its sides.
class WindowRetention {
 public:
  /// The field is only read.
  WindowRetention(KeepWindows keep, const WindowField& field) : keep_(keep), field_(field) {
    if (keep == KeepWindows::near_bisectors) state_.assign(field.frames.frame.size(), State::open);
  }

  /// A window stands on halfedge h. `front`: no window to come holds a distance below it.
  void add(const Rays& w, const Origin& origin, std::int32_t h, double front) {
    if (keep_ == KeepWindows::none) return;
    const KeptWindow kept{w.begin, w.end, w.x, w.depth, origin.offset, origin.generator, h};
    if (keep_ == KeepWindows::all || state_[static_cast<std::size_t>(h / 3)] == State::mixed) {
      kept_.push_back(kept);
      return;
    }
    if (recent_.push_back(kept)) review(front);
  }

  /// A window whose label is not that of both ends of the edge stands on halfedge h.
  void mark_edge(std::int32_t h) {
    if (keep_ != KeepWindows::near_bisectors) return;
    mark_face(h / 3);
    const std::int32_t twin = twin_of(h);
    if (twin >= 0) mark_face(twin / 3);
  }
  /// The vertex that halfedge `outgoing` leaves changes its label: windows on its edges may have had the old one.
  void mark_vertex(const VertexFan& fan, std::int32_t outgoing) {
    if (keep_ != KeepWindows::near_bisectors) return;
    std::int32_t h = outgoing;
    do {
      mark_face(h / 3);
      h = fan.left_of(h);
    } while (h >= 0 && h != outgoing);
    if (h == outgoing) return;
    for (h = outgoing; h >= 0; h = fan.right_of(h)) mark_face(h / 3);
  }

  EdgeWindows finish() {
    const double end = std::numeric_limits<double>::infinity();
    while (!recent_.empty()) review_block(end);
    return EdgeWindows(std::move(kept_), field_.frames.frame.size());
  }

 private:
  enum class State : std::uint8_t { open, quiet, mixed };
  /// The queue's keys are floats; a distance counts as settled this part of itself later.
  static constexpr double kMargin = 1e-6;
  static constexpr double kReach = 0.5773503;  // 1 / sqrt(3), rounded up

  /// Lets go of what can go, oldest first. Where half of a block can't be told yet, so can't what is younger.
  void review(double settled) {
    while (!recent_.empty() && recent_.age() > patience_) {
      const std::size_t undecided = review_block(settled);
      if (2 * undecided > BlockQueue<KeptWindow>::kBlock) {
        patience_ = recent_.age() + recent_.age() / 4 + 1;
        return;
      }
    }
  }

  std::size_t review_block(double settled) {
    std::size_t undecided = 0;
    std::int32_t last = -1;
    State state = State::open;
    recent_.take_block([&](const KeptWindow& w) {
      if (w.halfedge != last) state = look_at_edge(last = w.halfedge, settled);
      if (state == State::open) {
        recent_.push_back(w);
        ++undecided;
      } else if (state == State::mixed) {
        kept_.push_back(w);
      }
    });
    return undecided;
  }

  /// Where a face is quiet already, what comes is beaten by the paths through its corners.
  void mark_face(std::int32_t face) {
    State& state = state_[static_cast<std::size_t>(face)];
    if (state == State::open) state = State::mixed;
  }

  std::int32_t twin_of(std::int32_t h) const {
    return field_.frames.frame[FaceId(h / 3)].twin[static_cast<std::size_t>(h % 3)];
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

  /// Every point of a triangle is within its longest side / sqrt(3) of a corner: where the farthest corner's distance
  /// plus that is below `settled`, paths through the corners beat all windows to come.
  State look_at_face(std::int32_t face, double settled) {
    State& state = state_[static_cast<std::size_t>(face)];
    if (state != State::open) return state;
    const FaceFrame& f = field_.frames.frame[FaceId(face)];
    const VertexId a(f.vertex[0]), b(f.vertex[1]), c(f.vertex[2]);
    const double farthest = std::max({field_.distance[a], field_.distance[b], field_.distance[c]});
    const double longest = std::max({f.length[0], f.length[1], f.length[2]});
    if (!((farthest + kReach * longest) * (1 + kMargin) < settled)) return state;
    state = field_.label[a] == field_.label[b] && field_.label[b] == field_.label[c] ? State::quiet : State::mixed;
    return state;
  }

  KeepWindows keep_;
  const WindowField& field_;
  std::vector<State> state_;
  BlockQueue<KeptWindow> recent_;  // in the order in which they were added
  BlockList<KeptWindow> kept_;     // for good
  std::size_t patience_ = 8;       // blocks that wait before the oldest one is looked at
};

}  // namespace gvd
