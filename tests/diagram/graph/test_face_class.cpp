#include "diagram/graph/face_class.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_face_class {

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

}  // namespace gvd::test_face_class
