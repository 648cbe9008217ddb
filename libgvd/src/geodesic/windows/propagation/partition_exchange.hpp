#pragma once

#include <algorithm>
#include <limits>

#include "geodesic/windows/geometry/window_filters.hpp"
#include "geodesic/windows/propagation/mesh_partitions.hpp"
#include "geodesic/windows/propagation/partition_messages.hpp"

namespace gvd {

/// The path with which a copy of a vertex last sent windows.
struct LastSent {
  double distance = std::numeric_limits<double>::infinity();
  GeneratorId generator;
};

/// One partition's side of the exchange with the others: what it tells them, and what it hears from them.
class PartitionExchange {
 public:
  /// Of the mailboxes, only those of this partition are used; of `last_sent`, only its own copies. All have to outlive
  /// this.
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
  /// Hands a window over to the partition whose halfedge it crosses next. No path in the window is shorter than `key`.
  void send_window(const Window& w, const WindowHistory& history, double key) {
    PartitionMessages& messages = mailboxes_.to_send(own_, partitions_.of_halfedge(w.halfedge));
    messages.windows.push_back({w, history});
    messages.least_key = std::min(messages.least_key, key);
  }
  /// Tells the partition of a face that it has a window of another label on one of its sides.
  void send_multi_label_face(FaceId f) {
    mailboxes_.to_send(own_, partitions_.of_face(f)).multi_label_faces.push_back(f);
  }

  /// Hands on what has come since the last round, and clears it: target.receive_multi_label_face(FaceId) and
  /// target.receive_path(VertexCopyId, const VertexPath&) first, then target.receive_window(const PropagatedWindow&),
  /// so that the windows are compared with all paths.
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

  /// Whether windows for this path to a vertex were not sent yet. Another partition may have found a path that is
  /// shorter by rounding alone. True for a vertex of this partition alone.
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
