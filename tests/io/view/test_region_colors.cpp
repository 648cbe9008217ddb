#include <algorithm>
#include <set>

#include "io/view/region_colors.hpp"
#include "support/catch.hpp"
#include "support/color_difference.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test {
namespace {

using Pairs = std::vector<std::pair<GeneratorId, GeneratorId>>;

/// Every pair of `count` labels.
Pairs complete_graph(int count) {
  Pairs pairs;
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) pairs.emplace_back(GeneratorId(a), GeneratorId(b));
  }
  return pairs;
}

/// The smallest colour difference of regions on both sides of an edge or a bisector, in the colours of the page.
double least_difference_of_neighbours(const ViewScene& scene, const Diagram& diagram) {
  const std::vector<Rgb> colors = io::choose_region_colors(scene.cells.size(), io::find_adjacent_regions(scene));
  double least = 1000;
  const auto compare = [&](GeneratorId a, GeneratorId b) {
    if (a != b) least = std::min(least, least_difference(colors[a.index()], colors[b.index()]));
  };
  for (const Bisector& bisector : diagram.bisectors) compare(bisector.left, bisector.right);
  const Mesh& mesh = *scene.mesh;
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const HalfedgeId twin = mesh.twin(HalfedgeId(h));
    if (!twin.valid()) continue;
    const GeneratorId a = scene.face_label[Mesh::face(HalfedgeId(h))], b = scene.face_label[Mesh::face(twin)];
    if (a.valid() && b.valid()) compare(a, b);
  }
  return least;
}

}  // namespace

TEST_CASE("CIEDE2000 agrees with the published test pairs") {
  CHECK(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}) == Approx(2.0425).margin(5e-5));
  CHECK(ciede2000({50, -1.3802, -84.2814}, {50, 0, -82.7485}) == Approx(1.0).margin(5e-5));
  CHECK(ciede2000({50, 2.49, -0.001}, {50, -2.49, 0.0009}) == Approx(7.1792).margin(5e-5));
  CHECK(ciede2000({50, 2.5, 0}, {73, 25, -18}) == Approx(27.1492).margin(5e-5));
  CHECK(ciede2000({50, 2.5, 0}, {58, 24, 15}) == Approx(19.4535).margin(5e-5));
  CHECK(ciede2000({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}) == Approx(1.2644).margin(5e-5));
  CHECK(ciede2000({22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}) == Approx(2.0373).margin(5e-5));
  CHECK(ciede2000({2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}) == Approx(0.9082).margin(5e-5));
}

TEST_CASE("any two colours of the page differ for every kind of vision") {
  std::vector<Rgb> colors(io::kRegionPalette.begin(), io::kRegionPalette.end());
  colors.push_back(io::kUnreachedColor);
  for (std::size_t a = 0; a < colors.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (const Vision& vision : visions()) {
        INFO("colours " << a << " and " << b << ", " << vision.name);
        CHECK(ciede2000(seen(vision, colors[a]), seen(vision, colors[b])) >= 20);
      }
    }
  }
}

TEST_CASE("neighbours have different colours on every mesh, with any number of generators") {
  for (const auto& [name, mesh] : small_family()) {
    for (const int count : {2, 8, 30, 100, 400}) {
      INFO(name << ", " << count << " generators");
      const Diagram diagram = compute_diagram(mesh, random_generators(mesh, count, 5));
      ViewScene scene = make_view_scene("", mesh, diagram);
      CHECK(least_difference_of_neighbours(scene, diagram) >= 20);
      // Faces labelled as a whole touch regions that the bisectors keep apart.
      for (const FacePiece& piece : diagram.pieces) scene.face_label[piece.face] = piece.generator;
      scene.pieces.clear();
      CHECK(least_difference_of_neighbours(scene, diagram) >= 20);
    }
  }
}

TEST_CASE("every colour is used about as often as the others") {
  const Mesh mesh = make_sphere(4);
  const Diagram diagram = compute_diagram(mesh, random_generators(mesh, 210, 2));
  const ViewScene scene = make_view_scene("", mesh, diagram);
  const std::vector<Rgb> colors = io::choose_region_colors(210, io::find_adjacent_regions(scene));
  for (const Rgb& color : io::kRegionPalette) {
    const auto uses = std::count(colors.begin(), colors.end(), color);
    CHECK(uses >= 20);
    CHECK(uses <= 40);
  }
}

TEST_CASE("seven regions that all touch each other have seven colours, and more still have some") {
  const auto differing = [](const std::vector<Rgb>& colors) {
    std::set<int> known;
    for (const Rgb& c : colors) known.insert(65536 * c.red + 256 * c.green + c.blue);
    return known.size();
  };
  CHECK(differing(io::choose_region_colors(7, complete_graph(7))) == 7);
  CHECK(io::choose_region_colors(9, complete_graph(9)).size() == 9);
  CHECK(differing(io::choose_region_colors(9, complete_graph(9))) == 7);
  CHECK(io::choose_region_colors(0, {}).empty());
}

}  // namespace gvd::test
