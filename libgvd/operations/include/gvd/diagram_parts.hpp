#pragma once

#include <functional>
#include <optional>

#include "gvd/balance.hpp"
#include "gvd/diagram.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"

// What the operations that make diagrams share.
namespace gvd {

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
