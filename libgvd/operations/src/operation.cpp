// The table of operations.
#include "gvd/operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "gvd/diagram_operation.hpp"
#include "gvd/distances_operation.hpp"
#include "gvd/edit_operation.hpp"
#include "gvd/error.hpp"
#include "gvd/lloyd_operation.hpp"
#include "gvd/remesh_operation.hpp"
#include "gvd/segment_operation.hpp"

namespace gvd {
namespace {

/// What an operation works on.
template <class Kind>
const Kind& take(const Object& object, std::string_view wanted) {
  const auto* const taken = dynamic_cast<const Kind*>(&object);
  if (taken != nullptr) return *taken;
  throw Error(ErrorCode::invalid_option, fmt::format("this takes a {}, and the object is a {}", wanted, object.kind()));
}

/// A call of the operation with these options, on an object of this kind.
template <class Options, class Kind>
class CallWith : public Call {
 public:
  void describe(OptionList& list) override {
    gvd::describe(list, options_);
    if constexpr (requires { describe_for_programs(list, options_); }) describe_for_programs(list, options_);
  }
  std::shared_ptr<const Object> run(const std::shared_ptr<const Object>& on, Observer& observer) override {
    if constexpr (std::is_same_v<Kind, MeshObject>) {
      return gvd::run(take<MeshObject>(*on, "mesh").mesh(), options_, observer);
    } else {
      return gvd::run(take<Kind>(*on, "diagram"), options_, observer);
    }
  }

 private:
  Options options_;
};

template <class Options, class Outcome, class Kind = MeshObject>
Operation make_operation(std::string_view name, std::string_view summary) {
  return {name, summary, std::is_same_v<Kind, MeshObject> ? "mesh" : "diagram",
          []() -> std::unique_ptr<Call> { return std::make_unique<CallWith<Options, Kind>>(); },
          []() -> std::shared_ptr<const Object> { return std::make_shared<Outcome>(); }};
}

}  // namespace

const std::vector<Operation>& operations() {
  static const std::vector<Operation> kOperations{
      make_operation<DistancesCall, DistancesOutcome>(
          "distances", "Measures exact distances from points or curves, with shortest paths and isolines"),
      make_operation<SampleCall, SampleOutcome>("sample",
                                                "Spreads points over the surface, or moves those of a list to it"),
      make_operation<DiagramCall, DiagramOutcome>("diagram", "Computes the Voronoi diagram of points or curves"),
      make_operation<EditCall, EditOutcome, DiagramObject>(
          "edit", "Moves, adds or removes a generator of a diagram, and computes what changes with it"),
      make_operation<LabelCall, SegmentOutcome, DiagramObject>(
          "label", "Labels the faces of a mesh by the cells of its diagram, or cuts them along the bisectors"),
      make_operation<SegmentCall, SegmentOutcome>(
          "segment", "Labels every face with the region of the geodesically nearest generator, or cuts the faces"),
      make_operation<LloydCall, LloydOutcome>(
          "lloyd", "Moves generators to the geodesic centroids of their cells until they stop moving"),
      make_operation<RemeshCall, RemeshOutcome>(
          "remesh", "Builds a coarse mesh: a vertex for each generator, a triangle for each branch point"),
  };
  return kOperations;
}

const MeshPtr& mesh_of(const Object& object) {
  const auto* const diagram = dynamic_cast<const DiagramObject*>(&object);
  return diagram != nullptr ? diagram->mesh() : take<MeshObject>(object, "mesh").mesh();
}

const Operation* find_operation(std::string_view name) {
  const auto found = std::ranges::find(operations(), name, &Operation::name);
  return found == operations().end() ? nullptr : &*found;
}

}  // namespace gvd
