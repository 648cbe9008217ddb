#include <cmath>
#include <limits>
#include <sstream>

#include "gvd/io/label_color.hpp"
#include "io/fixture.hpp"
#include "support/catch.hpp"

using namespace gvd;
using namespace gvd::test;

namespace {

/// The lines of the header, "end_header" included; `offset` is where the data begins.
std::vector<std::string> read_header(const std::string& bytes, std::size_t& offset) {
  offset = bytes.find("end_header\n") + 11;
  std::istringstream text(bytes.substr(0, offset));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("a labelled PLY has the contract's properties, bit for bit") {
  const Labelled labelled;
  const std::string bytes = to_bytes(labelled.view(), OutputFormat::ply);
  std::size_t offset = 0;
  CHECK(read_header(bytes, offset) ==
        std::vector<std::string>{"ply", "format binary_little_endian 1.0", "element vertex 20", "property double x",
                                 "property double y", "property double z", "property float distance",
                                 "property int label", "element face 24", "property list uchar int vertex_indices",
                                 "property int label", "property uchar red", "property uchar green",
                                 "property uchar blue", "property int parent", "end_header"});
  for (int v = 0; v < labelled.mesh.vertex_count(); ++v) {
    for (int i = 0; i < 3; ++i) CHECK(take<double>(bytes, offset) == labelled.mesh.position(VertexId(v))[i]);
    CHECK(take<float>(bytes, offset) == static_cast<float>(labelled.diagram.vertex_distance[VertexId(v)]));
    CHECK(take<std::int32_t>(bytes, offset) == labelled.diagram.vertex_label[VertexId(v)].value());
  }
  for (int f = 0; f < labelled.mesh.face_count(); ++f) {
    CHECK(take<std::uint8_t>(bytes, offset) == 3);
    for (const VertexId v : labelled.mesh.vertices(FaceId(f))) CHECK(take<std::int32_t>(bytes, offset) == v.value());
    const GeneratorId label(take<std::int32_t>(bytes, offset));
    CHECK(label == labelled.face_label[FaceId(f)]);
    const Rgb color{take<std::uint8_t>(bytes, offset), take<std::uint8_t>(bytes, offset),
                    take<std::uint8_t>(bytes, offset)};
    CHECK(color == label_color(label));
    CHECK(take<std::int32_t>(bytes, offset) == f / 2);
  }
  CHECK(offset == bytes.size());
}

TEST_CASE("what nothing reaches is -1 and infinite in a PLY") {
  const Labelled labelled;
  LabelledMesh view{labelled.mesh};
  view.vertex_distance = &labelled.diagram.vertex_distance;
  view.vertex_label = &labelled.diagram.vertex_label;
  const std::string bytes = to_bytes(view, OutputFormat::ply);
  std::size_t offset = 0;
  read_header(bytes, offset);
  offset += 19 * 32 + 24;  // the last vertex, behind its coordinates
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
    const std::string bytes = to_bytes(view, OutputFormat::ply);
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
