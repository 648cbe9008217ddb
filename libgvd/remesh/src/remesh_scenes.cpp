// The pictures of a remesh on a page: the remesh, the same before placement, the input, and the diagram.
//
// Remesh and input show their distances from each other by one scale of colours, so that they can be compared. The
// scale ends at a few RMS distances, because the largest distance would leave all others with similar colours.
// Distances are measured anew at the points that a page shows; the figures are those of the result.
#include "gvd/remesh_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "gvd/quality.hpp"
#include "gvd/surface_distance.hpp"
#include "move_guard.hpp"

namespace gvd {
namespace {

/// Moves the added generators, which come last, to a list of their own.
void mark_added(const RemeshResult& result, ViewScene& scene) {
  const auto first = scene.generators.end() - result.added;
  scene.added_generators.assign(first, scene.generators.end());
  scene.generators.erase(first, scene.generators.end());
}

void add(ViewScene& scene, const std::vector<ViewFigure>& figures) {
  scene.figures.insert(scene.figures.end(), figures.begin(), figures.end());
}

void add_counts(ViewScene& scene) {
  const MeshSummary summary = compute_mesh_summary(*scene.mesh);
  add(scene, {{"Vertices", fmt::format("{}", summary.vertices)},
              {"Faces", fmt::format("{}", summary.faces)},
              {"Euler characteristic", fmt::format("{}", summary.euler_characteristic)}});
}

void add_shapes(ViewScene& scene) {
  const TriangleQuality quality = compute_triangle_quality(*scene.mesh);
  const Valences valences = compute_valences(*scene.mesh);
  add(scene, {{"Q, mean", fmt::format("{:.3f}", quality.q_average)},
              {"Q, least", fmt::format("{:.3f}", quality.q_min)},
              {"Smallest angle, mean", fmt::format("{:.1f}°", quality.angle_min_average)},
              {"Smallest angle, least", fmt::format("{:.1f}°", quality.angle_min)},
              {"Faces below 30°", fmt::format("{:.1f} %", quality.percent_below_30)},
              {"Valences", fmt::format("{} to {}", valences.least, valences.largest)},
              {"Regular vertices", fmt::format("{:.1f} %", valences.percent_regular)}});
}

/// The end of the scale of distances, in RMS distances of the remesh. It holds nearly all distances; the largest one is
/// often ten times the RMS distance, and would leave the others with similar colours.
constexpr double kScaleEnd = 3;

/// Makes the scenes that show distances.
class DistanceScenes {
 public:
  DistanceScenes(const Mesh& input, const RemeshResult& result, int threads, const Progress& progress)
      : input_(input), result_(result), threads_(threads), progress_(progress) {}

  ViewScene make_remesh() const {
    ViewScene scene = make_coarse("Remesh", result_.mesh);
    add(scene, {{"Generators added", fmt::format("{}", result_.added)},
                {"Intersecting pairs", fmt::format("{}", result_.certificate.self_intersections.size())}});
    add_shapes(scene);
    add_distances(scene, result_.input_to_output, result_.output_to_input);
    return scene;
  }

  ViewScene make_unplaced(const Mesh& unplaced) const {
    ViewScene scene = make_coarse("Before placement", unplaced);
    add_shapes(scene);
    add_distances(scene, measure_surface_distance(input_, unplaced, threads_),
                  measure_surface_distance(unplaced, input_, threads_));
    return scene;
  }

  ViewScene make_input() const {
    ViewScene scene;
    scene.name = "Input";
    scene.mesh = &input_;
    add_other(scene, result_.mesh, "the remesh", "Remesh, translucent");
    add_counts(scene);
    add_shapes(scene);
    return scene;
  }

 private:
  ViewScene make_coarse(std::string name, const Mesh& coarse) const {
    ViewScene scene;
    scene.name = std::move(name);
    scene.mesh = &coarse;
    scene.generators = coarse.positions();  // vertex i stands for generator i
    mark_added(result_, scene);
    for (const SurfacePoint& p : result_.generators) scene.vertex_generators.push_back(position(input_, p));
    scene.wireframe = true;
    scene.smooth = false;
    add_other(scene, input_, "the input", "Input, translucent");
    add_counts(scene);
    return scene;
  }

  /// Adds the distances of the scene's surface from `other`, and `other` as an overlay.
  void add_other(ViewScene& scene, const Mesh& other, const char* name, const char* overlay) const {
    const double rms = std::max(result_.input_to_output.rms, result_.output_to_input.rms);
    const double largest = std::max(result_.input_to_output.hausdorff, result_.output_to_input.hausdorff);
    ViewSurfaceDistance& distance = scene.surface_distance.emplace();
    distance.other = name;
    distance.samples = sample_surface_distance(*scene.mesh, other, threads_, progress_);
    distance.reference = diagonal();
    distance.scale_end = std::max(std::min(kScaleEnd * rms, largest), kLeastHausdorffTolerance * diagonal());
    scene.overlay = ViewOverlay{overlay, &other};
  }

  /// In percent of the diagonal of the input's bounding box.
  void add_distances(ViewScene& scene, const SurfaceDistance& from_input, const SurfaceDistance& to_input) const {
    const auto percent = [&](double length) { return fmt::format("{:.3g} %", 100 * length / diagonal()); };
    add(scene, {{"Mesh to input, largest", percent(to_input.hausdorff)},
                {"Mesh to input, RMS", percent(to_input.rms)},
                {"Input to mesh, largest", percent(from_input.hausdorff)},
                {"Input to mesh, RMS", percent(from_input.rms)},
                {"Diagonal (100 %)", fmt::format("{:.4g}", diagonal())}});
  }

  double diagonal() const { return result_.certificate.input.bbox_diagonal; }

  const Mesh& input_;
  const RemeshResult& result_;
  int threads_;
  const Progress& progress_;
};

ViewScene make_diagram_scene(const Mesh& input, const RemeshResult& result) {
  ViewScene scene = make_view_scene("Diagram", input, result.diagram);
  mark_added(result, scene);
  return scene;
}

}  // namespace

Mesh make_unplaced(const Mesh& input, const RemeshResult& result) {
  std::vector<Vec3> positions;
  for (const SurfacePoint& p : result.generators) positions.push_back(position(input, p));
  return with_positions(result.mesh, std::move(positions));
}

std::vector<ViewScene> make_remesh_scenes(const Mesh& input, const RemeshResult& result, const Mesh& unplaced,
                                          int threads, const Progress& progress) {
  const DistanceScenes scenes(input, result, threads, progress);
  std::vector<ViewScene> list{scenes.make_remesh()};
  if (unplaced.positions() != result.mesh.positions()) list.push_back(scenes.make_unplaced(unplaced));
  list.push_back(scenes.make_input());
  list.push_back(make_diagram_scene(input, result));
  return list;
}

}  // namespace gvd
