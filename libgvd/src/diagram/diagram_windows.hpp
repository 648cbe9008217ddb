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

/// A function that reads the windows from which a diagram was traced. They are valid only during the call.
using WindowReader = std::function<void(const WorkingMesh&, const WindowField&, const Diagram&)>;

/// The distances at which generators with these weights start: the weights minus the least weight. Empty if there are
/// none.
std::vector<double> from_zero(std::vector<double> weights);

/// Throws the Error{invalid_option} that `compute_diagram` throws for these options.
void check_diagram_options(const DiagramOptions& options);

/// `compute_diagram`, where the error of generators that coincide is returned.
OrError<Diagram> try_to_compute_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                        const DiagramOptions& options);

/// `compute_diagram` with windows as the solver. If `read` is not empty, it is called once, at the end, with the
/// windows that `keep` names; with KeepWindows::all they have departures. The order of windows depends on `keep`, so
/// that distances may differ by rounding, and points of bisectors within the chord tolerance.
Diagram compute_diagram_and_read(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                 const DiagramOptions& options, KeepWindows keep, const WindowReader& read);

/// A generator without a cell: by their weights, another generator is nearer even at this generator's own position.
struct HiddenGenerator {
  GeneratorId generator, nearer;
  Error error() const;  ///< the error that `compute_diagram` throws in this case
};

/// The same for weights that may leave a generator without a cell. Instead of throwing an error, it returns the first
/// such generator, and does not call `read`.
std::variant<Diagram, HiddenGenerator> try_to_compute_and_read(const Mesh& mesh,
                                                               const std::vector<SurfacePoint>& generators,
                                                               const DiagramOptions& options, KeepWindows keep,
                                                               const WindowReader& read);

}  // namespace gvd
