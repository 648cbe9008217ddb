#pragma once

#include <functional>
#include <optional>

#include "gvd/balance.hpp"
#include "gvd/diagram.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/given_regions.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"
#include "gvd/parted_mesh.hpp"

// Options and steps that the operations that make diagrams share.
namespace gvd {

/// Weights of the generators: given weights, or shares that the cells must have by weights that are searched for.
struct GivenWeights {
  GivenNumbers balance;  ///< "area", or a density for each vertex or face; none: cells are not balanced
  GivenNumbers shares;   ///< a number > 0 for each generator, in any unit; none: equal shares
  GivenNumbers weights;  ///< a number for each generator, mesh units; with `balance`, where the search starts
};

/// The options of a diagram: its generators, how to compute it, and the regions that its cells keep to.
struct DiagramParts {
  GeneratorOptions generators;  ///< points or curves
  DiagramOptions diagram;
  GivenWeights weights;
  GivenRegions regions;
};

void describe(OptionList& list, GivenWeights& weights, const DiagramOptions& diagram);

/// Describes `balance`, which needs the exact method. `help`: what it does, without the quantity that becomes equal.
void describe_balance(OptionList& list, GivenNumbers& balance, const std::string& help, const DiagramOptions& diagram);
/// Adds the rules that exclude other options if curves are the generators: weights, regions, and options of sampled
/// points.
void describe_curve_rules(OptionList& list, const DiagramOptions& diagram);

/// Chooses generators and computes their diagram on the surface of `parted`, balanced if the options ask for it. Sets
/// `found` if the generators are points, and `balanced` if the cells were balanced. `each`: the number of generators is
/// per region. Throws what `choose_inside`, `choose_curves`, `compute_diagram` and `balance_cells` throw, and
/// Error{precondition} if a weight or share is out of its range. Throws Error{invalid_option}, or
/// Error{unreadable_input} for a file, if there is not one number for each generator.
Diagram compute_parts(const CheckedMesh& input, PartedMesh& parted, const DiagramParts& parts, bool each,
                      Observer& observer, ResolvedGenerators& found, std::optional<BalancedDiagram>& balanced);

using DiagramMaker = std::function<Diagram(const DiagramOptions&)>;

/// Computes a diagram as the step `diagram`. The library's own steps are steps inside it, named "diagram: NAME".
Diagram compute_in_steps(Observer& observer, DiagramOptions options, const DiagramMaker& compute);

/// Notes how equal the cells are, and which cells missed their share.
void tell_balance(Observer& observer, const BalancedDiagram& balanced);

/// Visits the same as figures, which are empty if the cells were not balanced.
void visit_balance(ObjectVisitor& visitor, const std::optional<BalancedDiagram>& balanced);

/// Notes the numbers of cells, branch points and bisectors, and any defects.
void tell_diagram(Observer& observer, const Diagram& diagram);

}  // namespace gvd
