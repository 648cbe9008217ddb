// What files hold besides positions and polygons: properties, lists, and texture coordinates of corners.
#include <cmath>

#include "gvd/mesh_property.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/refusal.hpp"

namespace gvd::test_mesh_attributes {

using namespace test;

MeshAttributes parse_attributes(const std::string& bytes, MeshFormat format) {
  return parse_mesh_attributes(bytes, format, "mesh");
}

std::string with_face_list(const std::string& name, const std::string& faces) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
         "2\nproperty list uchar int vertex_indices\nproperty list uchar float " +
         name + "\nend_header\n0 0 0\n1 0 0\n0 1 0\n" + faces;
}

TEST_CASE("attributes: the corners of an OBJ have the coordinates that they refer to, or none") {
  const auto texture =
      parse_attributes(
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0.5\nvt 1\nf 1/1 2/2 3\nvt 0.25 -2\nf 2/-1/7 4//1 3/9\n",
          MeshFormat::obj)
          .texture;
  REQUIRE(texture.has_value());
  CHECK(texture->corners == std::vector<std::int32_t>{0, 1, 2, 1, 3, 2});
  CHECK(texture->first_corner == std::vector<std::size_t>{0, 3, 6});
  REQUIRE(texture->coordinates.size() == 6);
  CHECK(texture->coordinates[0] == std::array<double, 2>{0, 0.5});
  CHECK(texture->coordinates[1] == std::array<double, 2>{1, 0});
  CHECK(texture->coordinates[3] == std::array<double, 2>{0.25, -2});
  for (const std::size_t none : {2, 4, 5}) CHECK(std::isnan(texture->coordinates[none][0]));
}

TEST_CASE("attributes: an OBJ without used coordinates, an STL and an OFF have nothing") {
  CHECK(!parse_attributes(kObj, MeshFormat::obj).texture);
  CHECK(!parse_attributes("vt 0 0\n" + kObj, MeshFormat::obj).texture);
  for (const auto& [bytes, format] : {std::pair(kStl, MeshFormat::stl), {kOff, MeshFormat::off}}) {
    CHECK(!parse_attributes(bytes, format).texture);
    CHECK(parse_attributes(bytes, format).properties.empty());
  }
}

TEST_CASE("attributes: a coordinate that is no number is refused with its line") {
  const auto refused = [](const std::string& bytes) {
    return refusal([&] { parse_attributes(bytes, MeshFormat::obj); }, ErrorCode::unreadable_input);
  };
  CHECK_THAT(refused(kObj + "vt a 0\n"), Catch::Matchers::Contains("mesh:10:"));
  CHECK(refused("vt 0 b\n") == "mesh:1: 'b' is no texture coordinate");
}

TEST_CASE("attributes: a PLY's lists keep their lengths; texcoord is the texture where it has two numbers a corner") {
  const auto weights = parse_attributes(with_face_list("weights", "3 0 1 2 0\n3 0 2 1 2 0.5 -1\n"), MeshFormat::ply);
  REQUIRE(weights.properties.size() == 1);
  CHECK(weights.properties[0].name == "weights");
  CHECK(weights.properties[0].element_count() == 2);
  CHECK(weights.properties[0].first_value == std::vector<std::size_t>{0, 0, 2});
  CHECK(weights.properties[0].values == std::vector<double>{0.5, -1});
  CHECK(!weights.texture);

  const auto wedges =
      parse_attributes(with_face_list("texcoord", "3 0 1 2 6 0 0 1 0 0 1\n3 0 2 1 0\n"), MeshFormat::ply);
  CHECK(wedges.properties.empty());
  REQUIRE(wedges.texture.has_value());
  CHECK(parse_soup(with_face_list("texcoord", "3 0 1 2 0\n3 0 2 1 0\n"), MeshFormat::ply, "mesh").has_texture);
  CHECK(!parse_soup(with_face_list("weights", "3 0 1 2 0\n3 0 2 1 0\n"), MeshFormat::ply, "mesh").has_texture);
  CHECK(wedges.texture->corners == std::vector<std::int32_t>{0, 1, 2, 0, 2, 1});
  CHECK(wedges.texture->coordinates[1] == std::array<double, 2>{1, 0});
  CHECK(std::isnan(wedges.texture->coordinates[3][1]));

  const auto other = parse_attributes(with_face_list("texcoord", "3 0 1 2 2 0 0\n3 0 2 1 0\n"), MeshFormat::ply);
  CHECK(other.properties.size() == 1);
  CHECK(!other.texture);
}

}  // namespace gvd::test_mesh_attributes
