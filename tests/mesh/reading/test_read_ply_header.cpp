#include <string>

#include "gvd/error.hpp"
#include "mesh/reading/read_ply_header.hpp"
#include "support/catch.hpp"

namespace gvd::test_read_ply_header {

const std::string kVertex = "element vertex 3\nproperty float x\nproperty float y\nproperty double z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n";

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

TEST_CASE("PLY header: elements and properties in their order, and where the data begin") {
  const std::string text = header("binary_big_endian", "comment made by hand\n" + kVertex + kFace);
  const PlyHeader parsed = parse_ply_header(text + "data", "file");
  CHECK(parsed.encoding == PlyEncoding::big_endian);
  CHECK(parsed.bytes == text.size());
  CHECK(parsed.lines == 10);
  REQUIRE(parsed.elements.size() == 2);
  const PlyElement& vertex = parsed.elements[0];
  CHECK(vertex.name == "vertex");
  CHECK(vertex.count == 3);
  CHECK(vertex.find("z") == 2);
  CHECK(vertex.find("w") == -1);
  CHECK(vertex.properties[2].type == NumberType::float64);
  CHECK_FALSE(vertex.properties[2].count_type);
  CHECK(parsed.elements[1].properties[0].count_type == NumberType::uint8);
}

TEST_CASE("PLY header: sizes of the types, and which are integers") {
  CHECK(size_of(NumberType::int8) == 1);
  CHECK(size_of(NumberType::uint16) == 2);
  CHECK(size_of(NumberType::float32) == 4);
  CHECK(size_of(NumberType::float64) == 8);
  CHECK(is_integer(NumberType::uint32));
  CHECK_FALSE(is_integer(NumberType::float32));
}

TEST_CASE("PLY header: what is missing or given twice is refused") {
  CHECK_NOTHROW(parse_ply_header(header("ascii", kVertex + kFace), "file"));
  for (const std::string& bad :
       {std::string("obj\n"), std::string("ply\n"), header("text", kVertex + kFace), header("ascii", kVertex),
        header("ascii", kFace), header("ascii", kVertex + kFace + kFace), "ply\n" + kVertex + kFace + "end_header\n",
        header("ascii", "property float x\n"), header("ascii", "element vertex -1\n")}) {
    INFO(bad);
    CHECK_THROWS_AS(parse_ply_header(bad, "file"), Error);
  }
}

TEST_CASE("PLY header: names in messages are printable and short") {
  const std::string odd = "b\x01" + std::string(5000, 'a');
  const PlyHeader parsed =
      parse_ply_header(header("ascii", kVertex + kFace + "element " + odd + " 1\nproperty int " + odd + "\n"), "file");
  const std::string shown = "b?" + std::string(38, 'a') + "...";
  CHECK(parsed.elements[2].name == shown);
  CHECK(parsed.elements[2].properties[0].name == shown);
}

TEST_CASE("PLY header: elements whose names look alike in messages are two") {
  const std::string elements = kVertex + kFace + "element \x01 1\nelement \x02 1\n";
  CHECK(parse_ply_header(header("ascii", elements), "file").elements.size() == 4);
}

// Each end_header without a line end was searched for one to the end of the file: hours for these 20 MB.
TEST_CASE("PLY header: many lines end_header without the header's line end take no longer than one") {
  std::string text = "ply\r\n", more = text;
  for (int i = 0; i < 2'000'000; ++i) text += "end_header", more += "\nend_header";
  CHECK_THROWS_AS(parse_ply_header(text, "file"), Error);
  CHECK_THROWS_AS(parse_ply_header(more, "file"), Error);
}

// Each name was compared with all before it: minutes for these 12 MB.
TEST_CASE("PLY header: many elements take no longer each than one") {
  std::string elements = kVertex + kFace;
  for (int i = 0; i < 600'000; ++i) elements += "element e" + std::to_string(i) + " 0\n";
  CHECK(parse_ply_header(header("ascii", elements), "file").elements.size() == 600'002);
}

}  // namespace gvd::test_read_ply_header
