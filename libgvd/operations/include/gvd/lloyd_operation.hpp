#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "gvd/balance.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"
#include "gvd/parted_mesh.hpp"
#include "gvd/relaxation_parts.hpp"

namespace gvd {

/// The options of the operation `lloyd`.
struct LloydCall {
  GeneratorOptions generators;
  DiagramOptions diagram;
  LloydOptions relaxation;
  RelaxationStartOptions start;
  GivenConstraints constraints;
  GivenRegions regions;
  /// "area" or a density, of which the final cells have equal shares; none: cells are not balanced.
  GivenNumbers balance;
};

void describe(OptionList& list, LloydCall& call);

/// The step in which generators move.
inline constexpr const char* kRelaxationStep = "relaxation";

// Names of the iterations of a relaxation in files and results.

/// How an iteration's energy was measured: the name of a method, or `sampled` without a diagram.
std::string_view measure_name(const LloydIteration& iteration);

/// How the step of an iteration was found, as a single word.
std::string_view step_name(const LloydIteration& iteration);

/// The result of `lloyd`: relaxed generators with their diagram.
class LloydOutcome : public Object {
 public:
  static constexpr Content kContent = DiagramObject::kContent;
  std::string_view kind() const override { return "lloyd"; }
  Content content() const override { return kContent; }
  void visit(ObjectVisitor& visitor) const override;
  std::optional<LabelledMesh> labelled() const override { return diagram->labelled(); }
  OwnWriters own_writers() const override { return diagram->own_writers(); }
  OwnWriters part_writers(std::string_view part) const override;

  /// After balancing, if the cells were balanced.
  std::shared_ptr<const LloydResult> relaxed = std::make_shared<LloydResult>();
  /// The diagram of the relaxed generators.
  std::shared_ptr<const DiagramObject> diagram = std::make_shared<DiagramObject>();
  std::optional<BalancedRelaxation> balanced;  ///< if the cells were balanced; without the diagram
  /// How far each listed generator was moved to the surface; nothing for a generator that the relaxation moved.
  std::vector<std::optional<double>> snap_distance;
};

/// Relaxes generators and balances their cells if the options ask for it. Replaces options such as `auto` in `call` by
/// the values used. Throws what `choose_generators`, `start_relaxation`, `relax_generators` and `relax_balanced` throw.
std::shared_ptr<const LloydOutcome> run(const MeshPtr& input, LloydCall& call, Observer& observer);

}  // namespace gvd
