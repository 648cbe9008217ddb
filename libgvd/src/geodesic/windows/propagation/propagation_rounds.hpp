#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/propagation/partition_exchange.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {

/// Lets the partitions of a mesh work in rounds until nothing waits any more. In each round every partition takes the
/// messages of the last round and the current bucket of its queue. When no message for that bucket is left, all
/// partitions advance to the next one. Windows and paths that cross from one partition to another arrive a round late.
/// This costs a few windows that a shorter path would have stopped earlier, but distances do not depend on the order of
/// windows.
///
/// The result is bit-identical for any number of threads for the following reasons. The partitions, and the contents of
/// the buckets, do not depend on the number of threads. During a round, a partition writes only its own data and its
/// outgoing messages. It reads only these, the mesh, and data that is written only between rounds. Messages are read in
/// the order of the senders. The state of a partition after a round is therefore a function of its state and messages
/// before it, whichever thread works on it, and when.
///
/// All queues have buckets of the same width, and are at the same bucket.
///
/// `Partition` is RecordedPartition, or a substitute in tests.
template <class Partition>
class PropagationRounds {
 public:
  /// All arguments must outlive this object.
  PropagationRounds(std::vector<std::unique_ptr<Partition>>& partitions, Mailboxes& mailboxes, double bucket_width,
                    const ParallelChunks& parallel)
      : partitions_(partitions),
        mailboxes_(mailboxes),
        bucket_width_(bucket_width),
        parallel_(parallel),
        alone_(1, parallel.progress()) {}

  /// Ends when everything that waits holds only distances beyond `limit`. Calls report() after each round; if it
  /// throws, the propagation ends.
  template <class Report>
  void run(double limit, Report report) {
    while (waits()) {
      const double next_front = partitions_.front()->front() + bucket_width_;
      // A list is queued with the key of its first windows, which may be one bucket later than the keys of others.
      const double settled = partitions_.front()->front() - bucket_width_;
      if (settled > limit) return;
      do {
        run_round(settled);
        report();
      } while (mailboxes_.least_key() < next_front);
      const std::size_t steps = steps_to_next();
      for (const auto& partition : partitions_) partition->end_bucket(settled, steps);
    }
  }

 private:
  /// With fewer windows than this, it is not worth waking up other threads.
  static constexpr std::size_t kWorthSharing = 128;

  struct Busy {
    std::size_t partition, work;
  };

  bool waits() const {
    return mailboxes_.has_come() || std::any_of(partitions_.begin(), partitions_.end(),
                                                [](const auto& partition) { return partition->waits(); });
  }

  /// Number of buckets, >= 1, to the next bucket with any work. With needles, most buckets are empty.
  std::size_t steps_to_next() const {
    const double to_messages = std::floor((mailboxes_.least_key() - partitions_.front()->front()) / bucket_width_);
    std::size_t steps = std::numeric_limits<std::size_t>::max();
    for (const auto& partition : partitions_) steps = std::min(steps, partition->steps_to_next());
    return to_messages < double(steps) ? static_cast<std::size_t>(std::max(to_messages, 1.0)) : steps;
  }

  void run_round(double settled) {
    std::size_t work = 0;
    busy_.clear();
    for (std::size_t i = 0; i < partitions_.size(); ++i) {
      const std::size_t own_work = partitions_[i]->waits_now() + mailboxes_.count_for(PartitionId(i));
      if (own_work > 0) busy_.push_back({i, own_work});
      work += own_work;
    }
    if (busy_.empty()) return;
    // The largest partitions come first, so that threads end at about the same time.
    std::sort(busy_.begin(), busy_.end(), [](const Busy& a, const Busy& b) { return a.work > b.work; });
    const ParallelChunks& parallel = work < kWorthSharing ? alone_ : parallel_;
    parallel.run(busy_.size(), {steps::kDistances},
                 [&](std::size_t i) { partitions_[busy_[i].partition]->run_round(settled); });
    mailboxes_.deliver();
  }

  std::vector<std::unique_ptr<Partition>>& partitions_;
  Mailboxes& mailboxes_;
  double bucket_width_;
  const ParallelChunks& parallel_;
  ParallelChunks alone_;
  std::vector<Busy> busy_;  // partitions with work in this round
};

}  // namespace gvd
