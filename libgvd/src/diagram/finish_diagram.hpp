#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

// The steps that turn a traced diagram of the working mesh into the `Diagram` of the input, in their order.

/// Follows the arcs from branch point to branch point and fills in bisectors, branch points and their total length, in
/// the input mesh's faces. Counts ends that are unresolved in its report. Several threads compute the points. Reports
/// the first half of the step "cells".
/// Cost: O(k) for k arcs.
void trace_bisectors(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                     Diagram& diagram);

/// Fills in face labels, pieces and cells by several threads; expects the bisectors in `diagram`, for a cell's
/// neighbours. Reports the second half of the step "cells". Cost: O(n).
void collect_cells(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                   Diagram& diagram);

/// The boundary loops of every cell, made of bisectors and of the mesh's boundary. Cost: O(k) for k arcs and boundary
/// edges.
IdVector<GeneratorId, std::int32_t> count_boundary_loops(const WorkingMesh& working, const TracedDiagram& traced);

/// What a subset of the mesh's elements adds to a cell.
struct CellShare {
  GeneratorId generator;
  std::int32_t euler_characteristic = 0;
  double area = 0;  ///< square mesh units
};

/// The shares of cells in a subset of the mesh: a hash map with linear probing, in the order of insertion. Memory and
/// time depend on the cells in the subset, not on the number of generators.
class CellShares {
 public:
  /// The share of cell g, new if there is none; valid until the next call.
  CellShare& operator[](GeneratorId g) {
    if (last_ < shares_.size() && shares_[last_].generator == g) return shares_[last_];
    std::size_t slot = find(g);
    if (slots_[slot] == kNone) {
      if (2 * shares_.size() >= slots_.size()) slot = grow_and_find(g);
      slots_[slot] = static_cast<std::uint32_t>(shares_.size());
      shares_.push_back({g, 0, 0});
    }
    last_ = slots_[slot];
    return shares_[last_];
  }

  /// All shares, each cell once, in the order of insertion.
  std::vector<CellShare> take() { return std::move(shares_); }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// The slot of g, or the free slot for it.
  std::size_t find(GeneratorId g) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = (static_cast<std::uint32_t>(g.value()) * std::uint64_t{0x9e3779b97f4a7c15} >> 32) & mask;
    while (slots_[slot] != kNone && shares_[slots_[slot]].generator != g) slot = (slot + 1) & mask;
    return slot;
  }

  std::size_t grow_and_find(GeneratorId g) {
    slots_.assign(2 * slots_.size(), kNone);
    for (std::uint32_t i = 0; i < shares_.size(); ++i) slots_[find(shares_[i].generator)] = i;
    return find(g);
  }

  std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(16, kNone);  // a power of two, at most half full
  std::vector<CellShare> shares_;
  std::size_t last_ = 0;  // of the last call: most calls ask for the same cell again
};

}  // namespace gvd
