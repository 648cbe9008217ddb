// Texture coordinates of regions: known logarithms, maps without a flip, islands apart from each other.
#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include "base/plane.hpp"
#include "gvd/charts.hpp"
#include "gvd/disc_cells.hpp"
#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/face_regions.hpp"
#include "pack_boxes.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_charts {

/// A cut mesh and its charts.
struct Made {
  Diagram diagram;
  CutMesh cut;
  Charts charts;

  Vec2 at(FaceId f, int corner) const {
    const auto& [u, v] = charts.texture[3 * f.index() + std::size_t(corner)];
    return {u, v};
  }
  /// The corner of a logmap, mesh units round its generator.
  Vec2 log(const Chart& chart, FaceId f, int corner) const { return (at(f, corner) - chart.origin) / charts.scale; }
  bool is_counter_clockwise(FaceId f) const { return orientation(at(f, 0), at(f, 1), at(f, 2)) > 0; }
  double area(FaceId f) const { return 0.5 * twice_signed_area(at(f, 0), at(f, 1), at(f, 2)); }
};

Made make(const Mesh& mesh, Diagram diagram, ChartMap map, int threads = 0) {
  Made made{std::move(diagram), {}, {}};
  made.cut = cut_faces(mesh, made.diagram);
  made.charts = make_charts(mesh, made.diagram, made.cut, {.map = map, .threads = threads});
  return made;
}

Made make(const Mesh& mesh, const std::vector<SurfacePoint>& generators, ChartMap map) {
  return make(mesh, compute_diagram(mesh, generators), map);
}

/// The boxes of the charts of regions that have one chart each.
std::vector<Box2> boxes_of(const Made& made) {
  std::vector<Box2> boxes(made.diagram.generators.size());
  for (const FaceId f : made.cut.mesh.faces()) {
    for (int c = 0; c < 3 && made.cut.label[f].valid(); ++c) boxes[made.cut.label[f].index()].extend(made.at(f, c));
  }
  return boxes;
}

void check_square(const Made& made) {
  std::vector<Box2> boxes = boxes_of(made);
  std::erase_if(boxes, [](const Box2& box) { return box.isEmpty(); });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CHECK(boxes[i].min().minCoeff() > 0);
    CHECK(boxes[i].max().maxCoeff() < 1);
    for (std::size_t k = 0; k < i; ++k) CHECK(!boxes[i].intersects(boxes[k]));
  }
}

void check_logarithms_in_plane(const Mesh& mesh, const Made& made) {
  const double extent = mesh.bbox_diagonal();
  std::vector<std::complex<double>> turn(made.diagram.generators.size());
  REQUIRE(made.charts.charts.size() == turn.size());
  for (const FaceId f : made.cut.mesh.faces()) {
    const GeneratorId g = made.cut.label[f];
    const Vec3 from = position(mesh, made.diagram.generators[g.index()]);
    const auto chart = std::ranges::find(made.charts.charts, g, &Chart::generator);
    for (int c = 0; c < 3; ++c) {
      const Vec3 to = made.cut.mesh.position(made.cut.mesh.vertices(f)[std::size_t(c)]) - from;
      const Vec2 log = made.log(*chart, f, c);
      REQUIRE(std::abs(log.norm() - to.norm()) < 1e-12 * extent);
      // The same turn of all vectors of a generator: its tangent plane has axes of its own.
      const std::complex<double> planar(to.x(), to.y()), laid(log.x(), log.y());
      if (to.norm() < 0.1) continue;
      if (turn[g.index()] == 0.0) turn[g.index()] = laid / planar;
      REQUIRE(std::abs(laid - turn[g.index()] * planar) < 1e-11 * extent);
    }
  }
}

TEST_CASE("charts: logarithms of a flat mesh are planar polar coordinates") {
  const Mesh mesh = test::make_jittered_grid(9, 7, 0.2, 3);
  for (unsigned seed = 1; seed < 4; ++seed) {
    const Made made = make(mesh, test::random_generators(mesh, 7, seed), ChartMap::logmap);
    check_logarithms_in_plane(mesh, made);
    check_square(made);
    CHECK(made.charts.share(&Chart::torn_area) == 0);
    CHECK(made.charts.share(&Chart::unplaced_area) == 0);
    CHECK(made.charts.share(&Chart::flipped_area) < 1e-9);  // of needles that a cut has left
  }
}

TEST_CASE("charts: logarithms of a flat mesh with weights are planar polar coordinates") {
  const Mesh mesh = test::make_jittered_grid(9, 7, 0.2, 3);
  DiagramOptions options;
  options.weights = {0, -0.3, 0.2, 0.1};
  const auto generators = test::random_generators(mesh, 4, 6);
  check_logarithms_in_plane(mesh, make(mesh, compute_diagram(mesh, generators, options), ChartMap::logmap));
}

/// A cone of a total angle at its apex, vertex 0: `sides` flat sectors with the radii 1, 2, ... `rings`.
Mesh make_cone(double total_angle, int sides, int rings) {
  const double half = 0.5 * total_angle / sides, slice = 2 * std::numbers::pi / sides;
  const double radius = std::sin(half) / std::sin(0.5 * slice), height = std::sqrt(1 - radius * radius);
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  for (int r = 1; r <= rings; ++r) {
    for (int i = 0; i < sides; ++i) {
      positions.emplace_back(r * radius * std::cos(slice * i), r * radius * std::sin(slice * i), -r * height);
      const int next = (i + 1) % sides, inner = 1 + (r - 2) * sides, outer = 1 + (r - 1) * sides;
      if (r == 1) {
        faces.push_back({0, outer + i, outer + next});
      } else {
        faces.push_back({inner + i, outer + i, outer + next});
        faces.push_back({inner + i, outer + next, inner + next});
      }
    }
  }
  return test::make_mesh(std::move(positions), faces);
}

TEST_CASE("charts: at the apex of a cone, angles are scaled to a full turn") {
  constexpr int kSides = 12, kRings = 3;
  const Mesh mesh = make_cone(4, kSides, kRings);
  const Made made = make(mesh, {vertex_point(mesh, VertexId(0))}, ChartMap::logmap);
  REQUIRE(made.charts.charts.size() == 1);
  CHECK(made.charts.share(&Chart::flipped_area) == 0);
  const Chart& chart = made.charts.charts.front();
  for (const FaceId f : made.cut.mesh.faces()) {
    for (int c = 0; c < 3; ++c) {
      const VertexId v = made.cut.mesh.vertices(f)[std::size_t(c)];
      if (v == VertexId(0)) continue;
      const Vec2 log = made.log(chart, f, c);
      const int ring = 1 + (v.value() - 1) / kSides, side = (v.value() - 1) % kSides;
      CHECK(log.norm() == Approx(ring).epsilon(1e-12));
      // The x axis is the apex's first halfedge.
      const int first = (mesh.to(mesh.halfedge(VertexId(0))).value() - 1) % kSides;
      const double angle = 2 * std::numbers::pi * (side - first) / kSides;
      CHECK((log / ring - unit_vector(angle)).norm() < 1e-12);
    }
  }
}

TEST_CASE("charts: round the apex of a cone, logarithms have the lengths of unfolded paths, and tear behind it") {
  constexpr int kSides = 24, kRings = 6;
  constexpr double kTotal = 4;
  const Mesh mesh = make_cone(kTotal, kSides, kRings);
  const int from = 1 + 2 * kSides;  // on ring 3
  const Made made = make(mesh, {vertex_point(mesh, VertexId(from))}, ChartMap::logmap);
  const Chart& chart = made.charts.charts.front();
  for (const FaceId f : made.cut.mesh.faces()) {
    for (int c = 0; c < 3; ++c) {
      const int v = made.cut.mesh.vertices(f)[std::size_t(c)].value();
      const double radius = v == 0 ? 0 : 1 + (v - 1) / kSides;
      const double turn = kTotal / kSides * ((v == 0 ? 0 : v - 1) % kSides);
      const double angle = std::min(turn, kTotal - turn),
                   expected = std::sqrt(9 + radius * radius - 6 * radius * std::cos(angle));
      // A torn face is laid by its centre: only its shape is checked, below.
      const bool is_behind = std::abs(turn - kTotal / 2) < 1.5 * kTotal / kSides;
      if (!is_behind) CHECK(made.log(chart, f, c).norm() == Approx(expected).epsilon(1e-11).margin(1e-12));
    }
  }
  CHECK(chart.torn_area > 0);
  CHECK(chart.torn_area < 0.2 * chart.area);
  CHECK(chart.flipped_area == 0);
  CHECK(chart.unplaced_area == 0);
}

TEST_CASE("charts: at the tip of a cone of many faces, no work is repeated for each of them") {
  // Each step that looked at all faces round the tip for each vertex took half a minute and more.
  constexpr int kSides = 20000;
  const Mesh mesh = make_cone(6, kSides, 1);
  const VertexId tip(0), rim(1);
  const Made at_tip = make(mesh, {vertex_point(mesh, tip)}, ChartMap::logmap);
  CHECK(at_tip.charts.charts.front().flipped_area == 0);
  CHECK(at_tip.charts.charts.front().unplaced_area == 0);
  for (const FaceId f : at_tip.cut.mesh.faces()) {
    for (int c = 0; c < 3; ++c) {
      const double expected = at_tip.cut.mesh.vertices(f)[std::size_t(c)] == tip ? 0 : 1;
      REQUIRE(at_tip.log(at_tip.charts.charts.front(), f, c).norm() == Approx(expected).margin(1e-12));
    }
  }
  // Three cells meet near the tip, and thousands of paths begin there.
  const Made three =
      make(mesh, {vertex_point(mesh, rim), vertex_point(mesh, VertexId(6000)), vertex_point(mesh, VertexId(13000))},
           ChartMap::logmap);
  CHECK(three.charts.charts.size() == 3);
  CHECK(three.charts.share(&Chart::flipped_area) < 1e-9);
  CHECK(three.charts.share(&Chart::unplaced_area) == 0);
}

TEST_CASE("charts: the stretch is that of a known map, and 1 where the map is isometric") {
  constexpr int kSides = 12;
  constexpr double kTotal = 4;
  const Mesh cone = make_cone(kTotal, kSides, 1), grid = test::make_grid(6, 4), sphere = test::make_sphere(3);
  // The sectors are laid with a full turn in place of kTotal: their bases and heights grow by these factors.
  const double half = std::numbers::pi / kSides, was = kTotal / 2 / kSides;
  const double expected = std::hypot(std::sin(half) / std::sin(was), std::cos(half) / std::cos(was)) / std::sqrt(2);
  const Made laid = make(cone, {vertex_point(cone, VertexId(0))}, ChartMap::logmap);
  CHECK(laid.charts.charts.front().stretch == Approx(expected).epsilon(1e-12));
  for (const ChartMap map : {ChartMap::logmap, ChartMap::flat}) {
    const Made flat = make(grid, {make_surface_point(FaceId(20), {0.2, 0.3, 0.5})}, map);
    CHECK(flat.charts.charts.front().stretch == Approx(1).epsilon(1e-4));
    const Made made = make(sphere, test::random_generators(sphere, 12, 2), map);
    const std::vector<Box2> boxes = boxes_of(made);
    for (const Chart& chart : made.charts.charts) {
      CHECK(chart.box.isApprox(boxes[chart.generator.index()], 0));
      CHECK(std::abs(chart.stretch - 1) < 0.1);
    }
  }
}

TEST_CASE("charts: on a sphere the logarithm has the exact distance, and torn faces have their shapes") {
  const Mesh mesh = test::make_sphere(3);
  const auto generators = test::random_generators(mesh, 1, 2);
  const Made made = make(mesh, generators, ChartMap::logmap);
  const ExactField field(mesh, generators);
  const Chart& chart = made.charts.charts.front();
  int torn = 0;
  for (const FaceId f : made.cut.mesh.faces()) {
    REQUIRE(std::isfinite(made.at(f, 0).x()));
    int exact = 0;
    for (int c = 0; c < 3; ++c) {
      const double distance = field.distance(made.cut.mesh.vertices(f)[std::size_t(c)]);
      exact += std::abs(made.log(chart, f, c).norm() - distance) < 1e-11;
    }
    if (exact == 3) continue;
    ++torn;
    CHECK(made.area(f) == Approx(made.cut.mesh.area(f) * made.charts.scale * made.charts.scale).epsilon(1e-9));
  }
  CHECK(torn > 0);
  CHECK(torn < 0.12 * mesh.face_count());  // beyond 4/5 of the way: (1 - cos(36 degrees)) / 2 of the area, .095
  CHECK(chart.torn_area > 0);
  CHECK(chart.torn_area < 0.12 * chart.area);
}

TEST_CASE("charts: flat maps of all families flip no face, have the regions' areas, and lie apart in the square") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (const int count : {1, 6, 25}) {
      const auto generators = test::random_generators(mesh, count, unsigned(count));
      const DiscCells discs = make_discs(mesh, compute_diagram(mesh, generators));
      const Made made = make(mesh, discs.diagram, ChartMap::flat);
      std::vector<double> laid(made.diagram.generators.size(), 0), area = laid;
      for (const FaceId f : made.cut.mesh.faces()) {
        const GeneratorId g = made.cut.label[f];
        if (!g.valid()) {
          CHECK(std::isnan(made.at(f, 0).x()));
          continue;
        }
        REQUIRE(made.is_counter_clockwise(f));
        laid[g.index()] += made.area(f);
        area[g.index()] += made.cut.mesh.area(f);
      }
      const double scale = made.charts.scale * made.charts.scale;
      for (std::size_t g = 0; g < laid.size(); ++g) CHECK(laid[g] == Approx(scale * area[g]).epsilon(1e-9));
      CHECK(made.charts.share(&Chart::flipped_area) == 0);
      CHECK(made.charts.charts.size() == laid.size());
      check_square(made);
    }
  }
}

TEST_CASE("charts: a flat region with its generator inside keeps its shape") {
  const Mesh mesh = test::make_jittered_grid(12, 9, 0.2, 3);
  std::vector<SurfacePoint> generators;
  for (int f = 5; f < mesh.face_count(); f += 40) generators.push_back(make_surface_point(FaceId(f), {0.3, 0.3, 0.4}));
  const Made made = make(mesh, generators, ChartMap::flat);
  for (const FaceId f : made.cut.mesh.faces()) {
    for (int c = 0; c < 3; ++c) {
      const double side = made.cut.mesh.length(Mesh::halfedge(f, c));
      CHECK((made.at(f, (c + 1) % 3) - made.at(f, c)).norm() ==
            Approx(made.charts.scale * side).margin(1e-4 * made.charts.scale));
    }
  }
}

TEST_CASE("charts: corners of a region at one vertex have the same bits, if they are not torn") {
  const Mesh mesh = test::make_torus(24, 12);
  for (const ChartMap map : {ChartMap::flat, ChartMap::logmap}) {
    const Made made = make(mesh, test::random_generators(mesh, 20, 4), map);
    if (made.charts.share(&Chart::torn_area) > 0) continue;
    std::map<std::pair<VertexId, GeneratorId>, Vec2> first;
    for (const FaceId f : made.cut.mesh.faces()) {
      for (int c = 0; c < 3; ++c) {
        const auto [entry, is_new] =
            first.try_emplace({made.cut.mesh.vertices(f)[std::size_t(c)], made.cut.label[f]}, made.at(f, c));
        CHECK(entry->second == made.at(f, c));
      }
    }
  }
}

TEST_CASE("charts: what is no disc can't be laid flat, and is named, its logarithms tear") {
  const Mesh mesh = test::make_torus(24, 12);
  const auto generators = test::random_generators(mesh, 2, 1);
  try {
    make(mesh, generators, ChartMap::flat);
    FAIL("the cells of two generators on a torus are no discs");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::no_valid_result);
    CHECK((error.element() == 0 || error.element() == 1));
  }
  const Made made = make(mesh, generators, ChartMap::logmap);
  CHECK(made.charts.share(&Chart::torn_area) > 0);
  CHECK(made.charts.share(&Chart::unplaced_area) == 0);
  CHECK(find_non_disc_regions(made.cut.mesh, made.cut.label).size() >= 1);
  CHECK(find_non_disc_regions(mesh, IdVector<FaceId, GeneratorId>(std::size_t(mesh.face_count()), GeneratorId(0))) ==
        std::vector{GeneratorId(0)});
}

TEST_CASE("charts: no bit depends on the number of threads") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 12, 4));
  for (const ChartMap map : {ChartMap::flat, ChartMap::logmap}) {
    const auto one = make(mesh, diagram, map, 1).charts.texture;
    std::vector<Uv> many;
    test::with_many_threads([&] { many = make(mesh, diagram, map, 8).charts.texture; });
    REQUIRE(one.size() == many.size());
    CHECK(std::equal(one.begin(), one.end(), many.begin(), [](const Uv& a, const Uv& b) { return a == b; }));
  }
}

TEST_CASE("charts: regions that were separated have charts of their own") {
  const Mesh mesh = test::make_grid(8, 4);
  FaceRegions regions;
  for (const FaceId f : mesh.faces()) regions.push_back(mesh.position(mesh.vertices(f)[0]).x() < 4 ? 0 : 1);
  const SeparatedMesh separated = separate_regions(mesh, regions);
  const Diagram diagram =
      compute_diagram(separated.mesh, {make_surface_point(FaceId(3), {0.2, 0.3, 0.5}),
                                       make_surface_point(FaceId(mesh.face_count() - 3), {0.2, 0.3, 0.5})});
  const CutMesh cut = cut_faces(mesh, diagram);
  const Charts charts = make_charts(separated.mesh, diagram, cut, {.map = ChartMap::logmap});
  CHECK(charts.charts.size() == 2);
  CHECK(charts.share(&Chart::unplaced_area) == 0);
  CHECK(charts.share(&Chart::flipped_area) == 0);
  CHECK_THROWS_AS(make_charts(test::make_grid(1, 1), diagram, cut), Error);
}

TEST_CASE("pack boxes: they lie apart in the square, in a fair part of it, and the same each time") {
  test::Random random(5);
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{17}, std::size_t{2000}}) {
    std::vector<Vec2> sizes;
    double area = 0;
    for (std::size_t i = 0; i < count; ++i) {
      sizes.emplace_back(random.real(0.1, 1), random.real(0.1, 1));
      area += sizes.back().prod();
    }
    const Packing packing = pack_boxes(sizes);
    REQUIRE(packing.at.size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      const Box2 box(packing.at[i], packing.at[i] + sizes[i]);
      CHECK(box.min().minCoeff() > 0);
      CHECK(box.max().maxCoeff() < packing.side);
      for (std::size_t k = 0; k < i; ++k) {
        if (box.intersects(Box2(packing.at[k], packing.at[k] + sizes[k]))) FAIL("two boxes overlap");
      }
    }
    if (count > 10) CHECK(area > 0.5 * packing.side * packing.side);
    CHECK(pack_boxes(sizes).at == packing.at);
  }
  CHECK(pack_boxes({}).at.empty());
  CHECK(pack_boxes({Vec2(0, 0)}).at.size() == 1);
}

}  // namespace gvd::test_charts
