#include "mesh/reading/soup_files.hpp"

namespace gvd::test_read_obj {

using namespace test;

PolygonSoup parse(std::string_view bytes) { return parse_soup(bytes, MeshFormat::obj, "file"); }
const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

TEST_CASE("OBJ: a tetrahedron") { require_tetrahedron(parse(kObj)); }

TEST_CASE("OBJ: corners with texture and normal, negative indices, quads") {
  for (const std::string face : {"f 1/2 2/3 4/4 3/5", "f 1//2 2//3 4//4 3//5", "f 1/1/2 2/1/3 4/1/4 3/1/5",
                                 "f -4 -3 -1 -2", "f +1 +2 +4 +3", "  f\t1   2 4 3\t "}) {
    INFO(face);
    CHECK(parse(kVertices + face).corners == std::vector<std::int32_t>{0, 1, 3, 2});
  }
}

TEST_CASE("OBJ: line ends, continued lines, comments, statements that are skipped") {
  const std::vector<std::int32_t> triangle{0, 1, 2};
  CHECK(parse("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n").corners == triangle);
  CHECK(parse("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3").corners == triangle);
  CHECK(parse(kVertices + "f 1 \\\n2 \\\r\n 3\nf 1 2 4\n").polygon_count() == 2);
  CHECK(parse("\xEF\xBB\xBF# comment\n" + kVertices + "f 1 2 3 # 4\n").corners == triangle);
  CHECK(parse("o name\ng a b\n" + kVertices + "vn 0 0 1\nvt 0 0\nvp 1\nusemtl x\ns off\np 1\nf 1 2 3\n").corners ==
        triangle);
  CHECK(parse("mtllib C:\\models\\\n" + kVertices + "# ends in \\\nf 1 2 3\n").corners == triangle);
  const PolygonSoup soup = parse(kVertices + "l 1 2\nf 1 2 3\n");
  REQUIRE(soup.notes.size() == 1);
  CHECK_THAT(soup.notes[0], Catch::Matchers::Contains("1 polyline"));
}

TEST_CASE("OBJ: numbers") {
  const PolygonSoup soup =
      parse("v +1 -2.5e-3 .5\nv 1E2 1. -0\nv 1e-400 -1e-9999999999999999999 0 1.0\nv 0 0 1 0.5 0.5 0.5\nf 1 2 3\n");
  CHECK(soup.positions[0] == Vec3(1, -0.0025, 0.5));
  CHECK(soup.positions[1] == Vec3(100, 1, 0));
  CHECK(soup.positions[2] == Vec3(0, 0, 0));
  CHECK(soup.positions[3] == Vec3(0, 0, 1));
  for (const std::string number : {"1,5", "1.5x", "0x10", "--1", "+-1", "1e", "one", "1d5", "'"}) {
    INFO(number);
    require_refused("v 0 0 0\nv 1 " + number + " 0\n", MeshFormat::obj, "file:2: coordinate y is '");
  }
  for (const std::string number : {"nan", "inf", "-inf", "1e400", "-1e99999999999999999999"}) {
    INFO(number);
    require_refused("v 0 0 0\nv 1 2 " + number, MeshFormat::obj,
                    "file:2: coordinate z of vertex 1 is not a finite number", ErrorCode::precondition);
  }
}

TEST_CASE("OBJ: bad bytes are refused with their line") {
  require_refused(kVertices + "f 1 2 5\n", MeshFormat::obj, "file:5: a face refers to vertex 5, and the file has 4");
  require_refused(kVertices + "f 1 2 0\n", MeshFormat::obj, "file:5: a face refers to vertex 0");
  require_refused(kVertices + "f 1 2 -5\n", MeshFormat::obj,
                  "file:5: a face refers to vertex -5, and there are 4 before it");
  require_refused(kVertices + "f 1 2 99999999999\n", MeshFormat::obj, "file:5: a face refers to vertex 99999999999");
  require_refused(kVertices + "f 1 2 99999999999999999999\n", MeshFormat::obj, "is no corner of a face");
  require_refused(kVertices + "f 1 2 x\n", MeshFormat::obj, "file:5: 'x' is no corner of a face");
  require_refused(kVertices + "f 1 2 3/y\n", MeshFormat::obj, "file:5: '3/y' is no corner of a face");
  require_refused("v 1 2\n", MeshFormat::obj, "file:1: coordinate z is missing");
  require_refused(kVertices, MeshFormat::obj, "4 vertices and no face");
  require_refused(std::string("\x80\x01\0\xff", 4), MeshFormat::obj, "no face");
  require_refused("", MeshFormat::obj, "the file is empty");
  CHECK(parse("f 1 2 3\n" + kVertices).corners == std::vector<std::int32_t>{0, 1, 2});  // later vertices are legal
}

}  // namespace gvd::test_read_obj
