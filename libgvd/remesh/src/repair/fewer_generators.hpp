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

/// The ids of the first `points`, as many as a list holds, perhaps among others, in the same order. No two generators
/// coincide, so a point tells one also where ids have changed. Cost: O(n).
std::vector<GeneratorId> find_in_order(const std::vector<SurfacePoint>& points,
                                       const std::vector<SurfacePoint>& generators);

/// What a search among the generators of a right dual may do.
struct GeneratorSearch {
  std::size_t kept = 0;             ///< the first generators, which stay
  std::vector<SurfacePoint> fixed;  ///< of other generators that stay, too, in their order
  std::size_t least = 0;            ///< it ends with so many generators
  std::int64_t most_events = 0;     ///< windows propagated (DiagramReport) in all diagrams, after which the search ends
  DiagramOptions diagram;
  std::optional<DualProperty> only = {};  ///< the property that counts; nothing: all
  /// Whether the dual of these generators is right. If so, it has made the diagram of the search theirs.
  std::function<bool(const std::vector<SurfacePoint>&)> accept;
};

/// Looks for generators without which the dual has no defect either, among those that a repair has added. It tries to
/// leave one out, and to put a single one in the place of two that are near each other. Where a single property counts,
/// all are tried alone first: a trial of two looks for points in their place, and would take all the time.
///
/// Candidates for the place of two are the points that would repair the defects that the two leave. In the cells with
/// these defects, branch points and some vertices are candidates, too. Afterwards no single added generator can be left
/// out, as far as parts of the mesh tell, unless the search has ended at its limit.
/// `diagram`: without defects. Returns false where the search ended at its limit. Deterministic.
bool search_fewer_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search);

/// Leaves out generators until `search.least` are left, where the surface is flattest for the distances between them.
///
/// `diagram`: without defects. Returns whether so many are left; without success they are as few as it came to.
/// Deterministic.
bool exchange_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search);

}  // namespace gvd
