// Makes scenes: pictures for the page, one after the other, for a program that computes while the user watches.
//
// Unlike a page, which is made once, scenes follow each other while a generator moves. So all of them use the frame of
// the mesh, and a region keeps its colour as far as its neighbours allow.
#include "gvd/scene_operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "gvd/distances_operation.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/read_values.hpp"
#include "gvd/remesh_operation.hpp"
#include "gvd/remesh_scenes.hpp"
#include "io/view/scene_colors.hpp"
#include "io/view/scene_entry.hpp"
#include "io/view/view_blobs.hpp"
#include "io/view/view_page.hpp"
#include "io/writers/region_colors.hpp"

namespace gvd {
namespace {

constexpr double kScreenTolerance = 1e-3;  ///< chord tolerance of isolines, in mean edge lengths

io::ViewFrame frame_of(const Mesh& mesh) {
  ViewScene plain;
  plain.mesh = &mesh;
  return io::compute_view_frame({plain});
}

std::vector<Rgb> colors_of(const GivenNumbers& given) {
  std::vector<Rgb> colors;
  if (!given.values) return colors;
  const std::vector<double>& numbers = given.values->soup.values;
  const bool is_right = numbers.size() % 3 == 0 &&
                        std::ranges::all_of(numbers, [](double n) { return n >= 0 && n <= 255 && n == std::floor(n); });
  if (!is_right) {
    throw Error(ErrorCode::invalid_option, "\1colors\2: three whole numbers from 0 to 255 are needed for each region");
  }
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(numbers[i]); };
  for (std::size_t i = 0; i < numbers.size(); i += 3) colors.push_back({byte(i), byte(i + 1), byte(i + 2)});
  return colors;
}

ViewScene scene_of(const DistancesOutcome& made, std::int32_t levels) {
  if (!made.field) throw Error(ErrorCode::invalid_option, "distances from each source alone have no scene");
  const Mesh& mesh = made.surface();
  if (levels == 0) return make_distance_scene("", mesh, *made.field, made.table);
  double largest = 0;
  for (const VertexId v : mesh.vertices()) {
    if (std::isfinite(made.field->distance(v))) largest = std::max(largest, made.field->distance(v));
  }
  std::vector<double> at;
  for (int i = 1; i <= levels; ++i) at.push_back(largest * i / (levels + 1));
  DistanceTable table = made.table;
  // Users see these isolines while they drag a generator. This tolerance gives a third of the points without a visible
  // difference.
  if (largest > 0) table.isolines = made.field->isolines(at, {.chord_tolerance = kScreenTolerance});
  return make_distance_scene("", mesh, *made.field, table);
}

}  // namespace

void describe(OptionList& list, SceneCall& call) {
  list.group("Scene");
  list.option("colors", ValueSource{&call.colors, {}, ValueSource::Of::generators},
              {.help = "Colours of the regions in the previous scene: red, green and blue of each, 0 to 255"});
  list.option("isolines", Number{&call.isolines, {.least = 0}},
              {.help = "Levels of isolines up to the largest distance; 0: the isolines of the distances"});
}

void SceneObject::visit(ObjectVisitor& visitor) const {
  visitor.figure({"manifest", "", "what the page holds of the scene, as JSON"}, manifest);
  visitor.array({"bytes", "", "of all arrays that the manifest refers to by their numbers"},
                {bytes.data(), ArrayType::uint8, 1, {std::ssize(bytes), 1}, {1, 0}});
  visitor.array({"offsets", "", "index of each array's first byte, and the total number of bytes"}, view(offsets));
  visitor.array({"colors", "", "red, green and blue of the regions"},
                {colors.data(), ArrayType::uint8, 2, {std::ssize(colors), 3}, {sizeof(Rgb), 1}});
}

std::shared_ptr<const SceneObject> run(const Object& on, SceneCall& call, Observer& observer) {
  const Step step(observer, "scene");
  const std::vector<Rgb> before = colors_of(call.colors);
  Mesh unplaced;  // the scene refers to this mesh
  MeshPtr input;
  ViewScene scene;
  if (const auto* const diagram = dynamic_cast<const DiagramObject*>(&on)) {
    input = diagram->mesh();
    scene = make_view_scene("", input->mesh, diagram->diagram());
  } else if (const auto* const distances = dynamic_cast<const DistancesOutcome*>(&on)) {
    input = distances->input;
    scene = scene_of(*distances, call.isolines);
  } else if (const auto* const remesh = dynamic_cast<const RemeshOutcome*>(&on)) {
    input = remesh->input;
    unplaced = make_unplaced(input->mesh, remesh->result());
    scene =
        make_remesh_scenes(input->mesh, remesh->result(), unplaced, observer.threads, progress_of(observer)).front();
  } else {
    throw Error(ErrorCode::invalid_option,
                fmt::format("this takes a {}, and the object is a {}", kSceneSubjects, on.kind()));
  }
  io::check_view_scene(scene);
  auto made = std::make_shared<SceneObject>();
  if (scene.region_color.empty() && !scene.cells.empty()) {
    const auto adjacent = io::find_adjacent_regions(scene);
    made->colors = before.empty() ? io::choose_region_colors(scene.cells.size(), adjacent)
                                  : io::adapt_region_colors(before, scene.cells.size(), adjacent);
    scene.region_color = made->colors;
  }
  io::ViewBlobs blobs;
  const auto manifest =
      io::make_view_manifest({std::move(scene)}, frame_of(input->mesh), {.progress = progress_of(observer)}, blobs);
  made->manifest = manifest.dump();
  made->offsets = {0};
  for (const std::string* const array : blobs.all()) {
    made->bytes += *array;
    made->offsets.push_back(std::ssize(made->bytes));
  }
  return made;
}

}  // namespace gvd
