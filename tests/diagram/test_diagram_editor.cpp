// A diagram that is edited has the bytes of a new diagram.
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/diagram_editor.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_diagram_editor {

/// Ten small meshes, and ten on which most changes concern a part of the cells. Two have several partitions.
std::vector<test::NamedMesh> twenty_meshes() {
  std::vector<test::NamedMesh> meshes = test::small_family();
  meshes.push_back({"larger sphere", test::make_sphere(4)});
  meshes.push_back({"larger torus", test::make_torus(80, 40)});
  meshes.push_back({"larger plate", test::make_plate(30)});
  meshes.push_back({"larger grid", test::make_grid(60, 45)});
  meshes.push_back({"larger ring", test::make_ring(120, 20)});
  meshes.push_back({"larger half sphere", test::make_half_sphere(4)});
  meshes.push_back({"larger bumpy sphere", test::make_bumpy_sphere(5, 7)});
  meshes.push_back({"larger thin-faced sphere", test::make_thin_faced_sphere(5, 8)});
  meshes.push_back({"larger genus 3", test::make_genus3(8)});
  meshes.push_back({"nested spheres", test::make_nested_spheres(0.9)});
  return meshes;
}

/// Applies random edits: far moves, near and tiny ones, additions, removals.
class RandomEdits {
 public:
  RandomEdits(const Mesh& mesh, unsigned seed) : mesh_(mesh), random_(seed) {}

  /// Edits once. Where the edit is refused because two generators coincide, others are tried.
  void apply(DiagramEditor& editor) {
    while (true) {
      try {
        return apply_once(editor);
      } catch (const Error& error) {
        REQUIRE(error.code() == ErrorCode::precondition);
      }
    }
  }

 private:
  int below(std::size_t n) { return static_cast<int>(random_() % n); }
  SurfacePoint anywhere() {
    return test::random_generators(mesh_, 3, static_cast<unsigned>(random_()))[static_cast<std::size_t>(below(3))];
  }
  /// A point in a face at or beside that of p.
  SurfacePoint near(const SurfacePoint& p) {
    const std::vector<FaceId> around = faces_around(mesh_, p);
    FaceId f = around[static_cast<std::size_t>(below(around.size()))];
    const HalfedgeId twin = mesh_.twin(Mesh::halfedge(f, below(3)));
    if (twin.valid()) f = Mesh::face(twin);
    const double a = 0.1 + 0.4 * below(100) / 100.0, b = 0.1 + 0.3 * below(100) / 100.0;
    return make_surface_point(f, {a, b, 1 - a - b});
  }
  /// None, one or several points.
  std::vector<SurfacePoint> some_points() {
    std::vector<SurfacePoint> points(static_cast<std::size_t>(below(5)));
    for (SurfacePoint& p : points) p = anywhere();
    return points;
  }
  /// The same point, a millionth of its face further.
  static SurfacePoint tiny(SurfacePoint p) {
    const double step = 1e-6 * p.bary[0];
    return make_surface_point(p.face, {p.bary[0] - step, p.bary[1] + step, p.bary[2]});
  }

  void apply_once(DiagramEditor& editor) {
    const std::vector<SurfacePoint> points = editor.generators();
    const GeneratorId g(below(points.size()));
    switch (below(6)) {
      case 0:
        editor.move(g, anywhere());
        break;
      case 1:
      case 2:
        editor.move(g, near(points[g.index()]));
        break;
      case 3:
        editor.move(g, tiny(points[g.index()]));
        break;
      case 4:
        editor.add(some_points());
        break;
      default:
        points.size() > 1 ? editor.remove(g) : editor.add(anywhere());
    }
  }

  const Mesh& mesh_;
  std::mt19937 random_;
};

std::vector<SurfacePoint> start(const Mesh& mesh, unsigned seed) {
  return test::random_generators(mesh, mesh.face_count() < 2000 ? 6 : 40, seed);
}

TEST_CASE("generators can be removed down to one, and added again") {
  const Mesh mesh = test::make_two_components();
  DiagramEditor editor(mesh, test::random_generators(mesh, 8, 1));
  const auto agrees = [&] { return test::same_diagram(editor.diagram(), compute_diagram(mesh, editor.generators())); };
  while (editor.generators().size() > 1) {
    editor.remove(GeneratorId(0));
    CHECK(agrees());
  }
  CHECK_THROWS_AS(editor.remove(GeneratorId(0)), Error);
  for (const SurfacePoint& p : test::random_generators(mesh, 9, 2)) {
    editor.add(p);
    CHECK(agrees());
  }
}

TEST_CASE("a thousand random edits on twenty meshes have the bytes of new diagrams") {
  int local = 0;
  for (const auto& [name, mesh] : twenty_meshes()) {
    DiagramEditor editor(mesh, start(mesh, 3));
    RandomEdits edits(mesh, 5);
    for (int i = 0; i < 50; ++i) {
      INFO(name << ", edit " << i);
      edits.apply(editor);
      REQUIRE(test::same_diagram(editor.diagram(), compute_diagram(mesh, editor.generators())));
      local += editor.propagated() < std::ssize(editor.generators()) ? 1 : 0;
    }
  }
  CHECK(local > 450);  // the others are on meshes of few cells
}

// All windows of a generator may lie in parts of one face, which each change splits anew.
TEST_CASE("many generators in one face can be moved") {
  for (const Mesh& mesh : {test::make_triangle(), test::make_pillow(), test::make_sphere(3)}) {
    std::mt19937 random(7);
    const auto inside = [&random] {
      const double u = double(random() % 997 + 1) / 1000, v = (1 - u) * double(random() % 997 + 1) / 1000;
      return make_surface_point(FaceId(0), {u, v, 1 - u - v});
    };
    std::vector<SurfacePoint> points = test::random_generators(mesh, mesh.face_count() < 100 ? 1 : 60, 1);
    const std::size_t others = points.size();
    for (int i = 0; i < 12; ++i) points.push_back(inside());
    DiagramEditor editor(mesh, points);
    for (int i = 0; i < 60; ++i) {
      INFO(mesh.face_count() << " faces, move " << i);
      editor.move(GeneratorId(others + random() % 12), inside());
      REQUIRE(test::same_diagram(editor.diagram(), compute_diagram(mesh, editor.generators())));
    }
  }
}

TEST_CASE("a near move propagates the generator and those around it only") {
  const Mesh mesh = test::make_bumpy_sphere(5, 7);
  DiagramEditor editor(mesh, test::random_generators(mesh, 100, 4));
  const SurfacePoint p = editor.generators()[2];
  editor.move(GeneratorId(2), make_surface_point(p.face, {0.3, 0.3, 0.4}));
  CHECK(editor.propagated() < 25);
  CHECK(test::same_diagram(editor.diagram(), compute_diagram(mesh, editor.generators())));
}

TEST_CASE("edits have the same bytes with any number of threads, and with another chord tolerance") {
  const Mesh mesh = test::make_bumpy_sphere(5, 7);
  DiagramOptions one, many;
  one.threads = 1;
  many.threads = 8;
  one.chord_tolerance = many.chord_tolerance = 1e-6;
  DiagramEditor first(mesh, start(mesh, 3), one), second(mesh, start(mesh, 3), many);
  RandomEdits first_edits(mesh, 9), second_edits(mesh, 9);
  for (int i = 0; i < 10; ++i) {
    first_edits.apply(first);
    second_edits.apply(second);
    CHECK(test::same_diagram(first.diagram(), second.diagram()));
  }
  CHECK(test::same_diagram(first.diagram(), compute_diagram(mesh, first.generators(), one)));
}

TEST_CASE("an edit that is refused changes nothing") {
  const Mesh mesh = test::make_sphere(3);
  DiagramEditor editor(mesh, test::random_generators(mesh, 12, 1));
  const Diagram before = editor.diagram();
  CHECK_THROWS_AS(editor.move(GeneratorId(3), before.generators[4]), Error);
  CHECK_THROWS_AS(editor.move(GeneratorId(12), before.generators[4]), Error);
  CHECK_THROWS_AS(editor.move(GeneratorId(), before.generators[4]), Error);
  CHECK_THROWS_AS(editor.add({FaceId(mesh.face_count()), {1, 0, 0}}), Error);
  CHECK_THROWS_AS(editor.move(GeneratorId(3), {FaceId(0), {std::nan(""), 0.5, 0.5}}), Error);
  CHECK_THROWS_AS(editor.remove(GeneratorId(12)), Error);
  CHECK(test::same_diagram(editor.diagram(), before));
  editor.move(GeneratorId(3), vertex_point(mesh, VertexId(0)));
  CHECK(test::same_diagram(editor.diagram(), compute_diagram(mesh, editor.generators())));
}

TEST_CASE("an edit that is interrupted changes nothing, and the next one is right") {
  const Mesh mesh = test::make_bumpy_sphere(4, 7);
  int calls = 0, last = 1 << 30;
  DiagramOptions options;
  options.threads = 1;
  options.progress = [&](std::string_view, double) { return ++calls < last; };
  DiagramEditor editor(mesh, test::random_generators(mesh, 30, 1), options);
  const auto point = [](int i) { return make_surface_point(FaceId(97 * i), {0.31, 0.33, 0.36}); };
  int interrupted = 0;
  for (int limit = 1; limit < 40; ++limit) {
    const Diagram before = editor.diagram();
    calls = 0;
    last = limit;
    try {
      editor.move(GeneratorId(limit % 30), point(limit));
    } catch (const Error& error) {
      REQUIRE(error.code() == ErrorCode::interrupted);
      CHECK(test::same_diagram(editor.diagram(), before));
      ++interrupted;
    }
    last = 1 << 30;
    editor.move(GeneratorId((limit + 1) % 30), point(limit + 1));
    DiagramOptions silent;
    silent.threads = 1;
    REQUIRE(test::same_diagram(editor.diagram(), compute_diagram(mesh, editor.generators(), silent)));
  }
  CHECK(interrupted >= 4);
}

TEST_CASE("other methods and weights can't be edited") {
  const Mesh mesh = test::make_sphere(2);
  const std::vector<SurfacePoint> generators = test::random_generators(mesh, 3, 1);
  DiagramOptions marched, weighted;
  marched.method = Method::gbgvd;
  weighted.weights = {0, 0, 0.01};
  for (const DiagramOptions& options : {marched, weighted}) {
    try {
      const DiagramEditor editor(mesh, generators, options);
      FAIL("not refused");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::invalid_option);
    }
  }
}

}  // namespace gvd::test_diagram_editor
