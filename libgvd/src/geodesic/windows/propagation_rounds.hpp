#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/partition_messages.hpp"
#include "geodesic/windows/partition_propagator.hpp"

namespace gvd {

/// Lets the parts of a mesh work in rounds until nothing waits any more. In each round every part takes the mail of the
/// round before, and the current bucket of its queue; when no mail for that bucket is left, all go on to the next one.
/// What crosses from one part to another comes a round late: that costs a few windows that a shorter path would have
/// stopped before, and nothing else, for the order in which windows are taken changes no distance.
///
/// Why any number of threads leaves the same bits: the parts, and what lies in a bucket, do not depend on it. During a
/// round a part writes only its own data and the boxes of its mail, and reads these, the mesh, and what is written
/// between rounds alone. Mail is read in the order of the senders. So what a part holds after a round is a function of
/// what it and its mail held before, whichever thread works on it, and when.
///
/// All queues have buckets of the same width, and stand at the same one.
class PropagationRounds {
 public:
  /// All have to outlive this.
  PropagationRounds(std::vector<std::unique_ptr<PartitionPropagation>>& parts, Mailboxes& mail, double bucket_width,
                    const ParallelChunks& parallel)
      : partitions_(parts),
        mail_(mail),
        bucket_width_(bucket_width),
        parallel_(parallel),
        alone_(1, parallel.progress()) {}

  /// Calls report() after each round; what that throws ends the propagation.
  template <class Report>
  void run(Report report) {
    while (waits()) {
      const double next_front = partitions_.front()->front() + bucket_width_;
      // A list's key in the queue is that of its first windows, which may be later than another's by a bucket.
      const double settled = partitions_.front()->front() - bucket_width_;
      do {
        run_round(settled);
        report();
      } while (mail_.least_key() < next_front);
      const std::size_t steps = steps_to_next();
      for (const auto& part : partitions_) part->end_bucket(settled, steps);
    }
  }

 private:
  /// Windows that make it worth while to wake other threads up.
  static constexpr std::size_t kWorthSharing = 128;

  struct Busy {
    std::size_t part, work;
  };

  bool waits() const {
    return mail_.has_come() ||
           std::any_of(partitions_.begin(), partitions_.end(), [](const auto& part) { return part->waits(); });
  }

  /// Number of buckets to the next one that anything is to be done in, >= 1: where there are needles, most are empty.
  std::size_t steps_to_next() const {
    const double to_mail = std::floor((mail_.least_key() - partitions_.front()->front()) / bucket_width_);
    std::size_t steps = std::numeric_limits<std::size_t>::max();
    for (const auto& part : partitions_) steps = std::min(steps, part->steps_to_next());
    return to_mail < static_cast<double>(steps) ? static_cast<std::size_t>(std::max(to_mail, 1.0)) : steps;
  }

  void run_round(double settled) {
    std::size_t work = 0;
    busy_.clear();
    for (std::size_t i = 0; i < partitions_.size(); ++i) {
      const std::size_t of_part = partitions_[i]->waits_now() + mail_.count_for(i);
      if (of_part > 0) busy_.push_back({i, of_part});
      work += of_part;
    }
    if (busy_.empty()) return;
    // The largest first, so that threads end at about the same time.
    std::sort(busy_.begin(), busy_.end(), [](const Busy& a, const Busy& b) { return a.work > b.work; });
    const ParallelChunks& parallel = work < kWorthSharing ? alone_ : parallel_;
    parallel.run(busy_.size(), {"distances"}, [&](std::size_t i) { partitions_[busy_[i].part]->run_round(settled); });
    mail_.deliver();
  }

  std::vector<std::unique_ptr<PartitionPropagation>>& partitions_;
  Mailboxes& mail_;
  double bucket_width_;
  const ParallelChunks& parallel_;
  ParallelChunks alone_;
  std::vector<Busy> busy_;  // parts with work in this round
};

}  // namespace gvd
