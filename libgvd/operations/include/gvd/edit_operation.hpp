#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "gvd/generator_options.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"

namespace gvd {

/// The options of the operation `edit`, which works on a diagram: exactly one of `move`, `add` and `remove` is set.
struct EditCall {
  std::optional<std::int32_t> move, remove;  ///< the number of a generator
  GivenPoints to;                            ///< where `move` goes: a single point
  GivenPoints add;
  std::optional<double> max_snap;  ///< largest snap distance of points, mesh units, >= 0
};

void describe(OptionList& list, EditCall& call);

/// The result of `edit`: a diagram after a change of its generators, with the editor for the next change.
class EditOutcome : public DiagramObject {
 public:
  EditOutcome() = default;
  EditOutcome(DiagramObject diagram, std::int32_t propagated)
      : DiagramObject(std::move(diagram)), propagated_(propagated) {}
  void visit(ObjectVisitor& visitor) const override;

 private:
  std::int32_t propagated_ = 0;
};

/// Returns the diagram after a change of its generators. `on` does not change, but its editor moves to the result. If
/// `on` has no editor, because it was edited before, a new editor computes the diagram again. Throws what
/// `resolve_generators`, `take_editor` and DiagramEditor throw; `on` then keeps its editor.
/// Cost: a change of DiagramEditor, or a new diagram if `on` has no editor.
std::shared_ptr<const EditOutcome> run(const DiagramObject& on, EditCall& call, Observer& observer);

}  // namespace gvd
