// The table of operations.
#include "gvd/operation.hpp"

#include <algorithm>

#include "gvd/diagram_operation.hpp"
#include "gvd/distances_operation.hpp"
#include "gvd/lloyd_operation.hpp"
#include "gvd/remesh_operation.hpp"
#include "gvd/segment_operation.hpp"

namespace gvd {
namespace {

/// A call of the operation with these options.
template <class Options>
class CallWith : public Call {
 public:
  void describe(OptionList& list) override {
    gvd::describe(list, options_);
    if constexpr (requires { describe_for_programs(list, options_); }) describe_for_programs(list, options_);
  }
  std::shared_ptr<const Object> run(const MeshPtr& input, Observer& observer) override {
    return gvd::run(input, options_, observer);
  }

 private:
  Options options_;
};

template <class Options, class Outcome>
Operation make_operation(std::string_view name, std::string_view summary) {
  return {name, summary, []() -> std::unique_ptr<Call> { return std::make_unique<CallWith<Options>>(); },
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
      make_operation<SegmentCall, SegmentOutcome>(
          "segment", "Labels every face with the region of the geodesically nearest generator, or cuts the faces"),
      make_operation<LloydCall, LloydOutcome>(
          "lloyd", "Moves generators to the geodesic centroids of their cells until they stop moving"),
      make_operation<RemeshCall, RemeshOutcome>(
          "remesh", "Builds a coarse mesh: a vertex for each generator, a triangle for each branch point"),
  };
  return kOperations;
}

const Operation* find_operation(std::string_view name) {
  const auto found = std::ranges::find(operations(), name, &Operation::name);
  return found == operations().end() ? nullptr : &*found;
}

}  // namespace gvd
