#include <cmath>
#include <map>

#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"
#include "io/view/view_page.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_view_scene {

using namespace test;

std::map<std::string, std::string> figures_of(const ViewScene& scene) {
  std::map<std::string, std::string> figures;
  for (const ViewFigure& figure : scene.figures) figures[figure.name] = figure.value;
  return figures;
}

TEST_CASE("a scene has the labels, pieces, lines and points of its diagram") {
  const Mesh mesh = make_sphere(2);
  const Diagram diagram = compute_diagram(mesh, random_generators(mesh, 12, 3));
  const ViewScene scene = make_view_scene("A name", mesh, diagram);
  CHECK(scene.name == "A name");
  CHECK(scene.mesh == &mesh);
  CHECK(scene.face_label == diagram.face_label);
  CHECK(scene.pieces.size() == diagram.pieces.size());
  CHECK(scene.vertex_distance == diagram.vertex_distance);
  CHECK(scene.bisectors.size() == diagram.bisectors.size());
  CHECK(scene.branch_points.size() == diagram.branch_points.size());
  CHECK(scene.cells.size() == 12);
  CHECK(scene.added_generators.empty());
  REQUIRE(scene.generators.size() == 12);
  for (std::size_t i = 0; i < 12; ++i) CHECK(scene.generators[i] == position(mesh, diagram.generators[i]));
  CHECK(figures_of(scene)["Generators"] == "12");
  CHECK(figures_of(scene)["Branch points"] == std::to_string(diagram.branch_points.size()));
}

TEST_CASE("the scene of a labelled mesh shows its labels, and counts the faces that it shows") {
  const Mesh mesh = make_sphere(2), finer = make_sphere(3);
  const Diagram diagram = compute_diagram(mesh, random_generators(mesh, 12, 3));
  const IdVector<FaceId, GeneratorId> label(std::size_t(finer.face_count()), GeneratorId(3));
  const IdVector<VertexId, double> distance(std::size_t(finer.vertex_count()), 0.5);
  LabelledMesh shown{finer};
  shown.face_label = &label;
  shown.vertex_distance = &distance;
  shown.diagram = &diagram;
  shown.diagram_mesh = &mesh;
  CHECK(figures_of(make_view_scene("Doubled vertices, no cut", shown)).count("Faces before the cut") == 0);
  const std::vector<ViewScene> scenes = make_region_scenes(shown);
  REQUIRE(scenes.size() == 2);
  CHECK(scenes[0].mesh == &mesh);
  CHECK(scenes[0].vertex_distance == diagram.vertex_distance);
  CHECK(scenes[1].mesh == &finer);
  const IdVector<FaceId, FaceId> parent(std::size_t(finer.face_count()), FaceId(0));
  Appearance appearance;
  appearance.texture.resize(std::size_t(finer.halfedge_count()), {0.25, 0.5});
  shown.appearance = &appearance;
  CHECK(make_view_scene("Whole faces", shown).texture.empty());
  shown.face_parent = &parent;
  CHECK(make_region_scenes(shown).size() == 1);
  const ViewScene scene = make_view_scene("A name", shown);
  CHECK(scene.texture == appearance.texture);
  CHECK(scene.name == "A name");
  CHECK(scene.mesh == &finer);
  CHECK(scene.face_label == label);
  CHECK(scene.vertex_distance == distance);
  CHECK(scene.pieces.empty());
  CHECK(scene.bisectors.size() == diagram.bisectors.size());
  CHECK(figures_of(scene)["Faces"] == "1280");
  CHECK(figures_of(scene)["Vertices"] == "642");
  CHECK(figures_of(scene)["Faces before the cut"] == "320");
  CHECK(figures_of(scene)["Euler count"] == figures_of(make_view_scene("", mesh, diagram))["Euler count"]);
}

TEST_CASE("the scene of whole faces counts them once, and none can be made without a diagram") {
  const Mesh mesh = make_sphere(2);
  const Diagram diagram = compute_diagram(mesh, random_generators(mesh, 12, 3));
  LabelledMesh shown{mesh};
  shown.face_label = &diagram.face_label;
  shown.vertex_distance = &diagram.vertex_distance;
  CHECK_THROWS_AS(make_view_scene("", shown), Error);
  shown.diagram = &diagram;
  const ViewScene scene = make_view_scene("", shown);
  CHECK(figures_of(scene)["Faces"] == "320");
  CHECK(figures_of(scene).count("Faces before the cut") == 0);
}

TEST_CASE("the line of a closed bisector ends at its first point") {
  const Mesh mesh = make_grid(4, 4);
  Diagram diagram;
  Bisector open, closed;
  open.points = closed.points = {vertex_point(mesh, VertexId(6)), vertex_point(mesh, VertexId(7)),
                                 vertex_point(mesh, VertexId(12))};
  closed.closed = true;
  diagram.bisectors.push_back(open);
  diagram.bisectors.push_back(closed);
  const ViewScene scene = make_view_scene("", mesh, diagram);
  CHECK(scene.bisectors[0].size() == 3);
  REQUIRE(scene.bisectors[1].size() == 4);
  CHECK(scene.bisectors[1].front() == scene.bisectors[1].back());
}

TEST_CASE("the Euler count of a complete diagram agrees, and is left out where a vertex is not reached") {
  const Mesh mesh = make_torus(24, 12);
  Diagram diagram = compute_diagram(mesh, random_generators(mesh, 30, 3));
  const std::string count = figures_of(make_view_scene("", mesh, diagram)).at("Euler count");
  const std::size_t middle = count.find(" of ");
  CHECK(count.substr(0, middle) == count.substr(middle + 4));
  diagram.vertex_label[VertexId(0)] = GeneratorId();
  CHECK(figures_of(make_view_scene("", mesh, diagram)).count("Euler count") == 0);
}

TEST_CASE("the energy of a flat cell is the integral of the squared distance") {
  const Mesh grid = make_grid(4, 4);
  const Diagram one = compute_diagram(grid, {vertex_point(grid, VertexId(12))});
  REQUIRE(grid.position(VertexId(12)) == Vec3(2, 2, 0));
  const auto energies = io::compute_cell_energies(grid, one);
  REQUIRE(energies.size() == 1);
  CHECK(energies[GeneratorId(0)] == Approx(2.0 * 4 * 2 * 8 / 3));  // of x^2 + y^2 over [-2, 2]^2
}

TEST_CASE("the energies of two cells that share a flat square are equal and add up") {
  const Mesh grid = make_grid(8, 8);
  const Diagram two =
      compute_diagram(grid, {vertex_point(grid, VertexId(4 * 9 + 2)), vertex_point(grid, VertexId(4 * 9 + 6))});
  const auto energies = io::compute_cell_energies(grid, two);
  const double exact = 8 * 16.0 / 3 + 4 * 128.0 / 3;  // x in [-2, 2] and y in [-4, 4]
  for (const double energy : energies) CHECK(energy == Approx(exact).epsilon(1e-12));
}

TEST_CASE("faces that no generator reaches have no energy") {
  const Mesh both = make_two_components();
  const Diagram diagram = compute_diagram(both, {vertex_point(both, VertexId(0))});
  const auto energies = io::compute_cell_energies(both, diagram);
  CHECK(std::isfinite(energies[GeneratorId(0)]));
  CHECK(energies[GeneratorId(0)] > 0);
  CHECK(io::compute_cell_energies(both, Diagram()).empty());
}

TEST_CASE("a scene of distances has the sources, curves, and the exact paths of vertices") {
  const Mesh mesh = make_grid(6, 6);
  const std::vector<SurfacePoint> sources{vertex_point(mesh, VertexId(24))}, targets{vertex_point(mesh, VertexId(0))};
  const ExactField field(mesh, sources);
  DistanceTable table{.sources = sources, .targets = targets, .isolines = field.isolines({1.5, 3.5})};
  table.paths.push_back({0, GeneratorId(0), field.path(targets[0])});
  const ViewScene scene = make_distance_scene("Distances", mesh, field, table);
  CHECK(scene.generators == std::vector<Vec3>{mesh.position(VertexId(24))});
  CHECK(scene.isolines.size() == table.isolines.size());
  CHECK(scene.isolines[0].front() == scene.isolines[0].back());
  CHECK(scene.isolines.back().front() != scene.isolines.back().back());
  REQUIRE(scene.paths.size() == 1);
  REQUIRE(scene.vertex_paths.vertices.size() == 49);
  for (std::size_t i = 0; i < 49; ++i) {
    const VertexId v = scene.vertex_paths.vertices[i];
    const std::vector<Vec3>& path = scene.vertex_paths.points[i];
    double length = 0;
    for (std::size_t k = 1; k < path.size(); ++k) length += (path[k] - path[k - 1]).norm();
    CHECK(path.front() == mesh.position(v));
    CHECK(path.back() == mesh.position(VertexId(24)));
    CHECK(length == Approx(scene.vertex_distance[v]).margin(1e-14));
  }
}

TEST_CASE("a scene of a large mesh has paths of some of its vertices, of what no source reaches none") {
  const Mesh large = make_grid(120, 120);
  const SurfacePoint corner = vertex_point(large, VertexId(0));
  const ViewScene scene = make_distance_scene("", large, ExactField(large, {corner}), {.sources = {corner}});
  const std::size_t stored = scene.vertex_paths.vertices.size();
  CHECK(stored > 1000);
  CHECK(stored < 8000);
  std::size_t points = 0;
  for (const auto& path : scene.vertex_paths.points) points += path.size();
  CHECK(points < kMostPathPoints + kMostPathPoints / 10);
  const auto& vertices = scene.vertex_paths.vertices;
  CHECK(vertices[1].value() - vertices[0].value() == vertices[2].value() - vertices[1].value());
  const Mesh two = make_two_components();
  const SurfacePoint first = vertex_point(two, VertexId(0));
  const ExactField field(two, {first});
  for (const VertexId v : make_distance_scene("", two, field, {.sources = {first}}).vertex_paths.vertices) {
    CHECK(std::isfinite(field.distance(v)));
  }
}

}  // namespace gvd::test_view_scene
