#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "repair/fewer_generators.hpp"
#include "repair/local_dual.hpp"

namespace gvd {

/// Changes that leave a dual right with fewer generators: one is left out, or one takes the place of two.
///
/// Each change is tried on a part of the mesh. Those that pass and are apart from each other are collected. `apply`
/// then decides on the whole mesh: on all of them at once and, if they fail together, on smaller groups.
class LocalChanges {
 public:
  /// The dual of `diagram` must have no defects. All arguments must outlive this. Cost: O(n).
  LocalChanges(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search)
      : mesh_(mesh), diagram_(diagram), search_(search), tried_(diagram.generators.size(), 0), near_change_(tried_) {}

  /// The number of generators after the collected changes.
  std::size_t count() const { return diagram_.generators.size() - collected_.size() - both_; }
  /// Whether the work of all diagrams so far exceeds the limit.
  bool is_over() const { return events_ > search_.most_events; }
  /// Whether a trial with this generator is pointless now, because nothing has changed near it since its last trial, or
  /// a collected change is near.
  bool is_idle(GeneratorId g) const { return tried_[g] || is_near_change(g); }
  bool is_near_change(GeneratorId g) const { return near_change_[g] != 0; }
  void forget_trials() { tried_.assign(tried_.size(), 0); }

  /// Collects the change that leaves out a generator, if the part keeps no defect.
  void leave_out(GeneratorId g);
  /// Collects the change that leaves out two generators, or puts a point in their place.
  void unite(GeneratorId g, GeneratorId other);
  /// Decides on the collected changes. Afterwards, trials near those made are worth repeating.
  void apply();

 private:
  struct Change {
    std::vector<GeneratorId> removed;
    std::vector<SurfacePoint> added;
    std::vector<GeneratorId> near;  // cells whose trials it may alter
  };

  void collect(std::vector<GeneratorId> removed, std::vector<SurfacePoint> added);
  std::optional<LocalDual::Result> compute(const LocalDual& local, const std::vector<SurfacePoint>& added);
  std::vector<SurfacePoint> list_candidates(const LocalDual& local, const LocalDual::Result& without) const;
  std::vector<std::size_t> decide(const std::vector<SurfacePoint>& before);
  void refuse(const Change& change);
  bool accept(const std::vector<SurfacePoint>& before, const std::vector<std::size_t>& changes);

  const Mesh& mesh_;
  const Diagram& diagram_;
  const GeneratorSearch& search_;
  CellFlags tried_, near_change_;
  std::vector<Change> collected_;
  std::vector<SurfacePoint> refused_;  // points in the place of two that failed on the whole mesh
  std::size_t both_ = 0;               // collected changes that leave out two generators for none
  std::int64_t events_ = 0;            // of all diagrams so far
};

}  // namespace gvd
