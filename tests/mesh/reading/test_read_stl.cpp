#include "mesh/reading/soup_files.hpp"

namespace gvd::test_read_stl {

using namespace test;

TEST_CASE("STL: a tetrahedron, text and binary, welded to four vertices") {
  for (const std::string& bytes : {kStl, binary_stl()}) {
    const PolygonSoup soup = parse_soup(bytes, MeshFormat::stl, "file");
    CHECK(soup.unwelded);
    CHECK(soup.positions.size() == 12);
    require_tetrahedron(soup);
    CHECK(build_mesh(soup).defects.count(DefectKind::unwelded_vertices) == 8);
  }
}

TEST_CASE("STL: a binary file may start with solid and have extra bytes at the end") {
  std::string bytes = binary_stl();
  bytes.replace(0, 5, "solid");
  require_tetrahedron(parse_soup(bytes, MeshFormat::stl, "file"));
  const PolygonSoup soup = parse_soup(bytes + "more", MeshFormat::stl, "file");
  require_tetrahedron(soup);
  CHECK(soup.notes == std::vector<std::string>{"4 bytes after the last triangle are left out"});
}

TEST_CASE("STL: upper case, several solids, no name") {
  std::string upper = kStl;
  for (char& c : upper) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  require_tetrahedron(parse_soup(upper, MeshFormat::stl, "file"));
  require_tetrahedron(parse_soup("\n solid\nendsolid\n" + kStl, MeshFormat::stl, "file"));
}

TEST_CASE("STL: bad bytes are refused with their line or byte") {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    require_refused(replaced(kStl, from, to), MeshFormat::stl, part);
  };
  refused("vertex 1 1 0", "vertex 1 1", "file:5: coordinate z is missing");
  refused("vertex 1 1 0", "vertex 1 x 0", "file:5: coordinate y is 'x'");
  refused("vertex 1 1 0\n", "", "file:6: facet 0 has 2 vertices, and should have 3");
  refused("vertex 1 1 0", "corner 1 1 0", "file:5: 'corner' is not a statement");
  refused("outer loop\n", "", "file:3: 'vertex' is out of place");
  refused("endloop\n", "", "file:7: 'endfacet' is out of place");
  refused("endsolid tetrahedron\n", "", "ends after line 29, and endsolid is missing");
  require_refused("solid\nendsolid\n", MeshFormat::stl, "no face");
  require_refused("hello", MeshFormat::stl, "5 bytes are too few for an STL file");
  const std::string binary = binary_stl();
  require_refused(binary.substr(0, 200), MeshFormat::stl,
                  "as a binary STL of 4 triangles it should have 284 bytes, not 200");
  std::string wrong = binary;
  wrong.replace(84 + 50 + 12, 4, bytes_of(std::uint32_t{0x7f800000}));
  require_refused(wrong, MeshFormat::stl, "byte 146: a coordinate of triangle 1", ErrorCode::precondition);
  wrong = binary;
  wrong.replace(80, 4, "\xff\xff\xff\xff");
  require_refused(wrong, MeshFormat::stl, "4294967295 triangles");
  wrong.replace(80, 4, std::string(4, '\0'));
  require_refused(wrong, MeshFormat::stl,
                  "the header of the STL says that there are 0 triangles, and 200 bytes follow, room for 4 triangles; "
                  "write the file again");
  require_refused(wrong.substr(0, 84), MeshFormat::stl, "0 triangles, and none follows");
}

}  // namespace gvd::test_read_stl
