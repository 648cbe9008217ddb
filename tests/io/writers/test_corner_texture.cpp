// Texture coordinates of corners, in the formats that hold them: what is written is read back.
#include <cmath>
#include <limits>

#include "gvd/error.hpp"
#include "io/fixture.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_corner_texture {

using namespace test;

struct Textured {
  Mesh mesh = make_grid(3, 2);
  std::vector<std::array<double, 2>> texture;
  std::vector<MeshProperty> lists{{"ids", NumberType::uint16, true, {}, NumberType::uint8, {0}}};

  Textured() {
    for (std::int32_t i = 0; i < mesh.halfedge_count(); ++i) {
      const Vec3& at = mesh.position(mesh.from(HalfedgeId(i)));
      texture.push_back({at.x() / 4 + (i < 12 ? 0 : 0.5), at.y() / 4});
    }
    texture[30] = {std::numeric_limits<double>::quiet_NaN(), 0};
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      for (std::int32_t k = 0; k < v % 4; ++k) lists[0].values.push_back(100 * v + k);
      lists[0].first_value.push_back(lists[0].values.size());
    }
  }

  std::string bytes(OutputFormat format, bool ascii = false) const {
    LabelledMesh view{mesh};
    const Appearance appearance{texture, {}, {}, {}};
    view.appearance = &appearance;
    view.properties = &lists;
    view.ascii_ply = ascii;
    return to_bytes(view, format);
  }
};

void require_texture(const Textured& textured, const MeshAttributes& found) {
  REQUIRE(found.texture.has_value());
  REQUIRE(found.texture->coordinates.size() == textured.texture.size());
  for (std::size_t i = 0; i < textured.texture.size(); ++i) {
    if (i / 3 == 10) {
      CHECK(std::isnan(found.texture->coordinates[i][0]));  // one of the face's corners has none
    } else {
      CHECK(found.texture->coordinates[i] == textured.texture[i]);
    }
  }
}

TEST_CASE("texture of corners: OBJ and PLY give it back") {
  const Textured textured;
  require_texture(textured, parse_mesh_attributes(textured.bytes(OutputFormat::obj), MeshFormat::obj, "out"));
  for (const bool ascii : {false, true}) {
    require_texture(textured, parse_mesh_attributes(textured.bytes(OutputFormat::ply, ascii), MeshFormat::ply, "out"));
  }
}

TEST_CASE("texture of corners: an OBJ has equal coordinates of a vertex once") {
  const std::string bytes = Textured().bytes(OutputFormat::obj);
  std::size_t count = 0;
  for (std::size_t at = bytes.find("vt "); at != std::string::npos; at = bytes.find("vt ", at + 1)) ++count;
  CHECK(count >= 12);
  CHECK(count <= 18);
}

TEST_CASE("lists of properties: a PLY gives them back") {
  const Textured textured;
  for (const bool ascii : {false, true}) {
    const auto found = parse_mesh_attributes(textured.bytes(OutputFormat::ply, ascii), MeshFormat::ply, "out");
    REQUIRE(found.properties.size() == 1);
    CHECK(found.properties[0].values == textured.lists[0].values);
    CHECK(found.properties[0].first_value == textured.lists[0].first_value);
  }
}

TEST_CASE("texture of corners: refuses a wrong number") {
  Textured textured;
  textured.texture.pop_back();
  CHECK_THROWS_AS(textured.bytes(OutputFormat::obj), Error);
}

}  // namespace gvd::test_corner_texture
