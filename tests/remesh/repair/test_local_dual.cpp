// Diagrams of a part of the mesh: the same as those of the whole mesh, cell by cell.
#include <algorithm>
#include <vector>

#include "remesh/dual_defects.hpp"
#include "repair/local_dual.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_local_dual {

TEST_CASE("rings of cells grow by one bisector a ring") {
  const Mesh mesh = test::make_torus(72, 36);
  const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 60, 2));
  const auto count = [](const CellFlags& flags) { return std::count(flags.begin(), flags.end(), 1); };
  const GeneratorId g(5);
  CHECK(count(grow_rings(diagram, {g}, 0)) == 1);
  CHECK(count(grow_rings(diagram, {g}, 1)) == 1 + std::ssize(diagram.cells[g].neighbours));
  CHECK(count(grow_rings(diagram, {g}, 60)) == 60);
}

TEST_CASE("cell part: the faces of some cells, and points there and back") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 20, 4));
    const CellFlags cells = grow_rings(diagram, {GeneratorId(3)}, 1);
    const CellPart part = cut_out_cells(mesh, diagram, cells);
    CHECK(part.mesh.face_count() == static_cast<std::int32_t>(part.whole_face.size()));
    CHECK(part.mesh.face_count() < mesh.face_count());
    for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
      if (!cells[GeneratorId(i)]) continue;
      const auto point = part.to_part(diagram.generators[i]);
      REQUIRE(point);
      CHECK(part.to_whole(*point) == diagram.generators[i]);
      CHECK((position(part.mesh, *point) - position(mesh, diagram.generators[i])).norm() == 0);
    }
  }
}

TEST_CASE("cell part: all cells give the whole mesh, without a fringe") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 12, 1));
    const CellPart part = cut_out_cells(mesh, diagram, CellFlags(diagram.cells.size(), 1));
    const MeshSummary whole = compute_mesh_summary(mesh), same = compute_mesh_summary(part.mesh);
    CHECK(same.faces == whole.faces);
    CHECK(same.vertices == whole.vertices);
    CHECK(same.boundary_loops == whole.boundary_loops);
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) CHECK_FALSE(part.is_fringe[FaceId(f)]);
  }
}

TEST_CASE("cell part: faces that meet at one vertex only get a vertex each") {
  // Two cells at opposite corners of a grid of four squares, whose faces meet in the middle.
  const Mesh mesh = test::make_grid(2, 2);
  std::vector<SurfacePoint> generators;
  for (const int v : {0, 2, 6, 8}) generators.push_back(vertex_point(mesh, VertexId(v)));
  Diagram diagram = compute_diagram(mesh, generators);
  // Whole faces only: each belongs to the corner that it is nearest to.
  diagram.pieces.clear();
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    diagram.face_label[FaceId(f)] = GeneratorId(f / 2);
  }
  CellFlags opposite(4, 0);
  opposite[GeneratorId(0)] = opposite[GeneratorId(3)] = 1;
  const CellPart part = cut_out_cells(mesh, diagram, opposite);
  CHECK(part.mesh.face_count() == 4);
  CHECK(part.mesh.vertex_count() == 8);
  for (std::int32_t f = 0; f < 4; ++f) CHECK(part.is_fringe[FaceId(f)]);
}

std::vector<test::NamedMesh> fine_family() {
  return {{"sphere", test::make_sphere(4)},
          {"torus", test::make_torus(72, 36)},
          {"plate", test::make_plate(24)},
          {"grid", test::make_grid(40, 40)},
          {"ring", test::make_ring(96, 24)},
          {"half sphere", test::make_half_sphere(4)},
          {"bumpy sphere", test::make_bumpy_sphere(4, 3)},
          {"thin faces", test::make_thin_faced_sphere(4, 3)},
          {"genus 3", test::make_genus3(30)}};
}

/// Generators of the whole mesh before a change and after it.
struct Change {
  std::vector<SurfacePoint> before, added;
  std::vector<GeneratorId> cells, removed;

  std::vector<SurfacePoint> after() const {
    std::vector<SurfacePoint> all;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const GeneratorId g(i);
      if (std::find(removed.begin(), removed.end(), g) == removed.end()) all.push_back(before[i]);
    }
    all.insert(all.end(), added.begin(), added.end());
    return all;
  }
};

/// The id in the whole diagram after the change, for each cell of the part.
std::vector<GeneratorId> whole_ids(const LocalDual& local, const Change& change) {
  std::vector<GeneratorId> ids;
  for (const GeneratorId g : local.kept()) {
    const auto before =
        std::count_if(change.removed.begin(), change.removed.end(), [&](GeneratorId r) { return r < g; });
    ids.emplace_back(g.value() - before);
  }
  const std::size_t first = change.before.size() - change.removed.size();
  for (std::size_t i = 0; i < change.added.size(); ++i) ids.emplace_back(static_cast<std::int64_t>(first + i));
  return ids;
}

/// Requires equal inner cells; returns their number.
int require_equal_cells(const Diagram& whole, const LocalDual::Result& local, const std::vector<GeneratorId>& ids) {
  int inner = 0;
  for (const Cell& cell : local.diagram.cells) {
    if (!local.inner[cell.generator]) continue;
    ++inner;
    const Cell& other = whole.cells[ids[cell.generator.index()]];
    // Polylines of the two may differ within the chord tolerance, where rounding decides whether a point is added.
    CHECK(cell.area == Approx(other.area).epsilon(1e-6));
    CHECK(cell.euler_characteristic == other.euler_characteristic);
    CHECK(cell.components == other.components);
    CHECK(cell.boundary_loops == other.boundary_loops);
    std::vector<GeneratorId> neighbours;
    for (const GeneratorId n : cell.neighbours) neighbours.push_back(ids[n.index()]);
    std::sort(neighbours.begin(), neighbours.end());
    CHECK(neighbours == other.neighbours);
  }
  return inner;
}

/// The branch points between inner cells are those of the whole mesh, in position too.
void require_equal_branch_points(const Diagram& whole, const LocalDual::Result& local,
                                 const std::vector<GeneratorId>& ids, double size) {
  for (const BranchPoint& b : local.diagram.branch_points) {
    if (!std::all_of(b.generators.begin(), b.generators.end(), [&](GeneratorId g) { return local.inner[g]; })) continue;
    double nearest = size;
    for (const BranchPoint& other : whole.branch_points) {
      nearest = std::min(nearest, (b.position - other.position).norm());
    }
    CHECK(nearest < 1e-9 * size);
  }
  CHECK(ids.size() == local.diagram.generators.size());
}

/// Returns the number of inner cells; -1 where the part can't tell.
int require_same_as_whole(const Mesh& mesh, const Change& change) {
  const Diagram diagram = compute_diagram(mesh, change.before);
  const LocalDual local(mesh, diagram, change.cells, change.removed, {});
  const auto result = local.compute(change.added);
  if (!result) return -1;
  const auto ids = whole_ids(local, change);
  const Diagram whole = compute_diagram(mesh, change.after());
  require_equal_branch_points(whole, *result, ids, mesh.bbox_diagonal());
  return require_equal_cells(whole, *result, ids);
}

/// Makes a change of eighty generators on each mesh with four seeds, and requires that most parts can tell its cells.
/// `alter(change, mesh, diagram, seed)`: says what is added and removed.
template <class Alter>
void require_most_told(const Alter& alter) {
  int told = 0, tried = 0;
  for (const auto& [name, mesh] : fine_family()) {
    for (unsigned seed = 0; seed < 4; ++seed) {
      INFO(name << ", seed " << seed);
      Change change;
      change.before = test::random_generators(mesh, 80, seed);
      alter(change, mesh, compute_diagram(mesh, change.before), seed);
      ++tried;
      if (require_same_as_whole(mesh, change) > 0) ++told;
    }
  }
  CHECK(told >= tried * 2 / 3);
}

GeneratorId cell_at(const Mesh& mesh, const Diagram& diagram, const SurfacePoint& point) {
  return diagram.vertex_label[mesh.vertices(point.face)[0]];
}

TEST_CASE("local dual: after generators are added, the cells are those of the whole mesh") {
  require_most_told([](Change& change, const Mesh& mesh, const Diagram& diagram, unsigned seed) {
    change.added = test::random_generators(mesh, 1 + static_cast<int>(seed % 2), seed + 100);
    for (const SurfacePoint& p : change.added) change.cells.push_back(cell_at(mesh, diagram, p));
  });
}

TEST_CASE("local dual: after generators are removed, and one added in their place") {
  require_most_told([](Change& change, const Mesh&, const Diagram& diagram, unsigned seed) {
    const GeneratorId first(7 + static_cast<int>(seed));
    change.removed = {first, diagram.cells[first].neighbours[0]};
    std::sort(change.removed.begin(), change.removed.end());
    change.cells = change.removed;
    if (seed % 2 == 0) change.added = {diagram.branch_points[BranchPointId(0)].point};
    for (const BranchPoint& b : diagram.branch_points) {
      if (seed % 2 == 0 && b.generators[0] == first) change.added = {b.point};
    }
  });
}

TEST_CASE("local dual: defects are those of the whole mesh where it can tell") {
  const Mesh mesh = test::make_torus(96, 24);
  // Six round the torus: annuli. One more in the first.
  std::vector<SurfacePoint> generators;
  for (int i = 0; i < 8; ++i) generators.push_back(vertex_point(mesh, VertexId(i * 12 * 24)));
  const Diagram diagram = compute_diagram(mesh, generators);
  const auto whole = test::find_dual_defects(mesh, diagram);
  const LocalDual local(mesh, diagram, {GeneratorId(0)}, {}, {});
  CHECK(local.part().whole_face.size() < static_cast<std::size_t>(mesh.face_count()));
  const auto result = local.compute({});
  REQUIRE(result);
  const auto discs = [](const std::vector<DualDefect>& defects) {
    return std::count_if(defects.begin(), defects.end(),
                         [](const DualDefect& d) { return d.property == DualProperty::cell_is_disc; });
  };
  CHECK(discs(whole) == 8);
  CHECK(discs(result->defects) >= 1);
  CHECK(discs(result->defects) < 8);
}

TEST_CASE("local dual: nothing where a point lies outside, coincides, or a component loses its only generator") {
  const Mesh mesh = test::make_torus(96, 24);
  const auto generators = test::random_generators(mesh, 60, 1);
  const Diagram diagram = compute_diagram(mesh, generators);
  const LocalDual local(mesh, diagram, {GeneratorId(0)}, {}, {});
  CHECK_FALSE(local.compute({generators[0]}));
  const auto& near = diagram.cells[GeneratorId(0)].neighbours;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const GeneratorId g(i);
    if (local.part().to_part(generators[i]) || std::find(near.begin(), near.end(), g) != near.end()) continue;
    CHECK_FALSE(local.compute({generators[i]}));
  }
  const Mesh two = test::make_two_components();
  const auto component = compute_face_components(two);
  const FaceId other(std::find(component.begin(), component.end(), 1) - component.begin());
  const Diagram both = compute_diagram(two, {vertex_point(two, VertexId(0)), make_surface_point(other, {1, 0, 0})});
  CHECK_FALSE(LocalDual(two, both, {GeneratorId(0), GeneratorId(1)}, {GeneratorId(1)}, {}).compute({}));
}

}  // namespace gvd::test_local_dual
