// Diagrams inside regions: given ones, those of a mask, and those of the coarser levels of a hierarchy.
//
// The steps are those of gvd-segment, in its order. What belongs to the separated mesh stays with the diagram, which
// itself has the vertices of the input.
#include <optional>
#include <utility>
#include <variant>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "gvd/error.hpp"
#include "gvd/face_regions.hpp"

namespace gvd::python {
namespace {

/// The regions that a diagram keeps to, and where its generators come from.
struct RegionOptions {
  std::optional<Array<double>> within, mask;
  std::vector<std::int32_t> levels;
  bool each_region = false;
  std::string labels;  ///< of the coarser levels
};

/// As many numbers as faces are those of the faces, also where there are as many vertices.
SoupProperty to_numbers(const Mesh& mesh, const Array<double>& array) {
  return {array.size() != mesh.face_count(), std::vector<double>(array.data(), array.data() + array.size())};
}

/// Names the argument in front of an error.
template <class Work>
void name_errors(const char* argument, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    throw Error(error.code(), std::string(argument) + ": " + error.what(), error.element());
  }
}

/// Keeps the regions as they are given among the numbers.
FaceRegions make_regions(const Mesh& mesh, const RegionOptions& options, std::vector<FaceNumbers>& numbers) {
  FaceRegions regions;
  if (options.within) {
    name_errors("within", [&] { regions = make_face_regions(mesh, to_numbers(mesh, *options.within)); });
    numbers.push_back({kRegionName, regions});
  }
  if (options.mask) {
    if (regions.empty()) regions.assign(mesh.face_vertices().size(), 0);
    name_errors("mask", [&] { mask_regions(mesh, to_numbers(mesh, *options.mask), regions); });
    if (options.within) update_numbers(regions, numbers.back().values);
  }
  return regions;
}

/// Labels all levels but the last one, so that `regions` become those of the last level but one.
void label_levels(const Mesh& mesh, const RegionOptions& options, LevelOptions level, FaceRegions& regions,
                  PartedSurface& parted) {
  parted.levels = options.levels.size();
  for (std::size_t i = 0; i + 1 < options.levels.size(); ++i) {
    level.generators.sampling.count = options.levels[i];
    regions = to_regions(label_level(mesh, regions, level));
    parted.numbers.push_back({level_name(i + 1), regions});
  }
}

using Generators = std::variant<PointList, Sampler>;

/// Generators of a mesh that is separated by these regions, or of a whole one.
std::vector<SurfacePoint> make_generators(const Mesh& mesh, const SeparatedMesh& separated, const FaceRegions& regions,
                                          const Generators& given, RegionSamplingOptions sampling) {
  if (const auto* const list = std::get_if<PointList>(&given)) {
    std::vector<SurfacePoint> points = list->points;
    if (!regions.empty()) move_into_regions(mesh, regions, points);
    return points;
  }
  return regions.empty() ? sample_generators(mesh, sampling.sampling)
                         : sample_regions(separated, regions, sampling).points;
}

SharedDiagram make_diagram_inside(const SharedMesh& input, const Generators& given, const ComputeOptions& compute,
                                  const RegionOptions& options, const py::object& progress) {
  LevelOptions level;
  level.diagram = compute.make();
  level.labels.labels = choose("labels", options.labels, kFaceLabelNames);
  if (const auto* const sampler = std::get_if<Sampler>(&given)) level.generators.sampling = sampler->options;
  return run_unlocked(progress, [&](const Progress& reported) {
    level.diagram.progress = level.labels.progress = level.generators.sampling.progress = reported;
    const Mesh& mesh = input->mesh;
    PartedSurface parted;
    FaceRegions regions = make_regions(mesh, options, parted.numbers);
    label_levels(mesh, options, level, regions, parted);
    // A single level without regions is on the input itself, and its labels are named as those of several.
    parted.separated = separate_regions(mesh, regions.empty() ? FaceRegions(mesh.face_vertices().size()) : regions);
    level.generators.each_region = options.each_region;
    const auto points = make_generators(mesh, parted.separated, regions, given, level.generators);
    parted.diagram = compute_diagram(parted.separated.mesh, points, level.diagram);
    auto on_input = std::make_shared<const Diagram>(restrict_to_input(parted.separated, parted.diagram));
    return std::make_shared<MeshDiagram>(
        MeshDiagram{input, std::move(on_input), std::make_shared<const PartedSurface>(std::move(parted))});
  });
}

}  // namespace

void bind_regions(py::module_& module) {
  py::class_<RegionOptions>(module, "RegionOptions")
      .def(py::init([](std::optional<Array<double>> within, std::optional<Array<double>> mask,
                       std::vector<std::int32_t> levels, bool each_region, std::string labels) {
        return RegionOptions{std::move(within), std::move(mask), std::move(levels), each_region, std::move(labels)};
      }));
  module.def("diagram_inside", &make_diagram_inside);
}

}  // namespace gvd::python
