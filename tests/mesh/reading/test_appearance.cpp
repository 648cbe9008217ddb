// What files hold besides positions and polygons: properties, lists, texture coordinates of corners, and materials.
#include <cmath>

#include "gvd/mesh_property.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"

namespace gvd::test_appearance {

using namespace test;

constexpr Uv kNone{-99, -99};

/// The texture coordinates of the corners; kNone where there are none.
std::vector<Uv> texture_of(const PolygonSoup& soup) {
  std::vector<Uv> texture = soup.appearance.texture;
  for (Uv& uv : texture) {
    if (!is_finite(uv)) uv = kNone;
  }
  return texture;
}

PolygonSoup parse_obj(const std::string& bytes) { return parse_soup(bytes, MeshFormat::obj, "mesh"); }
PolygonSoup parse_ply(const std::string& bytes) { return parse_soup(bytes, MeshFormat::ply, "mesh"); }

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

TEST_CASE("appearance: the corners of an OBJ have the coordinates that they refer to, or none") {
  const PolygonSoup soup =
      parse_obj(kSquare + "vt 0 0.5\nvt 1\nf 1/1 2/2 3\nvt 0.25 -2 7\nf 2/-1/7 4//1 3/4\nvt 8 9\n");
  CHECK(texture_of(soup) == std::vector<Uv>{{0, 0.5}, {1, 0}, kNone, {0.25, -2}, kNone, {8, 9}});
  CHECK(soup.notes.empty());
}

TEST_CASE("appearance: an OBJ without used coordinates has none") {
  for (const std::string faces : {"f 1 2 3\n", "vt 0 0\nf 1 2 3\n", "vn 0 0 1\nf 1//1 2//1 3//1\n"}) {
    const PolygonSoup soup = parse_obj(kSquare + faces);
    CHECK(soup.appearance.empty());
    CHECK(soup.notes.empty());
  }
}

TEST_CASE("appearance: wrong coordinates of an OBJ are noted in one line, and the corners have none") {
  const PolygonSoup soup = parse_obj(kSquare + "vt 0 0\nvt a 0\nvt 0 b\nvt nan 0\nvt\n" +
                                     "f 1/1 2/2 3/3\nf 2/4 4/5 3/6\nf 1/0 2/-9 3/99999999999999999999\nf 1 2 4\n");
  std::vector<Uv> expected(12, kNone);
  expected[0] = {0, 0};
  CHECK(texture_of(soup) == expected);
  CHECK(soup.notes ==
        std::vector<std::string>{"8 corners refer to texture coordinates that are missing or no numbers: left out"});
  const PolygonSoup without = parse_obj(kSquare + "f 1/1 2/2 3/3\n");
  CHECK(without.appearance.texture.empty());
  CHECK(without.notes.size() == 1);
}

TEST_CASE("appearance: the materials of an OBJ hold up to the next one, and their names may have blanks") {
  const Appearance found =
      parse_obj(
          "mtllib a b.mtl\r\nmtllib c.mtl\n" + kSquare + "f 1 2 3\nusemtl  Red  #25 \r\nf 1 2 4\nf 2 3 4\n" +
          "usemtl blue\nusemtl Red  #25\nf 1 3 4\nusemtl blue\nf 1 2 3\nusemtl (null)\nf 1 2 3\nusemtl\nf 1 2 3\n")
          .appearance;
  CHECK(found.material_files == std::vector<std::string>{"a b.mtl", "c.mtl"});
  CHECK(found.materials == std::vector<std::string>{"Red  #25", "blue"});
  CHECK(found.material == std::vector<std::int32_t>{-1, 0, 0, 0, 1, -1, -1});
  CHECK(parse_obj(kSquare + "usemtl (null)\nf 1 2 3\n").appearance.empty());
}

TEST_CASE("appearance: an STL and an OFF have nothing") {
  for (const auto& [bytes, format] : {std::pair(kStl, MeshFormat::stl), {kOff, MeshFormat::off}}) {
    CHECK(parse_soup(bytes, format, "mesh").appearance.empty());
    CHECK(parse_mesh_properties(bytes, format, "mesh").empty());
  }
}

std::string with_face_list(const std::string& name, const std::string& faces) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
         "2\nproperty list uchar int vertex_indices\nproperty list uchar float " +
         name + "\nend_header\n0 0 0\n1 0 0\n0 1 0\n" + faces;
}

TEST_CASE("appearance: a PLY's lists keep their lengths, texcoord is the texture and no property") {
  const std::string weights = with_face_list("weights", "3 0 1 2 0\n3 0 2 1 2 0.5 -1\n");
  const auto properties = parse_mesh_properties(weights, MeshFormat::ply, "mesh");
  REQUIRE(properties.size() == 1);
  CHECK(properties[0].name == "weights");
  CHECK(properties[0].element_count() == 2);
  CHECK(properties[0].first_value == std::vector<std::size_t>{0, 0, 2});
  CHECK(properties[0].values == std::vector<double>{0.5, -1});
  CHECK(parse_ply(weights).appearance.empty());

  const std::string wedges = with_face_list("texcoord", "3 0 1 2 6 0 0 1 0 0 1\n3 0 2 1 0\n");
  CHECK(parse_mesh_properties(wedges, MeshFormat::ply, "mesh").empty());
  CHECK(texture_of(parse_ply(wedges)) == std::vector<Uv>{{0, 0}, {1, 0}, {0, 1}, kNone, kNone, kNone});

  const PolygonSoup none = parse_ply(with_face_list("texcoord", "3 0 1 2 0\n3 0 2 1 0\n"));
  CHECK(none.appearance.empty());
  CHECK(none.notes.empty());
  const PolygonSoup wrong = parse_ply(with_face_list("texcoord", "3 0 1 2 2 0 0\n3 0 2 1 6 1 2 3 4 5 6\n"));
  CHECK(texture_of(wrong) == std::vector<Uv>{kNone, kNone, kNone, {1, 2}, {3, 4}, {5, 6}});
  CHECK(wrong.notes == std::vector<std::string>{"1 face has not two texture coordinates for each corner: left out"});
}

TEST_CASE("appearance: a PLY's pair of numbers of vertices is the texture, by the names of three programs") {
  for (const auto& [u, v] : {std::pair("s", "t"), {"u", "v"}, {"texture_u", "texture_v"}}) {
    const std::string bytes =
        std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float ") + v +
        "\nproperty float x\nproperty float y\nproperty float z\nproperty int w\nproperty float " + u +
        "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
        "0.5 0 0 0 7 0.25\n1 1 0 0 8 0.75\n2 0 1 0 9 -1\n3 2 0 1\n";
    const PolygonSoup soup = parse_ply(bytes);
    CHECK(texture_of(soup) == std::vector<Uv>{{-1, 2}, {0.25, 0.5}, {0.75, 1}});
    CHECK(soup.positions[1] == Vec3(1, 0, 0));
    const auto properties = parse_mesh_properties(bytes, MeshFormat::ply, "mesh");
    REQUIRE(properties.size() == 1);
    CHECK(properties[0].name == "w");
  }
}

TEST_CASE("appearance: texture coordinates of a PLY's corners come before those of its vertices") {
  const auto parse = [](const std::string& strips, const std::string& faces) {
    const std::string vertices =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float "
        "s\nproperty float t\n";
    return parse_ply(vertices + (strips.empty() ? "" : "element tristrips 1\nproperty list int int vertex_indices\n") +
                     "element face 1\nproperty list uchar float texcoord\nproperty list uchar int vertex_indices\n"
                     "end_header\n0 0 0 0.5 0.5\n1 0 0 1 0\n0 1 0 0 1\n" +
                     strips + faces);
  };
  CHECK(texture_of(parse("", "6 1 2 3 4 5 6 3 0 1 2\n")) == std::vector<Uv>{{1, 2}, {3, 4}, {5, 6}});
  CHECK(texture_of(parse("", "0 3 0 1 2\n")) == std::vector<Uv>{{0.5, 0.5}, {1, 0}, {0, 1}});
  const PolygonSoup beside = parse("3 0 2 1\n", "6 1 2 3 4 5 6 3 0 1 2\n");
  CHECK(texture_of(beside) == std::vector<Uv>{{0.5, 0.5}, {0, 1}, {1, 0}, {0.5, 0.5}, {1, 0}, {0, 1}});
  CHECK(beside.notes == std::vector<std::string>{"texture coordinates of faces beside strips of triangles: left out"});
}

/// The tetrahedron with texture coordinates (k, k / 4) of vertex k.
std::string textured_glb(const std::string& accessor, const std::string& more = "") {
  std::string description = replaced(glb_description(1), R"("POSITION":0)", R"("POSITION":0,"TEXCOORD_0":4)" + more);
  description =
      replaced(description, R"("count":12,"type":"SCALAR"}],)", R"("count":12,"type":"SCALAR"},)" + accessor + "],");
  description = replaced(description, R"("byteOffset":84,"byteLength":48}])",
                         R"("byteOffset":84,"byteLength":48},{"buffer":0,"byteOffset":132,"byteLength":32}])");
  description = replaced(description, R"("byteLength":132}])", R"("byteLength":164}])");
  std::string numbers = glb_numbers();
  for (int k = 0; k < 4; ++k) numbers += bytes_of(static_cast<float>(k)) + bytes_of(static_cast<float>(k) / 4);
  return glb_of(description, numbers);
}

const std::string kPairs = R"({"bufferView":4,"componentType":5126,"count":4,"type":"VEC2"})";

TEST_CASE("appearance: the first texture coordinates of a GLB are read, with v upwards") {
  const PolygonSoup soup = parse_soup(textured_glb(kPairs), MeshFormat::glb, "file");
  REQUIRE(soup.appearance.texture.size() == 12);
  for (std::size_t c = 0; c < 12; ++c)
    CHECK(soup.appearance.texture[c] == Uv{1.0 * soup.corners[c], 1 - soup.corners[c] / 4.0});
  CHECK(soup.appearance.unread.empty());
}

TEST_CASE("appearance: what a GLB has besides is named, and wrong texture coordinates are refused") {
  const auto unread = [](const std::string& bytes) {
    return parse_soup(bytes, MeshFormat::glb, "file").appearance.unread;
  };
  CHECK(unread(textured_glb(kPairs, R"(,"TEXCOORD_1":4)")) ==
        std::vector<std::string>{"the second texture coordinates"});
  CHECK(unread(textured_glb(replaced(kPairs, R"("count":4)", R"("count":4,"sparse":{})"))) ==
        std::vector<std::string>{"sparse texture coordinates"});
  const std::string materials = R"({"images":[{}],"materials":[{},{}],"asset")";
  CHECK(unread(glb_of(replaced(glb_description(1), R"({"asset")", materials), glb_numbers())) ==
        std::vector<std::string>{"texture images", "materials"});
  require_refused(textured_glb(replaced(kPairs, R"("count":4)", R"("count":3)")), MeshFormat::glb,
                  "accessor 4 has no texture coordinates for 4 vertices");
  require_refused(textured_glb(replaced(kPairs, "VEC2", "SCALAR")), MeshFormat::glb,
                  "accessor 4 has no texture coordinates for 4 vertices");
  require_refused(textured_glb(replaced(kPairs, "VEC2", "VEC4")), MeshFormat::glb, "accessor 4 has the type 'VEC4'");
}

TEST_CASE("appearance: texture coordinates of formats that are read without are named, and images of a PLY") {
  const auto unread = [](const std::string& bytes, MeshFormat format) {
    return parse_soup(bytes, format, "file").appearance.unread;
  };
  const std::vector<std::string> coordinates{"texture coordinates"}, images{"texture images"}, nothing;
  CHECK(unread("STOFF\n3 1 0\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n", MeshFormat::off) == coordinates);
  CHECK(unread("COFF\n3 1 0\n0 0 0 0 0 0 1\n1 0 0 0 0 0 1\n0 1 0 0 0 0 1\n3 0 1 2\n", MeshFormat::off) == nothing);
  const std::string data = "POINT_DATA 4\nSCALARS a float\nLOOKUP_TABLE default\n0 0 0 0\n";
  CHECK(unread(kVtk + data, MeshFormat::vtk) == nothing);
  CHECK(unread(kVtk + data + "TEXTURE_COORDINATES t 2 float\n0 0 1 0 0 1 1 1\n", MeshFormat::vtk) == coordinates);
  CHECK(unread(kVtp, MeshFormat::vtp) == nothing);
  CHECK(unread(replaced(kVtp, "<Points>", "<PointData TCoords=\"t\"/><Points>"), MeshFormat::vtp) == coordinates);
  CHECK(unread(kPly, MeshFormat::ply) == nothing);
  CHECK(unread(replaced(kPly, "element vertex", "comment TextureFile a.png\nelement vertex"), MeshFormat::ply) ==
        images);
}

}  // namespace gvd::test_appearance
