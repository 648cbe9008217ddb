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
#include "gvd/program_operations.hpp"
#include "gvd/remesh_operation.hpp"
#include "gvd/scene_operation.hpp"
#include "gvd/segment_operation.hpp"

namespace gvd {
namespace {

/// Finds the name of a part by its kind.
struct PartFinder : ObjectVisitor {
  void part(const Meaning& meaning, std::string_view kind, const PartMaker& make) override {
    if (name.empty() && kind == wanted && make()) name = meaning.name;
  }
  std::string_view wanted;
  std::string name = {};  ///< empty if there is none
};

/// The object that an operation works on, as its type.
template <class Kind>
const Kind& cast(const Object& object, std::string_view wanted) {
  const auto* const taken = dynamic_cast<const Kind*>(&object);
  if (taken != nullptr) return *taken;
  PartFinder finder;
  finder.wanted = wanted;
  object.visit(finder);
  throw Error(ErrorCode::invalid_option,
              fmt::format("this takes a {}, and the object is a {}{}", wanted, object.kind(),
                          finder.name.empty() ? "" : fmt::format("; take its part \"{}\"", finder.name)));
}

/// A call of the operation that has these options and takes an object of this kind.
template <class Options, class Kind>
class CallWith : public Call {
 public:
  void describe(OptionList& list) override {
    gvd::describe(list, options_);
    if constexpr (requires { describe_for_programs(list, options_); }) describe_for_programs(list, options_);
  }
  void take(std::span<const ArrayView> arrays) override {
    if constexpr (requires { options_.arrays; }) options_.arrays.assign(arrays.begin(), arrays.end());
  }
  std::shared_ptr<const Object> run(const std::shared_ptr<const Object>& on, Observer& observer) override {
    if constexpr (std::is_void_v<Kind>) {
      return gvd::run(options_, observer);
    } else if constexpr (std::is_abstract_v<Kind>) {  // objects of several kinds
      return gvd::run(*on, options_, observer);
    } else if constexpr (std::is_same_v<Kind, MeshObject>) {
      return gvd::run(cast<MeshObject>(*on, "mesh").mesh(), options_, observer);
    } else {
      return gvd::run(cast<Kind>(*on, Kind().kind()), options_, observer);
    }
  }

 private:
  Options options_;
};

template <class Options, class Outcome, class Kind = MeshObject>
Operation make_operation(std::string_view name, std::string_view summary) {
  std::string_view on;
  if constexpr (std::is_abstract_v<Kind>) {
    on = kSceneSubjects;
  } else if constexpr (!std::is_void_v<Kind>) {
    on = Kind().kind();  // a text that lives as long as the program
  }
  return {name, summary, on, []() -> std::unique_ptr<Call> { return std::make_unique<CallWith<Options, Kind>>(); },
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
          "edit", "Moves, adds or removes a generator of a diagram, and updates only what changed"),
      make_operation<LabelCall, SegmentOutcome, DiagramObject>(
          "label", "Labels the faces of a mesh by the cells of its diagram, or cuts them along the bisectors"),
      make_operation<SegmentCall, SegmentOutcome>(
          "segment", "Labels every face with the region of the geodesically nearest generator, or cuts the faces"),
      make_operation<LloydCall, LloydOutcome>(
          "lloyd", "Moves generators to the geodesic centroids of their cells until they stop moving"),
      make_operation<RemeshCall, RemeshOutcome>(
          "remesh", "Builds a coarse mesh: a vertex for each generator, a triangle for each branch point"),
      make_operation<MapCall, RemeshOutcome, RemeshOutcome>("map",
                                                            "Maps the vertices of a mesh to its remesh, and back"),
      make_operation<CheckCall, CheckOutcome, DiagramObject>("check", "Tests every invariant of a diagram"),
      make_operation<SceneCall, SceneObject, Object>("scene", "Makes a picture for the page"),
      make_operation<CurvesCall, CurvesOutcome>("curves",
                                                "Finds or makes the curves of a mesh that serve as generators"),
      make_operation<MeshCall, MeshObject, void>("mesh", "Makes a mesh of two arrays or of a file"),
      make_operation<SavedMeshCall, MeshObject, void>("saved_mesh", "Makes a mesh of all arrays that a mesh has"),
      make_operation<ValuesCall, NumbersObject, void>("values",
                                                      "Reads the numbers that a file has for vertices or faces"),
      make_operation<PropertiesCall, NumbersObject, void>("properties", "Reads the properties of a file of a mesh"),
  };
  return kOperations;
}

const MeshPtr& mesh_of(const Operation& operation, const Object& object) {
  if (operation.on == kSceneSubjects) {
    if (const auto* const distances = dynamic_cast<const DistancesOutcome*>(&object)) return distances->input;
    if (const auto* const remesh = dynamic_cast<const RemeshOutcome*>(&object)) return remesh->input;
  }
  if (operation.on == "mesh") return cast<MeshObject>(object, "mesh").mesh();
  if (operation.on == "remesh") return cast<RemeshOutcome>(object, "remesh").input;
  return cast<DiagramObject>(object, operation.on).mesh();
}

const Operation* find_operation(std::string_view name) {
  const auto found = std::ranges::find(operations(), name, &Operation::name);
  return found == operations().end() ? nullptr : &*found;
}

}  // namespace gvd
