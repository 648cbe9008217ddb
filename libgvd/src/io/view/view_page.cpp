// Makes the HTML page: checks the scenes, and fills the template of web/ with a title, their entries and their arrays.
//
// The build embeds the page's program, so one string is the whole page. In the browser a wrong index would only show as
// a hole, and a label above 2^24 as a wrong colour. So each scene is checked first, and an array that does not fit is
// refused with the offending element. Text from files is escaped: the title for HTML, and the JSON so that it can't end
// its script element.
//
// The energy of a cell is integrated face by face, where the squared distance is a quadratic function of barycentric
// coordinates; the midpoints of the sides of a triangle integrate it exactly. The Euler count compares the graph of the
// bisectors with the topology of the cells, which were found independently.
// Source: the midpoint rule, which is exact up to degree 2; Euler's V - E + F over branch points, bisectors and cells.
// Invariant: a page consists of checked scenes only, and needs no other file and no network when it is opened. A scene
// refers to its mesh and copies everything else, so the diagram may be destroyed before the page is made.
#include "io/view/view_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/cell_parts.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"
#include "io/view/scene_colors.hpp"
#include "io/view/scene_entry.hpp"
#include "io/view/view_blobs.hpp"
#include "io/view/view_template.hpp"

namespace gvd {
namespace io {
namespace {

using nlohmann::json;

/// The largest label that the page can show: codes travel through 32-bit floats, which are exact only below 2^24.
constexpr std::int32_t kLargestLabel = (1 << 24) - 3;

/// The largest number of lattice points: their numbers travel through 32-bit floats, too.
constexpr std::int64_t kMostLatticePoints = 1 << 24;

[[noreturn]] void refuse(const std::string& message, std::int64_t element = -1) {
  throw Error(ErrorCode::precondition, message, element);
}

void check_size(std::string_view what, std::int32_t size, std::int32_t wanted) {
  if (size == 0 || size == wanted) return;
  refuse(fmt::format("the view has {} {} where there are {} elements; give one for each, or none", size, what, wanted));
}

void check_labels(const ViewScene& scene) {
  const auto check = [&](GeneratorId label, std::int64_t face) {
    const bool known = (scene.cells.empty() || label.value() < scene.cells.count()) &&
                       (scene.region_color.empty() || label.value() < std::ssize(scene.region_color));
    if (known && label.value() <= kLargestLabel) return;
    refuse(fmt::format("face {} of the view has label {}, which has no cell or no colour; give one for each label",
                       face, label.value()),
           face);
  };
  for (const FaceId f : scene.face_label.ids()) check(scene.face_label[f], f.value());
  for (const FacePiece& piece : scene.pieces) check(piece.generator, piece.face.value());
}

void check_pieces(const ViewScene& scene) {
  for (const FacePiece& piece : scene.pieces) {
    if (!piece.face.valid() || piece.face.value() >= scene.mesh->face_count()) {
      refuse(fmt::format("a piece of the view lies in face {}, which the mesh does not have", piece.face.value()),
             piece.face.value());
    }
    for (const auto& corner : piece.corners) {
      if (std::isfinite(corner[0]) && std::isfinite(corner[1]) && std::isfinite(corner[2])) continue;
      refuse(fmt::format("a piece of face {} of the view has a corner that is not finite", piece.face.value()),
             piece.face.value());
    }
  }
}

void check_finite(std::string_view what, const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) refuse(fmt::format("{} {} of the view is not finite", what, i), std::int64_t(i));
  }
}

void check_distances(const std::vector<double>& distances) {
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (std::isfinite(distances[i]) && distances[i] >= 0) continue;
    refuse(fmt::format("distance {} of the view from another surface is not a finite number from 0 on", i),
           std::int64_t(i));
  }
}

void check_surface_distance(const ViewScene& scene) {
  const Mesh& mesh = *scene.mesh;
  const DistanceSamples& samples = scene.surface_distance->samples;
  if (!scene.pieces.empty()) refuse("the view has distances of cut faces from another surface; give whole faces");
  if (samples.at_vertex.count() != mesh.vertex_count() || samples.steps.count() != mesh.face_count()) {
    refuse("the view has distances from another surface that do not match its mesh; give one for each vertex and face");
  }
  std::int64_t size = 0;
  for (const std::int32_t k : samples.steps) {
    if (k < 1 || k > DistanceSamples::kMaxSteps) refuse(fmt::format("a face of the view is cut into {} steps", k));
    size += DistanceSamples::lattice_size(k);
  }
  if (size != std::ssize(samples.lattice)) {
    refuse(fmt::format("the view has {} distances on lattices of {} points", samples.lattice.size(), size));
  }
  if (size > kMostLatticePoints) {
    refuse(fmt::format("the view has more than {} points on lattices", kMostLatticePoints));
  }
  check_distances(samples.at_vertex.raw());
  check_distances(samples.lattice);
  for (const double length : {scene.surface_distance->reference, scene.surface_distance->scale_end}) {
    if (!std::isfinite(length) || length <= 0) refuse("the scale of distances of the view must be a positive length");
  }
}

void check_vertex_paths(const ViewScene& scene) {
  const auto& [vertices, points] = scene.vertex_paths;
  if (vertices.size() != points.size() || (!vertices.empty() && scene.vertex_distance.empty())) {
    refuse("the view has paths of vertices without a vertex or a distance; give one for each");
  }
  for (const VertexId v : vertices) {
    if (v.valid() && v.value() < scene.mesh->vertex_count()) continue;
    refuse(fmt::format("the view has a path of vertex {}, which the mesh does not have", v.value()), v.value());
  }
  for (const std::vector<Vec3>& polyline : points) check_finite("path point", polyline);
}

/// The squared distance in one face, as a function of barycentric coordinates.
class SquaredDistance {
 public:
  SquaredDistance(const Mesh& mesh, const Diagram& diagram, FaceId f) {
    const auto& corners = mesh.vertices(f);
    for (int i = 0; i < 3; ++i) {
      corner_[i] = std::pow(diagram.vertex_distance[corners[i]], 2);
      side_[i] = (mesh.position(corners[(i + 1) % 3]) - mesh.position(corners[i])).squaredNorm();
    }
  }

  double operator()(const Bary& b) const {
    const double value = interpolate(b, corner_[0], corner_[1], corner_[2]) -
                         (b[0] * b[1] * side_[0] + b[1] * b[2] * side_[1] + b[2] * b[0] * side_[2]);
    return value > 0 ? value : 0;
  }

 private:
  Bary corner_{}, side_{};
};

/// The integral over a polygon inside a face of area `area`. Sums over a fan of triangles with signed areas, and
/// integrates each by the midpoints of its sides, which is exact for quadratic functions.
double integrate(const SquaredDistance& squared, double area, std::span<const Bary> polygon) {
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Bary &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const double share = twice_signed_area(affine_point(a), affine_point(b), affine_point(c));
    sum += area * share * (squared(mix(a, b, 0.5)) + squared(mix(b, c, 0.5)) + squared(mix(c, a, 0.5))) / 3;
  }
  return sum;
}

/// Twice the amount by which the cells' Euler characteristics exceed the mesh's, computed from the graph of the
/// bisectors.
///
/// The count follows from V - E + F over branch points, bisectors, boundary pieces and cells. A branch point of degree
/// d counts d - 2 inside the mesh and d on the boundary. The end of a bisector on the boundary counts 1.
std::int64_t count_excess(const Mesh& mesh, const Diagram& diagram) {
  std::int64_t excess = 0;
  for (const Bisector& bisector : diagram.bisectors) excess += bisector.closed ? 0 : 2;
  for (const BranchPoint& branch_point : diagram.branch_points)
    excess -= is_on_boundary(mesh, branch_point.point) ? 0 : 2;
  return excess;
}

std::vector<ViewFigure> make_figures(const Mesh& mesh, const Diagram& diagram, const Mesh& shown) {
  const MeshSummary summary = compute_mesh_summary(mesh);
  std::int64_t characteristics = 0, discs = 0;
  for (const Cell& cell : diagram.cells) {
    characteristics += cell.euler_characteristic;
    discs += cell.is_disc();
  }
  std::vector<ViewFigure> figures{{"Faces", fmt::format("{}", shown.face_count())},
                                  {"Vertices", fmt::format("{}", shown.vertex_count())},
                                  {"Area", fmt::format("{:.6g}", summary.area)},
                                  {"Euler characteristic", fmt::format("{}", summary.euler_characteristic)},
                                  {"Generators", fmt::format("{}", diagram.generators.size())},
                                  {"Branch points", fmt::format("{}", diagram.branch_points.size())},
                                  {"Bisectors", fmt::format("{}", diagram.bisectors.size())},
                                  {"Bisector length", fmt::format("{:.6g}", diagram.length)},
                                  {"Disc regions", fmt::format("{} of {}", discs, diagram.cells.size())}};
  if (std::ranges::all_of(diagram.vertex_label, &GeneratorId::valid)) {  // the cells cover the mesh
    figures.push_back({"Euler count", fmt::format("{} of {}", count_excess(mesh, diagram),
                                                  2 * (characteristics - summary.euler_characteristic))});
  }
  return figures;
}

std::vector<Vec3> make_polyline(const Mesh& mesh, const Bisector& bisector) {
  std::vector<Vec3> polyline;
  polyline.reserve(bisector.points.size() + 1);
  for (const SurfacePoint& point : bisector.points) polyline.push_back(position(mesh, point));
  if (bisector.closed && !polyline.empty()) polyline.push_back(polyline.front());
  return polyline;
}

/// Makes the part of a scene that does not depend on the mesh shown.
ViewScene make_diagram_scene(std::string name, const Mesh& mesh, const Diagram& diagram) {
  ViewScene scene;
  scene.name = std::move(name);
  for (const Bisector& bisector : diagram.bisectors) scene.bisectors.push_back(make_polyline(mesh, bisector));
  if (diagram.curves.empty()) {
    for (const SurfacePoint& generator : diagram.generators) scene.generators.push_back(position(mesh, generator));
  }
  for (const GeneratorCurve& curve : diagram.curves) {
    for (std::vector<Vec3>& line : polylines(mesh, curve)) scene.paths.push_back(std::move(line));
  }
  for (const BranchPoint& branch_point : diagram.branch_points) scene.branch_points.push_back(branch_point.position);
  scene.cells = diagram.cells;
  scene.cell_energy = compute_cell_energies(mesh, diagram);
  return scene;
}

std::string replace_all(const std::string& text, char replaced, std::string_view by) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) c == replaced ? result.append(by) : result.append(1, c);
  return result;
}

std::string escape_html(const std::string& text) { return replace_all(replace_all(text, '&', "&amp;"), '<', "&lt;"); }

/// JSON without `<`, so that no text in it can end its HTML element or start a comment.
std::string dump_for_html(const json& document) {
  return replace_all(document.dump(-1, ' ', false, json::error_handler_t::replace), '<', "\\u003c");
}

std::string make_data(const std::vector<ViewScene>& scenes, const ViewOptions& options) {
  ViewBlobs blobs;
  const json manifest = make_view_manifest(scenes, compute_view_frame(scenes), options, blobs);
  return "<script type=\"application/json\" id=\"manifest\">" + dump_for_html(manifest) + "</script>\n" + blobs.html();
}

std::string fill_template(std::string_view page, const std::string& title, const std::string& data) {
  const std::size_t title_at = page.find(kViewTitleMark), data_at = page.find(kViewDataMark);
  const std::size_t title_end = title_at + kViewTitleMark.size();
  std::string filled;
  filled.reserve(page.size() + title.size() + data.size());
  filled.append(page.substr(0, title_at)).append(title);
  filled.append(page.substr(title_end, data_at - title_end)).append(data);
  filled.append(page.substr(data_at + kViewDataMark.size()));
  return filled;
}

}  // namespace

json make_view_manifest(const std::vector<ViewScene>& scenes, const ViewFrame& frame, const ViewOptions& options,
                        ViewBlobs& blobs) {
  json manifest{{"schema", "gvd-view/1"},
                {"title", options.title},
                {"up", name_in(kUpAxisNames, options.up)},
                {"scale", frame.scale},
                {"origin", {frame.origin.x(), frame.origin.y(), frame.origin.z()}},
                {"scenes", json::array()}};
  report_progress(options.progress, "view", 0);
  const std::vector<std::vector<Rgb>> colors = choose_scene_colors(scenes);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    report_progress(options.progress, "view", double(i) / double(scenes.size()));
    manifest["scenes"].push_back(make_scene_entry(scenes[i], colors[i], frame, blobs));
  }
  report_progress(options.progress, "view", 1);
  return manifest;
}

void check_view_scene(const ViewScene& scene) {
  if (scene.mesh == nullptr || scene.mesh->face_count() == 0) {
    refuse("a scene of the view has no faces; give each a mesh");
  }
  check_size("face labels", scene.face_label.count(), scene.mesh->face_count());
  check_size("vertex distances", scene.vertex_distance.count(), scene.mesh->vertex_count());
  check_size("texture coordinates", int(scene.texture.size()), scene.mesh->halfedge_count());
  check_size("cell energies", scene.cell_energy.count(), scene.cells.count());
  check_size("generators of vertices", int(scene.vertex_generators.size()), scene.mesh->vertex_count());
  if (scene.surface_distance) check_surface_distance(scene);
  if (scene.overlay && (scene.overlay->mesh == nullptr || scene.overlay->mesh->face_count() == 0)) {
    refuse("an overlay of the view has no faces; give it a mesh");
  }
  check_pieces(scene);
  check_labels(scene);
  check_finite("generator", scene.generators);
  check_finite("added generator", scene.added_generators);
  check_finite("branch point", scene.branch_points);
  for (const std::vector<Vec3>& polyline : scene.bisectors) check_finite("bisector point", polyline);
  for (const std::vector<Vec3>& polyline : scene.borders) check_finite("border point", polyline);
  for (const std::vector<Vec3>& polyline : scene.isolines) check_finite("isoline point", polyline);
  for (const std::vector<Vec3>& polyline : scene.paths) check_finite("path point", polyline);
  check_vertex_paths(scene);
}

IdVector<GeneratorId, double> compute_cell_energies(const Mesh& mesh, const Diagram& diagram) {
  IdVector<GeneratorId, double> energies(diagram.cells.size(), 0.0);
  for_each_cell_part(diagram, [&](const FacePart& part) {
    const double energy = integrate(SquaredDistance(mesh, diagram, part.face), mesh.area(part.face), part.corners);
    if (std::isfinite(energy)) energies[part.generator] += energy;
  });
  return energies;
}

}  // namespace io

ViewScene make_view_scene(std::string name, const Mesh& mesh, const Diagram& diagram) {
  ViewScene scene = io::make_diagram_scene(std::move(name), mesh, diagram);
  scene.mesh = &mesh;
  scene.face_label = diagram.face_label;
  scene.pieces = diagram.pieces;
  scene.vertex_distance = diagram.vertex_distance;
  scene.figures = io::make_figures(mesh, diagram, mesh);
  return scene;
}

ViewScene make_view_scene(std::string name, const LabelledMesh& shown) {
  if (shown.diagram == nullptr || shown.face_label == nullptr || shown.vertex_distance == nullptr)
    throw Error(ErrorCode::precondition, "a scene of a labelled mesh needs a diagram, face labels and distances");
  const Mesh& mesh = shown.surface();
  ViewScene scene = io::make_diagram_scene(std::move(name), mesh, *shown.diagram);
  scene.mesh = &shown.mesh;
  scene.face_label = *shown.face_label;
  scene.vertex_distance = *shown.vertex_distance;
  scene.region_color = region_colors(shown);
  scene.figures = io::make_figures(mesh, *shown.diagram, shown.mesh);
  if (shown.face_parent != nullptr) {
    scene.figures.insert(scene.figures.begin() + 1, {"Faces before the cut", fmt::format("{}", mesh.face_count())});
    if (shown.has_texture()) scene.texture = shown.appearance->texture;
  }
  return scene;
}

std::vector<ViewScene> make_region_scenes(const LabelledMesh& shown) {
  const bool is_cut = shown.face_parent != nullptr;
  std::vector<ViewScene> scenes{make_view_scene(is_cut ? "Regions" : "Whole faces, as in the file", shown)};
  if (is_cut) return scenes;
  // Cells are shown on the diagram's mesh, because distances differ on the two sides of a border between regions.
  scenes.insert(scenes.begin(), make_view_scene("Diagram", shown.surface(), *shown.diagram));
  scenes[0].region_color = scenes[1].region_color;
  return scenes;
}

bool has_viewer() { return !io::view_template().empty(); }

std::string make_view_page(const std::vector<ViewScene>& scenes, const ViewOptions& options) {
  if (!has_viewer()) {
    throw Error(
        ErrorCode::invalid_option,
        "can't make an HTML page: built without the viewer; configure with GVD_WITH_VIEWER=ON, which needs npm");
  }
  if (scenes.empty()) throw Error(ErrorCode::precondition, "the view has no scene; give at least one");
  for (const ViewScene& scene : scenes) io::check_view_scene(scene);
  return io::fill_template(io::view_template(), io::escape_html(options.title), io::make_data(scenes, options));
}

std::string make_view_page(const ViewScene& scene, const ViewOptions& options) {
  return make_view_page(std::vector<ViewScene>{scene}, options);
}

}  // namespace gvd
