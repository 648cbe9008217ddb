#include "mesh/reading/soup_files.hpp"

namespace gvd::test_read_ply {

using namespace test;

PolygonSoup parse(std::string_view bytes) { return parse_soup(bytes, MeshFormat::ply, "file"); }

TEST_CASE("PLY: a tetrahedron in every encoding") {
  require_tetrahedron(parse(kPly));
  require_tetrahedron(parse(binary_ply(false)));
  require_tetrahedron(parse(binary_ply(true)));
  require_tetrahedron(parse(replaced(kPly, "vertex_indices", "vertex_index")));
}

TEST_CASE("PLY: line ends of the header") {
  const auto with_line_ends = [](std::string text, const std::string& end) {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + end.size())) {
      text.replace(at, 1, end);
    }
    return text;
  };
  for (const std::string end : {"\r\n", "\r"}) {
    require_tetrahedron(parse(with_line_ends(kPly, end)));
    const std::string binary = binary_ply(false);
    const std::size_t data = binary.find("end_header\n") + 11;
    require_tetrahedron(parse(with_line_ends(binary.substr(0, data), end) + binary.substr(data)));
  }
}

TEST_CASE("PLY: other elements, properties and lists are skipped") {
  const std::string bytes =
      "ply\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty list uint8 float32 numbers\nproperty int id\n"
      "element vertex 3\nproperty uchar red\nproperty double z\nproperty list uchar int tags\nproperty float64 y\n"
      "property float32 x\nelement empty 7\nelement face 1\nproperty list uchar uint vertex_indices\nproperty char "
      "flag\n"
      "property list int short more\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
      "2 1.5 2.5 7\n255 3 0 2 1\n255 6 2 8 9 5 4\n255 9 1 1 8 7\n3 0 1 2 -1 2 5 6\n0 1\n";
  const PolygonSoup soup = parse(bytes);
  CHECK(soup.positions == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  CHECK(soup.corners == std::vector<std::int32_t>{0, 1, 2});
}

TEST_CASE("PLY: an element may continue on the next lines") {
  std::string wrapped = kPly;
  for (std::size_t at = kPly.find("end_header\n") + 11; at < wrapped.size(); ++at) {
    if (wrapped[at] == ' ') wrapped[at] = '\n';
  }
  require_tetrahedron(parse(wrapped));
  require_tetrahedron(parse(replaced(kPly, "1 0 1\n", "1\n\n0 1\n")));
  require_tetrahedron(parse(replaced(kPly, "3 0 3 1", "3 0\r\n3 1")));
  require_refused(replaced(wrapped, "3\n0\n3\n1", "3\n0\n9\n1"), MeshFormat::ply, "face 1 refers to vertex 9");
  require_refused(wrapped.substr(0, wrapped.size() - 2), MeshFormat::ply,
                  "announces 3 entries, but the file has room for 2");
}

TEST_CASE("PLY: lists in binary files are skipped") {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty list ushort double extra\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\nproperty list int ushort vertex_indices\nend_header\n";
  for (const float x : {0.F, 1.F, 2.F}) {
    bytes += bytes_of(std::uint16_t{2}) + bytes_of(9.0) + bytes_of(8.0);
    bytes += bytes_of(x) + bytes_of(x * x) + bytes_of(0.5F);
  }
  bytes +=
      bytes_of(std::int32_t{3}) + bytes_of(std::uint16_t{0}) + bytes_of(std::uint16_t{2}) + bytes_of(std::uint16_t{1});
  const PolygonSoup soup = parse(bytes);
  CHECK(soup.positions == std::vector<Vec3>{{0, 0, 0.5}, {1, 1, 0.5}, {2, 4, 0.5}});
  CHECK(soup.corners == std::vector<std::int32_t>{0, 2, 1});
}

TEST_CASE("PLY: triangle strips") {
  const std::string begin =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n5 5 5\n";
  // A strip of three triangles, then one of a single triangle, and one too short for any.
  CHECK(parse(begin + "12 0 1 2 3 4 -1 3 5 4 -1 0 1\n").corners ==
        std::vector<std::int32_t>{0, 1, 2, 2, 1, 3, 2, 3, 4, 3, 5, 4});
  // A repeated corner leads to the next strip; the triangles after it keep their orientation.
  CHECK(parse(begin + "6 0 1 2 2 3 4\n").corners == std::vector<std::int32_t>{0, 1, 2, 3, 2, 4});
  require_refused(begin + "4 0 1 2 6\n", MeshFormat::ply, "strip 0 refers to vertex 6, and there are 6");
  require_refused(begin + "4 0 1 2 -2\n", MeshFormat::ply, "strip 0 refers to vertex -2");
  require_refused(replaced(begin, "vertex_indices", "indices"), MeshFormat::ply, "'tristrips' has no list");
}

TEST_CASE("PLY: bad headers are refused with their line") {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    require_refused(replaced(kPly, from, to), MeshFormat::ply, part);
  };
  refused("ply\n", "plx\n", "file:1: the first line of a PLY file should be ply");
  refused("ascii", "ascii_old", "file:2: the format 'ascii_old' is none of");
  refused("format ascii 1.0\n", "", "no line 'format'");
  refused("comment", "remark", "file:3: 'remark' is not a statement of a PLY header");
  refused("vertex 4", "vertex", "file:4: the number of elements is missing");
  refused("vertex 4", "vertex -4", "file:4: the number of elements is -4");
  refused("float x", "real x", "file:5: 'real' is not a type");
  refused("float x", "float u", "no number 'x'");
  refused("element vertex 4\n", "", "file:4: a property comes before the first element");
  refused("element face 4", "element vertex 4", "file:8: the element 'vertex' is declared twice");
  refused("element face 4", "element facet 4", "neither an element 'face' nor 'tristrips'");
  refused("vertex_indices", "indices", "no list 'vertex_indices'");
  refused("list uchar int", "list float int", "an integer type");
  refused("end_header", "end_headers", "is not a statement of a PLY header");
  require_refused("ply\nformat ascii 1.0\n", MeshFormat::ply, "ends after line 2, and end_header is missing");
}

TEST_CASE("PLY: bad data are refused with their line") {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    require_refused(replaced(kPly, from, to), MeshFormat::ply, part);
  };
  refused("1 0 1\n", "1 0\n", "file:13: vertex 2 has too few numbers, or continues on line 14");
  refused("1 0 1\n", "1 0 1 1\n", "file:13: vertex 2 has '1' too many; the header declares x, y, z");
  refused("1 0 1\n", "1 zero 1\n", "file:13: y is 'zero', and should be a number");
  refused("3 0 3 1", "3 0 4 1", "file:16: face 1 refers to vertex 4, and there are 4");
  refused("3 0 3 1", "3 0 -1 1", "file:16: face 1 refers to vertex -1");
  refused("3 0 3 1", "3 0 1.5 1", "file:16: face 1 refers to vertex 1.5");
  refused("3 0 3 1", "-3 0 3 1", "file:16: the list 'vertex_indices' announces -3 entries");
  refused("3 0 3 1", "3e50 0 3 1", "file:16: the list 'vertex_indices' announces 3e+50 entries");
  refused("3 0 3 1", "4000000000 0 3 1",
          "file:16: the list 'vertex_indices' announces 4000000000 entries, but the file has room");
  refused("face 4", "face 5", "the file ends after line 18, and face 4 of 5 is missing");
  refused("face 4", "face 4000000000", "promises 4000000000 of element 'face'");
  refused("face 4", "face 0", "no face");
  require_refused(replaced(kPly, "1 0 1\n", "1 nan 1\n"), MeshFormat::ply, "file:13: a coordinate of vertex 2",
                  ErrorCode::precondition);
}

TEST_CASE("PLY: binary files are refused with the byte") {
  const std::string bytes = binary_ply(false);
  require_refused(bytes.substr(0, bytes.size() - 1), MeshFormat::ply, "inside 'vertex_indices' of face 3 of 4");
  require_refused(replaced(bytes, "vertex 4\n", "vertex 4000000000\n"), MeshFormat::ply, "promises 4000000000");
  std::string wrong = bytes;
  wrong[wrong.size() - 4] = 9;
  require_refused(wrong, MeshFormat::ply, "face 3 refers to vertex 9, and there are 4");
  wrong = bytes;
  wrong[bytes.find("end_header\n") + 11 + 3] = '\x7f';
  wrong[bytes.find("end_header\n") + 11 + 2] = '\x80';
  require_refused(wrong, MeshFormat::ply, "vertex 0 is not a finite number", ErrorCode::precondition);
}

}  // namespace gvd::test_read_ply
