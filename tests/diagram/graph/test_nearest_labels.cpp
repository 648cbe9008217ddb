#include <algorithm>
#include <cmath>
#include <tuple>

#include "diagram/graph/nearest_labels.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "mesh/vertex_ring.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_nearest_labels {

bool is_supported(const WorkingMesh& working, const NearestLabels& labels, VertexId v) {
  if (working.vertex(labels.label[v]) == v) return true;
  bool supported = false;
  for_each_neighbour(working.mesh(), v, [&](VertexId u, HalfedgeId) {
    supported = supported || (labels.label[u] == labels.label[v] && labels.distance[u] < labels.distance[v]);
  });
  return supported;
}

/// A strip of squares and a table written by hand: generator 0 at vertex 0, generator 1 at vertex 4, and vertex 5,
/// where 1 is nearest although no neighbour has that label.
struct Strip {
  Mesh mesh = test::make_grid(4, 1);
  WorkingMesh working{mesh, test::at_vertices(mesh, {0, 4})};
  GeneratorTable table{mesh.vertex_count(), mesh.face_count()};

  void reach(int v, int g, double distance) { table.add(VertexId(v), GeneratorId(g), distance, HalfedgeId()); }

  Strip() {
    // Vertices 0 .. 4 along the lower side, 5 .. 9 along the upper one.
    for (int v = 0; v < 10; ++v) reach(v, 0, v % 5 + (v < 5 ? 0 : 0.5));
    reach(4, 1, 0.25);
    reach(9, 1, 1.25);
    reach(5, 1, 0.2);  // nearest, but an island
    reach(8, 1, 2.25);
  }
};

TEST_CASE("ties go to the least generator") {
  Strip strip;
  strip.table = GeneratorTable(strip.mesh.vertex_count(), strip.mesh.face_count());
  for (int v = 0; v < 10; ++v) strip.reach(v, 1, 1), strip.reach(v, 0, 1);
  const NearestLabels labels = compute_nearest_labels(strip.working, strip.table);
  for (int v = 0; v < 10; ++v) CHECK(labels.label[VertexId(v)] == GeneratorId(v == 4 ? 1 : 0));
}

TEST_CASE("labels are the nearest generators, and all but unsupported vertices have a neighbour nearer to theirs") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Front front : {Front::circle, Front::planar}) {
      for (const int count : {1, 3, 30, 200}) {
        INFO(name << ", " << test::name(front) << ", " << count << " generators");
        const test::Stages stages(mesh, test::random_generators(mesh, count, 1), front);
        auto unsupported = stages.labels.unsupported.begin();
        for (int i = 0; i < stages.mesh().vertex_count(); ++i) {
          const VertexId v(i);
          const GeneratorId own = stages.labels.label[v];
          REQUIRE(own.valid() == stages.table().reached(v));
          REQUIRE(own.valid() == std::isfinite(stages.labels.distance[v]));
          if (!own.valid()) continue;
          stages.table().for_each(v, [&](const VertexDistance& d) {
            REQUIRE(std::tuple(stages.labels.distance[v], own) <= std::tuple(d.distance, d.generator));
          });
          const bool listed = unsupported != stages.labels.unsupported.end() && *unsupported == v;
          if (listed) ++unsupported;
          REQUIRE(listed != is_supported(stages.working, stages.labels, v));
        }
        REQUIRE(unsupported == stages.labels.unsupported.end());
        for (int g = 0; g < count; ++g)
          REQUIRE(stages.labels.label[stages.working.vertex(GeneratorId(g))] == GeneratorId(g));
      }
    }
  }
}

TEST_CASE("after relabel_unsupported every vertex has a chain of decreasing distance, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Front front : {Front::circle, Front::planar}) {
      for (const int count : {3, 30, 200}) {
        INFO(name << ", " << test::name(front) << ", " << count << " generators");
        const test::Stages stages(mesh, test::random_generators(mesh, count, 1), front);
        NearestLabels labels = stages.labels;
        const std::int64_t moved = relabel_unsupported(stages.working, labels);
        REQUIRE(labels.unsupported.empty());
        REQUIRE(moved >= static_cast<std::int64_t>(stages.labels.unsupported.size()));
        for (int i = 0; i < stages.mesh().vertex_count(); ++i) {
          const VertexId v(i);
          REQUIRE(labels.label[v].valid() == stages.labels.label[v].valid());
          if (labels.label[v].valid()) REQUIRE(is_supported(stages.working, labels, v));
        }
      }
    }
  }
}

TEST_CASE("a generator owns its vertex, even if another one is nearer than the symbolic offsets") {
  const Mesh mesh = test::make_triangle();
  const HalfedgeId h = Mesh::halfedge(FaceId(0), 0);
  for (const double apart : {1e-8, 1e-9, 1e-10, 1e-11}) {
    CAPTURE(apart);
    const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0)), edge_point(h, apart),
                                               edge_point(h, 2 * apart)};
    const test::Stages stages(mesh, generators, Front::circle);
    for (int g = 0; g < 3; ++g) CHECK(stages.labels.label[stages.working.vertex(GeneratorId(g))] == GeneratorId(g));
    for (const Method& method : {Method::gbgvd, Method{Solver::fast_marching, Tracer::envelope}, Method::exact}) {
      DiagramOptions options;
      options.method = method;
      CHECK(check_diagram(mesh, compute_diagram(mesh, generators, options)).violations.empty());
    }
  }
}

TEST_CASE("an island is listed as unsupported, and takes the label of a neighbour") {
  const Strip strip;
  NearestLabels labels = compute_nearest_labels(strip.working, strip.table);
  CHECK(labels.label[VertexId(5)] == GeneratorId(1));
  CHECK(labels.unsupported == std::vector<VertexId>{VertexId(5)});
  NearestLabels by_neighbours = labels;
  relabel_from_neighbours(strip.working, {VertexId(5)}, by_neighbours);
  CHECK(relabel_unsupported(strip.working, labels) == 1);
  for (const NearestLabels& result : {labels, by_neighbours}) {
    CHECK(result.label[VertexId(5)] == GeneratorId(0));
    CHECK(result.distance[VertexId(5)] == 1);  // along the edge from the neighbour that keeps its label
    CHECK(result.label[VertexId(9)] == GeneratorId(1));
    CHECK(result.label[VertexId(6)] == GeneratorId(0));
  }
}

TEST_CASE("a vertex whose only support takes another label is listed as unsupported") {
  Strip strip;
  strip.table = GeneratorTable(strip.mesh.vertex_count(), strip.mesh.face_count());
  for (int v = 0; v < 10; ++v) strip.reach(v, 0, v == 0 ? 0 : v == 6 ? 0.5 : 0.35);
  strip.reach(4, 1, 0);
  strip.reach(5, 1, 0.2);
  strip.reach(6, 1, 0.45);
  NearestLabels labels = compute_nearest_labels(strip.working, strip.table);
  REQUIRE(labels.label[VertexId(6)] == GeneratorId(1));
  const auto listed = [&] { return std::count(labels.unsupported.begin(), labels.unsupported.end(), VertexId(6)); };
  REQUIRE(listed() == 0);
  relabel_from_neighbours(strip.working, {VertexId(5)}, labels);
  CHECK(labels.label[VertexId(5)] == GeneratorId(0));
  CHECK(labels.label[VertexId(6)] == GeneratorId(1));
  CHECK(listed() == 1);
}

TEST_CASE("a vertex that the march of its new generator did not reach gets the distance along the edge") {
  Strip strip;
  strip.table = GeneratorTable(strip.mesh.vertex_count(), strip.mesh.face_count());
  for (int v = 0; v < 10; ++v) {
    if (v != 5) strip.reach(v, 0, 3 + v % 5 + (v < 5 ? 0 : 0.5));
  }
  strip.reach(4, 1, 0.25);
  strip.reach(5, 1, 0.2);
  NearestLabels labels = compute_nearest_labels(strip.working, strip.table);
  relabel_from_neighbours(strip.working, labels.unsupported, labels);
  CHECK(labels.label[VertexId(5)] == GeneratorId(0));
  CHECK(labels.distance[VertexId(5)] == 4);
}

IdVector<VertexId, GeneratorId> labels(const std::vector<int>& of_vertex) {
  IdVector<VertexId, GeneratorId> label;
  for (const int g : of_vertex) label.push_back(g < 0 ? GeneratorId() : GeneratorId(g));
  return label;
}

TEST_CASE("the class of a face is the number of different labels of its corners") {
  const Mesh mesh = test::make_triangle();
  const auto class_of = [&](const std::vector<int>& of_vertex) { return classify(mesh, labels(of_vertex), FaceId(0)); };
  CHECK(class_of({4, 4, 4}) == FaceClass::trivial);
  CHECK(class_of({4, 4, 2}) == FaceClass::ordinary);
  CHECK(class_of({4, 2, 4}) == FaceClass::ordinary);
  CHECK(class_of({2, 4, 4}) == FaceClass::ordinary);
  CHECK(class_of({0, 1, 2}) == FaceClass::branching);
  CHECK(class_of({-1, -1, -1}) == FaceClass::unreached);
}

TEST_CASE("every diagram counts the faces of each class") {
  const Mesh mesh = test::make_two_components();
  for (const Method method : {Method::exact, Method::gbgvd, Method::paper}) {
    DiagramOptions options;
    options.method = method;
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 12, 2), options);
    const FaceClassCounts& n = diagram.report.face_classes;
    CHECK(n.trivial + n.ordinary + n.branching == mesh.face_count());
    CHECK(n.trivial > n.ordinary);
    CHECK(n.ordinary > n.branching);
    CHECK(n.branching > 0);
  }
  // The other component is reached by no generator.
  const Diagram one = compute_diagram(mesh, test::at_vertices(mesh, {0}));
  CHECK(one.report.face_classes.trivial > 0);
  CHECK(one.report.face_classes.trivial < mesh.face_count());
  CHECK(one.report.face_classes.ordinary == 0);
}

}  // namespace gvd::test_nearest_labels
