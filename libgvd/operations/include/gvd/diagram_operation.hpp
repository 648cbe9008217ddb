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

// Two operations that other ones begin with: points on a surface, and their diagram.
namespace gvd {

/// The options of the operation `sample`.
struct SampleCall {
  GeneratorOptions generators;
  GivenPoints points;  ///< to move to the surface, in place of generators; they may be in the same place
};

void describe(OptionList& list, SampleCall& call);

/// Points on a mesh.
class SampleOutcome : public Object {
 public:
  std::string_view kind() const override { return "sample"; }
  void visit(ObjectVisitor& visitor) const override;

  MeshPtr input = std::make_shared<CheckedMesh>();
  ResolvedGenerators found;
};

/// Chooses points as generators are chosen. Throws what choose_generators throws.
std::shared_ptr<const SampleOutcome> run(const MeshPtr& input, SampleCall& call, Observer& observer);

/// The options of the operation `diagram`.
struct DiagramCall : DiagramParts {
  bool editable = false;  ///< keep what edits need
};

void describe(OptionList& list, DiagramCall& call);

/// A diagram, how equal its cells are where they were balanced, and the regions that they keep to.
class DiagramOutcome : public DiagramObject {
 public:
  DiagramOutcome() = default;
  DiagramOutcome(DiagramObject diagram, std::optional<BalancedDiagram> balanced)
      : DiagramObject(std::move(diagram)), balanced_(std::move(balanced)) {}
  void visit(ObjectVisitor& visitor) const override;

 private:
  std::optional<BalancedDiagram> balanced_;
};

/// Chooses generators, and computes their diagram. Options become what they stand for. Throws what its steps throw.
std::shared_ptr<const DiagramOutcome> run(const MeshPtr& input, DiagramCall& call, Observer& observer);

}  // namespace gvd
