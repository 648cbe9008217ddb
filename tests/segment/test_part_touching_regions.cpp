// Regions that touch themselves at a vertex, taken apart: round fans, on a grid, and where cells nearly meet.

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "gvd/charts.hpp"
#include "part_touching_regions.hpp"
#include "plain_topology.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_part_touching_regions {

using Labels = std::vector<int>;

/// A mesh that is cut nowhere, with labels of its faces.
CutMesh label_faces(Mesh mesh, const Labels& labels) {
  CutMesh cut;
  cut.input_vertices = mesh.vertex_count();
  for (const FaceId f : mesh.faces()) {
    cut.parent.push_back(f);
    cut.label.push_back(GeneratorId(labels[f.index()]));
  }
  cut.mesh = std::move(mesh);
  return cut;
}

/// Faces round vertex 0, one for each label. `closed`: the last one is beside the first one.
CutMesh make_fan(const Labels& labels, bool closed) {
  const int n = int(labels.size()), rim = closed ? n : n + 1;
  std::vector<Vec3> positions{Vec3::Zero()};
  for (int i = 0; i < rim; ++i) {
    const double angle = 6.283185307179586 * i / (n + (closed ? 0 : n));
    positions.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  std::vector<std::array<VertexId, 3>> faces;
  for (int i = 0; i < n; ++i) faces.push_back({VertexId(0), VertexId(1 + i), VertexId(1 + (i + 1) % rim)});
  return label_faces(Mesh(std::move(positions), std::move(faces)), labels);
}

/// Cells of which all have a bisector in common, or none.
IdVector<GeneratorId, Cell> make_cells(int count, bool are_neighbours = true) {
  IdVector<GeneratorId, Cell> cells;
  for (int g = 0; g < count; ++g) {
    Cell cell;
    cell.generator = GeneratorId(g);
    for (int other = 0; are_neighbours && other < count; ++other) {
      if (other != g) cell.neighbours.emplace_back(other);
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

constexpr double kTolerance = 1e-15;

bool touches_itself(const CutMesh& cut) {
  for (const auto& [at, parts] : test::count_parts(cut.mesh, cut.label)) {
    if (parts > 1) return true;
  }
  return false;
}

std::map<GeneratorId, double> areas_of(const CutMesh& cut) {
  std::map<GeneratorId, double> areas;
  for (const FaceId f : cut.mesh.faces()) areas[cut.label[f]] += cut.mesh.area(f);
  return areas;
}

/// Takes the regions apart, and checks what holds for every mesh.
void require_parted(CutMesh cut, const IdVector<GeneratorId, Cell>& cells) {
  const CutMesh before = cut;
  REQUIRE(touches_itself(before));
  part_touching_regions(cells, kTolerance, cut);
  CHECK(!touches_itself(cut));
  CHECK(std::ranges::is_sorted(cut.parent.raw()));
  for (const VertexId v : before.mesh.vertices()) REQUIRE(cut.mesh.position(v) == before.mesh.position(v));
  CHECK(cut.mesh.vertex_count() - cut.mesh.edge_count() + cut.mesh.face_count() ==
        before.mesh.vertex_count() - before.mesh.edge_count() + before.mesh.face_count());
  const auto new_areas = areas_of(cut);
  for (const auto& [label, area] : areas_of(before)) CHECK(new_areas.at(label) == Approx(area).epsilon(1e-5));
  std::map<FaceId, double> of_parents;
  for (const FaceId f : cut.mesh.faces()) of_parents[cut.parent[f]] += cut.mesh.area(f);
  for (const auto& [parent, area] : of_parents) REQUIRE(area == Approx(before.mesh.area(parent)).epsilon(1e-12));
}

TEST_CASE("touching regions: a label with two sectors round a vertex keeps one, whatever is beside them") {
  for (const Labels& labels :
       {Labels{0, 1, 0, 2}, {1, 0, 2, 0}, {0, 0, 1, 0, 0, 2, 2}, {0, 1, 2, 0, 1, 2}, {0, 1, 0, 1, 2}}) {
    CAPTURE(labels);
    require_parted(make_fan(labels, true), make_cells(3));
  }
}

TEST_CASE("touching regions: at a boundary vertex, an end gives its corner to its only neighbour") {
  for (const Labels& labels : {Labels{0, 1, 0}, {0, 1, 0, 1}, {0, 0, 1, 2, 0}}) {
    CAPTURE(labels);
    require_parted(make_fan(labels, false), make_cells(3));
  }
}

TEST_CASE("touching regions: a region is connected through the vertex where it is not elsewhere") {
  const Mesh mesh = test::make_grid(6, 6);
  Labels labels;
  for (const FaceId f : mesh.faces()) {
    Vec3 centre = Vec3::Zero();
    for (const VertexId v : mesh.vertices(f)) centre += mesh.position(v) / 3;
    const double x = centre.x() - 3, y = centre.y() - 3;
    // Two quadrants of each label; label 0 goes round all, so that its two are connected.
    labels.push_back(std::max(std::abs(x), std::abs(y)) < 2 && x * y > 0 ? 1 : 0);
  }
  CutMesh cut = label_faces(mesh, labels);
  REQUIRE(test::find_topology(cut.mesh, cut.label)[GeneratorId(1)].components == 2);
  part_touching_regions(make_cells(2), kTolerance, cut);
  CHECK(!touches_itself(cut));
  for (const auto& [label, region] : test::find_topology(cut.mesh, cut.label)) CHECK(region.components == 1);
}

TEST_CASE("touching regions: no label passes to a cell without a common bisector, nor closes a ring") {
  CutMesh apart = make_fan({0, 1, 0, 2}, true);
  part_touching_regions(make_cells(3, false), kTolerance, apart);
  CHECK(apart.mesh.face_count() == 4);
  CutMesh unreached = make_fan({0, -1, 0, -1}, true);
  part_touching_regions(make_cells(1), kTolerance, unreached);
  CHECK(unreached.mesh.face_count() == 4);
}

TEST_CASE("touching regions: a vertex with thousands of sectors is soon done") {
  Labels labels;
  for (int i = 0; i < 2000; ++i) labels.push_back(i % 2 == 0 ? 0 : 1 + i / 2 % 50);
  require_parted(make_fan(labels, true), make_cells(51));
}

/// Squares of cubes of integer coordinates, with two triangles for each.
struct CubeFaces {
  std::map<std::array<int, 3>, int> number;
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;

  /// The square of a cube that is across an axis, on side 0 or 1.
  void add_square(const std::array<int, 3>& cube, int axis, int side) {
    std::array<VertexId, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<int, 3> at = cube;
      at[std::size_t(axis)] += side;
      at[std::size_t((axis + 1) % 3)] += k == 1 || k == 2 ? 1 : 0;
      at[std::size_t((axis + 2) % 3)] += k >= 2 ? 1 : 0;
      const auto [entry, is_new] = number.try_emplace(at, int(positions.size()));
      if (is_new) positions.emplace_back(at[0], at[1], at[2]);
      corners[k] = VertexId(entry->second);
    }
    if (side == 0) std::swap(corners[1], corners[3]);
    faces.push_back({corners[0], corners[1], corners[2]});
    faces.push_back({corners[0], corners[2], corners[3]});
  }
};

bool is_in_ring(const std::array<int, 3>& cube) {
  const auto [x, y, z] = cube;
  return z == 0 && x >= 0 && y >= 0 && x < 3 && y < 3 && (x != 1 || y != 1);
}

/// A ring of eight cubes.
Mesh make_cube_ring() {
  CubeFaces made;
  for (int i = 0; i < 9; ++i) {
    const std::array<int, 3> cube{i / 3, i % 3, 0};
    if (!is_in_ring(cube)) continue;
    for (int side = 0; side < 6; ++side) {
      std::array<int, 3> neighbour = cube;
      neighbour[std::size_t(side / 2)] += 2 * (side % 2) - 1;
      if (!is_in_ring(neighbour)) made.add_square(cube, side / 2, side % 2);
    }
  }
  return {std::move(made.positions), std::move(made.faces)};
}

TEST_CASE("a cut mesh: where branch points are nearer than rounding, no cell touches itself, and discs are discs") {
  const Mesh mesh = make_cube_ring();
  for (const std::vector<int>& vertices : {std::vector{0, 13, 25}, {0, 13, 29}, {0, 1, 2, 3}, {0, 9, 18, 27, 30}}) {
    CAPTURE(vertices);
    std::vector<SurfacePoint> generators;
    for (const int v : vertices) generators.push_back(vertex_point(mesh, VertexId(v)));
    const Diagram diagram = compute_diagram(mesh, generators);
    const CutMesh cut = cut_faces(mesh, diagram);
    CHECK(!touches_itself(cut));
    const auto regions = test::find_topology(cut.mesh, cut.label);
    std::vector<GeneratorId> non_discs;
    for (const Cell& cell : diagram.cells) {
      const test::RegionTopology& region = regions.at(cell.generator);
      CHECK(region.components == cell.components);
      CHECK(region.euler_characteristic == cell.euler_characteristic);
      if (region.components != 1 || region.euler_characteristic != 1) non_discs.push_back(cell.generator);
    }
    CHECK(find_non_disc_regions(cut.mesh, cut.label) == non_discs);
    const CutVertices carried = carry_to_cut_vertices(mesh, diagram, cut);
    CHECK(carried.label.count() == cut.mesh.vertex_count());
  }
}

TEST_CASE("regions that touch themselves at a vertex are no discs as meshes") {
  const CutMesh fan = make_fan({0, 1, 0, 2}, true);
  CHECK(find_non_disc_regions(fan.mesh, fan.label) == std::vector{GeneratorId(0)});
  // Faces 0 and 3 of a strip touch at a vertex, and are connected by faces 4 and 5.
  CutMesh ring = make_fan({0, 1, 0, 2}, true);
  std::vector<Vec3> positions = ring.mesh.positions();
  positions.emplace_back(3, 3, 0);
  const auto corner = [](int a, int b, int c) { return std::array{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh mesh(positions, {corner(0, 1, 2), corner(0, 2, 3), corner(0, 3, 4), corner(2, 1, 5), corner(3, 2, 5),
                              corner(4, 3, 5)});
  IdVector<FaceId, GeneratorId> label(std::size_t{6}, GeneratorId(0));
  label[FaceId(1)] = GeneratorId(1);
  CHECK(find_non_disc_regions(mesh, label) == std::vector{GeneratorId(0)});
}

}  // namespace gvd::test_part_touching_regions
