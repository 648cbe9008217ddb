#include <array>

#include "gvd/mesh_property.hpp"
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
  require_refused(kVertices + "f 1 2 99999999999999999999\n", MeshFormat::obj, "is not a corner of a face");
  require_refused(kVertices + "f 1 2 x\n", MeshFormat::obj, "file:5: 'x' is not a corner of a face");
  require_refused(kVertices + "f 1 2 3/y\n", MeshFormat::obj, "file:5: '3/y' is not a corner of a face");
  require_refused("v 1 2\n", MeshFormat::obj, "file:1: coordinate z is missing");
  require_refused(kVertices, MeshFormat::obj, "4 vertices and no face");
  require_refused(std::string("\x80\x01\0\xff", 4), MeshFormat::obj,
                  "as an OBJ, the file has neither a vertex nor a face, and it begins with '?");
  require_refused("# nothing\n", MeshFormat::obj, "and it is blank");
  require_refused("", MeshFormat::obj, "the file is empty");
  CHECK(parse("f 1 2 3\n" + kVertices).corners == std::vector<std::int32_t>{0, 1, 2});  // later vertices are legal
}

TEST_CASE("OBJ: a file of free-form surfaces or polylines says so, and free-form surfaces beside faces are noted") {
  const std::string surface = "cstype bspline\ndeg 3 3\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nend\n";
  require_refused(kVertices + surface, MeshFormat::obj,
                  "the file has 4 vertices and no face; a surface is needed (1 free-form surface (statement surf) left "
                  "out; export the surface as triangles)");
  require_refused(kVertices + "l 1 2\n", MeshFormat::obj,
                  "4 vertices and no face; a surface is needed (1 polyline (statement l) left out)");
  const PolygonSoup soup = parse(kVertices + surface + surface + "s off\nf 1 2 3\n");
  CHECK(soup.notes ==
        std::vector<std::string>{"2 free-form surfaces (statement surf) left out; export the surface as triangles"});
}

using Rows = std::vector<std::vector<double>>;

// The colours of the file, channel by channel.
Rows colors_of(const std::string& bytes) {
  Rows values;
  const std::array<std::string, 4> names{"red", "green", "blue", "alpha"};
  for (const MeshProperty& property : parse_mesh_properties(bytes, MeshFormat::obj, "file")) {
    CHECK(property.name == names.at(values.size()));
    CHECK(property.type == NumberType::uint8);
    CHECK(property.of_vertices);
    values.push_back(property.values);
  }
  return values;
}

TEST_CASE("OBJ colours: from 0 to 1, or from 0 to 255 where a number of the file is above 1") {
  CHECK(colors_of("v 0 0 0 0 0.5 1\nv 1 0 0 1 1 0.002\nf 1 2 1\n") == Rows{{0, 255}, {128, 255}, {255, 1}});
  CHECK(colors_of("v 0 0 0 0 1 1\nv 1 0 0 2 255 64.4\n") == Rows{{0, 2}, {1, 255}, {1, 64}});
  CHECK(colors_of("v 0 0 0 0 1 1 0.2\nv 1 0 0 1 1 1\n") == Rows{{0, 255}, {255, 255}, {255, 255}, {51, 255}});
}

TEST_CASE("OBJ colours: numbers that rounding moved out of their range neither choose another nor lose the colours") {
  const Rows row{{255}, {128}, {0}};
  for (const std::string end : {"1", "1.0000001", "1.00001", "1.001"}) {
    INFO(end);
    CHECK(colors_of("v 0 0 0 " + end + " 0.5 0\n") == row);
    CHECK(colors_of("v 0 0 0 " + end + " 0.5 -1e-7\n") == row);
  }
  CHECK(colors_of("v 0 0 0 255.0001 128 -1e-7\n") == row);
  CHECK(colors_of("v 0 0 0 2 0.5 0\n") == Rows{{2}, {1}, {0}});
  CHECK(colors_of("v 0 0 0 1 0.5 -0.01\n").empty());
}

TEST_CASE("OBJ colours: a vertex without one is white, continued lines and comments count as for faces") {
  CHECK(colors_of("v 0 0 0 # 1 1 1\nv 1 0 0 0 \\\n 0 0 # black\n") == Rows{{255, 0}, {255, 0}, {255, 0}});
  CHECK(colors_of("v 0 0 0 1\nv 1 0 0 0 0 0\n") == Rows{{255, 0}, {255, 0}, {255, 0}});
}

TEST_CASE("OBJ colours: weights, normals and other numbers are none") {
  CHECK(colors_of(kObj).empty());
  CHECK(colors_of("v 0 0 0 1\nv 1 0 0 0.5\n").empty());
  CHECK(colors_of("v 0 0 0 0 0 1\nv 1 0 0 0 0 -1\n").empty());
  CHECK(colors_of("v 0 0 0 0 0 1\nv 1 0 0 0 256 0\n").empty());
  CHECK(colors_of("v 0 0 0 0 0 1\nv 1 0 0 0 nan 0\n").empty());
  CHECK(colors_of("v 0 0 0 0 0 1\nv 1 0 0 red 0 0\n").empty());
  CHECK(colors_of("v 0 0 0 1 2 3 4 5\n").empty());
  CHECK(colors_of("").empty());
}

TEST_CASE("OBJ colours: ZBrush's comments, where there is one for each vertex") {
  const std::string zbrush = "v 0 0 0\nv 1 0 0\nv 0 1 0\n#MRGB ff0a0b0cff010203\n#MRGB 00ffffff\n";
  CHECK(colors_of(zbrush) == Rows{{10, 1, 255}, {11, 2, 255}, {12, 3, 255}});
  CHECK(colors_of(zbrush + "v 1 1 1\n").empty());
  CHECK(colors_of(zbrush + "#MRGB ffxx0000\n") == colors_of(zbrush));
  CHECK(colors_of("v 0 0 0 1 0 0\n#MRGB ff0a0b0c\n") == Rows{{255}, {0}, {0}});
}

}  // namespace gvd::test_read_obj
