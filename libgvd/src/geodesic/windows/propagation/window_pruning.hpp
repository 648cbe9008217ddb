#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geodesic/windows/propagation/partition_exchange.hpp"
#include "geodesic/windows/propagation/propagation_state.hpp"
#include "geodesic/windows/vertex_fan.hpp"
#include "geodesic/windows/window_field.hpp"

namespace gvd {

/// Keeps the windows of one partition that have been carried across their face. Windows that no bisector can need are
/// dropped while the propagation is still running, so that they never fill the memory.
///
/// A face has a single label if all distances in it are settled, its corners' labels are equal, and no window with
/// another label was ever on its sides. The windows on an edge are needed as long as one of its two faces may turn out
/// to have several labels, because points inside a face see the windows on all of its sides. Each partition decides
/// about its own faces, and tells the other partitions about windows with another label on edges between them. It
/// decides about windows on such an edge while no other partition runs, so that it can read the states of the other
/// partition's faces.
class WindowPruning {
 public:
  /// Only the states of the partition's own faces are written. Both arguments must outlive this object.
  WindowPruning(PropagationState& state, PartitionExchange& exchange)
      : keep_(state.keep),
        keeps_departures_(!state.angles.empty()),
        frames_(state.frames),
        labels_(state.labels),
        fan_(frames_),
        state_(state.face_state.raw().data()),
        exchange_(exchange) {}

  /// Where the windows on an edge go: nowhere, or to the list of windows that are kept, of windows that are decided
  /// about while no other partition runs, or of windows that are decided about soon.
  enum class Place : std::uint8_t { none, kept, on_border, recent };

  Place place(HalfedgeId h) const {
    if (keep_ == KeepWindows::none) return Place::none;
    if (keep_ == KeepWindows::all || state(Mesh::face(h)) == FaceState::multi_label) return Place::kept;
    const HalfedgeId twin = fan_.twin(h);
    return twin.valid() && !exchange_.is_own(twin) ? Place::on_border : Place::recent;
  }

  /// Adds a window on its edge. `departure` is kept if the state has angles; then all windows are kept. `settled`: no
  /// window to come holds a distance below it.
  [[gnu::always_inline]] void add(const Window& w, Departure departure, Place place, double settled) {
    if (place == Place::recent) {
      if (recent_.windows.push_back(w)) review(recent_, settled);
    } else if (place == Place::kept) {
      if (keeps_departures_) kept_.departures.push_back(departure);
      kept_.windows.push_back(w);
    } else if (place == Place::on_border) {
      on_border_.windows.push_back(w);
    }
  }

  /// Records that halfedge h has a window whose label differs from that of an end of the edge.
  void mark_edge(HalfedgeId h, double settled) {
    if (keep_ != KeepWindows::near_bisectors) return;
    mark_face(Mesh::face(h), settled);
    const HalfedgeId twin = fan_.twin(h);
    if (twin.valid()) mark_face(Mesh::face(twin), settled);
  }
  /// Records that the vertex that `outgoing` leaves changes its label, because windows on its edges may have the old
  /// label.
  void mark_vertex(HalfedgeId outgoing, double settled) {
    if (keep_ != KeepWindows::near_bisectors) return;
    HalfedgeId h = outgoing;
    do {
      mark_face(Mesh::face(h), settled);
      h = fan_.left_of(h);
    } while (h.valid() && h != outgoing);
    if (h == outgoing) return;
    for (h = outgoing; h.valid(); h = fan_.right_of(h)) mark_face(Mesh::face(h), settled);
  }

  /// Records that a side of a face of this partition has a window with another label. `settled` is as in `add`.
  void mark_own_face(FaceId f, double settled) {
    // If the face has a single label already, the paths through its corners beat such a window. Faces are decided about
    // before they are marked, so that their states do not depend on when windows far away were reviewed.
    if (state(f) == FaceState::open && decide_face(f, settled) == FaceState::open) state(f) = FaceState::multi_label;
  }

  /// Decides about windows on edges to other partitions. To be called only while no partition runs. `settled` is as in
  /// `add`.
  void review_border(double settled) { review(on_border_, settled); }

  /// Decides about all remaining windows, and returns the windows that are kept. To be called after the propagation has
  /// ended in all partitions.
  KeptWindows finish() {
    const auto decide = [&](HalfedgeId h, std::span<const Window> windows) {
      if (!is_edge_multi_label_at_end(h)) return;
      for (const Window& w : windows) kept_.windows.push_back(w);
    };
    for (Undecided* list : {&recent_, &on_border_}) {
      while (!list->windows.empty()) visit_edges(list->windows, decide);  // this adds no windows to the list
    }
    return std::move(kept_);
  }

 private:
  /// A distance counts as settled later by this fraction of itself, because the queue's keys are floats.
  static constexpr double kKeyRounding = 1e-6;
  static constexpr double kCornerRadius = 0.5773503;  // 1 / sqrt(3), rounded up

  /// Windows that are neither kept nor dropped yet, in the order in which they were added.
  struct Undecided {
    BlockQueue<Window> windows;
    std::size_t patience = 2;  // lists of up to this many blocks are not reviewed
  };

  /// Decides about windows, oldest first. Stops if half of a block stays undecided, because then younger windows would,
  /// too.
  [[gnu::noinline]] void review(Undecided& list, double settled) {
    while (list.windows.block_count() > list.patience) {
      const std::size_t undecided = review_block(list.windows, settled);
      if (2 * undecided > BlockQueue<Window>::kBlock) {
        list.patience = list.windows.block_count() + list.windows.block_count() / 8 + 1;
        return;
      }
    }
  }

  std::size_t review_block(BlockQueue<Window>& windows, double settled) {
    std::size_t undecided = 0;
    visit_edges(windows, [&](HalfedgeId h, std::span<const Window> on_edge) {
      const FaceState decision = decide_edge(h, settled);
      if (decision == FaceState::single_label) return;
      if (decision == FaceState::multi_label) {
        for (const Window& w : on_edge) kept_.windows.push_back(w);
      } else {
        for (const Window& w : on_edge) windows.push_back(w);
        undecided += on_edge.size();
      }
    });
    return undecided;
  }

  /// Takes the oldest block, and calls visit(HalfedgeId, std::span<const Window>) for each sequence of windows on the
  /// same edge.
  template <class Visit>
  void visit_edges(BlockQueue<Window>& windows, const Visit& visit) const {
    constexpr std::size_t kWindowsAhead = 8;
    windows.take_block([&](std::span<const Window> block) {
      for (std::size_t begin = 0, end = 0; begin < block.size(); begin = end) {
        const HalfedgeId h = block[begin].halfedge;
        while (end < block.size() && block[end].halfedge == h) ++end;
        prefetch_face(Mesh::face(block[std::min(end + kWindowsAhead, block.size() - 1)].halfedge));
        visit(h, block.subspan(begin, end - begin));
      }
    });
  }

  void prefetch_face(FaceId f) const {
    prefetch(state_ + f.value());
    prefetch(frames_.frame[f].length.data());
    prefetch(frames_.frame[f].vertex.data());
  }

  FaceState& state(FaceId f) { return state_[f.value()]; }
  FaceState state(FaceId f) const { return state_[f.value()]; }

  void mark_face(FaceId f, double settled) {
    if (exchange_.is_own(f)) {
      mark_own_face(f, settled);
    } else {
      exchange_.send_multi_label_face(f);
    }
  }

  /// Whether one of the edge's faces has several labels, both have a single label, or this is still open.
  FaceState decide_edge(HalfedgeId h, double settled) {
    const FaceState here = decide_face(Mesh::face(h), settled);
    if (here == FaceState::multi_label) return here;
    const HalfedgeId twin = fan_.twin(h);
    if (!twin.valid()) return here;
    const FaceState there = decide_face(Mesh::face(twin), settled);
    if (there == FaceState::multi_label) return there;
    return here == FaceState::single_label ? there : here;
  }

  /// Let l be the longest side of a triangle. Every point of the triangle is at most l away from each corner, and at
  /// most l / sqrt(3) from some corner. If the nearest corner's distance plus l, or the farthest corner's distance plus
  /// l / sqrt(3), is below `settled`, paths through the corners beat all windows to come.
  FaceState decide_face(FaceId face, double settled) {
    FaceState& decision = state(face);
    if (decision != FaceState::open) return decision;
    const FaceFrame& f = frames_.frame[face];
    const auto [nearest, farthest] =
        std::minmax({labels_.distance[f.vertex[0]], labels_.distance[f.vertex[1]], labels_.distance[f.vertex[2]]});
    const double longest = std::max({f.length[0], f.length[1], f.length[2]});
    const double latest = std::min(farthest + kCornerRadius * longest, nearest + longest);
    if (!(latest * (1 + kKeyRounding) < settled)) return decision;
    decision = has_one_label(f) ? FaceState::single_label : FaceState::multi_label;
    return decision;
  }

  bool has_one_label(const FaceFrame& f) const {
    const GeneratorId label = labels_.label[f.vertex[1]];
    return labels_.label[f.vertex[0]] == label && label == labels_.label[f.vertex[2]];
  }

  bool is_edge_multi_label_at_end(HalfedgeId h) const {
    const HalfedgeId twin = fan_.twin(h);
    return is_multi_label_at_end(Mesh::face(h)) || (twin.valid() && is_multi_label_at_end(Mesh::face(twin)));
  }

  /// This changes nothing, because several partitions may ask about the same face at the same time.
  bool is_multi_label_at_end(FaceId f) const {
    if (state(f) != FaceState::open) return state(f) == FaceState::multi_label;
    return !has_one_label(frames_.frame[f]);
  }

  KeepWindows keep_;
  bool keeps_departures_;
  const FaceFrames& frames_;
  const DistanceLabels& labels_;
  VertexFan fan_;
  FaceState* state_;  // [face]; while partitions run, each uses only the items of its own faces
  PartitionExchange& exchange_;
  Undecided recent_, on_border_;
  KeptWindows kept_;
};

}  // namespace gvd
