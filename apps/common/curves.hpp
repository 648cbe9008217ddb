#pragma once

#include <vector>

#include "common/run.hpp"
#include "gvd/diagram.hpp"
#include "gvd/generator_curve.hpp"
#include "gvd/soup.hpp"

// Curves as generators, for the commands that take them: gvd-segment for bands between curves, gvd-distance for
// distances from them and their offset curves.
namespace gvd::app {

/// The curves of --curves, and reports them as generators, each by its first point. Throws what read_curves and
/// resolve_curves throw; Error{precondition} if the mesh has no boundary or no crease.
std::vector<GeneratorCurve> load_curves(Run& run, const CheckedMesh& input);

/// Computes the diagram of curves, and reports it. Throws what compute_diagram throws.
Diagram build_curve_diagram(Run& run, const Mesh& mesh, const std::vector<GeneratorCurve>& curves);

}  // namespace gvd::app
