#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

struct DiscOptions {
  DiagramOptions diagram;  ///< without weights
  /// The largest number of generators to add, >= 0. If it is not set, the limit is `default_max_added`.
  std::optional<std::int64_t> max_added;
};

/// A diagram whose cells are discs.
struct DiscCells {
  Diagram diagram;                ///< of the given generators, in their order, then the added ones
  std::int64_t added = 0;         ///< number of generators added
  std::int32_t rounds = 0;        ///< number of diagrams to which generators were added
  bool search_cut_short = false;  ///< the search for fewer generators ended at its limit
};

/// The cells that are not discs, because they are not connected or have an Euler characteristic other than 1.
/// Ascending. Cost: O(cells).
std::vector<GeneratorId> find_non_discs(const Diagram& diagram);

/// Adds generators until every cell is a disc, as few as are found.
///
/// In each round, every cell that is not a disc, and is not next to another such cell, is divided by one more
/// generator. The candidates are the point opposite the generator on a limb, the point opposite it on the shortest
/// non-contractible loop, a point as far from a tip as the generator, and vertices; a forecast chooses the one that
/// leaves the fewest cells to divide. Where the forecast fails, each candidate is tried on the part of the mesh around
/// the cell. A search follows, which removes generators that are not needed and replaces two by one where one is
/// enough. The result need not be the smallest possible, but no single added generator can be removed, as far as parts
/// of the mesh tell, unless the search was cut short. Two cells may share several bisectors, and a cell may touch
/// itself at a branch point.
///
/// Properties: (1) every cell of the result is a disc; (2) the given generators come first, unchanged; (3)
/// deterministic.
///
/// `diagram` must be the diagram of `mesh` with `options.diagram`. Throws Error{no_valid_result}, with the cell as its
/// element, if `max_added` generators or kMaxRemeshRounds rounds are not enough, or if every point of the cell is too
/// close to a generator. Throws Error{invalid_option} for a negative `max_added` and for weights. Cost: one diagram for
/// each round, and trials and a search within the limits of kDiscSearch.
DiscCells make_discs(const Mesh& mesh, const Diagram& diagram, const DiscOptions& options = {});

/// The limit on the work of all trials, and of the search, counted in diagrams of the given generators: at least the
/// first number, then as many more as propagate the second number of windows, which take about a second, and at most
/// the third number, which matters on small meshes.
inline constexpr double kDiscSearch = 1, kDiscSearchWindows = 5e6, kMostDiscSearch = 300;

}  // namespace gvd
