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
  std::optional<std::int32_t> move, remove;  ///< a generator
  GivenPoints to;                            ///< one point, for the generator that moves
  GivenPoints add;
  std::optional<double> max_snap;  ///< largest snap distance of points, mesh units, >= 0
};

void describe(OptionList& list, EditCall& call);

/// A diagram after a change of its generators. It has the editor that its next change needs.
class EditOutcome : public DiagramObject {
 public:
  EditOutcome() = default;
  EditOutcome(DiagramObject diagram, std::int32_t propagated)
      : DiagramObject(std::move(diagram)), propagated_(propagated) {}
  void visit(ObjectVisitor& visitor) const override;

 private:
  std::int32_t propagated_ = 0;
};

/// Changes the generators of a diagram, which stays as it is but for its editor: the result has that. Where `on` has
/// none, since it was edited before, a new one computes it again. Throws what resolve_generators, take_editor and
/// DiagramEditor throw; `on` can be edited as before then.
std::shared_ptr<const EditOutcome> run(const DiagramObject& on, EditCall& call, Observer& observer);

}  // namespace gvd
