#include <algorithm>

#include "mesh/reading/soup_files.hpp"

namespace gvd::test_read_off {

using namespace test;

PolygonSoup parse(std::string_view bytes) { return parse_soup(bytes, MeshFormat::off, "file"); }

TEST_CASE("OFF: a tetrahedron, with every form of the header") {
  require_tetrahedron(parse(kOff));
  const std::string body = kOff.substr(kOff.find("0 0 0"));
  for (const std::string header : {"OFF 4 4 6\n", "OFF\n\n# comment\n 4 4 6 # counts\n", "4 4 6\n",
                                   "# first\nOFF # kind\n4 4\n", "OFF\r\n4\t4 0\r\n", "NOFF\n4 4 0\n",
                                   "STCNOFF\n4 4 0\n", "OFF4 4 6\n", "NOFF4 4 0\n", "OFF4\t4 6 # ModelNet40\n"}) {
    INFO(header);
    require_tetrahedron(parse(header + body));
  }
}

TEST_CASE("OFF: the counts right behind the keyword are read in every way a file is given") {
  const std::string bytes = replaced(kOff, "OFF\n", "OFF");
  CHECK(detect_format(bytes, "a.txt") == MeshFormat::off);
  CHECK(detect_format(replaced(kOff, "OFF\n", "COFF"), "") == MeshFormat::off);
  require_refused("OFF4", MeshFormat::off, "the number of vertices is 4, and the file has only 0 more bytes");
  require_refused("nOFF4 4 6\n", MeshFormat::off, "'nOFF' has vertices that are not three-dimensional");
  require_refused("OFF99999999999999999999 1 0\n", MeshFormat::off, "should be a whole number");
}

TEST_CASE("OFF: colours of vertices and faces are skipped") {
  const PolygonSoup soup =
      parse("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n\n# between\n0 1 0 1 1 1 1\n3 0 1 2 0.5 1 1");
  CHECK(soup.positions[2] == Vec3(0, 1, 0));
  CHECK(soup.corners == std::vector<std::int32_t>{0, 1, 2});
}

TEST_CASE("OFF: a keyword of colours may have the counts on its line, and not all numbers") {
  const std::string vertices = "0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 255 0 0 255\n0 0 1 255 0 0 255\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  for (const std::string header : {"COFF 4 4 6\n", "COFF4 4 6\n", "COFF 4 4\n", "COFF # colours\n4 4 6\n"}) {
    INFO(header);
    const PolygonSoup soup = parse(header + vertices + faces);
    CHECK(soup.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(soup.polygon_count() == 4);
  }
  std::string line = "COFF 4 4 6 " + vertices + faces;
  std::ranges::replace(line, '\n', ' ');
  require_refused(line, MeshFormat::off,
                  "file:1: colours, normals or texture coordinates can't be told from coordinates on one line; give "
                  "each vertex and face a line of its own");
}

TEST_CASE("OFF: a vertex or a face may continue on the next lines") {
  const PolygonSoup soup =
      parse("OFF\n4 2 0\n0 0\n0\n1 0 0 255 0 0 255\n1\n# between\n\n1 # y\n0\n0 1 0\n4 0 1\n 2 3 # last\n3\n0\n1\n2");
  CHECK(soup.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(soup.corners == std::vector<std::int32_t>{0, 1, 2, 3, 0, 1, 2});
  CHECK(soup.first_corner == std::vector<std::size_t>{0, 4, 7});
}

TEST_CASE("OFF: all numbers may be on one line") {
  std::string line = kOff;
  std::ranges::replace(line, '\n', ' ');
  for (const std::string& bytes : {line, replaced(line, "OFF ", ""), replaced(line, "OFF 4", "OFF4"),
                                   line + "\n# end\n", replaced(line, "OFF ", "OFF\n"), "# one\r\n" + line + "\r\n"}) {
    INFO(bytes);
    require_tetrahedron(parse(bytes));
  }
  CHECK(parse("OFF 4 1 0 0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3").corners == std::vector<std::int32_t>{0, 1, 2, 3});
  CHECK(parse("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2\n3 2 1 0\n").notes ==
        std::vector<std::string>{"1 line after the last face left out"});
  require_refused(
      "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2 255 0 0", MeshFormat::off,
      "file:1: '255' follows the last face; if faces or vertices have colours, give each a line of its own");
  require_refused("OFF 4 1 0 0 0 0 1 0 0 0 1 0 0 0 1 4 0 1 2", MeshFormat::off, "a corner of the face is missing");
  // What else stands behind the counts is skipped, as ever.
  CHECK(parse("OFF 3 1 0 9 9\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").positions[1] == Vec3(1, 0, 0));
}

TEST_CASE("OFF: lines after the last face are noted") {
  CHECK(parse(kOff + "3 0 1 2\n# comment\n").notes == std::vector<std::string>{"1 line after the last face left out"});
  CHECK(parse(kOff + "\n# comment\n").notes.empty());
}

TEST_CASE("OFF: bad bytes are refused with their line") {
  const auto refused = [](const std::string& bytes, const std::string& part) {
    require_refused(bytes, MeshFormat::off, part);
  };
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n3 0 1 2\n", "file:5: vertex 2 has too few numbers, or continues on line 6");
  refused("OFF\n3 1 0\n0.0 0 0\n1 0 0\n0 1\n", "ends after line 5, and coordinate z is missing");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "file:6: face 0 refers to vertex 3, and there are 3");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "file:6: face 0 refers to vertex -1");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "ends after line 6, and a corner of the face is missing");
  refused("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n2 1 0\n",
          "file:6: face 0 has too few numbers, or continues on line 7");
  refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "file:6: face 0 has -3 corners");
  refused("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "ends after line 6, and face 1 of 2 is missing");
  refused("OFF\n3 1 0\n0.0 0 0\n10.0 0 0\n", "ends after line 4, and vertex 2 of 3 is missing");
  refused("OFF\n4000000000 1 0\n0 0 0\n",
          "file:2: the number of vertices is 4000000000, and the file has only 10 more");
  refused("OFF\n1 999999999999999 0\n0 0 0\n", "file:2: the number of faces is 999999999999999");
  refused("OFF\n-3 1 0\n", "file:2: the number of vertices is -3");
  refused("OFF\n3.5 1 0\n", "file:2: the number of vertices is '3.5', and should be a whole number");
  refused("OFF\n", "the counts of vertices and faces are missing");
  refused("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "3 vertices and no face");
  refused("OFF BINARY\n", "binary OFF");
  refused("4OFF\n1 1 0\n", "not three-dimensional");
  refused("ply\n", "file:1: the first line of an OFF file should be OFF, and is 'ply'");
  refused("# only\n", "holds no OFF header");
  require_refused("OFF\n1 1 0\nnan 0 0\n1 0\n", MeshFormat::off, "file:3: coordinate x of vertex 0",
                  ErrorCode::precondition);
}

}  // namespace gvd::test_read_off
