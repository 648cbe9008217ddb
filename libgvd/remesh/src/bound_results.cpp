// Diagrams, their faces labelled or cut, as Python and JavaScript have them.
//
// The steps are those of gvd-segment, in its order, and so are the arrays of the files. What belongs to the separated
// mesh stays with the diagram, which itself has the vertices of the input.
#include "bound_results.hpp"

#include <utility>

#include "gvd/disc_cells.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/diagram_json.hpp"

namespace gvd {
namespace {

/// As many numbers as faces are those of the faces, also where there are as many vertices.
SoupProperty to_numbers(const Mesh& mesh, const std::vector<double>& values) {
  return {std::ssize(values) != mesh.face_count(), values};
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
                  PartedDiagram& parted) {
  parted.levels = options.levels.size();
  for (std::size_t i = 0; i + 1 < options.levels.size(); ++i) {
    level.generators.sampling.count = options.levels[i];
    regions = to_regions(label_level(mesh, regions, level));
    parted.numbers.push_back({level_name(i + 1), regions});
  }
}

/// Generators of a mesh that is separated by these regions, or of a whole one.
std::vector<SurfacePoint> make_generators(const Mesh& mesh, const SeparatedMesh& separated, const FaceRegions& regions,
                                          std::vector<SurfacePoint> listed, const RegionSamplingOptions& sampling) {
  if (listed.empty()) {
    return regions.empty() ? sample_generators(mesh, sampling.sampling)
                           : sample_regions(separated, regions, sampling).points;
  }
  if (!regions.empty()) move_into_regions(mesh, regions, listed);
  return listed;
}

/// The labels and distances of a diagram, and the bisectors on the surface that it was made on.
LabelledMesh label_surface(const MeshDiagram& of, const IdVector<FaceId, GeneratorId>& faces) {
  LabelledMesh mesh = label_mesh(of.mesh(), *of.diagram, faces);
  mesh.diagram = &of.surface_diagram();
  mesh.diagram_mesh = &of.surface();
  mesh.appearance = &of.input->appearance;
  return mesh;
}

}  // namespace

void PartedDiagram::add_labels(const IdVector<FaceId, GeneratorId>& labels, std::vector<FaceNumbers>& to) const {
  if (levels > 0) to.push_back({level_name(levels), to_regions(labels)});
}

SharedMesh Cut::mesh() const {
  auto checked = std::make_shared<CheckedMesh>(as_input(cut.mesh));
  checked->appearance = appearance;
  return checked;
}

MeshDiagram compute_diagram_inside(const SharedMesh& input, const RegionOptions& options, LevelOptions level) {
  const Mesh& mesh = input->mesh;
  PartedDiagram parted;
  FaceRegions regions = make_regions(mesh, options, parted.numbers);
  label_levels(mesh, options, level, regions, parted);
  // A single level without regions is on the input itself, and its labels are named as those of several.
  parted.separated = separate_regions(mesh, regions.empty() ? FaceRegions(mesh.face_vertices().size()) : regions);
  const auto points = make_generators(mesh, parted.separated, regions, options.listed, level.generators);
  parted.diagram = compute_diagram(parted.separated.mesh, points, level.diagram);
  auto on_input = std::make_shared<const Diagram>(restrict_to_input(parted.separated, parted.diagram));
  return {input, std::move(on_input), std::make_shared<const PartedDiagram>(std::move(parted))};
}

MeshDiagram make_cells_discs(const MeshDiagram& of, const DiagramOptions& options) {
  auto made = std::make_shared<Diagram>(make_discs(of.surface(), of.surface_diagram(), {options, {}}).diagram);
  if (!of.parted) return {of.input, std::move(made)};
  auto parted = std::make_shared<PartedDiagram>(*of.parted);
  parted->diagram = std::move(*made);
  *made = restrict_to_input(parted->separated, parted->diagram);
  return {of.input, std::move(made), std::move(parted)};
}

Segmented segment_diagram(const MeshDiagram& of, const SegmentOptions& options) {
  Segmented made{of, segment_faces(of.surface(), of.surface_diagram(), options)};
  if (of.parted) {
    made.numbers = of.parted->numbers;
    of.parted->add_labels(made.segmentation.face_label, made.numbers);
  }
  return made;
}

Cut cut_diagram(const MeshDiagram& of, const std::optional<ChartMap>& charts, const Progress& progress) {
  CutMesh faces = cut_faces(of.mesh(), of.surface_diagram(), progress);
  CutVertices vertices = carry_to_cut_vertices(of.surface(), of.surface_diagram(), faces);
  if (of.parted) {
    faces.numbers = carry_to_cut_faces(of.parted->numbers, faces);
    of.parted->add_labels(faces.label, faces.numbers);
  }
  Cut made{of, std::move(faces), std::move(vertices), {}};
  made.appearance = carry_to_cut_faces(of.mesh(), of.input->appearance, made.cut);
  if (charts) {
    made.charts = make_charts(of.surface(), of.surface_diagram(), made.cut, {.map = *charts, .progress = progress});
    replace_texture(std::exchange(made.charts.texture, {}), made.appearance);
  }
  return made;
}

LabelledMesh labelled(const MeshDiagram& of) { return label_surface(of, of.surface_diagram().face_label); }

LabelledMesh labelled(const Segmented& made) {
  LabelledMesh mesh = label_surface(made.of, made.segmentation.face_label);
  mesh.face_numbers = &made.numbers;
  return mesh;
}

LabelledMesh labelled(const Cut& made) {
  LabelledMesh mesh{made.cut.mesh,        &made.cut.label,         &made.cut.parent,
                    &made.vertices.label, &made.vertices.distance, &made.of.surface_diagram(),
                    &made.of.surface()};
  mesh.face_numbers = &made.cut.numbers;
  mesh.appearance = &made.appearance;
  return mesh;
}

OwnFormats own_formats(const MeshDiagram& of) {
  const auto list = [&of](GeneratorFormat format) {
    return [&of, format](std::ostream& out) { out << format_generators(of.mesh(), of.diagram->generators, format); };
  };
  return {{"json", [&of](std::ostream& out) { write_diagram_json(out, of.mesh(), *of.diagram); }},
          {"txt", list(GeneratorFormat::text)},
          {"csv", list(GeneratorFormat::csv)}};
}

OwnFormats own_formats(const Segmented& made) {
  return {{"json", [&made](std::ostream& out) {
             write_segmentation_json(out, made.of.mesh(), *made.of.diagram, made.segmentation, made.numbers);
           }}};
}

OwnFormats own_formats(const Cut& made) {
  return {{"json", [&made](std::ostream& out) {
             write_cut_json(out, made.of.mesh(), *made.of.diagram, made.cut, made.vertices);
           }}};
}

}  // namespace gvd
