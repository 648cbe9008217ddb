#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "geodesic/windows/edge_windows.hpp"
#include "geodesic/windows/propagation_state.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// The propagation in one part of the mesh. Parts may work on several threads, each one on one at a time.
class PartitionPropagation {
 public:
  virtual ~PartitionPropagation() = default;

  /// Windows will start from a vertex's place in all directions. Before the first round.
  virtual void start_vertex(std::int32_t place, GeneratorId g, double d) = 0;

  /// Takes the mail, and then all that waits in the current bucket of the queue. `settled`: no window in the whole mesh
  /// that has still to be carried holds a distance below it.
  virtual void run_round(double settled) = 0;
  /// No part runs, and no mail for the current bucket is left: goes on by `steps` buckets, of which none but the last
  /// one holds anything. `settled`: as above.
  virtual void end_bucket(double settled, std::size_t steps) = 0;

  /// Number of items in the current bucket; mail apart.
  virtual std::size_t waits_now() const = 0;
  /// Whether anything waits in the queue.
  virtual bool waits() const = 0;
  /// Number of buckets to the next one that holds anything.
  virtual std::size_t steps_to_next() const = 0;
  /// The least key of the current bucket.
  virtual double front() const = 0;

  /// After the last round of all parts: returns all windows of the part that are kept.
  virtual BlockList<KeptWindow> finish() = 0;

  virtual std::int64_t carried() const = 0;  ///< windows carried across a face
  virtual std::int64_t events() const = 0;   ///< vertices that sent windows
};

std::unique_ptr<PartitionPropagation> make_partition_propagation(PropagationState& state, std::int32_t part);

}  // namespace gvd
