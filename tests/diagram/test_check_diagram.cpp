// Violates each property of a sound diagram in turn: the check has to name its number.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "diagram/check_diagram.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"
#include "support/three_cells.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_check_diagram {

using test::ThreeCells;

/// A mesh with boundary and one without, with generators on vertices, on edges and in faces.
struct Sound {
  Mesh mesh;
  Diagram diagram;
  explicit Sound(Mesh input, int count = 12) : mesh(std::move(input)) {
    DiagramOptions options;
    options.method = Method::gbgvd;  // one straight arc of a bisector in a face: some cases depend on it
    diagram = compute_diagram(mesh, test::random_generators(mesh, count, 16), options);
    REQUIRE(check_diagram(mesh, diagram).ok());
  }
};

std::vector<Sound> sound_diagrams() {
  std::vector<Sound> all;
  all.emplace_back(test::make_sphere(3));
  all.emplace_back(test::make_ring(24, 6));
  all.emplace_back(test::make_genus3(3));
  return all;
}

bool names(const DiagramCheck& check, int property) {
  const std::string start = fmt::format("({}) ", property);
  return std::any_of(check.violations.begin(), check.violations.end(),
                     [&](const auto& v) { return v.starts_with(start); });
}

/// Changes copies of the sound diagrams. `tamper` returns false if it can't be applied to a diagram; it must apply to
/// one.
void require_named(int property, const std::function<bool(const Mesh&, Diagram&)>& tamper) {
  int tampered = 0;
  for (const Sound& sound : sound_diagrams()) {
    Diagram diagram = sound.diagram;
    if (!tamper(sound.mesh, diagram)) continue;
    ++tampered;
    const DiagramCheck check = check_diagram(sound.mesh, diagram);
    for (const std::string& violation : check.violations) UNSCOPED_INFO(violation);
    CHECK(names(check, property));
  }
  REQUIRE(tampered > 0);
}

GeneratorId other_than(GeneratorId g) { return GeneratorId(g.value() == 0 ? 1 : 0); }

Bisector* first_bisector(Diagram& d, const std::function<bool(const Bisector&)>& wanted) {
  const auto it = std::find_if(d.bisectors.begin(), d.bisectors.end(), wanted);
  return it == d.bisectors.end() ? nullptr : &*it;
}

bool joins_branches(const Bisector& b) { return b.ends[0].valid() && b.ends[1].valid(); }
bool ends_on_boundary(const Bisector& b) { return !b.closed && !b.ends[0].valid(); }

TEST_CASE("(1) a generator outside its cell") {
  SECTION("at a vertex of another label") {
    require_named(1, [](const Mesh& mesh, Diagram& d) {
      const auto at_vertex = std::find_if(d.generators.begin(), d.generators.end(),
                                          [](const auto& p) { return p.kind() == SurfacePoint::Kind::vertex; });
      GeneratorId& label = d.vertex_label[vertex(mesh, *at_vertex)];
      label = other_than(label);
      return true;
    });
  }
  for (const auto kind : {SurfacePoint::Kind::vertex, SurfacePoint::Kind::edge, SurfacePoint::Kind::face}) {
    require_named(1, [&](const Mesh&, Diagram& d) {  // two of them swapped
      const auto p =
          std::find_if(d.generators.begin(), d.generators.end(), [&](const auto& x) { return x.kind() == kind; });
      if (p == d.generators.end()) return false;
      std::swap(*p, p + 1 == d.generators.end() ? d.generators.front() : *(p + 1));
      return true;
    });
  }
  require_named(1, [](const Mesh&, Diagram& d) { return d.cells[GeneratorId(0)].area = -1, true; });
}

TEST_CASE("(1) generators and cells that do not match each other or the mesh") {
  require_named(1, [](const Mesh&, Diagram& d) { return d.cells.raw().pop_back(), true; });
  require_named(
      1, [](const Mesh&, Diagram& d) { return std::swap(d.cells[GeneratorId(0)], d.cells[GeneratorId(1)]), true; });
  require_named(1, [](const Mesh& m, Diagram& d) { return d.generators[0].face = FaceId(m.face_count()), true; });
  require_named(1, [](const Mesh&, Diagram& d) { return d.generators[0].face = FaceId(), true; });
}

TEST_CASE("(2) faces that are not covered once") {
  require_named(2, [](const Mesh&, Diagram& d) { return d.pieces.erase(d.pieces.begin() + 3), true; });
  require_named(
      2, [](const Mesh&, Diagram& d) { return d.pieces.insert(d.pieces.begin() + 3, FacePiece(d.pieces[3])), true; });
  require_named(2, [](const Mesh&, Diagram& d) {
    return std::reverse(d.pieces[3].corners.begin(), d.pieces[3].corners.end()), true;
  });
  require_named(2, [](const Mesh&, Diagram& d) { return d.pieces[3].corners.pop_back(), true; });
  require_named(2,
                [](const Mesh&, Diagram& d) { return d.face_label[d.pieces[3].face] = d.pieces[3].generator, true; });
  require_named(2, [](const Mesh&, Diagram& d) {
    return std::rotate(d.pieces.begin(), d.pieces.end() - 1, d.pieces.end()), true;
  });
  require_named(2, [](const Mesh&, Diagram& d) {
    const auto whole = std::find_if(d.face_label.begin(), d.face_label.end(), [](GeneratorId g) { return g.valid(); });
    return *whole = GeneratorId(), true;
  });
}

TEST_CASE("(2) a face, a piece or a vertex with another cell's label") {
  require_named(2, [](const Mesh&, Diagram& d) {
    const auto whole = std::find_if(d.face_label.begin(), d.face_label.end(), [](GeneratorId g) { return g.valid(); });
    return *whole = other_than(*whole), true;
  });
  require_named(
      2, [](const Mesh&, Diagram& d) { return d.pieces[3].generator = other_than(d.pieces[3].generator), true; });
  require_named(2, [](const Mesh&, Diagram& d) {
    GeneratorId& label = d.vertex_label[VertexId(7)];
    return label = other_than(label), true;
  });
  require_named(2, [](const Mesh& mesh, Diagram& d) {  // of the same area, so that no sum changes
    for (int i = 0; i < mesh.face_count(); ++i) {
      for (int j = 0; j < i; ++j) {
        GeneratorId &a = d.face_label[FaceId(i)], &b = d.face_label[FaceId(j)];
        if (a.valid() && b.valid() && a != b && std::abs(mesh.area(FaceId(i)) - mesh.area(FaceId(j))) < 1e-12) {
          return std::swap(a, b), true;
        }
      }
    }
    return false;
  });
  require_named(2, [](const Mesh&, Diagram& d) { return d.cells[GeneratorId(0)].area *= 1.001, true; });
  require_named(2, [](const Mesh&, Diagram& d) {
    return std::swap(d.cells[GeneratorId(0)].area, d.cells[GeneratorId(1)].area), true;
  });
}

TEST_CASE("(2) labels that do not match the mesh or the cells") {
  require_named(2, [](const Mesh&, Diagram& d) { return d.vertex_label.raw().pop_back(), true; });
  require_named(2, [](const Mesh&, Diagram& d) { return d.vertex_distance.raw().pop_back(), true; });
  require_named(2, [](const Mesh&, Diagram& d) { return d.face_label.raw().pop_back(), true; });
  require_named(2, [](const Mesh&, Diagram& d) { return d.face_label[FaceId(0)] = GeneratorId(1000), true; });
  require_named(2, [](const Mesh&, Diagram& d) { return d.vertex_label[VertexId(0)] = GeneratorId(1000), true; });
  require_named(2, [](const Mesh&, Diagram& d) { return d.pieces[0].generator = GeneratorId(), true; });
  require_named(2, [](const Mesh& m, Diagram& d) { return d.pieces.back().face = FaceId(m.face_count()), true; });
}

TEST_CASE("(3) a bisector that separates no cells, or whose points have no common face") {
  require_named(3, [](const Mesh&, Diagram& d) {
    Bisector& b = d.bisectors[BisectorId(1)];
    return b.left = b.right, true;
  });
  require_named(3, [](const Mesh&, Diagram& d) { return d.bisectors[BisectorId(1)].left = GeneratorId(), true; });
  require_named(3, [](const Mesh&, Diagram& d) { return d.bisectors[BisectorId(1)].right = GeneratorId(1000), true; });
  require_named(3, [](const Mesh&, Diagram& d) { return d.bisectors[BisectorId(1)].points.resize(1), true; });
  require_named(3, [](const Mesh& mesh, Diagram& d) {
    Bisector& b = d.bisectors[BisectorId(1)];
    const FaceId far(b.points[0].face.value() < mesh.face_count() / 2 ? mesh.face_count() - 1 : 0);
    return b.points[b.points.size() / 2] = make_surface_point(far, {0.3, 0.3, 0.4}), true;
  });
  require_named(3, [](const Mesh&, Diagram& d) {
    Bisector* b = first_bisector(d, [](const Bisector& x) { return x.points.size() > 6; });
    return b->points.erase(b->points.begin() + 2, b->points.begin() + 5), true;
  });
  require_named(3, [](const Mesh&, Diagram& d) { return d.bisectors[BisectorId(0)].points[0].face = FaceId(), true; });
}

TEST_CASE("(4) an end neither at a branch point nor on the boundary") {
  require_named(
      4, [](const Mesh&, Diagram& d) { return first_bisector(d, joins_branches)->ends[0] = BranchPointId(), true; });
  require_named(
      4, [](const Mesh&, Diagram& d) { return first_bisector(d, joins_branches)->ends[1] = BranchPointId(), true; });
  require_named(4, [](const Mesh&, Diagram& d) {
    return first_bisector(d, joins_branches)->ends[1] = BranchPointId(1000), true;
  });
  require_named(4, [](const Mesh&, Diagram& d) {  // moved away from the boundary
    Bisector* b = first_bisector(d, ends_on_boundary);
    if (!b) return false;
    b->points.front() = make_surface_point(b->points.front().face, {0.3, 0.3, 0.4});
    return true;
  });
  require_named(4, [](const Mesh&, Diagram& d) { return d.branch_points.raw().pop_back(), true; });
}

TEST_CASE("(5) branch points and their bisectors") {
  require_named(5,
                [](const Mesh&, Diagram& d) { return d.branch_points[BranchPointId(0)].generators.pop_back(), true; });
  require_named(5, [](const Mesh&, Diagram& d) {
    auto& g = d.branch_points[BranchPointId(0)].generators;
    return g.push_back(other_than(g[0])), true;
  });
  require_named(5, [](const Mesh&, Diagram& d) {
    auto& generators = d.branch_points[BranchPointId(0)].generators;
    for (int g = 0; g < 12; ++g) {
      if (std::find(generators.begin(), generators.end(), GeneratorId(g)) != generators.end()) continue;
      return generators[1] = GeneratorId(g), true;
    }
    return false;
  });
  require_named(
      5, [](const Mesh&, Diagram& d) { return d.branch_points.push_back(d.branch_points[BranchPointId(0)]), true; });
  require_named(5, [](const Mesh&, Diagram& d) {
    const auto it = std::find_if(d.bisectors.begin(), d.bisectors.end(), joins_branches);
    return d.bisectors.raw().erase(it), true;
  });
  require_named(5, [](const Mesh&, Diagram& d) {
    Bisector* b = first_bisector(d, joins_branches);
    return std::swap(b->left, b->right), true;
  });
  require_named(5, [](const Mesh&, Diagram& d) {
    Bisector* b = first_bisector(d, joins_branches);
    return std::swap(b->ends[0], b->ends[1]), true;
  });
}

TEST_CASE("(6) cells that are not connected, or have an impossible Euler characteristic") {
  const GeneratorId g(2);
  require_named(6, [&](const Mesh&, Diagram& d) { return d.cells[g].components = 2, true; });
  require_named(6, [&](const Mesh&, Diagram& d) { return d.cells[g].components = 0, true; });
  require_named(6, [&](const Mesh&, Diagram& d) { return ++d.cells[g].euler_characteristic, true; });
  require_named(6, [&](const Mesh&, Diagram& d) { return --d.cells[g].euler_characteristic, true; });
  require_named(6, [&](const Mesh&, Diagram& d) { return ++d.cells[g].boundary_loops, true; });
  require_named(6, [&](const Mesh&, Diagram& d) {
    return d.cells[g].euler_characteristic = 4 - d.cells[g].boundary_loops, true;
  });
}

TEST_CASE("(7) a sum that is not the surface's Euler characteristic") {
  // One more handle keeps the cell possible: only the sum changes.
  require_named(7, [](const Mesh&, Diagram& d) { return d.cells[GeneratorId(2)].euler_characteristic -= 2, true; });
  require_named(7, [](const Mesh&, Diagram& d) {
    Bisector* b = first_bisector(d, joins_branches);
    return b->closed = true, true;
  });
  require_named(
      7, [](const Mesh&, Diagram& d) { return d.bisectors.push_back(*first_bisector(d, joins_branches)), true; });
}

TEST_CASE("(8) neighbours that are not mutual, or not those with a bisector in common") {
  require_named(8, [](const Mesh&, Diagram& d) { return d.cells[GeneratorId(0)].neighbours.pop_back(), true; });
  require_named(8, [](const Mesh&, Diagram& d) {
    for (Cell& cell : d.cells) {
      for (int g = 0; g < 12; ++g) {
        const bool known =
            std::find(cell.neighbours.begin(), cell.neighbours.end(), GeneratorId(g)) != cell.neighbours.end();
        if (!known && g != cell.generator.value()) return cell.neighbours.push_back(GeneratorId(g)), true;
      }
    }
    return false;
  });
  require_named(
      8, [](const Mesh&, Diagram& d) { return d.cells[GeneratorId(0)].neighbours.push_back(GeneratorId(0)), true; });
  require_named(8, [](const Mesh&, Diagram& d) {  // mutual, but against the bisectors
    const GeneratorId a(0), b = d.cells[a].neighbours.front();
    std::erase(d.cells[a].neighbours, b);
    std::erase(d.cells[b].neighbours, a);
    return true;
  });
}

TEST_CASE("an empty diagram, and one of another mesh, violate properties and do not crash") {
  const Mesh mesh = test::make_sphere(2), other = test::make_torus(24, 12);
  CHECK_FALSE(check_diagram(mesh, Diagram()).ok());
  CHECK_FALSE(check_diagram(other, compute_diagram(mesh, test::at_vertices(mesh, {0, 5}))).ok());
  CHECK_FALSE(check_diagram(mesh, compute_diagram(other, test::at_vertices(other, {0, 5, 100}))).ok());
}

TEST_CASE("no violation: empty") {
  Violations violations;
  CHECK(violations.empty());
  CHECK(violations.take().empty());
}

TEST_CASE("a violation begins with its property, and then names the element") {
  Violations violations;
  violations.add(7, "a sum is wrong");
  violations.add(3, "bisector", 12, "separates nothing");
  CHECK_FALSE(violations.empty());
  CHECK(violations.take() == std::vector<std::string>{"(7) a sum is wrong", "(3) bisector 12: separates nothing"});
}

using Lines = std::vector<std::string>;

Lines find_in_ids(const ThreeCells& x) { return x.run(check_ids); }

TEST_CASE("ids of a sound diagram are valid") { CHECK(find_in_ids(ThreeCells()).empty()); }

TEST_CASE("an end at a branch point that does not exist") {
  ThreeCells broken;
  Bisector* b = &broken.bisector(0);
  b->ends[0] = BranchPointId(7);
  CHECK(find_in_ids(broken) == Lines{"(4) bisector 0: ends at a branch point that does not exist"});
}

TEST_CASE("sizes, labels and faces that do not match the mesh") {
  ThreeCells cells;
  cells.diagram.cells.raw().pop_back();
  CHECK(find_in_ids(cells)[0] ==
        "(1) cells are not numbered like the generators, or a generator lies in no face of the mesh");
  ThreeCells labels;
  labels.diagram.vertex_label[VertexId(3)] = GeneratorId(3);
  CHECK(find_in_ids(labels) ==
        Lines{"(2) labels or pieces do not match the mesh in number, or name a cell or face that does not exist"});
  ThreeCells points;
  points.bisector(2).points[1].face = FaceId(points.mesh.face_count());
  CHECK(find_in_ids(points) == Lines{"(3) bisector 2: names a cell or face that does not exist"});
}

TEST_CASE("a diagram without anything matches no mesh but the empty one") {
  ThreeCells empty;
  empty.diagram = Diagram();
  CHECK(find_in_ids(empty).size() == 1);  // no labels
}

Lines find_in_generators(const ThreeCells& x) { return x.run(check_generators); }

TEST_CASE("the generators of a sound diagram lie in their cells") { CHECK(find_in_generators(ThreeCells()).empty()); }

TEST_CASE("one in another cell, and an area that is not a number") {
  ThreeCells broken;
  std::swap(broken.diagram.generators[0], broken.diagram.generators[2]);
  CHECK(find_in_generators(broken) ==
        Lines{"(1) generator 0: lies outside its cell", "(1) generator 2: lies outside its cell"});
  ThreeCells area;
  area.cell(1).area = std::nan("");
  CHECK(find_in_generators(area) == Lines{"(1) cell 1: its area is negative or not a number"});
}

Lines find_in_bisectors(const ThreeCells& x) { return x.run(check_bisectors); }

TEST_CASE("the bisectors of a sound diagram have no violation") { CHECK(find_in_bisectors(ThreeCells()).empty()); }

TEST_CASE("points, sides, ends and branch points") {
  ThreeCells sides;
  sides.bisector(0).left = sides.bisector(0).right;
  CHECK(find_in_bisectors(sides)[0] == "(3) bisector 0: does not separate two cells, or has fewer than two points");
  ThreeCells points;
  std::vector<SurfacePoint>& p = points.bisector(0).points;
  p.erase(p.begin() + 1, p.end() - 1);
  CHECK(find_in_bisectors(points) == Lines{"(3) bisector 0: its points 0 and 1 have no face in common"});
  ThreeCells named;
  named.diagram.branch_points[BranchPointId(0)].generators.pop_back();
  CHECK(find_in_bisectors(named) == Lines{"(5) branch point 0: its generators are not those of its bisectors"});
}

Lines find_in_topology(const ThreeCells& x) {
  return x.run(check_topology, ReachedFaces(x.mesh, x.diagram.generators));
}

bool one_begins(const Lines& lines, const std::string& start) {
  return lines.size() == 1 && lines[0].starts_with(start);
}

TEST_CASE("the topology of a sound diagram has no violation") { CHECK(find_in_topology(ThreeCells()).empty()); }

TEST_CASE("components, genus, Euler's formula and neighbours") {
  ThreeCells components;
  components.cell(2).components = 3;  // with which the characteristic would still be possible
  CHECK(find_in_topology(components) == Lines{"(6) cell 2: is not connected"});
  ThreeCells genus;
  genus.cell(2).euler_characteristic -= 2;
  CHECK(one_begins(find_in_topology(genus), "(7) Euler's formula: cells 1 - bisectors 3 + branch points 1 is not "));
  ThreeCells neighbours;
  neighbours.cell(0).neighbours.pop_back();
  CHECK(find_in_topology(neighbours) == Lines{"(8) the cells' neighbours are not the cells with a bisector in common"});
}

Lines find_in_partition(const ThreeCells& x) {
  return x.run(check_partition, ReachedFaces(x.mesh, x.diagram.generators));
}

TEST_CASE("the cells of a sound diagram are a partition") { CHECK(find_in_partition(ThreeCells()).empty()); }

TEST_CASE("a cell's area, a vertex's label and a piece that is missing") {
  ThreeCells area;
  area.cell(1).area *= 1.01;
  CHECK(find_in_partition(area) == Lines{"(2) cell 1: its area is not that of its faces and pieces"});
  ThreeCells label;
  label.diagram.vertex_label[VertexId(0)] = GeneratorId(2);
  for (const std::string& line : find_in_partition(label)) {
    CHECK(line == "(2) vertex 0: its label is not that of a face or piece at it");
  }
  CHECK_FALSE(find_in_partition(label).empty());
  ThreeCells missing;
  const std::string face = std::to_string(missing.diagram.pieces[0].face.value());
  missing.diagram.pieces.erase(missing.diagram.pieces.begin());
  const Lines lines = find_in_partition(missing);
  REQUIRE(lines.size() == 2);  // the face, and the cell whose piece it was
  CHECK(lines[0].starts_with("(2) face " + face + ": its label and pieces cover 0."));
  CHECK(lines[0].ends_with(" of its area instead of 1"));
}

TEST_CASE("without a generator no face is reached") {
  const Mesh mesh = test::make_triangle();
  CHECK_FALSE(ReachedFaces(mesh, {}).contains(FaceId(0)));
}

TEST_CASE("one generator reaches its component, and no other") {
  const Mesh mesh = test::make_two_components();
  const FaceId last(mesh.face_count() - 1);
  const ReachedFaces first_only(mesh, {vertex_point(mesh, VertexId(0))});
  CHECK(first_only.contains(FaceId(0)));
  CHECK_FALSE(first_only.contains(last));
  const ReachedFaces last_only(mesh, {make_surface_point(last, {0.3, 0.3, 0.4})});
  CHECK_FALSE(last_only.contains(FaceId(0)));
  CHECK(last_only.contains(last));
  const ReachedFaces both(mesh, {vertex_point(mesh, VertexId(0)), make_surface_point(last, {0.3, 0.3, 0.4})});
  for (int f = 0; f < mesh.face_count(); ++f) REQUIRE(both.contains(FaceId(f)));
}

}  // namespace gvd::test_check_diagram
