#include <charconv>
#include <sstream>

#include "io/fixture.hpp"
#include "support/catch.hpp"

namespace gvd::test_write_obj {

using namespace test;

std::vector<std::vector<std::string>> read_words(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    auto& row = lines.emplace_back();
    for (std::string word; words >> word;) row.push_back(word);
  }
  return lines;
}

double number(const std::string& word) {
  double value = 0;
  std::from_chars(word.data(), word.data() + word.size(), value);
  return value;
}

TEST_CASE("an OBJ keeps doubles, and its bisectors come as lines with their own vertices") {
  const Labelled labelled;
  std::vector<Vec3> points;
  std::vector<std::vector<std::size_t>> lines;
  for (const auto& words : read_words(to_bytes(labelled.view(), MeshFormat::obj))) {
    if (words[0] == "v") points.emplace_back(number(words.at(1)), number(words.at(2)), number(words.at(3)));
    if (words[0] != "l") continue;
    auto& line = lines.emplace_back();
    for (std::size_t i = 1; i < words.size(); ++i) line.push_back(std::stoul(words[i]) - 1);
  }
  const auto vertices = static_cast<std::size_t>(labelled.mesh.vertex_count());
  REQUIRE(points.size() == vertices + 3 + 2 + 4);
  for (std::size_t v = 0; v < vertices; ++v) CHECK(points[v] == labelled.mesh.positions()[v]);
  // Blender keeps one edge of a longer polyline.
  CHECK(lines == std::vector<std::vector<std::size_t>>{{20, 21}, {21, 22}, {23, 24}, {25, 26}, {26, 27}, {27, 28}});
  CHECK(points[20] == position(labelled.mesh, labelled.diagram.bisectors[BisectorId(0)].points[0]));
  CHECK(points[25] == points[28]);
}

TEST_CASE("a stream's OBJ names groups, and no materials that it can't carry") {
  const std::string text = to_bytes(Labelled().view(), MeshFormat::obj);
  CHECK(text.find("g region_0\nf ") != std::string::npos);
  CHECK(text.find("mtl") == std::string::npos);
}

TEST_CASE("a cut mesh draws the bisectors on the mesh that they belong to") {
  const Labelled labelled;
  const Mesh other({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  LabelledMesh view{other};
  view.diagram = &labelled.diagram;
  view.diagram_mesh = &labelled.mesh;
  const auto words = read_words(to_bytes(view, MeshFormat::obj));
  const auto first = position(labelled.mesh, labelled.diagram.bisectors[BisectorId(0)].points[0]);
  CHECK(words.at(4) == std::vector<std::string>{"o", "bisectors"});
  CHECK(words.at(5) == std::vector<std::string>{"g", "bisectors"});
  CHECK(words.at(6) == std::vector<std::string>{"#", "left", "0", "right", "1"});
  CHECK(number(words.at(7).at(1)) == first.x());
}

}  // namespace gvd::test_write_obj
