// The operations `sample` and `diagram`.

#include "gvd/diagram_operation.hpp"

#include <limits>
#include <utility>

#include "figures.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/diagram_parts.hpp"

namespace gvd {

void describe(OptionList& list, SampleCall& call) {
  describe(list, call.generators, {"points"});
  list.option("points", PointList{&call.points},
              {.help = "Points to move to the surface, in place of generators; they may coincide"});
  list.excludes("points", {"sampling", "seed", "merge_coincident"});
}

void SampleOutcome::visit(ObjectVisitor& visitor) const {
  const Figures figure(visitor);
  figure("count", "", "number of points", found.points.size());
  figure("merged", "", "points that were merged with earlier ones", found.merged);
  figure(
      "snap_distances", "mesh units", "from where each point was given; none for others",
      each_of(found.snap_distance, [](const auto& d) { return d.value_or(std::numeric_limits<double>::quiet_NaN()); }));
  visitor.points({"points", "", "in the order of the list, or as they were sampled"}, found.points);
  visitor.array({"vertices", "", "of the input, that the points were given as; -1: none"}, view(found.vertex));
}

std::shared_ptr<const SampleOutcome> run(const MeshPtr& input, SampleCall& call, Observer& observer) {
  auto outcome = std::make_shared<SampleOutcome>();
  outcome->input = input;
  if (call.points.is_given()) {
    call.generators.points = call.points;
    outcome->found = resolve_listed(*input, call.generators, observer, true);
  } else {
    outcome->found = choose_generators(*input, call.generators, {}, observer);
  }
  return outcome;
}

void describe(OptionList& list, DiagramCall& call) {
  describe(list, call.generators, {"curves"});
  describe_curves(list, call.generators);
  describe(list, call.diagram);
  describe(list, call.weights, call.diagram);
  describe(list, call.regions, "cells and distances");
  list.option(
      "editable", Flag{&call.editable},
      {.help = "Keep what an edit of the diagram needs, some 450 bytes a face, so that the first edit is as quick "
               "as the next"});
  const std::string why = "only a diagram of points on the whole mesh, without weights, can be edited";
  list.excludes("editable", {"curves", "balance", "weights", "within", "mask"}, why);
  list.rule({"editable", {"method"}, [&call](const Given&) -> std::string {
               return call.diagram.method == Method::exact ? "" : "\1editable\2 needs \1method=exact\2";
             }});
  describe_curve_rules(list, call.diagram);
}

void DiagramOutcome::visit(ObjectVisitor& visitor) const {
  DiagramObject::visit(visitor);
  visit_balance(visitor, balanced_);
  visit_parted(visitor, parted());
}

std::shared_ptr<const DiagramOutcome> run(const MeshPtr& input, DiagramCall& call, Observer& observer) {
  call.diagram.threads = observer.threads;
  std::optional<BalancedDiagram> balanced;
  std::unique_ptr<DiagramEditor> editor;
  PartedMesh parted = find_parted(*input, call.regions, observer);
  separate(input->mesh, parted, observer);
  auto made = std::make_shared<Diagram>();
  ResolvedGenerators found;
  if (call.editable) {
    found = choose_generators(*input, call.generators, call.diagram, observer);
    *made = compute_in_steps(observer, call.diagram, [&](const DiagramOptions& stepped) {
      editor = std::make_unique<DiagramEditor>(input->mesh, found.points, stepped);
      return editor->diagram();
    });
    tell_diagram(observer, *made);
  } else {
    *made = compute_parts(*input, parted, call, false, observer, found, balanced);
  }
  resolve(call.diagram);
  const auto regions = std::make_shared<const PartedMesh>(std::move(parted));
  auto outcome = std::make_shared<DiagramOutcome>(DiagramObject(input, std::move(made), call.diagram, regions),
                                                  std::move(balanced));
  if (editor) outcome->keep(std::move(editor));
  return outcome;
}

}  // namespace gvd
