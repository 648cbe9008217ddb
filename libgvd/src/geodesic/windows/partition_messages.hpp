#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "geodesic/windows/vertex_fan.hpp"
#include "geodesic/windows/window.hpp"

namespace gvd {

/// What one part of the mesh tells another one at the end of a round.
struct PartitionMessages {
  /// A window that stands on an edge between the two.
  struct SentWindow {
    Rays rays;
    Origin origin;
    std::int32_t halfedge;  ///< that it crosses next, the receiver's
  };
  /// A path to a vertex that both have.
  struct Path {
    std::int32_t vertex;  ///< the receiver's place of it
    std::int32_t generator;
    double distance;
    FanRay back;  ///< towards where the path came from
  };

  std::vector<SentWindow> windows;
  std::vector<Path> paths;
  std::vector<std::int32_t> multi_label_faces;  ///< the receiver's, on whose sides stands a window with another label
  double least_key = std::numeric_limits<double>::infinity();  ///< no path in it is shorter
  bool is_open = false;                                        ///< the sender has begun it

  std::size_t count() const { return windows.size() + paths.size() + multi_label_faces.size(); }
  void clear() {
    windows.clear();
    paths.clear();
    multi_label_faces.clear();
    least_key = std::numeric_limits<double>::infinity();
    is_open = false;
  }
};

/// Mail between any two parts. What is sent in one round is received in the next one, by sender and then in the order
/// in which it was sent: it does not matter which part works first, nor on which thread.
class Mailboxes {
 public:
  explicit Mailboxes(std::int32_t parts)
      : partitions_(static_cast<std::size_t>(parts)),
        receivers_(partitions_),
        senders_(partitions_),
        count_(partitions_, 0) {
    for (auto& boxes : boxes_) boxes.resize(partitions_ * partitions_);
  }

  /// To be written by `from` alone, during a round. Who asks for it writes something: a box that stays empty is not
  /// received, and would not be opened again.
  PartitionMessages& to_send(std::int32_t from, std::int32_t to) {
    PartitionMessages& mail = box(sent_, from, to);
    if (!mail.is_open) {
      mail.is_open = true;
      receivers_[static_cast<std::size_t>(from)].push_back(to);
    }
    return mail;
  }

  /// Calls visit(PartitionMessages&) for what has come for `to`, which alone may call this during a round.
  template <class Visit>
  void for_each_received(std::int32_t to, Visit visit) {
    for (const std::int32_t from : senders_[static_cast<std::size_t>(to)]) visit(box(1 - sent_, from, to));
  }

  /// Between two rounds: how much has come for a part.
  std::size_t count_for(std::size_t to) const { return count_[to]; }
  /// Between two rounds: what was sent can be received. All that was received before must have been cleared.
  void deliver() {
    sent_ = 1 - sent_;
    has_come_ = false;
    least_key_ = std::numeric_limits<double>::infinity();
    for (auto& senders : senders_) senders.clear();
    std::fill(count_.begin(), count_.end(), 0);
    for (std::size_t from = 0; from < partitions_; ++from) {
      for (const std::int32_t to : receivers_[from]) deliver(static_cast<std::int32_t>(from), to);
      receivers_[from].clear();
    }
  }

  /// Between two rounds: whether anything can be received, and the least key in it.
  bool has_come() const { return has_come_; }
  double least_key() const { return least_key_; }

 private:
  void deliver(std::int32_t from, std::int32_t to) {
    const PartitionMessages& mail = box(1 - sent_, from, to);
    senders_[static_cast<std::size_t>(to)].push_back(from);
    count_[static_cast<std::size_t>(to)] += mail.count();
    has_come_ = has_come_ || mail.count() > 0;
    least_key_ = std::min(least_key_, mail.least_key);
  }

  PartitionMessages& box(std::size_t set, std::int32_t from, std::int32_t to) {
    return boxes_[set][static_cast<std::size_t>(from) * partitions_ + static_cast<std::size_t>(to)];
  }

  std::size_t partitions_;
  std::array<std::vector<PartitionMessages>, 2> boxes_;  // [set][from, to]
  std::size_t sent_ = 0;                                 // the set that is written
  std::vector<std::vector<std::int32_t>> receivers_;     // [from] of the mail that is written
  std::vector<std::vector<std::int32_t>> senders_;       // [to] of the mail that has come, ascending
  std::vector<std::size_t> count_;                       // [to] how much has come
  bool has_come_ = false;
  double least_key_ = std::numeric_limits<double>::infinity();
};

}  // namespace gvd
