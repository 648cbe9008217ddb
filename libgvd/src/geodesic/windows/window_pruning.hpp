#pragma once

#include <algorithm>
#include <cstdint>

#include "base/prefetch.hpp"
#include "geodesic/windows/propagation_state.hpp"
#include "geodesic/windows/vertex_fan.hpp"
#include "geodesic/windows/window_field.hpp"

namespace gvd {

/// Keeps the windows of one part of the mesh that have done their work, and lets go of those that no bisector can need
/// while the propagation goes on, so that they never fill the memory.
///
/// A face is quiet where every distance in it is settled and has one label: the corners' labels are equal, and no
/// window with another label has ever stood on its sides. The windows on an edge are needed as long as one of its faces
/// may turn out not to be quiet, since points inside of a face see the windows on all of its sides.
/// Each part decides about its own faces, and tells the others of windows on its edges to them. About windows on such
/// an edge it decides while no other part runs, so that what these have found out can be read.
class WindowPruning {
 public:
  /// Of the state, the mail and the states of the part's own faces are written.
  WindowPruning(PropagationState& state, std::int32_t part)
      : keep_(state.keep),
        frames_(state.frames),
        field_(state.field),
        partitions_(state.parts),
        partition_(part),
        state_(state.face_state.data()),
        mail_(state.mail) {}

  /// A window stands on halfedge h. `front`: no window to come holds a distance below it.
  [[gnu::always_inline]] void add(const Rays& w, const Origin& origin, std::int32_t h, double front) {
    if (keep_ == KeepWindows::none) return;
    const KeptWindow kept{w.begin, w.end, w.x, w.depth, origin.offset, origin.generator, h};
    if (keep_ == KeepWindows::all || state_[h / 3] == FaceState::multi_label) {
      kept_.push_back(kept);
      return;
    }
    const std::int32_t twin = twin_of(h);
    if (twin >= 0 && !is_own(twin / 3)) {
      on_border_.windows.push_back(kept);
    } else if (recent_.windows.push_back(kept)) {
      review(recent_, front);
    }
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

  /// A window with another label stands on a side of the part's face.
  void mark_own_face(std::int32_t face) {
    // Where a face is quiet already, what comes is beaten by the paths through its corners.
    if (state_[face] == FaceState::open) state_[face] = FaceState::multi_label;
  }

  /// Lets go of what can go on edges to other parts, none of which may run. `settled` as in `add`.
  void review_border(double settled) { review(on_border_, settled); }

  /// The propagation is over, in all parts: decides about the rest. Returns what is kept.
  BlockList<KeptWindow> finish() {
    std::int32_t last = -1;
    bool stays = false;
    const auto decide = [&](const KeptWindow& w) {
      if (w.halfedge != last) stays = is_edge_multi_label_at_end(last = w.halfedge);
      if (stays) kept_.push_back(w);
    };
    for (Undecided* list : {&recent_, &on_border_}) {
      while (!list->windows.empty()) list->windows.take_block(decide);  // nothing is added: one block less each time
    }
    return std::move(kept_);
  }

 private:
  /// The queue's keys are floats; a distance counts as settled this part of itself later.
  static constexpr double kMargin = 1e-6;
  static constexpr double kReach = 0.5773503;  // 1 / sqrt(3), rounded up

  /// Windows of which it can't be told yet whether they are kept, in the order in which they were added.
  struct Undecided {
    BlockQueue<KeptWindow> windows;
    std::size_t patience = 2;  // blocks that wait before the oldest one is looked at
  };

  /// Lets go of what can go, oldest first. Where half of a block can't be told yet, so can't what is younger.
  [[gnu::noinline]] void review(Undecided& list, double settled) {
    while (list.windows.age() > list.patience) {
      const std::size_t undecided = review_block(list.windows, settled);
      if (2 * undecided > BlockQueue<KeptWindow>::kBlock) {
        list.patience = list.windows.age() + list.windows.age() / 4 + 1;
        return;
      }
    }
  }

  std::size_t review_block(BlockQueue<KeptWindow>& windows, double settled) {
    std::size_t undecided = 0;
    std::int32_t last = -1;
    FaceState state = FaceState::open;
    const auto decide = [&](const KeptWindow& w) {
      if (w.halfedge != last) state = look_at_edge(last = w.halfedge, settled);
      if (state == FaceState::open) {
        windows.push_back(w);
        ++undecided;
      } else if (state == FaceState::multi_label) {
        kept_.push_back(w);
      }
    };
    windows.take_block(decide, [&](const KeptWindow& w) {
      const std::int32_t face = w.halfedge / 3;
      prefetch(&state_[face]);
      prefetch(frames_.frame[FaceId(face)].length.data());
      prefetch(frames_.frame[FaceId(face)].vertex.data());
    });
    return undecided;
  }

  bool is_own(std::int32_t face) const { return partitions_.of_face(face) == partition_; }

  void mark_face(std::int32_t face) {
    const std::int32_t part = partitions_.of_face(face);
    if (part == partition_) {
      mark_own_face(face);
    } else {
      mail_.to_send(partition_, part).multi_label_faces.push_back(face);
    }
  }

  std::int32_t twin_of(std::int32_t h) const {
    return frames_.frame[FaceId(h / 3)].twin[static_cast<std::size_t>(h % 3)];
  }

  FaceState look_at_edge(std::int32_t h, double settled) {
    const FaceState here = look_at_face(h / 3, settled);
    if (here == FaceState::multi_label) return here;
    const std::int32_t twin = twin_of(h);
    if (twin < 0) return here;
    const FaceState there = look_at_face(twin / 3, settled);
    if (there == FaceState::multi_label) return there;
    return here == FaceState::single_label ? there : here;
  }

  /// Every point of a triangle is within its longest side of each corner, and within that / sqrt(3) of one of them:
  /// where the nearest corner's distance plus the former, or the farthest one's plus the latter, is below `settled`,
  /// paths through the corners beat all windows to come.
  FaceState look_at_face(std::int32_t face, double settled) {
    FaceState& state = state_[face];
    if (state != FaceState::open) return state;
    const FaceFrame& f = frames_.frame[FaceId(face)];
    const VertexId a(f.vertex[0]), b(f.vertex[1]), c(f.vertex[2]);
    const auto [nearest, farthest] = std::minmax({field_.distance[a], field_.distance[b], field_.distance[c]});
    const double longest = std::max({f.length[0], f.length[1], f.length[2]});
    if (!(std::min(farthest + kReach * longest, nearest + longest) * (1 + kMargin) < settled)) return state;
    state = has_one_label(f) ? FaceState::single_label : FaceState::multi_label;
    return state;
  }

  bool has_one_label(const FaceFrame& f) const {
    const VertexId a(f.vertex[0]), b(f.vertex[1]), c(f.vertex[2]);
    return field_.label[a] == field_.label[b] && field_.label[b] == field_.label[c];
  }

  bool is_edge_multi_label_at_end(std::int32_t h) const {
    const std::int32_t twin = twin_of(h);
    return is_multi_label_at_end(h / 3) || (twin >= 0 && is_multi_label_at_end(twin / 3));
  }

  /// Changes nothing: several parts may ask about one face at the same time.
  bool is_multi_label_at_end(std::int32_t face) const {
    if (state_[face] != FaceState::open) return state_[face] == FaceState::multi_label;
    return !has_one_label(frames_.frame[FaceId(face)]);
  }

  KeepWindows keep_;
  const FaceFrames& frames_;
  const WindowField& field_;
  const MeshPartitions& partitions_;
  std::int32_t partition_;
  FaceState* state_;  // [face]; those of other parts are not touched while these run
  Mailboxes& mail_;
  Undecided recent_, on_border_;
  BlockList<KeptWindow> kept_;  // for good
};

}  // namespace gvd
