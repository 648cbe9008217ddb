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
  GivenNumbers balance;  ///< what cells share in the end: "area" or numbers; none: as they come
};

void describe(OptionList& list, LloydCall& call);

/// The step in which generators move.
inline constexpr const char* kRelaxationStep = "relaxation";

// What files and results call the iterations of a relaxation.

/// The measure of an iteration's energy: the name of a method, or `sampled` without a diagram.
std::string_view measure_name(const LloydIteration& iteration);

/// How the step of an iteration was found, in one word.
std::string_view step_name(const LloydIteration& iteration);

/// Relaxed generators with their diagram.
class LloydOutcome : public Object {
 public:
  static constexpr Content kContent = DiagramObject::kContent;
  std::string_view kind() const override { return "lloyd"; }
  Content content() const override { return kContent; }
  void visit(ObjectVisitor& visitor) const override;
  std::optional<LabelledMesh> labelled() const override { return diagram->labelled(); }
  OwnWriters own_writers() const override { return diagram->own_writers(); }
  OwnWriters part_writers(std::string_view part) const override;

  std::shared_ptr<const LloydResult> relaxed = std::make_shared<LloydResult>();      ///< with balanced cells at the end
  std::shared_ptr<const DiagramObject> diagram = std::make_shared<DiagramObject>();  ///< of the relaxed generators
  std::optional<BalancedRelaxation> balanced;                                        ///< without its diagram
  /// How far each generator is from where it was given; nothing for one that is somewhere else now.
  std::vector<std::optional<double>> snap_distance;
};

/// Relaxes generators and, where that is asked for, balances their cells. Options become what they stand for. Throws
/// what choose_generators, start_relaxation, relax_generators and relax_balanced throw.
std::shared_ptr<const LloydOutcome> run(const MeshPtr& input, LloydCall& call, Observer& observer);

}  // namespace gvd
