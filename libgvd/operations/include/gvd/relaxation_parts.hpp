#pragma once

#include <cstdint>
#include <string>

#include "gvd/density.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"
#include "gvd/relaxation_start.hpp"

// Options and notes that the operations that relax generators share.
namespace gvd {

/// Fixed generators and the density of a relaxation, as users give them.
struct GivenConstraints {
  GivenPoints fixed;     ///< generators that must not move
  GivenNumbers density;  ///< "curvature", or a number for each vertex or face; none: uniform
};

void describe(OptionList& list, GivenConstraints& given);

/// Makes a density of the given numbers; uniform if there are none. Throws Error{precondition} for numbers that are no
/// valid density.
Density find_density(const CheckedMesh& input, const GivenNumbers& given);

/// Completes the options for the start of a relaxation with the generators and their constraints. Sets `listed` to the
/// generators of a list, if there is one.
RelaxationStartOptions make_start_options(const CheckedMesh& input, const GeneratorOptions& generators,
                                          const DiagramOptions& diagram, const GivenConstraints& given,
                                          RelaxationStartOptions options, ResolvedGenerators& listed,
                                          Observer& observer);

/// How far each of `points` was moved to the surface, in mesh units; nothing for a point that has moved since.
std::vector<std::optional<double>> snaps_of_unmoved(const ResolvedGenerators& listed,
                                                    const std::vector<SurfacePoint>& points);

/// Notes how many of a start's generators are fixed, on creases and free, which curves they do not follow, and why a
/// requested copy is not used. `is_listed`: the generators were not sampled.
void tell_start(Observer& observer, const Mesh& mesh, const RelaxationStart& start,
                const RelaxationStartOptions& options, bool is_listed);

/// Reports an iteration with its energy as the status.
void show_iteration(Observer& observer, std::int64_t iterations, double energy);

/// Notes which part of the relaxation ran on a copy of the mesh.
void tell_copy(Observer& observer, const CoarseRelaxation& used, const RelaxationStart& start, bool ends_on_copy);

/// Visits the figures of a relaxation on a copy of the mesh. Their names begin with `name`.
void visit_copy(ObjectVisitor& visitor, const CoarseRelaxation& copy, const std::string& name = "coarse");

}  // namespace gvd
