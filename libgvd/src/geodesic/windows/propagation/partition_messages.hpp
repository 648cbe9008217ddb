#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "geodesic/windows/geometry/propagation_ids.hpp"
#include "geodesic/windows/geometry/vertex_fan.hpp"
#include "geodesic/windows/geometry/window.hpp"

namespace gvd {

/// What one partition tells another one at the end of a round.
struct PartitionMessages {
  /// A path to a vertex that both have.
  struct SentPath {
    VertexCopyId vertex;  ///< the receiver's copy
    VertexPath path;
  };

  std::vector<PropagatedWindow> windows;  ///< on edges between the two; their halfedges are the receiver's
  std::vector<SentPath> paths;
  std::vector<FaceId> multi_label_faces;  ///< the receiver's, with a window of another label on one of their sides
  double least_key = std::numeric_limits<double>::infinity();  ///< no path in the messages is shorter
  bool is_open = false;                                        ///< the sender has begun them

  std::size_t count() const { return windows.size() + paths.size() + multi_label_faces.size(); }
  void clear() {
    windows.clear();
    paths.clear();
    multi_label_faces.clear();
    least_key = std::numeric_limits<double>::infinity();
    is_open = false;
  }
};

/// Messages between any two partitions. Those of one round are received in the next one, ordered by sender and then as
/// they were sent. So it does not matter which partition works first, nor on which thread.
class Mailboxes {
 public:
  explicit Mailboxes(std::int32_t partitions)
      : partitions_(static_cast<std::size_t>(partitions)),
        receivers_(partitions_),
        senders_(partitions_),
        count_(partitions_, 0) {
    for (auto& boxes : boxes_) boxes.resize(partitions_ * partitions_);
  }

  /// Messages to be written by `from` alone, during a round. The caller must write something: an empty box is not
  /// received, and would not be opened again.
  PartitionMessages& to_send(PartitionId from, PartitionId to) {
    PartitionMessages& messages = box(sent_, from, to);
    if (!messages.is_open) {
      messages.is_open = true;
      receivers_[from].push_back(to);
    }
    return messages;
  }

  /// Calls visit(PartitionMessages&) for what has come for `to`, which alone may call this during a round.
  template <class Visit>
  void for_each_received(PartitionId to, Visit visit) {
    for (const PartitionId from : senders_[to]) visit(box(1 - sent_, from, to));
  }

  /// Between two rounds: how many messages have come for a partition.
  std::size_t count_for(PartitionId to) const { return count_[to]; }
  /// Between two rounds: lets what was sent be received. All that was received before must have been cleared.
  void deliver() {
    sent_ = 1 - sent_;
    has_come_ = false;
    least_key_ = std::numeric_limits<double>::infinity();
    for (auto& senders : senders_) senders.clear();
    std::fill(count_.begin(), count_.end(), 0);
    for (std::size_t i = 0; i < partitions_; ++i) {
      const PartitionId from(static_cast<std::int64_t>(i));
      for (const PartitionId to : receivers_[from]) deliver(from, to);
      receivers_[from].clear();
    }
  }

  /// Between two rounds: whether anything can be received, and the least key in it.
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
  std::size_t sent_ = 0;                                       // the set that is written
  IdVector<PartitionId, std::vector<PartitionId>> receivers_;  // [from] of the messages that are written
  IdVector<PartitionId, std::vector<PartitionId>> senders_;    // [to] of the messages that have come, ascending
  IdVector<PartitionId, std::size_t> count_;                   // [to] number of messages that have come
  bool has_come_ = false;
  double least_key_ = std::numeric_limits<double>::infinity();
};

}  // namespace gvd
