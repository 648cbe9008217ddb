#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/balance.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"
#include "gvd/parted_mesh.hpp"
#include "gvd/segment_operation.hpp"

// The operations `sample` and `diagram`: points on a surface, and their diagram.
namespace gvd {

/// The options of the operation `sample`.
struct SampleCall {
  GeneratorOptions generators;
  GivenPoints points;  ///< in place of generators: points to move to the surface; they may coincide
};

void describe(OptionList& list, SampleCall& call);

/// The result of `sample`: points on a mesh.
class SampleOutcome : public Object {
 public:
  std::string_view kind() const override { return "sample"; }
  void visit(ObjectVisitor& visitor) const override;

  MeshPtr input = std::make_shared<CheckedMesh>();
  ResolvedGenerators found;
};

/// Chooses points in the same way as generators. Throws what `choose_generators` throws. Cost: the cost of the
/// sampling.
std::shared_ptr<const SampleOutcome> run(const MeshPtr& input, SampleCall& call, Observer& observer);

/// The options of the operation `diagram`.
struct DiagramCall : DiagramParts {
  bool editable = false;  ///< keep an editor, so that the operation `edit` is fast
};

void describe(OptionList& list, DiagramCall& call);

/// The result of `diagram`: a diagram with the regions that it keeps to, and how equal its cells are if they were
/// balanced.
class DiagramOutcome : public DiagramObject {
 public:
  DiagramOutcome() = default;
  DiagramOutcome(DiagramObject diagram, std::optional<BalancedDiagram> balanced)
      : DiagramObject(std::move(diagram)), balanced_(std::move(balanced)) {}
  void visit(ObjectVisitor& visitor) const override;

 private:
  std::optional<BalancedDiagram> balanced_;
};

/// Chooses generators, and computes their diagram. Replaces options such as `auto` in `call` by the values used. Throws
/// what its steps throw: `choose_inside`, `choose_curves`, `compute_diagram` and `balance_cells`.
std::shared_ptr<const DiagramOutcome> run(const MeshPtr& input, DiagramCall& call, Observer& observer);

}  // namespace gvd
