#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The ids of `points` in a list of generators that has them in the same order, perhaps among others; it may end before
/// the last ones. No two generators coincide, so a point identifies its generator even if ids have changed. Cost: O(n).
std::vector<GeneratorId> find_in_order(const std::vector<SurfacePoint>& points,
                                       const std::vector<SurfacePoint>& generators);

/// The limits of a search among the generators of a right dual.
struct GeneratorSearch {
  std::size_t kept = 0;             ///< the first generators, which stay
  std::vector<SurfacePoint> fixed;  ///< of other generators that stay, too, in their order
  std::size_t least = 0;            ///< the search ends when so many generators are left
  std::int64_t most_events = 0;     ///< windows propagated (DiagramReport) in all diagrams, after which the search ends
  DiagramOptions diagram;
  std::optional<DualProperty> only = {};  ///< the only property that counts; if not set, all count
  /// Whether the dual of these generators is right. If so, it has made the diagram of the search theirs.
  std::function<bool(const std::vector<SurfacePoint>&)> accept;
};

/// Removes generators that the dual does not need, among those that a repair has added. It tries to remove one, and to
/// replace two that are near each other by one. If a single property counts, every generator is tried alone first,
/// because trials of two, which look for points in their place, would use up all the time.
///
/// The candidates to replace two are the points that would repair the defects that the two leave, and the branch points
/// and some vertices of the cells with these defects. Afterwards no single added generator can be removed, as far as
/// parts of the mesh tell, unless the search ended at its limit. `diagram` must have no defects. Returns false if the
/// search ended at its limit. Deterministic.
bool search_fewer_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search);

/// Removes generators until `search.least` are left, first those around which the surface is flattest for the distances
/// between generators.
///
/// `diagram` must have no defects. Returns whether exactly that many are left; if not, more are left, as few as the
/// search could reach. Deterministic.
bool exchange_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search);

}  // namespace gvd
