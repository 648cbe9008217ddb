// What the playground shows: scenes as those of a page of --view, all in the coordinates of one mesh.
//
// A page is made once; here scenes follow each other while a generator moves. So the frame stays that of the mesh, and
// a region keeps its colour as far as its neighbours allow.
#include "scenes.hpp"

#include <nlohmann/json.hpp>

#include "gvd/exact_field.hpp"
#include "gvd/io/distance_writer.hpp"
#include "io/writers/region_colors.hpp"

namespace gvd::web {
namespace {

constexpr int kIsolines = 12;              ///< levels up to the largest distance
constexpr double kScreenTolerance = 1e-3;  ///< of isolines, mean edge lengths

io::ViewFrame frame_of(const Mesh& mesh) {
  ViewScene plain;
  plain.mesh = &mesh;
  return io::compute_view_frame({plain});
}

}  // namespace

Scenes::Scenes(SharedMesh input) : input_(std::move(input)), frame_(frame_of(input_->mesh)) {}

val Scenes::show(ViewScene scene) {
  io::check_view_scene(scene);
  if (scene.region_color.empty() && !scene.cells.empty()) {
    const auto adjacent = io::find_adjacent_regions(scene);
    colors_ = colors_.empty() ? io::choose_region_colors(scene.cells.size(), adjacent)
                              : io::adapt_region_colors(colors_, scene.cells.size(), adjacent);
    scene.region_color = colors_;
  }
  io::ViewBlobs blobs;
  const nlohmann::json manifest = io::make_view_manifest({std::move(scene)}, frame_, {}, blobs);
  val arrays = val::array();
  for (const std::string* bytes : blobs.all()) arrays.call<void>("push", to_bytes(*bytes));
  return object({{"manifest", val(manifest.dump())}, {"blobs", arrays}});
}

val Scenes::of_diagram(const MeshDiagram& of) {
  return guarded([&] { return show(make_view_scene("", input_->mesh, *of.diagram)); });
}

val Scenes::of_distances(const val& points) {
  return guarded([&] {
    const Mesh& mesh = input_->mesh;
    DistanceTable table;
    table.sources = resolve(mesh, "points", points);
    const ExactField field(mesh, table.sources);
    double largest = 0;
    for (const VertexId v : mesh.vertices()) {
      if (std::isfinite(field.distance(v))) largest = std::max(largest, field.distance(v));
    }
    std::vector<double> levels;
    for (int i = 1; i <= kIsolines; ++i) levels.push_back(largest * i / (kIsolines + 1));
    // Seen while a generator is dragged: a third of the points, and no difference on a screen.
    if (largest > 0) table.isolines = field.isolines(levels, {.chord_tolerance = kScreenTolerance});
    return show(make_distance_scene("", mesh, field, table));
  });
}

val Scenes::write_distances(const val& points, const std::string& format) const {
  return guarded([&] {
    const Mesh& mesh = input_->mesh;
    DistanceTable table;
    table.sources = resolve(mesh, "points", points);
    const VertexDistances found = measure(mesh, table.sources, nullptr, {});
    table.rows = {found.distance.raw()};
    table.nearest = found.label.raw();
    const LabelledMesh written{.mesh = mesh, .vertex_label = &found.label, .vertex_distance = &found.distance};
    const auto json = [&](std::ostream& out) { write_distances_json(out, mesh, table); };
    return write_result(written, format, Given(mesh, val::object()), {{"json", json}});
  });
}

val Scenes::to_page(const val& positions) const {
  std::vector<float> moved;
  const auto at = emscripten::convertJSArrayToNumberVector<double>(positions);
  for (std::size_t i = 0; i < at.size(); ++i) {
    moved.push_back(static_cast<float>((at[i] - frame_.origin[int(i % 3)]) / frame_.scale));
  }
  return to_array(moved);
}

void bind_scenes() {
  emscripten::class_<Scenes>("Scenes")
      .constructor<SharedMesh>()
      .function("of_diagram", &Scenes::of_diagram)
      .function("of_distances", &Scenes::of_distances)
      .function("write_distances", &Scenes::write_distances)
      .function("to_page", &Scenes::to_page);
}

}  // namespace gvd::web
