#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Reads the windows from which a diagram was traced. They live during the call only.
using WindowReader = std::function<void(const WorkingMesh&, const WindowField&, const Diagram&)>;

/// The distances at which generators with these weights start: the weights less the least one. Empty for none.
std::vector<double> from_zero(std::vector<double> weights);

/// Throws Error{invalid_option} where `compute_diagram` does.
void check_diagram_options(const DiagramOptions& options);

/// `compute_diagram` with the windows as the solver. `read` may be empty; else it is called once, at the end, with the
/// windows that `keep` names, and with departures where that is all of them. Rounding differs between the two, because
/// windows come in another order, and so may the points within the chord tolerance.
Diagram compute_diagram_and_read(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                 const DiagramOptions& options, KeepWindows keep, const WindowReader& read);

/// A generator without a cell: by their weights, another one is nearer even at its own place.
struct HiddenGenerator {
  GeneratorId generator, nearer;
  Error error() const;  ///< that `compute_diagram` throws then
};

/// The same for weights that may leave a generator without a cell: returns the first such generator in place of an
/// error, without a call of `read`.
std::variant<Diagram, HiddenGenerator> try_to_compute_and_read(const Mesh& mesh,
                                                               const std::vector<SurfacePoint>& generators,
                                                               const DiagramOptions& options, KeepWindows keep,
                                                               const WindowReader& read);

}  // namespace gvd
