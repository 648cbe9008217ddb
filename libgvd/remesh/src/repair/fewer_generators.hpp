#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Bounds on the search, in faces and generators of all its diagrams: so many times those of the whole diagram, or so
/// many in all. Beyond either, no more pairs are tried; beyond twice as many, the search ends. That is some seconds on
/// one core. With 400 times as many, two meshes of docs/notes/remesh-bench.md came out the same.
inline constexpr std::size_t kSearchedMeshes = 60, kSearchedElements = 1'000'000;

/// Looks for generators without which the dual has no defect either, among those that a repair has added. It tries to
/// leave one out, and to put a single one in the place of two that are near each other.
///
/// Candidates for the place of two are the points that would repair the defects that the two leave. In the cells with
/// these defects, branch points and some vertices are candidates, too. Afterwards no single added generator can be left
/// out, as far as parts of the mesh tell, unless the search has become too long.
/// `diagram`: without defects. Its first `given` generators stay. `accept(generators)`: whether the dual of these
/// generators is right; if so, it has made `diagram` theirs. Deterministic. Cost: of kSearchedMeshes diagrams at most
/// twice.
void search_fewer_generators(const Mesh& mesh, const Diagram& diagram, std::size_t given, const DiagramOptions& options,
                             const std::function<bool(const std::vector<SurfacePoint>&)>& accept);

}  // namespace gvd
