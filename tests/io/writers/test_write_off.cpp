#include <algorithm>
#include <array>
#include <sstream>

#include "io/fixture.hpp"
#include "support/catch.hpp"

namespace gvd::test_write_off {

using namespace test;

TEST_CASE("an OFF has no colours, whatever labels there are") {
  const Labelled labelled;
  const std::string text = to_bytes(labelled.view(), MeshFormat::off);
  CHECK(text == to_bytes(LabelledMesh{labelled.mesh}, MeshFormat::off));
  CHECK(text.starts_with("OFF\n20 24 "));
  CHECK(std::count(text.begin(), text.end(), '\n') == 2 + 20 + 24);
  CHECK(std::count(text.begin(), text.end(), ' ') == 2 + 20 * 2 + 24 * 3);
}

TEST_CASE("a coloured OFF has colours behind each vertex and face") {
  const Labelled labelled;
  std::istringstream text(to_bytes(labelled.view(), MeshFormat::coff));
  std::string header;
  int vertices = 0, faces = 0, edges = 0;
  text >> header >> vertices >> faces >> edges;
  CHECK(header == "COFF");
  CHECK(vertices == 20);
  CHECK(faces == 24);
  CHECK(edges == labelled.mesh.edge_count());
  for (int v = 0; v < vertices; ++v) {
    std::array<double, 7> numbers{};
    for (double& number : numbers) text >> number;
    CHECK(Vec3(numbers[0], numbers[1], numbers[2]) == labelled.mesh.position(VertexId(v)));
    const Rgb color = color_in(labelled.view(), labelled.diagram.vertex_label[VertexId(v)]);
    CHECK(255 * numbers[3] == Approx(color.red).margin(0.02));
    CHECK(255 * numbers[4] == Approx(color.green).margin(0.02));
    CHECK(255 * numbers[5] == Approx(color.blue).margin(0.02));
    CHECK(numbers[6] == 1);
  }
  for (int f = 0; f < faces; ++f) {
    const auto& [a, b, c] = labelled.mesh.vertices(FaceId(f));
    const Rgb color = color_in(labelled.view(), labelled.face_label[FaceId(f)]);
    std::vector<int> numbers(7);
    for (int& number : numbers) text >> number;
    CHECK(numbers == std::vector<int>{3, a.value(), b.value(), c.value(), color.red, color.green, color.blue});
  }
  CHECK(text.good());
  text >> std::ws;
  CHECK(text.eof());
}

TEST_CASE("without labels of vertices a coloured OFF takes those of a face beside") {
  const Labelled labelled;
  LabelledMesh view{labelled.mesh};
  view.face_label = &labelled.face_label;
  std::istringstream text(to_bytes(view, MeshFormat::coff));
  std::string line;
  for (int i = 0; i < 3; ++i) std::getline(text, line);
  const FaceId beside = Mesh::face(labelled.mesh.halfedge(VertexId(0)));
  const double red = color_in(view, labelled.face_label[beside]).red / 255.0;
  std::istringstream words(line);
  double x = 0, y = 0, z = 0, read = 0;
  words >> x >> y >> z >> read;
  CHECK(read == Approx(red).margin(1e-4));
}

}  // namespace gvd::test_write_off
