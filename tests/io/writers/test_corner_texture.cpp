// Texture coordinates of corners and materials, in the formats that hold them: what is written is read back.
#include <cmath>
#include <limits>
#include <set>

#include "gvd/error.hpp"
#include "gvd/read_soup.hpp"
#include "io/fixture.hpp"
#include "io/writers/format_writers.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_corner_texture {

using namespace test;

struct Textured {
  Mesh mesh = make_grid(3, 2);
  Appearance appearance;
  std::vector<MeshProperty> lists{{"ids", NumberType::uint16, true, {}, NumberType::uint8, {0}}};

  Textured() {
    for (std::int32_t i = 0; i < mesh.halfedge_count(); ++i) {
      const Vec3& at = mesh.position(mesh.from(HalfedgeId(i)));
      appearance.texture.push_back({at.x() / 4 + (i < 12 ? 0 : 0.5), at.y() / 4});
    }
    appearance.texture[30] = {std::numeric_limits<double>::quiet_NaN(), 0};
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      for (std::int32_t k = 0; k < v % 4; ++k) lists[0].values.push_back(100 * v + k);
      lists[0].first_value.push_back(lists[0].values.size());
    }
  }

  std::string bytes(MeshFormat format, bool ascii = false) const {
    LabelledMesh view{mesh};
    view.appearance = &appearance;
    view.properties = &lists;
    view.ascii_ply = ascii;
    return to_bytes(view, format);
  }
};

void require_texture(const Textured& textured, const std::vector<Uv>& found) {
  REQUIRE(found.size() == textured.appearance.texture.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i / 3 == 10) {
      CHECK(std::isnan(found[i][0]));  // one of the face's corners has none
    } else {
      CHECK(found[i] == textured.appearance.texture[i]);
    }
  }
}

Appearance read_back(const std::string& bytes, MeshFormat format) {
  return parse_soup(bytes, format, "out").appearance;
}

TEST_CASE("texture of corners: OBJ and PLY give it back") {
  const Textured textured;
  require_texture(textured, read_back(textured.bytes(MeshFormat::obj), MeshFormat::obj).texture);
  for (const bool ascii : {false, true}) {
    require_texture(textured, read_back(textured.bytes(MeshFormat::ply, ascii), MeshFormat::ply).texture);
  }
}

TEST_CASE("texture of corners: PLY has doubles where floats would flatten a face or turn it round, and then only") {
  Textured textured;
  for (const bool ascii : {false, true}) {
    CHECK(textured.bytes(MeshFormat::ply, ascii).find("property list uchar float texcoord\n") != std::string::npos);
  }
  textured.appearance.texture[0] = {0.1, 0.1};
  textured.appearance.texture[1] = {0.9, 0.9};
  textured.appearance.texture[2] = {0.5, 0.5 + 1e-10};
  for (const bool ascii : {false, true}) {
    const std::string bytes = textured.bytes(MeshFormat::ply, ascii);
    CHECK(bytes.find("property list uchar double texcoord\n") != bytes.npos);
    require_texture(textured, read_back(bytes, MeshFormat::ply).texture);
  }
}

TEST_CASE("texture of corners: an OBJ has equal coordinates of a vertex once") {
  const std::string bytes = Textured().bytes(MeshFormat::obj);
  std::size_t written = 0;
  for (std::size_t at = bytes.find("vt "); at != bytes.npos; at = bytes.find("vt ", at + 1)) ++written;
  // The vertices of the first four faces and of the others, less the one corner without coordinates.
  CHECK(written > 12);
  CHECK(written < 20);
}

TEST_CASE("texture of corners: without a seam a PLY has it as numbers of vertices, beside other properties") {
  Textured textured;
  for (const HalfedgeId h : textured.mesh.halfedges()) {
    const Vec3& at = textured.mesh.position(textured.mesh.from(h));
    textured.appearance.texture[h.index()] = {at.x() / 4, -at.y() / 4};
  }
  for (const bool ascii : {false, true}) {
    const std::string bytes = textured.bytes(MeshFormat::ply, ascii);
    CHECK(bytes.find("property float s\nproperty float t\n") != bytes.npos);
    CHECK(bytes.find("texcoord") == bytes.npos);
    CHECK(read_back(bytes, MeshFormat::ply).texture == textured.appearance.texture);
    const auto properties = parse_mesh_properties(bytes, MeshFormat::ply, "out");
    REQUIRE(properties.size() == 1);
    CHECK(properties[0].name == "ids");
  }
  Textured thin = textured;
  for (Uv& uv : thin.appearance.texture) uv[1] = 0.5 + 1e-9 * uv[1];
  const std::string doubles = thin.bytes(MeshFormat::ply);
  CHECK(doubles.find("property double s\nproperty double t\n") != doubles.npos);
  CHECK(read_back(doubles, MeshFormat::ply).texture == thin.appearance.texture);
  textured.lists.push_back(
      {"s", NumberType::float32, true, std::vector<double>(textured.mesh.positions().size()), {}, {}});
  const std::string taken = textured.bytes(MeshFormat::ply);
  CHECK(taken.find("texcoord") != taken.npos);
  CHECK(read_back(taken, MeshFormat::ply).texture == textured.appearance.texture);
}

TEST_CASE("texture of corners: a GLB has a vertex for each side of a seam and no more, with v downwards") {
  Textured textured;
  const Uv none = parse_soup(textured.bytes(MeshFormat::glb), MeshFormat::glb, "out").appearance.texture[30];
  CHECK(none == Uv{0, 0});  // a vertex of a GLB always has some
  const Vec3& at = textured.mesh.position(textured.mesh.from(HalfedgeId(30)));
  textured.appearance.texture[30] = {at.x() / 4 + 0.5, at.y() / 4};
  const PolygonSoup soup = parse_soup(textured.bytes(MeshFormat::glb), MeshFormat::glb, "out");
  REQUIRE(soup.appearance.texture.size() == textured.appearance.texture.size());
  CHECK(soup.appearance.texture == textured.appearance.texture);
  std::set<std::array<double, 3>> different;
  for (std::size_t i = 0; i < soup.corners.size(); ++i) {
    const auto& [u, v] = soup.appearance.texture[i];
    different.insert({static_cast<double>(textured.mesh.from(HalfedgeId(i)).value()), u, v});
  }
  CHECK(soup.positions.size() == different.size());
  CHECK(soup.positions.size() > textured.mesh.positions().size());
  textured.appearance.texture.clear();
  CHECK(parse_soup(textured.bytes(MeshFormat::glb), MeshFormat::glb, "out").positions.size() ==
        textured.mesh.positions().size());
}

TEST_CASE("texture of corners: coordinates beyond 32-bit floats are in OBJ and PLY") {
  Textured textured;
  textured.appearance.texture[0] = {1e39, 0};
  CHECK(read_back(textured.bytes(MeshFormat::obj), MeshFormat::obj).texture[0] == Uv{1e39, 0});
  CHECK(read_back(textured.bytes(MeshFormat::ply), MeshFormat::ply).texture[0] == Uv{1e39, 0});
  CHECK(read_back(textured.bytes(MeshFormat::glb), MeshFormat::glb).texture[0] == Uv{0, 0});
}

TEST_CASE("texture of corners: PLY has it beside lists of vertices") {
  const Textured textured;
  for (const bool ascii : {false, true}) {
    const auto found = parse_mesh_properties(textured.bytes(MeshFormat::ply, ascii), MeshFormat::ply, "out");
    REQUIRE(found.size() == 1);
    CHECK(found[0].values == textured.lists[0].values);
    CHECK(found[0].first_value == textured.lists[0].first_value);
  }
}

TEST_CASE("materials: an OBJ names them inside the groups of regions, and has no .mtl of its own") {
  const TemporaryFolder folder;
  const Labelled labelled;
  const std::size_t faces = labelled.mesh.face_vertices().size();
  Appearance appearance{{}, std::vector<std::int32_t>(faces, 1), {"a b", "c"}, {"d.mtl", "e.mtl"}, {}};
  appearance.material[0] = 0;
  appearance.material[faces - 1] = -1;
  LabelledMesh view = labelled.view();
  view.appearance = &appearance;
  write_mesh(folder / "x.obj", view);
  CHECK(folder.names() == std::vector<std::string>{"x.obj"});
  const std::string text = read_bytes(folder / "x.obj");
  CHECK(text.starts_with("mtllib d.mtl\nmtllib e.mtl\nv "));
  CHECK(text.find("usemtl region_") == text.npos);
  const PolygonSoup soup = parse_soup(text, MeshFormat::obj, "x");
  CHECK(soup.appearance.material_files == appearance.material_files);
  // Faces are in the order of their labels.
  std::vector<std::int32_t> order;
  for (const auto& region : io::collect_regions(view)) {
    for (const FaceId f : region.faces) order.push_back(appearance.material[f.index()]);
  }
  REQUIRE(soup.appearance.material.size() == order.size());
  for (std::size_t f = 0; f < order.size(); ++f) {
    const std::int32_t found = soup.appearance.material[f];
    CHECK((found < 0 ? "" : soup.appearance.materials[static_cast<std::size_t>(found)]) ==
          (order[f] < 0 ? "" : appearance.materials[static_cast<std::size_t>(order[f])]));
  }

  view.region_materials = true;
  write_mesh(folder / "y.obj", view);
  CHECK(folder.names() == std::vector<std::string>{"x.obj", "y.mtl", "y.obj"});
  CHECK(read_bytes(folder / "y.obj").find("usemtl region_") != std::string::npos);
  CHECK(read_bytes(folder / "y.obj").find("d.mtl") == std::string::npos);
}

TEST_CASE("materials: without labels an OBJ keeps the order of the faces") {
  const Mesh mesh = make_grid(2, 1);
  const Appearance appearance{{}, {-1, 0, 0, -1}, {"a"}, {}, {}};
  LabelledMesh view{mesh};
  view.appearance = &appearance;
  const std::string text = to_bytes(view, MeshFormat::obj);
  CHECK(text.find("usemtl a\nf ") < text.find("usemtl (null)\nf "));
  CHECK(read_back(text, MeshFormat::obj).material == appearance.material);
}

TEST_CASE("texture of corners: refuses a wrong number") {
  Textured textured;
  textured.appearance.texture.pop_back();
  CHECK_THROWS_AS(textured.bytes(MeshFormat::obj), Error);
  textured.appearance = {{}, {0}, {"a"}, {}, {}};
  CHECK_THROWS_AS(textured.bytes(MeshFormat::obj), Error);
}

}  // namespace gvd::test_corner_texture
