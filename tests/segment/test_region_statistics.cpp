#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/region_statistics.hpp"
#include "gvd/segment.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_region_statistics {

constexpr GeneratorId kA(0), kB(1);

double total_boundary(const Mesh& mesh) {
  double sum = 0;
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    if (!mesh.twin(HalfedgeId(h)).valid()) sum += mesh.length(HalfedgeId(h));
  }
  return sum;
}

TEST_CASE("region statistics: one cell that is the whole surface") {
  const Mesh mesh = test::make_tetrahedron();
  const auto regions = compute_region_statistics(mesh, compute_diagram(mesh, {vertex_point(mesh, VertexId(0))}));
  REQUIRE(regions.size() == 1);
  CHECK(regions[kA].share == Approx(1));
  CHECK(regions[kA].perimeter == 0);
  CHECK(regions[kA].compactness == std::numeric_limits<double>::infinity());
  CHECK(regions[kA].euler_characteristic == 2);
  CHECK(regions[kA].neighbours.empty());
  CHECK(regions[kA].radius == Approx(2 * std::sqrt(2)));
}

TEST_CASE("region statistics: two halves of a flat rectangle") {
  const Mesh mesh = test::make_grid(4, 2);  // the bisector is x = 2
  const auto at = [](double x) { return x < 2 ? FaceId(2) : FaceId(4); };
  const std::vector<SurfacePoint> generators{edge_point(Mesh::halfedge(at(1), 0), 0),
                                             edge_point(Mesh::halfedge(at(3), 0), 1)};
  const auto regions = compute_region_statistics(mesh, compute_diagram(mesh, generators));
  for (const GeneratorId g : {kA, kB}) {
    CAPTURE(g.value());
    CHECK(regions[g].area == Approx(4));
    CHECK(regions[g].share == Approx(0.5));
    CHECK(regions[g].perimeter == Approx(8));
    CHECK(regions[g].radius == Approx(std::sqrt(5)));
    CHECK(regions[g].compactness == Approx(std::numbers::pi / 4));
    CHECK(regions[g].euler_characteristic == 1);
    REQUIRE(regions[g].neighbours.size() == 1);
    CHECK(regions[g].neighbours[0].region == (g == kA ? kB : kA));
    CHECK(regions[g].neighbours[0].border_length == Approx(2));
  }
}

TEST_CASE("region statistics: a cell inside one face has the radius of its corners") {
  const Mesh mesh = test::make_triangle();
  std::vector<SurfacePoint> generators{make_surface_point(FaceId(0), {0.4, 0.3, 0.3})};
  for (int i = 0; i < 3; ++i) {
    std::array<double, 3> bary{0.35, 0.325, 0.325};
    bary[std::size_t(i)] += 0.1;
    generators.push_back(make_surface_point(FaceId(0), {bary[0] / 1.1, bary[1] / 1.1, bary[2] / 1.1}));
  }
  const auto regions = compute_region_statistics(mesh, compute_diagram(mesh, generators));
  CHECK(regions[kA].radius > 0.01);
  CHECK(regions[kA].area <= std::numbers::pi * regions[kA].radius * regions[kA].radius);
}

TEST_CASE("region statistics: sums and bounds over mesh families") {
  for (const auto& [name, mesh] : test::small_family()) {
    if (compute_mesh_summary(mesh).components > 1) continue;
    for (const int count : {1, 2, 9, 60}) {
      CAPTURE(name, count);
      const auto generators = test::random_generators(mesh, count, 4);
      const Diagram diagram = compute_diagram(mesh, generators);
      const auto regions = compute_region_statistics(mesh, diagram);
      double share = 0, perimeter = 0, border = 0;
      for (std::size_t i = 0; i < regions.size(); ++i) {
        const RegionStatistics& r = regions.raw()[i];
        share += r.share;
        perimeter += r.perimeter;
        CHECK(r.neighbours.size() == diagram.cells.raw()[i].neighbours.size());
        for (const RegionNeighbour& n : r.neighbours) {
          border += n.border_length;
          CHECK(n.border_length >= 0);
        }
        CHECK(r.radius > 0);
      }
      CHECK(share == Approx(1));
      CHECK(perimeter == Approx(2 * diagram.length + total_boundary(mesh)));
      CHECK(border <= 2 * diagram.length * (1 + 1e-9));
      const ExactField field(mesh, generators);
      const double longest = longest_edge(mesh);
      for (int f = 0; f < mesh.face_count(); ++f) {
        const auto [distance, g] = field.nearest(make_surface_point(FaceId(f), {0.2, 0.3, 0.5}));
        REQUIRE(distance <= regions[g].radius + longest);
      }
    }
  }
}

TEST_CASE("region statistics: a component without a generator has no figures, and lowers the shares") {
  const Mesh mesh = test::make_two_components();
  const auto regions = compute_region_statistics(mesh, compute_diagram(mesh, {vertex_point(mesh, VertexId(0))}));
  CHECK(regions[kA].share < 0.99);
  CHECK(std::isfinite(regions[kA].radius));
}

TEST_CASE("region statistics: a diagram of another mesh is refused") {
  const Mesh mesh = test::make_grid(1, 1);
  CHECK_THROWS_AS(
      compute_region_statistics(test::make_sphere(1), compute_diagram(mesh, {vertex_point(mesh, VertexId(0))})), Error);
}

const std::string kHeader = "label,area,share,perimeter,radius,compactness,euler_characteristic,neighbours\r\n";

std::string to_csv(const IdVector<GeneratorId, RegionStatistics>& regions) {
  std::ostringstream out;
  write_statistics_csv(out, regions);
  return out.str();
}

TEST_CASE("statistics as CSV: without regions there is the header") { CHECK(to_csv({}) == kHeader); }

TEST_CASE("statistics as CSV: a line for each region, with the shortest numbers") {
  IdVector<GeneratorId, RegionStatistics> regions(2);
  regions[GeneratorId(0)] = {0.1, 1.0 / 3, 2, 1e-300, 0.5, 1, {{GeneratorId(1), 0.25}, {GeneratorId(7), 1.5}}};
  regions[GeneratorId(1)].compactness = std::numeric_limits<double>::infinity();
  CHECK(to_csv(regions) == kHeader + "0,0.1,0.3333333333333333,2,1e-300,0.5,1,1=0.25 7=1.5\r\n1,0,0,0,0,,0,\r\n");
}

TEST_CASE("statistics as CSV: charts add columns, those of one region together") {
  const Chart first{
      .generator = GeneratorId(1), .area = 3, .flipped_area = 1, .stretch = 1, .box = {Vec2(0, 0.5), Vec2(0.25, 1)}};
  const Chart second{.generator = GeneratorId(1), .area = 1, .stretch = 3, .box = {Vec2(0.5, 0), Vec2(0.75, 0.25)}};
  Charts charts;
  charts.charts = {first, second};
  std::ostringstream out;
  write_statistics_csv(out, IdVector<GeneratorId, RegionStatistics>(2), &charts);
  const std::string header =
      kHeader.substr(0, kHeader.size() - 2) + ",flipped_share,stretch,u_min,v_min,u_max,v_max\r\n";
  CHECK(out.str() == header + "0,0,0,0,0,0,0,,,,,,,\r\n1,0,0,0,0,0,0,,0.25,1.5,0,0,0.75,1\r\n");
}

TEST_CASE("the sizes of regions count faces and add areas, unlabelled faces left out") {
  const Mesh mesh = test::make_grid(2, 2);  // eight faces of area 1/2
  IdVector<FaceId, GeneratorId> label(8, GeneratorId(0));
  label[FaceId(3)] = label[FaceId(4)] = GeneratorId(2);
  label[FaceId(7)] = GeneratorId();
  const auto sizes = measure_regions(mesh, label, 3);
  REQUIRE(sizes.size() == 3);
  CHECK(sizes[GeneratorId(0)].faces == 5);
  CHECK(sizes[GeneratorId(0)].area == Approx(2.5));
  CHECK(sizes[GeneratorId(1)].faces == 0);
  CHECK(sizes[GeneratorId(1)].area == 0);
  CHECK(sizes[GeneratorId(2)].faces == 2);
  CHECK(sizes[GeneratorId(2)].area == Approx(1));
}

TEST_CASE("labels that do not fit the mesh or the number of regions are refused") {
  const Mesh mesh = test::make_grid(2, 2);
  const IdVector<FaceId, GeneratorId> short_by_one(7, GeneratorId(0)), labels(8, GeneratorId(3));
  CHECK_THROWS_AS(measure_regions(mesh, short_by_one, 1), Error);
  CHECK_THROWS_AS(measure_regions(mesh, labels, 3), Error);
  CHECK_NOTHROW(measure_regions(mesh, labels, 4));
}

TEST_CASE("region statistics: the graph has a node for each region, and an edge for each two that meet") {
  const Mesh mesh = test::make_grid(4, 2);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(2)),
                                             vertex_point(mesh, VertexId(4))};
  const Diagram diagram = compute_diagram(mesh, generators);
  std::ostringstream out;
  write_adjacency_graphml(out, mesh, generators, compute_region_statistics(mesh, diagram));
  const std::string text = out.str();
  CHECK(text.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml "));
  CHECK(text.ends_with("</graph>\n</graphml>\n"));
  const auto has = [&](const std::string& part) { return text.find(part) != std::string::npos; };
  for (const GeneratorId g : {GeneratorId(0), GeneratorId(1), GeneratorId(2)}) {
    const std::string id = std::to_string(g.value());
    const std::string node = "<node id=\"" + id + "\"><data key=\"label\">" + id + "</data><data key=\"area\">";
    REQUIRE(has(node));
    const std::string rest = text.substr(text.find(node) + node.size());
    CHECK(std::stod(rest) == Approx(g.value() == 1 ? 4 : 2));
    CHECK(
        rest.substr(rest.find('<')).starts_with("</data><data key=\"x\">" + std::to_string(2 * g.value()) + "</data>"));
  }
  CHECK(has("<edge source=\"0\" target=\"1\"><data key=\"length\">2</data></edge>"));
  CHECK(has("<edge source=\"1\" target=\"2\"><data key=\"length\">2</data></edge>"));
  CHECK(text.find("<edge source", text.find("<edge source=\"1\"") + 1) == std::string::npos);
  CHECK_THROWS_AS(write_adjacency_graphml(out, mesh, {}, compute_region_statistics(mesh, diagram)), Error);
}

}  // namespace gvd::test_region_statistics
