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
  /// The largest number of generators to add, >= 0. Without a value: `default_max_added`.
  std::optional<std::int64_t> max_added;
};

/// A diagram whose cells are discs.
struct DiscCells {
  Diagram diagram;                ///< of the given generators, in their order, then the added ones
  std::int64_t added = 0;         ///< number of generators added
  std::int32_t rounds = 0;        ///< number of diagrams to which generators were added
  bool search_cut_short = false;  ///< the search for fewer generators ended at its limit
};

/// The cells that are no discs: not connected, or of an Euler characteristic other than 1. Ascending. Cost: O(cells).
std::vector<GeneratorId> find_non_discs(const Diagram& diagram);

/// Adds generators until every cell is a disc, as few as are found.
///
/// While there are cells that are no discs, each one that is apart from others is divided by one more generator: of
/// some candidates the one that a forecast says to leave least to do. These are the point opposite its generator on a
/// limb, that of its shortest non-contractible loop, one as far from a tip as its generator, and vertices. Where the
/// forecast fails, each is tried on the part of the mesh round the cell. A search follows: generators that the discs
/// can do without are left out, and one is put in the place of two where that will do. There may be fewer still; but no
/// single added one can be left out, as far as parts of the mesh tell, unless the search was cut short. Two cells may
/// share several bisectors, and a cell may touch itself at a branch point.
///
/// `diagram`: of `mesh` with `options.diagram`. Given generators are neither moved nor removed. Deterministic.
/// Throws Error{no_valid_result} with the cell as its element where `max_added` or kMaxRemeshRounds rounds are not
/// enough, or every point of it is too close to a generator; Error{invalid_option} for a negative `max_added` or
/// weights. Cost: one diagram a round, and trials and search as kDiscSearch allows.
DiscCells make_discs(const Mesh& mesh, const Diagram& diagram, const DiscOptions& options = {});

/// The most work of all trials and of the search, each, in diagrams of the given generators: the least number; as many
/// more as propagate so many windows, which take a second; and the largest number, for small meshes.
inline constexpr double kDiscSearch = 1, kDiscSearchWindows = 5e6, kMostDiscSearch = 300;

}  // namespace gvd
