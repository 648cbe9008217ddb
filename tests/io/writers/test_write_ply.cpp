#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "io/fixture.hpp"
#include "support/catch.hpp"

namespace gvd::test_write_ply {

using namespace test;

/// The lines of the header, "end_header" included; `offset` is where the data begins.
std::vector<std::string> read_header(const std::string& bytes, std::size_t& offset) {
  offset = bytes.find("end_header\n") + 11;
  std::istringstream text(bytes.substr(0, offset));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// A label and its colour.
GeneratorId take_label(const std::string& bytes, std::size_t& offset) {
  const GeneratorId label(take<std::int32_t>(bytes, offset));
  const Rgb color{take<std::uint8_t>(bytes, offset), take<std::uint8_t>(bytes, offset),
                  take<std::uint8_t>(bytes, offset)};
  CHECK(color == color_in(Labelled().view(), label));
  return label;
}

TEST_CASE("a labelled PLY has the contract's properties, bit for bit") {
  const Labelled labelled;
  const std::string bytes = to_bytes(labelled.view(), MeshFormat::ply);
  std::size_t offset = 0;
  CHECK(read_header(bytes, offset) == std::vector<std::string>{"ply",
                                                               "format binary_little_endian 1.0",
                                                               "element vertex 20",
                                                               "property double x",
                                                               "property double y",
                                                               "property double z",
                                                               "property float distance",
                                                               "property int label",
                                                               "property uchar red",
                                                               "property uchar green",
                                                               "property uchar blue",
                                                               "element face 24",
                                                               "property list uchar int vertex_indices",
                                                               "property int label",
                                                               "property uchar red",
                                                               "property uchar green",
                                                               "property uchar blue",
                                                               "property int parent",
                                                               "property uchar intensity",
                                                               "end_header"});
  for (int v = 0; v < labelled.mesh.vertex_count(); ++v) {
    for (int i = 0; i < 3; ++i) CHECK(take<double>(bytes, offset) == labelled.mesh.position(VertexId(v))[i]);
    CHECK(take<float>(bytes, offset) == static_cast<float>(labelled.diagram.vertex_distance[VertexId(v)]));
    CHECK(take_label(bytes, offset) == labelled.diagram.vertex_label[VertexId(v)]);
  }
  for (int f = 0; f < labelled.mesh.face_count(); ++f) {
    CHECK(take<std::uint8_t>(bytes, offset) == 3);
    for (const VertexId v : labelled.mesh.vertices(FaceId(f))) CHECK(take<std::int32_t>(bytes, offset) == v.value());
    const GeneratorId label = take_label(bytes, offset);
    CHECK(label == labelled.face_label[FaceId(f)]);
    CHECK(take<std::int32_t>(bytes, offset) == f / 2);
    CHECK(take<std::uint8_t>(bytes, offset) == (label.valid() ? label.value() : 255));
  }
  CHECK(offset == bytes.size());
}

TEST_CASE("what nothing reaches is -1 and infinite in a PLY") {
  const Labelled labelled;
  LabelledMesh view{labelled.mesh};
  view.vertex_distance = &labelled.diagram.vertex_distance;
  view.vertex_label = &labelled.diagram.vertex_label;
  const std::string bytes = to_bytes(view, MeshFormat::ply);
  std::size_t offset = 0;
  read_header(bytes, offset);
  offset += 19 * 35 + 24;  // the last vertex, behind its coordinates
  CHECK(std::isinf(take<float>(bytes, offset)));
  CHECK(take<std::int32_t>(bytes, offset) == -1);
}

TEST_CASE("distances beyond a float's range are doubles in a PLY") {
  const Labelled labelled;
  for (const double extreme : {1e39, 1e-39}) {
    IdVector<VertexId, double> distance(20, 0);
    distance[VertexId(1)] = extreme;
    distance[VertexId(2)] = std::numeric_limits<double>::infinity();
    LabelledMesh view{labelled.mesh};
    view.vertex_distance = &distance;
    const std::string bytes = to_bytes(view, MeshFormat::ply);
    std::size_t offset = 0;
    CHECK(read_header(bytes, offset)[6] == "property double distance");
    offset += 24;
    CHECK(take<double>(bytes, offset) == 0);
    offset += 24;
    CHECK(take<double>(bytes, offset) == extreme);
    offset += 24;
    CHECK(std::isinf(take<double>(bytes, offset)));
  }
}

TEST_CASE("a PLY as text has the same numbers as the binary one") {
  const Labelled labelled;
  LabelledMesh view = labelled.view();
  const std::string binary = to_bytes(view, MeshFormat::ply);
  view.ascii_ply = true;
  const std::string text = to_bytes(view, MeshFormat::ply);
  std::size_t offset = 0, text_offset = 0;
  std::vector<std::string> binary_header = read_header(binary, offset);
  binary_header[1] = "format ascii 1.0";
  CHECK(read_header(text, text_offset) == binary_header);
  std::istringstream numbers(text.substr(text_offset));
  const auto next = [&numbers] {
    std::string word;
    numbers >> word;
    return std::strtod(word.c_str(), nullptr);
  };
  for (int v = 0; v < 20; ++v) {
    for (int i = 0; i < 3; ++i) CHECK(next() == take<double>(binary, offset));
    CHECK(static_cast<float>(next()) == take<float>(binary, offset));
    CHECK(next() == take<std::int32_t>(binary, offset));
    for (int i = 0; i < 3; ++i) CHECK(next() == take<std::uint8_t>(binary, offset));
  }
  for (int f = 0; f < 24; ++f) {
    CHECK(next() == take<std::uint8_t>(binary, offset));
    for (int i = 0; i < 4; ++i) CHECK(next() == take<std::int32_t>(binary, offset));
    for (int i = 0; i < 3; ++i) CHECK(next() == take<std::uint8_t>(binary, offset));
    CHECK(next() == take<std::int32_t>(binary, offset));
    CHECK(next() == take<std::uint8_t>(binary, offset));
  }
  CHECK(offset == binary.size());
  CHECK(std::count(text.begin(), text.end(), '\n') == static_cast<long>(binary_header.size()) + 20 + 24);
}

}  // namespace gvd::test_write_ply
