#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/propagation/mesh_partitions.hpp"
#include "geodesic/windows/vertex_fan.hpp"
#include "geodesic/windows/window.hpp"
#include "geodesic/windows/window_filters.hpp"

namespace gvd {

/// The messages from one partition to another in a round.
struct PartitionMessages {
  /// A path to a vertex that both partitions have.
  struct SentPath {
    VertexCopyId vertex;  ///< the receiver's copy
    VertexPath path;
  };

  std::vector<PropagatedWindow> windows;  ///< on edges between the two; their halfedges are the receiver's
  std::vector<SentPath> paths;
  std::vector<FaceId> multi_label_faces;  ///< faces of the receiver with another label on one of their sides
  double least_key = kInfinity;           ///< no path in the messages is shorter
  bool is_open = false;                   ///< whether the sender has begun to write them

  std::size_t count() const { return windows.size() + paths.size() + multi_label_faces.size(); }
  void clear() {
    windows.clear();
    paths.clear();
    multi_label_faces.clear();
    least_key = kInfinity;
    is_open = false;
  }
};

/// Messages between any two partitions. Messages of one round are received in the next, ordered by sender and then as
/// they were sent. It therefore does not matter which partition works first, nor on which thread.
class Mailboxes {
 public:
  explicit Mailboxes(std::int32_t partitions)
      : partitions_(partitions), receivers_(partitions_), senders_(partitions_), count_(partitions_, 0) {
    for (auto& boxes : boxes_) boxes.resize(partitions_ * partitions_);
  }

  /// The messages from one partition to another. During a round, only `from` may write them. The caller must write
  /// something, because an empty box is not received and would not be opened again.
  PartitionMessages& to_send(PartitionId from, PartitionId to) {
    PartitionMessages& messages = box(sent_, from, to);
    if (!messages.is_open) {
      messages.is_open = true;
      receivers_[from].push_back(to);
    }
    return messages;
  }

  /// Calls visit(PartitionMessages&) for all messages that have come for `to`. During a round, only `to` may call this.
  template <class Visit>
  void for_each_received(PartitionId to, Visit visit) {
    for (const PartitionId from : senders_[to]) visit(box(1 - sent_, from, to));
  }

  /// The number of messages that have come for a partition. To be called between two rounds.
  std::size_t count_for(PartitionId to) const { return count_[to]; }
  /// Makes the sent messages available to their receivers. To be called between two rounds, when all messages received
  /// before have been cleared.
  void deliver() {
    sent_ = 1 - sent_;
    has_come_ = false;
    least_key_ = kInfinity;
    for (auto& senders : senders_) senders.clear();
    std::fill(count_.begin(), count_.end(), 0);
    for (const PartitionId from : receivers_.ids()) {
      for (const PartitionId to : receivers_[from]) deliver(from, to);
      receivers_[from].clear();
    }
  }

  /// Whether there are messages to receive, and their least key. To be called between two rounds.
  bool has_come() const { return has_come_; }
  double least_key() const { return least_key_; }

 private:
  void deliver(PartitionId from, PartitionId to) {
    const PartitionMessages& messages = box(1 - sent_, from, to);
    senders_[to].push_back(from);
    count_[to] += messages.count();
    has_come_ = has_come_ || messages.count() > 0;
    least_key_ = std::min(least_key_, messages.least_key);
  }

  PartitionMessages& box(std::size_t set, PartitionId from, PartitionId to) {
    return boxes_[set][from.index() * partitions_ + to.index()];
  }

  std::size_t partitions_;
  std::array<std::vector<PartitionMessages>, 2> boxes_;        // [set][from, to]
  std::size_t sent_ = 0;                                       // the set that is being written
  IdVector<PartitionId, std::vector<PartitionId>> receivers_;  // [from] of the messages being written
  IdVector<PartitionId, std::vector<PartitionId>> senders_;    // [to] senders of the messages that have come, ascending
  IdVector<PartitionId, std::size_t> count_;                   // [to] number of messages that have come
  bool has_come_ = false;
  double least_key_ = kInfinity;
};

/// The path for which a copy of a vertex last sent windows.
struct LastSent {
  double distance = kInfinity;
  GeneratorId generator;
};

/// One partition's side of the exchange with other partitions: what it sends and what it receives.
class PartitionExchange {
 public:
  /// The partition only uses its own mailboxes, and its own copies in `last_sent`. All arguments must outlive this
  /// object.
  PartitionExchange(const MeshPartitions& partitions, Mailboxes& mailboxes, IdVector<SharedCopyId, LastSent>& last_sent,
                    PartitionId own)
      : partitions_(partitions), mailboxes_(mailboxes), last_sent_(last_sent), own_(own) {}

  PartitionId own() const { return own_; }
  bool is_own(FaceId f) const { return partitions_.of_face(f) == own_; }
  bool is_own(HalfedgeId h) const { return partitions_.of_halfedge(h) == own_; }

  /// Tells the other copies of a vertex of a path to it.
  void send_path(VertexCopyId v, const VertexPath& path) {
    const SharedCopyId shared = partitions_.shared(v);
    if (shared.valid()) [[unlikely]]
      send_to_copies(shared, path);
  }
  /// Sends a window to the partition whose halfedge it crosses next. No path in the window is shorter than `key`.
  void send_window(const Window& w, const WindowHistory& history, double key) {
    PartitionMessages& messages = mailboxes_.to_send(own_, partitions_.of_halfedge(w.halfedge));
    messages.windows.push_back({w, history});
    messages.least_key = std::min(messages.least_key, key);
  }
  /// Tells the partition of a face that it has a window of another label on one of its sides.
  void send_multi_label_face(FaceId f) {
    mailboxes_.to_send(own_, partitions_.of_face(f)).multi_label_faces.push_back(f);
  }

  /// Passes the messages that have come since the last round to the target, and clears them:
  /// target.receive_multi_label_face(FaceId) and target.receive_path(VertexCopyId, const VertexPath&) first, then
  /// target.receive_window(const PropagatedWindow&), so that the windows are compared with all paths.
  template <class Target>
  void receive(Target& target) {
    mailboxes_.for_each_received(own_, [&](PartitionMessages& messages) {
      for (const FaceId f : messages.multi_label_faces) target.receive_multi_label_face(f);
      for (const PartitionMessages::SentPath& sent : messages.paths) target.receive_path(sent.vertex, sent.path);
    });
    mailboxes_.for_each_received(own_, [&](PartitionMessages& messages) {
      for (const PropagatedWindow& window : messages.windows) target.receive_window(window);
      messages.clear();
    });
  }

  /// Whether windows for this path to a vertex have not been sent yet; records that they are sent now. Another
  /// partition may have found a path that is shorter by rounding alone. Always true for a vertex that is not shared.
  bool record_sending(VertexCopyId v, const VertexPath& path) {
    const SharedCopyId shared = partitions_.shared(v);
    if (!shared.valid()) return true;
    LastSent& last = last_sent_[shared];
    if (!is_shorter_beyond_rounding(path.distance, last.distance) && path.generator == last.generator) return false;
    last = {path.distance, path.generator};
    return true;
  }

 private:
  void send_to_copies(SharedCopyId shared, const VertexPath& path) {
    for (const MeshPartitions::VertexCopy& copy : partitions_.copies(shared)) {
      if (copy.partition == own_) continue;
      PartitionMessages& messages = mailboxes_.to_send(own_, copy.partition);
      messages.paths.push_back({copy.vertex, path});
      messages.least_key = std::min(messages.least_key, path.distance);
    }
  }

  const MeshPartitions& partitions_;
  Mailboxes& mailboxes_;
  IdVector<SharedCopyId, LastSent>& last_sent_;
  PartitionId own_;
};

}  // namespace gvd
