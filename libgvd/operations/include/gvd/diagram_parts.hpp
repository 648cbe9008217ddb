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

// What the operations that make diagrams share.
namespace gvd {

/// Weights of the generators: given ones, and those by which the cells have their shares.
struct GivenWeights {
  GivenNumbers balance;  ///< "area", or a number for each vertex or face; none: cells as they come
  GivenNumbers shares;   ///< of the generators; none: equal ones
  GivenNumbers weights;  ///< of the generators, for `balance` to start from
};

/// The options of a diagram's generators, of how it is computed, and of what its cells keep to.
struct DiagramParts {
  GeneratorOptions generators;  ///< points or curves
  DiagramOptions diagram;
  GivenWeights weights;
  GivenRegions regions;
};

void describe(OptionList& list, GivenWeights& weights, const DiagramOptions& diagram);

/// Describes `balance`, for whose weights only the exact method serves. `help`: what it does, without what becomes
/// equal.
void describe_balance(OptionList& list, GivenNumbers& balance, const std::string& help, const DiagramOptions& diagram);
/// Says what curves as generators do not go with: weights, regions, and what is of sampled points.
void describe_curve_rules(OptionList& list, const DiagramOptions& diagram);

/// Computes the diagram of the generators on the surface, where regions part it, balanced where that is asked for. The
/// points and the balance are set where there are any. `each`: the number of generators is that of each region. Throws
/// what choose_inside, choose_curves, compute_diagram and balance_cells throw, and Error{precondition} where there is
/// not one number for each generator, or one is out of its range.
Diagram compute_parts(const CheckedMesh& input, PartedMesh& parted, const DiagramParts& parts, bool each,
                      Observer& observer, ResolvedGenerators& found, std::optional<BalancedDiagram>& balanced);

using DiagramMaker = std::function<Diagram(const DiagramOptions&)>;

/// Makes a diagram in the step `diagram`; what the library calls steps is inside it, as "diagram: NAME".
Diagram compute_in_steps(Observer& observer, DiagramOptions options, const DiagramMaker& compute);

/// Notes how equal the cells are, and which have no share of their own.
void tell_balance(Observer& observer, const BalancedDiagram& balanced);

/// The same as figures, which are empty without a diagram.
void visit_balance(ObjectVisitor& visitor, const std::optional<BalancedDiagram>& balanced);

/// Notes the numbers of cells, branch points and bisectors, and what is wrong with them.
void tell_diagram(Observer& observer, const Diagram& diagram);

}  // namespace gvd
