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

// What the operations that relax generators share.
namespace gvd {

/// What restricts and weighs a relaxation, as users give it.
struct GivenConstraints {
  GivenPoints fixed;     ///< generators that stay
  GivenNumbers density;  ///< "curvature", or a number for each vertex or face; none: uniform
};

void describe(OptionList& list, GivenConstraints& given);

/// A density out of numbers; uniform without. Throws Error{precondition} for numbers that are none.
Density find_density(const CheckedMesh& input, const GivenNumbers& given);

/// The options for the start of a relaxation, with the generators and what restricts them. `listed` becomes the
/// generators of a list, where there is one.
RelaxationStartOptions make_start_options(const CheckedMesh& input, const GeneratorOptions& generators,
                                          const DiagramOptions& diagram, const GivenConstraints& given,
                                          RelaxationStartOptions options, ResolvedGenerators& listed,
                                          Observer& observer);

/// How far each of `points` is from where it was given, mesh units; nothing for one that has moved since.
std::vector<std::optional<double>> snaps_of_unmoved(const ResolvedGenerators& listed,
                                                    const std::vector<SurfacePoint>& points);

/// Notes how many of a start's generators are fixed, on creases and free, what they do not follow, and why a
/// copy that was asked for is not used. `is_listed`: the generators were not sampled.
void tell_start(Observer& observer, const Mesh& mesh, const RelaxationStart& start,
                const RelaxationStartOptions& options, bool is_listed);

/// Shows iteration and energy from now on.
void show_iteration(Observer& observer, std::int64_t iterations, double energy);

/// Notes what was done on a copy of the mesh.
void tell_copy(Observer& observer, const CoarseRelaxation& used, const RelaxationStart& start, bool ends_on_copy);

/// The part of a relaxation on a copy of the mesh, as figures that begin with `name`.
void visit_copy(ObjectVisitor& visitor, const CoarseRelaxation& copy, const std::string& name = "coarse");

}  // namespace gvd
