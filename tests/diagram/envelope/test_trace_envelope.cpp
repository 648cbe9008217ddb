// Exact diagrams, compared with an exact field for each generator, with the planar Voronoi diagram, and in degenerate
// cases.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "diagram/envelope/trace_envelope.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error_measure.hpp"
#include "gvd/exact_field.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/hand_made_field.hpp"
#include "support/meshes.hpp"
#include "support/planar_voronoi.hpp"
#include "support/random.hpp"
#include "support/same_diagram.hpp"
#include "support/sound_diagram.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_trace_envelope {

/// Crossings and branch points are equidistant to this fraction of the bounding box's diagonal.
constexpr double kEquidistant = 1e-12;

Diagram compute_sound(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Method method,
                      double chord_tolerance = 1e-4) {
  DiagramOptions options;
  options.method = method;
  options.chord_tolerance = chord_tolerance;
  return test::compute_sound(mesh, generators, options);
}

Diagram compute_exact(const Mesh& mesh, const std::vector<SurfacePoint>& generators, double chord_tolerance = 1e-4) {
  return compute_sound(mesh, generators, Method::exact, chord_tolerance);
}

/// An exact field for each generator alone.
class SeparateFields {
 public:
  SeparateFields(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
    for (const SurfacePoint& g : generators) fields_.push_back(std::make_unique<ExactField>(mesh, std::vector{g}));
  }
  double distance(GeneratorId g, const SurfacePoint& p) const { return fields_[g.index()]->nearest(p).distance; }
  double nearest(const SurfacePoint& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& field : fields_) least = std::min(least, field->nearest(p).distance);
    return least;
  }

 private:
  std::vector<std::unique_ptr<ExactField>> fields_;
};

/// The largest errors of a diagram's points, mesh units.
struct Faults {
  double crossing = 0;  ///< difference of the two distances where a bisector crosses an edge of the mesh
  double inner = 0;     ///< and at its other points
  double branch = 0;    ///< largest difference of the distances at a branch point
  double nearer = 0;    ///< how much nearer another generator is, at any of these
};

Faults find_faults(const Mesh& mesh, const Diagram& diagram) {
  const SeparateFields fields(mesh, diagram.generators);
  Faults faults;
  for (const Bisector& b : diagram.bisectors) {
    if (b.left == b.right) continue;
    for (std::size_t i = b.ends[0].valid() ? 1 : 0; i + (b.ends[1].valid() ? 1 : 0) < b.points.size(); ++i) {
      const SurfacePoint& p = b.points[i];
      const double left = fields.distance(b.left, p), difference = std::abs(left - fields.distance(b.right, p));
      double& worst = p.kind() == SurfacePoint::Kind::face ? faults.inner : faults.crossing;
      worst = std::max(worst, difference);
      faults.nearer = std::max(faults.nearer, left - fields.nearest(p));
    }
  }
  for (const BranchPoint& b : diagram.branch_points) {
    const double first = fields.distance(b.generators[0], b.point);
    for (const GeneratorId g : b.generators) {
      faults.branch = std::max(faults.branch, std::abs(fields.distance(g, b.point) - first));
    }
    faults.branch = std::max(faults.branch, std::abs(b.distance - first));
    faults.nearer = std::max(faults.nearer, first - fields.nearest(b.point));
  }
  return faults;
}

/// E / length, by an exact field for each generator.
double mean_error(const Mesh& mesh, const Diagram& diagram) {
  const SeparateFields fields(mesh, diagram.generators);
  const auto find_id = [&](const SurfacePoint& g) {
    const auto at = std::find(diagram.generators.begin(), diagram.generators.end(), g);
    return GeneratorId(at - diagram.generators.begin());
  };
  const auto exact = [&](const std::vector<DistanceQuery>& queries) {
    std::vector<std::vector<double>> result;
    for (const DistanceQuery& query : queries) {
      auto& row = result.emplace_back();
      for (const SurfacePoint& p : query.points) row.push_back(fields.distance(find_id(query.generator), p));
    }
    return result;
  };
  return compute_error_measure(mesh, diagram, exact).error_mean;
}

std::vector<SurfacePoint> in_one_face(FaceId f, int count, unsigned seed) {
  test::Random random(seed);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const double u = random.real(0.001, 0.998), v = random.real(0.0005, 0.9995) * (1 - u);
    points.push_back(make_surface_point(f, {u, v, 1 - u - v}));
  }
  return points;
}

TEST_CASE("every family, few and many generators: valid, and exact at crossings and branch points") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {2, 7, 30}) {
      for (unsigned seed = 0; seed < 2; ++seed) {
        INFO(name << " with " << count << ", seed " << seed);
        const double tolerance = 1e-4;
        const Diagram diagram = compute_exact(mesh, test::random_generators(mesh, count, 50 + seed), tolerance);
        const Faults faults = find_faults(mesh, diagram);
        CHECK(faults.crossing <= kEquidistant * mesh.bbox_diagonal());
        CHECK(faults.branch <= kEquidistant * mesh.bbox_diagonal());
        CHECK(faults.inner <= 2 * tolerance * mesh.mean_edge_length());
        CHECK(faults.nearer <= 2 * tolerance * mesh.mean_edge_length());
      }
    }
  }
}

TEST_CASE("every family is valid for more generators than faces, and for one") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    compute_exact(mesh, test::random_generators(mesh, mesh.face_count() + 100, 9));
    const Diagram alone = compute_exact(mesh, test::random_generators(mesh, 1, 3));
    CHECK(alone.branch_points.empty());
    CHECK(alone.bisectors.empty());
  }
}

TEST_CASE("vertices have the distance and the label of separate exact fields, one for each generator") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto generators = test::random_generators(mesh, 12, 4);
    const Diagram diagram = compute_exact(mesh, generators);
    const SeparateFields fields(mesh, generators);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const SurfacePoint p = vertex_point(mesh, VertexId(v));
      const double nearest = fields.nearest(p);
      const GeneratorId label = diagram.vertex_label[VertexId(v)];
      REQUIRE(label.valid() == std::isfinite(nearest));
      if (!label.valid()) continue;
      REQUIRE(std::abs(diagram.vertex_distance[VertexId(v)] - nearest) <= kEquidistant * mesh.bbox_diagonal());
      REQUIRE(fields.distance(label, p) <= nearest + kEquidistant * mesh.bbox_diagonal());
    }
  }
}

TEST_CASE("on a flat mesh the diagram is the planar Voronoi diagram") {
  constexpr int kWidth = 12, kHeight = 9;
  constexpr double kPlanar = 1e-10;
  for (const bool jittered : {false, true}) {
    const Mesh mesh = jittered ? test::make_jittered_grid(kWidth, kHeight, 0.2, 1) : test::make_grid(kWidth, kHeight);
    for (unsigned seed = 0; seed < 6; ++seed) {
      INFO("seed " << seed << (jittered ? ", jittered" : ""));
      const auto generators = test::random_generators(mesh, 14, seed);
      const Diagram diagram = compute_exact(mesh, generators);
      std::vector<Vec2> points;
      for (const SurfacePoint& g : generators) points.push_back(position(mesh, g).head<2>());
      const test::PlanarVoronoi voronoi(points, kWidth, kHeight);
      const auto corners = voronoi.corners();
      CHECK(diagram.branch_points.size() == corners.size());
      for (const auto& corner : corners) {
        double least = std::numeric_limits<double>::infinity();
        for (const BranchPoint& b : diagram.branch_points) {
          least = std::min(least, (b.position.head<2>() - corner.point).norm());
        }
        CHECK(least <= kPlanar);
      }
      for (const Cell& cell : diagram.cells) {
        CHECK(cell.area == Approx(voronoi.cell_area(cell.generator.value())).epsilon(0).margin(kPlanar));
      }
    }
  }
}

TEST_CASE("the error E decreases with the chord tolerance, down to rounding") {
  for (const auto& [name, mesh] : test::small_family()) {
    if (name != "torus" && name != "bumpy sphere" && name != "half sphere" && name != "genus 3") continue;
    INFO(name);
    const auto generators = test::random_generators(mesh, 6, 2);
    double before = std::numeric_limits<double>::infinity();
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      INFO(tolerance);
      const double error = mean_error(mesh, compute_exact(mesh, generators, tolerance));
      CHECK(error <= 2 * tolerance * mesh.mean_edge_length() + 1e-13);
      CHECK(error <= before);
      before = error;
    }
  }
}

TEST_CASE("hundreds of generators in one face") {
  for (const auto& [name, mesh] :
       {test::NamedMesh{"triangle", test::make_triangle()}, test::NamedMesh{"sphere", test::make_sphere(1)}}) {
    INFO(name);
    const Diagram diagram = compute_exact(mesh, in_one_face(FaceId(0), 300, 8));
    const Faults faults = find_faults(mesh, diagram);
    CHECK(faults.crossing <= kEquidistant * mesh.bbox_diagonal());
    CHECK(faults.branch <= kEquidistant * mesh.bbox_diagonal());
  }
}

TEST_CASE(
    "hundreds of generators on one edge: each bisector crosses hundreds of faces, each face hundreds of bisectors") {
  const Mesh mesh = test::make_grid(1, 1);
  HalfedgeId diagonal(0);
  while (!mesh.twin(diagonal).valid()) diagonal = HalfedgeId(diagonal.value() + 1);
  const Diagram diagram = compute_exact(mesh, test::along_edge(diagonal, 200));
  const Faults faults = find_faults(mesh, diagram);
  CHECK(faults.crossing <= kEquidistant * mesh.bbox_diagonal());
  CHECK(diagram.branch_points.empty());
  CHECK(diagram.bisectors.size() == 199);
}

TEST_CASE("generators on edges, on vertices and on the boundary alone") {
  const Mesh grid = test::make_grid(6, 5), ring = test::make_ring(16, 3);
  for (const Mesh* mesh : {&grid, &ring}) {
    std::vector<SurfacePoint> on_edges, on_vertices, on_boundary;
    for (int h = 0; h < 3 * mesh->face_count(); h += 5) {
      const HalfedgeId halfedge(h);
      (mesh->twin(halfedge).valid() ? on_edges : on_boundary)
          .push_back(edge_point(halfedge, 0.1 + 0.8 * (h % 7) / 7.0));
    }
    std::erase_if(on_edges, [&](const SurfacePoint& p) { return !(canonical(*mesh, p) == p); });
    for (int v = 0; v < mesh->vertex_count(); ++v) on_vertices.push_back(vertex_point(*mesh, VertexId(v)));
    for (const auto& generators : {on_edges, on_vertices, on_boundary}) compute_exact(*mesh, generators);
  }
}

TEST_CASE("on closed meshes of few faces, and where everything is a tie") {
  for (const Mesh& mesh : {test::make_pillow(), test::make_tetrahedron(), test::make_triangle()}) {
    for (unsigned seed = 0; seed < 40; ++seed) {
      INFO("seed " << seed << ", " << mesh.face_count() << " faces");
      compute_exact(mesh, test::random_generators(mesh, 1 + int(seed) % 9, seed));
    }
    std::vector<SurfacePoint> corners;
    for (int v = 0; v < mesh.vertex_count(); ++v) corners.push_back(vertex_point(mesh, VertexId(v)));
    compute_exact(mesh, corners);
  }
}

std::vector<SurfacePoint> centre_of_every_face(const Mesh& mesh) {
  std::vector<SurfacePoint> points;
  for (int f = 0; f < mesh.face_count(); ++f) points.push_back(make_surface_point(FaceId(f), {1 / 3., 1 / 3., 1 / 3.}));
  return points;
}

TEST_CASE("bisectors along edges: all edges of regular solids, and the lines of a grid") {
  const Mesh tetrahedron = test::make_tetrahedron();
  double edges = 0;
  for (int e = 0; e < tetrahedron.edge_count(); ++e) edges += tetrahedron.length(EdgeId(e));
  CHECK(compute_exact(tetrahedron, centre_of_every_face(tetrahedron)).length == Approx(edges).epsilon(1e-9));
  const Mesh icosahedron = test::make_sphere(0);
  edges = 0;
  for (int e = 0; e < icosahedron.edge_count(); ++e) edges += icosahedron.length(EdgeId(e));
  CHECK(compute_exact(icosahedron, centre_of_every_face(icosahedron)).length == Approx(edges).epsilon(1e-9));
  for (const int n : {2, 3, 8}) {
    CAPTURE(n);
    const Mesh grid = test::make_grid(n, n);
    // The middle of every cell lies on the diagonal that its two faces share.
    std::vector<SurfacePoint> middles;
    for (int f = 0; f < grid.face_count(); f += 2) {
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId h = Mesh::halfedge(FaceId(f), corner);
        if (grid.length(h) > 1.1) middles.push_back(edge_point(h, 0.5));
      }
    }
    REQUIRE(middles.size() == static_cast<std::size_t>(n * n));
    CHECK(compute_exact(grid, middles).length == Approx(2 * n * (n - 1)).epsilon(1e-9));
  }
}

TEST_CASE("every solver works with every tracer") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Method method :
         {Method{Solver::windows, Tracer::growth}, Method{Solver::fast_marching, Tracer::envelope}}) {
      for (const int count : {4, 40}) {
        INFO(name << " with " << count << (method.solver == Solver::windows ? ", windows" : ", fast marching"));
        const Diagram diagram = compute_sound(mesh, test::random_generators(mesh, count, 13), method);
        CHECK(diagram.report.unresolved_ends == 0);
      }
    }
  }
}

TEST_CASE("the same input gives the same exact diagram, bit by bit") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const auto generators = test::random_generators(mesh, 40, 5);
  CHECK(test::same_diagram(compute_exact(mesh, generators), compute_exact(mesh, generators)));
}

TEST_CASE("two label intervals of one cell whose paths enter through different sides are one piece") {
  // A cell enters the face through two sides. No three of the label intervals 0, 1, 0, 2 have a branch point.
  const Mesh mesh = test::make_mesh({{-2.313232922078714, -0.24500076329078183, -4.9559022281649936},
                                     {3.6541655007717262, -1.6060447783812839, 4.7664874842163831},
                                     {1.9806961735113127, 0.49607427434267765, -0.82432827952762044},
                                     {-0.42586477137176659, -1.7098787787831966, -1.24847912605823}},
                                    {{0, 1, 2}, {2, 1, 3}, {3, 1, 0}});
  const std::vector<SurfacePoint> generators{
      make_surface_point(FaceId(0), {0.13714385555167685, 0.26650958614374975, 0.59634655830457339}),
      make_surface_point(FaceId(2), {1.9958828948118804e-05, 0.99996008234210376, 1.9958828948118804e-05}),
      make_surface_point(FaceId(2), {0.25056935601945873, 0.39786023532916054, 0.35157040865138073}),
      make_surface_point(FaceId(1), {0.5, 0, 0.5})};
  DiagramOptions options;
  options.method = Method::exact;
  const Diagram diagram = compute_diagram(mesh, generators, options);
  CHECK(check_diagram(mesh, diagram).ok());
  for (const BranchPoint& branch : diagram.branch_points) {
    for (const GeneratorId g : branch.generators) {
      const ExactField alone(mesh, {generators[g.index()]});
      CHECK(alone.nearest(branch.point).distance == Approx(branch.distance).epsilon(1e-9));
    }
  }
}

using test::from_corner;
using test::HandMadeField;
using test::through_side;

const GeneratorId kA(0), kB(1), kC(2);
const Vec2 k0(0, 0), k1(2, 0), k2(0.5, 1.5);  // corners of test::make_triangle, in its layout

/// The crossings of the triangle's edges, in the order of its sides, at parameters along the sides.
struct SideCrossing {
  int side;
  double t;
  GeneratorId before, after;
};

Crossings crossings_on(const Mesh& mesh, const std::vector<SideCrossing>& sides) {
  std::vector<Crossing> items;
  for (const SideCrossing& c : sides) {
    const HalfedgeId h = Mesh::halfedge(FaceId(0), c.side);
    const bool along = mesh.halfedge(mesh.edge(h)) == h;
    items.push_back({mesh.edge(h), along ? c.t : 1 - c.t, along ? c.before : c.after, along ? c.after : c.before});
  }
  std::sort(items.begin(), items.end(),
            [](const Crossing& a, const Crossing& b) { return std::pair(a.edge, a.t) < std::pair(b.edge, b.t); });
  return Crossings(mesh.edge_count(), std::move(items));
}

/// The triangle, assembled from hand-made sources.
struct Assembled {
  Mesh mesh = test::make_triangle();
  HandMadeField field;
  Crossings crossings;
  AssembledFaces result;

  Assembled(std::vector<FaceSource> sources, const std::vector<SideCrossing>& sides, double tolerance)
      : field(std::move(sources)), crossings(crossings_on(mesh, sides)) {
    result = assemble_envelope({mesh, crossings, field, {}, tolerance}, std::vector{FaceId(0)});
  }
};

/// The parameter on a side at which the images a and b, with their offsets, are equally far.
double equal_on(int side, const FaceSource& a, const FaceSource& b) {
  const std::array<Vec2, 3> corner{k0, k1, k2};
  const Vec2 &from = corner[std::size_t(side)], &to = corner[std::size_t((side + 1) % 3)];
  const auto error = [&](double t) { return a.distance(from + t * (to - from)) - b.distance(from + t * (to - from)); };
  double low = 0, high = 1;
  const bool rising = error(0) < 0;
  for (int i = 0; i < 100; ++i) ((error(0.5 * (low + high)) < 0) == rising ? low : high) = 0.5 * (low + high);
  return low;
}

/// A generator at each corner.
std::vector<FaceSource> at_corners() {
  return {from_corner(0, 0, k0, 0), from_corner(1, 1, k1, 0), from_corner(2, 2, k2, 0)};
}

TEST_CASE("a face without crossings adds nothing") {
  const Assembled face(at_corners(), {}, 1e-3);
  CHECK(face.result.diagram.arcs.empty());
  CHECK(face.result.diagram.branches.empty());
  CHECK(face.result.straightened.empty());
}

TEST_CASE("two crossings of generators with equal offsets make one straight arc") {
  const auto sources = at_corners();
  const Assembled face({sources[0], sources[1]}, {{0, 0.5, kA, kB}, {1, equal_on(1, sources[1], sources[0]), kB, kA}},
                       1e-6);
  REQUIRE(face.result.diagram.arcs.size() == 1);
  CHECK(face.result.diagram.arcs[0].point_count == 0);
  CHECK(face.result.diagram.branches.empty());
}

TEST_CASE("an arc between different offsets is refined until it is within the tolerance") {
  const FaceSource a = from_corner(0, 0, k0, 0), b = from_corner(1, 1, k1, 0.5);
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const Assembled face({a, b}, {{0, equal_on(0, a, b), kA, kB}, {1, equal_on(1, b, a), kB, kA}}, tolerance);
    REQUIRE(face.result.diagram.arcs.size() == 1);
    const FaceLayout layout(face.mesh, FaceId(0));
    for (const Bary& p : face.result.diagram.points) {
      const Vec2 at = layout.at(p);
      REQUIRE(std::abs(a.distance(at) - b.distance(at)) <= 2e-2 * tolerance + 1e-14);
    }
    if (tolerance < 1e-3) CHECK(face.result.diagram.points.size() > 1);
  }
}

TEST_CASE("three crossings make a branch point that is equally far from the three, with its distance") {
  const auto s = at_corners();
  const Assembled face(s,
                       {{0, equal_on(0, s[0], s[1]), kA, kB},
                        {1, equal_on(1, s[1], s[2]), kB, kC},
                        {2, equal_on(2, s[2], s[0]), kC, kA}},
                       1e-4);
  const FaceDiagram& diagram = face.result.diagram;
  REQUIRE(diagram.branches.size() == 1);
  CHECK(diagram.arcs.size() == 3);
  const FaceBranch& branch = diagram.branches[BranchPointId(0)];
  const Vec2 p = FaceLayout(face.mesh, FaceId(0)).at(branch.bary);
  for (const FaceSource& source : s) CHECK(source.distance(p) == Approx(branch.distance).epsilon(1e-13));
  CHECK(face.result.straightened.empty());
}

TEST_CASE("a branch point that no source reaches gets the distance of the nearest generator") {
  // Only A has a source in the face: the others' crossings contradict it.
  const Assembled face({from_corner(0, 0, k0, 0)}, {{0, 0.5, kA, kB}, {1, 0.5, kB, kC}, {2, 0.5, kC, kA}}, 1e-3);
  REQUIRE(face.result.diagram.branches.size() == 1);
  const FaceBranch& branch = face.result.diagram.branches[BranchPointId(0)];
  CHECK(branch.distance == Approx(FaceLayout(face.mesh, FaceId(0)).at(branch.bary).norm()));
}

TEST_CASE("faces follow each other in one result") {
  const Mesh mesh = test::make_pillow();
  const auto s = at_corners();
  const HandMadeField field({s[0], s[1]});
  const Crossings crossings = crossings_on(mesh, {{0, 0.5, kA, kB}, {1, equal_on(1, s[1], s[0]), kB, kA}});
  const AssembledFaces result =
      assemble_envelope({mesh, crossings, field, {}, 1e-3}, std::vector{FaceId(0), FaceId(1)});
  REQUIRE(result.diagram.arcs.size() == 2);
  CHECK(result.diagram.arcs[0].face == FaceId(0));
  CHECK(result.diagram.arcs[1].face == FaceId(1));
}

}  // namespace gvd::test_trace_envelope
