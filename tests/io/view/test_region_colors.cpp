// Colours of regions, and of the scenes of a slider: a region keeps its colour as far as neighbours still differ.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "gvd/geodesic_tracing.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "io/view/scene_colors.hpp"
#include "io/view/view_blobs.hpp"
#include "io/writers/region_colors.hpp"
#include "support/catch.hpp"
#include "support/color_difference.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_region_colors {

using namespace test;

constexpr double kPi = 3.14159265358979323846;

/// What label_color.hpp promises of the colours of neighbours.
constexpr double kLeast = 14;

using Pairs = std::vector<std::pair<GeneratorId, GeneratorId>>;

/// Every pair of `count` labels.
Pairs complete_graph(int count) {
  Pairs pairs;
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) pairs.emplace_back(GeneratorId(a), GeneratorId(b));
  }
  return pairs;
}

int code(const Rgb& color) { return 65536 * color.red + 256 * color.green + color.blue; }

std::size_t count_different(const std::vector<Rgb>& colors) {
  std::set<int> known;
  for (const Rgb& color : colors) known.insert(code(color));
  return known.size();
}

/// The number of pairs with the same colour.
std::size_t repeats(const std::vector<Rgb>& colors, const Pairs& pairs) {
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const auto& pair) {
    return colors[pair.first.index()] == colors[pair.second.index()];
  }));
}

/// On a sphere of radius 1, the vertex nearest to a point at an angle from the axis, and one around it.
SurfacePoint nearest_vertex(const Mesh& mesh, double angle, double turn) {
  const Vec3 wanted(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle));
  VertexId best(0);
  for (int v = 1; v < mesh.vertex_count(); ++v) {
    if (mesh.position(VertexId(v)).dot(wanted) > mesh.position(best).dot(wanted)) best = VertexId(v);
  }
  return vertex_point(mesh, best);
}

/// The smallest colour difference of regions on both sides of an edge or a bisector, in the colours of the page.
double least_difference_of_neighbours(const ViewScene& scene, const Diagram& diagram) {
  const std::vector<Rgb> colors = io::choose_region_colors(scene.cells.size(), io::find_adjacent_regions(scene));
  double least = 1000;
  const auto compare = [&](GeneratorId a, GeneratorId b) {
    if (a != b) least = std::min(least, least_difference(colors[a.index()], colors[b.index()]));
  };
  const bool whole = scene.pieces.empty();  // bisectors over whole faces are no borders
  for (const Bisector& bisector : diagram.bisectors) whole ? void() : compare(bisector.left, bisector.right);
  const Mesh& mesh = *scene.mesh;
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const HalfedgeId twin = mesh.twin(HalfedgeId(h));
    if (!twin.valid()) continue;
    const GeneratorId a = scene.face_label[Mesh::face(HalfedgeId(h))], b = scene.face_label[Mesh::face(twin)];
    if (a.valid() && b.valid()) compare(a, b);
  }
  return least;
}

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
  colors.push_back(kUnlabelledColor);
  for (std::size_t a = 0; a < colors.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (const Vision& vision : visions()) {
        INFO("colours " << a << " and " << b << ", " << vision.name);
        CHECK(ciede2000(seen(vision, colors[a]), seen(vision, colors[b])) >= kLeast);
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
      CHECK(least_difference_of_neighbours(scene, diagram) >= kLeast);
      // Faces labelled as a whole touch regions that the bisectors keep apart, and keep apart some that these touch.
      for (const FacePiece& piece : diagram.pieces) scene.face_label[piece.face] = piece.generator;
      scene.pieces.clear();
      CHECK(least_difference_of_neighbours(scene, diagram) >= kLeast);
    }
  }
}

/// Whole faces with the label of their largest piece.
IdVector<FaceId, GeneratorId> whole_labels(const Diagram& diagram) {
  IdVector<FaceId, GeneratorId> label = diagram.face_label;
  for (const FacePiece& piece : diagram.pieces) label[piece.face] = piece.generator;
  return label;
}

TEST_CASE("the page of a mesh with labels has the colours of its files, and so has that of its diagram") {
  for (const auto& [name, mesh] : small_family()) {
    for (const int count : {8, 60}) {
      INFO(name << ", " << count << " generators");
      const Diagram diagram = compute_diagram(mesh, random_generators(mesh, count, 3));
      LabelledMesh file{mesh, &diagram.face_label, nullptr, &diagram.vertex_label, &diagram.vertex_distance, &diagram};
      const ViewScene cells = make_view_scene("", mesh, diagram);
      CHECK(io::choose_scene_colors({cells}).at(0) == region_colors(file));
      file.no_bisectors = true;
      CHECK(io::choose_scene_colors({cells}).at(0) == region_colors(file));
      const IdVector<FaceId, GeneratorId> label = whole_labels(diagram);
      file.face_label = &label;
      CHECK(io::choose_scene_colors({make_view_scene("", file)}).at(0) == region_colors(file));
    }
  }
}

TEST_CASE("in files, labels differ that meet along edges, and those that meet along a bisector") {
  std::size_t edges = 0, bisectors = 0;
  for (const auto& [name, mesh] : small_family()) {
    for (const int count : {2, 8, 30, 100, 400}) {
      INFO(name << ", " << count << " generators");
      const Diagram diagram = compute_diagram(mesh, random_generators(mesh, count, 5));
      const IdVector<FaceId, GeneratorId> label = whole_labels(diagram);
      const std::vector<Rgb> colors =
          region_colors({mesh, &label, nullptr, &diagram.vertex_label, &diagram.vertex_distance, &diagram});
      const auto is_same = [&](GeneratorId a, GeneratorId b) {
        return a.valid() && b.valid() && a != b && colors[a.index()] == colors[b.index()];
      };
      for (const HalfedgeId h : mesh.halfedges()) {
        if (mesh.twin(h).valid()) edges += is_same(label[Mesh::face(h)], label[Mesh::face(mesh.twin(h))]);
      }
      for (const Bisector& bisector : diagram.bisectors) bisectors += is_same(bisector.left, bisector.right);
    }
  }
  CHECK(edges == 0);
  CHECK(bisectors == 0);
}

TEST_CASE("labels of vertices alone have colours, too, and a label that nothing has is no error") {
  const Mesh mesh = make_grid(3, 1);
  IdVector<VertexId, GeneratorId> label(mesh.vertex_count());
  for (const VertexId v : mesh.vertices()) {
    if (mesh.position(v).x() < 3) label[v] = GeneratorId(mesh.position(v).x() < 2 ? 0 : 7);
  }
  LabelledMesh file{mesh};
  CHECK(region_colors(file).empty());
  file.vertex_label = &label;
  const std::vector<Rgb> colors = region_colors(file);
  REQUIRE(colors.size() == 8);
  CHECK(colors[0] != colors[7]);
}

TEST_CASE("every colour is used about as often as the others") {
  const Mesh mesh = make_sphere(4);
  const Diagram diagram = compute_diagram(mesh, random_generators(mesh, 210, 2));
  const ViewScene scene = make_view_scene("", mesh, diagram);
  const std::vector<Rgb> colors = io::choose_region_colors(210, io::find_adjacent_regions(scene));
  for (std::size_t c = 0; c < io::kRegionPalette.size(); ++c) {
    const auto uses = std::count(colors.begin(), colors.end(), io::kRegionPalette[c]);
    INFO("colour " << c << ", " << uses << " times");
    CHECK((c < io::kUsualColors ? uses >= 25 && uses <= 45 : uses == 0));
  }
}

TEST_CASE("a region with 12 neighbours of many colours differs from all of them") {
  const Mesh mesh = make_sphere(4);
  std::vector<SurfacePoint> generators{nearest_vertex(mesh, 0, 0)};
  for (int i = 0; i < 12; ++i) generators.push_back(nearest_vertex(mesh, 1.0, 2 * kPi * i / 12));
  for (int i = 0; i < 24; ++i) generators.push_back(nearest_vertex(mesh, 1.25 + 0.1 * (i % 2), 2 * kPi * i / 24));
  const Diagram diagram = compute_diagram(mesh, generators);
  REQUIRE(diagram.cells[GeneratorId(0)].neighbours.size() == 12);
  ViewScene scene = make_view_scene("", mesh, diagram);
  CHECK(least_difference_of_neighbours(scene, diagram) >= kLeast);
  std::set<int> around;
  const std::vector<Rgb> colors = io::choose_region_colors(generators.size(), io::find_adjacent_regions(scene));
  for (const GeneratorId other : diagram.cells[GeneratorId(0)].neighbours) around.insert(code(colors[other.index()]));
  INFO(around.size() << " colours around it");
  CHECK(around.size() >= 4);
}

TEST_CASE("no planar map repeats a colour across a border, or needs more than the usual ones") {
  std::mt19937 random(7);
  for (int run = 0; run < 200; ++run) {
    // A region more at a time, at a corner of three others. In every other run some touch very many.
    Pairs pairs = complete_graph(3);
    std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {0, 1, 2}};
    for (int label = 3; label < 60; ++label) {
      const std::size_t t = random() % std::min<std::size_t>(triangles.size(), run % 2 == 0 ? 3 : 1000);
      const auto [a, b, c] = triangles[t];
      for (const int other : {a, b, c}) pairs.emplace_back(GeneratorId(other), GeneratorId(label));
      triangles[t] = {a, b, label};
      triangles.push_back({b, c, label});
      triangles.push_back({c, a, label});
    }
    const std::vector<Rgb> colors = io::choose_region_colors(60, pairs);
    CHECK(repeats(colors, pairs) == 0);
    CHECK(count_different(colors) <= io::kUsualColors);
  }
}

TEST_CASE("as many regions as can all touch each other up to genus 3 have colours of their own, and more have some") {
  for (const int count : {7, 8, 9}) {  // on surfaces of genus 1, 2 and 3
    CHECK(count_different(io::choose_region_colors(std::size_t(count), complete_graph(count))) == std::size_t(count));
  }
  const std::vector<Rgb> ten = io::choose_region_colors(10, complete_graph(10));
  CHECK(count_different(ten) == 9);
  CHECK(repeats(ten, complete_graph(10)) == 1);
  CHECK(io::choose_region_colors(0, {}).empty());
}

Pairs pairs_of(const std::vector<std::pair<int, int>>& given) {
  Pairs pairs;
  for (const auto& [a, b] : given) pairs.emplace_back(GeneratorId(a), GeneratorId(b));
  return pairs;
}

std::vector<Rgb> colors_of(const std::vector<std::size_t>& choice) {
  std::vector<Rgb> colors;
  for (const std::size_t c : choice) colors.push_back(io::kRegionPalette[c]);
  return colors;
}

bool neighbours_differ(const std::vector<Rgb>& colors, const Pairs& pairs) {
  return std::none_of(pairs.begin(), pairs.end(),
                      [&](const auto& pair) { return colors[pair.first.index()] == colors[pair.second.index()]; });
}

std::ptrdiff_t count_kept(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
  std::ptrdiff_t kept = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) kept += a[i] == b[i];
  return kept;
}

/// Scenes as generators move, each a little from where it was before; the iterations count upwards.
std::vector<ViewScene> make_scenes(const Mesh& mesh, int generators, std::int64_t count) {
  std::vector<SurfacePoint> points = random_generators(mesh, generators, 4);
  std::vector<ViewScene> scenes;
  for (std::int64_t k = 0; k < count; ++k) {
    scenes.push_back(make_view_scene("", mesh, compute_diagram(mesh, points)));
    scenes.back().iteration = k;
    const double step = 0.02 * mesh.bbox_diagonal();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double angle = double(i + std::size_t(k));
      points[i] = trace_geodesic(mesh, points[i], step * Vec2(std::cos(angle), std::sin(angle))).points.back();
    }
  }
  return scenes;
}

TEST_CASE("colours without a clash are kept, and one of two neighbours with the same colour changes") {
  const std::vector<Rgb> before = colors_of({0, 1, 2, 1});
  CHECK(io::adapt_region_colors(before, 4, pairs_of({{0, 1}, {1, 2}, {2, 3}})) == before);
  const Pairs clash = pairs_of({{0, 1}, {1, 3}, {2, 3}});
  const std::vector<Rgb> after = io::adapt_region_colors(before, 4, clash);
  CHECK(neighbours_differ(after, clash));
  CHECK(count_kept(before, after) == 3);
}

TEST_CASE("labels come and go") {
  const Pairs pairs = pairs_of({{0, 1}, {1, 2}, {0, 2}});
  const std::vector<Rgb> more = io::adapt_region_colors(colors_of({3, 4}), 3, pairs);
  REQUIRE(more.size() == 3);
  CHECK(count_kept(more, colors_of({3, 4})) == 2);
  CHECK(neighbours_differ(more, pairs));
  CHECK(io::adapt_region_colors(more, 2, pairs_of({{0, 1}})) == colors_of({3, 4}));
  CHECK(io::adapt_region_colors(more, 0, {}).empty());
}

TEST_CASE("a region with all usual colours round it takes the colour of a neighbour, which takes another one") {
  // Label 0 has that of label 6, and labels 1 to 6 all usual ones; each of these has no other neighbour.
  Pairs pairs;
  for (int i = 1; i < 7; ++i) pairs.emplace_back(GeneratorId(0), GeneratorId(i));
  const std::vector<Rgb> before = colors_of({5, 0, 1, 2, 3, 4, 5});
  const std::vector<Rgb> after = io::adapt_region_colors(before, 7, pairs);
  CHECK(neighbours_differ(after, pairs));
  CHECK(count_kept(before, after) >= 5);
}

TEST_CASE("dark colours go where a usual one will do, and come where regions need them") {
  const Pairs pair = pairs_of({{0, 1}});
  CHECK(io::adapt_region_colors(colors_of({0, 8}), 2, pair)[0] == io::kRegionPalette[0]);
  CHECK(io::adapt_region_colors(colors_of({0, 8}), 2, pair)[1] != io::kRegionPalette[8]);
  Pairs all;
  for (int a = 0; a < 9; ++a) {
    for (int b = a + 1; b < 9; ++b) all.emplace_back(GeneratorId(a), GeneratorId(b));
  }
  CHECK(neighbours_differ(io::adapt_region_colors(colors_of({0, 1, 2, 3, 4, 5, 6, 0, 1}), 9, all), all));
}

TEST_CASE("a region keeps its colour over the slider, and neighbours differ at each of its positions") {
  for (const auto& [name, mesh] : small_family()) {
    const std::vector<ViewScene> scenes = make_scenes(mesh, 40, 6);
    const auto colors = io::choose_scene_colors(scenes);
    REQUIRE(colors.size() == 6);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      INFO(name << ", iteration " << k);
      CHECK(neighbours_differ(colors[k], io::find_adjacent_regions(scenes[k])));
      if (k > 0) CHECK(count_kept(colors[k - 1], colors[k]) >= 32);
    }
    CHECK(colors.back() == io::choose_region_colors(40, io::find_adjacent_regions(scenes.back())));
  }
}

TEST_CASE("scenes that are no iterations, and the order of scenes in the page, change no colour of a slider") {
  const Mesh mesh = make_sphere(3);
  std::vector<ViewScene> scenes = make_scenes(mesh, 30, 3);
  const auto before = io::choose_scene_colors(scenes);
  ViewScene other = make_view_scene("other", mesh, compute_diagram(mesh, random_generators(mesh, 7, 1)));
  std::reverse(scenes.begin(), scenes.end());
  scenes.insert(scenes.begin() + 1, other);
  const auto after = io::choose_scene_colors(scenes);
  CHECK(after[0] == before[2]);
  CHECK(after[1] == io::choose_region_colors(7, io::find_adjacent_regions(other)));
  CHECK(after[2] == before[1]);
  CHECK(after[3] == before[0]);
}

}  // namespace gvd::test_region_colors
