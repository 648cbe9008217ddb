#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "io/fixture.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_write_glb {

using namespace test;

using Json = nlohmann::json;

/// A GLB, parsed as the specification says.
struct Glb {
  explicit Glb(const std::string& bytes) {
    std::size_t offset = 0;
    CHECK(take<std::uint32_t>(bytes, offset) == 0x46546C67);
    CHECK(take<std::uint32_t>(bytes, offset) == 2);
    CHECK(take<std::uint32_t>(bytes, offset) == bytes.size());
    const auto json_bytes = take<std::uint32_t>(bytes, offset);
    CHECK(json_bytes % 4 == 0);
    CHECK(take<std::uint32_t>(bytes, offset) == 0x4E4F534A);
    json = Json::parse(bytes.substr(offset, json_bytes));
    offset += json_bytes;
    const auto binary_bytes = take<std::uint32_t>(bytes, offset);
    CHECK(binary_bytes % 4 == 0);
    CHECK(take<std::uint32_t>(bytes, offset) == 0x004E4942);
    binary = bytes.substr(offset);
    CHECK(binary.size() == binary_bytes);
    CHECK(json["buffers"][0]["byteLength"] == binary_bytes);
  }

  /// The numbers of an accessor; T is what its componentType says.
  template <class T>
  std::vector<T> get(std::size_t index) const {
    const Json& accessor = json["accessors"].at(index);
    CHECK(accessor["componentType"] == (std::is_same_v<T, float> ? 5126 : 5125));
    const std::size_t components = accessor["type"] == "VEC3" ? 3 : 1;
    const Json& view = json["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    const std::size_t start = accessor.value("byteOffset", std::size_t{0});
    const std::size_t count = components * accessor["count"].get<std::size_t>();
    CHECK(start + count * sizeof(T) <= view["byteLength"].get<std::size_t>());
    std::size_t offset = view["byteOffset"].get<std::size_t>() + start;
    std::vector<T> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(take<T>(binary, offset));
    return values;
  }

  Json json;
  std::string binary;
};

using Corner = std::array<float, 3>;

TEST_CASE("a plain GLB is one grey surface") {
  const Glb glb(to_bytes(LabelledMesh{make_sphere(1)}, MeshFormat::glb));
  CHECK(glb.json["meshes"].size() == 1);
  CHECK(glb.json["meshes"][0]["primitives"].size() == 1);
  CHECK(glb.json["materials"][0]["name"] == "surface");
  CHECK(glb.json["meshes"][0]["primitives"][0]["attributes"].size() == 2);
}

TEST_CASE("a labelled GLB is one primitive, whose vertices have the labels of their faces and the colours of these") {
  const Labelled labelled;
  const Glb glb(to_bytes(labelled.view(), MeshFormat::glb));
  CHECK(glb.json["asset"]["version"] == "2.0");
  CHECK(glb.json["scenes"][0]["nodes"] == Json({0, 1}));
  REQUIRE(glb.json["meshes"][0]["primitives"].size() == 1);
  const Json& primitive = glb.json["meshes"][0]["primitives"][0];
  CHECK(primitive["mode"] == 4);
  const Json& material = glb.json["materials"].at(primitive["material"].get<std::size_t>());
  CHECK(material["pbrMetallicRoughness"]["baseColorFactor"] == Json({1.0, 1.0, 1.0, 1}));
  const auto attribute = [&](const char* name) {
    return glb.get<float>(primitive["attributes"][name].get<std::size_t>());
  };
  const std::vector<float> positions = attribute("POSITION"), colors = attribute("COLOR_0"),
                           labels = attribute("_LABEL");
  const auto indices = glb.get<std::uint32_t>(primitive["indices"].get<std::size_t>());
  REQUIRE(indices.size() == 3 * 24);
  const auto at = glb.json["nodes"][0].value("translation", std::array{0.0, 0.0, 0.0});
  const Vec3 translation(at[0], at[1], at[2]);  // the mesh is far from the origin
  const auto linear = [](std::uint8_t channel) { return std::pow((channel / 255.0 + 0.055) / 1.055, 2.4); };
  for (const HalfedgeId h : labelled.mesh.halfedges()) {
    const std::size_t i = indices[h.index()];
    const Eigen::Vector3f p = (labelled.mesh.position(labelled.mesh.from(h)) - translation).cast<float>();
    CHECK(Eigen::Vector3f(positions.at(3 * i), positions.at(3 * i + 1), positions.at(3 * i + 2)) == p);
    const GeneratorId label = labelled.face_label[Mesh::face(h)];
    CHECK(labels.at(i) == float(label.value()));
    const Rgb color = color_in(labelled.view(), label);
    CHECK(colors.at(3 * i) == Approx(linear(color.red)).margin(1e-4));
    CHECK(colors.at(3 * i + 1) == Approx(linear(color.green)).margin(1e-4));
    CHECK(colors.at(3 * i + 2) == Approx(linear(color.blue)).margin(1e-4));
  }
}

TEST_CASE("the vertices of a GLB lie within the bounds that it names, and all are used") {
  const Labelled labelled;
  const Glb glb(to_bytes(labelled.view(), MeshFormat::glb));
  const Json& primitive = glb.json["meshes"][0]["primitives"][0];
  const auto index = primitive["attributes"]["POSITION"].get<std::size_t>();
  const auto values = glb.get<float>(index);
  const auto indices = glb.get<std::uint32_t>(primitive["indices"].get<std::size_t>());
  CHECK(std::set(indices.begin(), indices.end()).size() == values.size() / 3);
  std::array<float, 3> low, high;
  low.fill(std::numeric_limits<float>::max());
  high.fill(std::numeric_limits<float>::lowest());
  for (std::size_t i = 0; i < values.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], values[i]);
    high[i % 3] = std::max(high[i % 3], values[i]);
  }
  CHECK(glb.json["accessors"][index]["min"].get<std::array<float, 3>>() == low);
  CHECK(glb.json["accessors"][index]["max"].get<std::array<float, 3>>() == high);
}

TEST_CASE("a GLB of 2,000 regions has two primitives") {
  const Mesh mesh = make_grid(50, 40);
  IdVector<FaceId, GeneratorId> label;
  for (const FaceId f : mesh.faces()) label.push_back(GeneratorId(f.value() / 2));
  const Labelled small;  // its bisectors are those of another mesh
  LabelledMesh view{mesh};
  view.face_label = &label;
  view.diagram = &small.diagram;
  view.diagram_mesh = &small.mesh;
  const Glb glb(to_bytes(view, MeshFormat::glb));
  std::size_t primitives = 0;
  for (const Json& item : glb.json["meshes"]) primitives += item["primitives"].size();
  CHECK(primitives == 2);
  CHECK(glb.json["materials"].size() == 2);
  const auto labels = glb.get<float>(glb.json["meshes"][0]["primitives"][0]["attributes"]["_LABEL"].get<std::size_t>());
  CHECK(std::set(labels.begin(), labels.end()).size() == 2000);
}

TEST_CASE("the normals of a GLB have length 1 and point out of the surface") {
  const Labelled labelled;
  const Glb glb(to_bytes(labelled.view(), MeshFormat::glb));
  for (const Json& primitive : glb.json["meshes"][0]["primitives"]) {
    const auto normals = glb.get<float>(primitive["attributes"]["NORMAL"].get<std::size_t>());
    CHECK(normals.size() == glb.get<float>(primitive["attributes"]["POSITION"].get<std::size_t>()).size());
    for (std::size_t i = 0; i < normals.size(); i += 3) {
      CHECK(std::hypot(normals[i], normals[i + 1], normals[i + 2]) == Approx(1));
      CHECK(normals[i + 2] == Approx(1));  // the grid lies flat
    }
  }
}

TEST_CASE("the bisectors of a GLB are line segments") {
  const Labelled labelled;
  const Glb glb(to_bytes(labelled.view(), MeshFormat::glb));
  const Json& primitive = glb.json["meshes"][1]["primitives"][0];
  CHECK(primitive["mode"] == 1);
  CHECK(glb.get<std::uint32_t>(primitive["indices"].get<std::size_t>()) ==
        std::vector<std::uint32_t>{0, 1, 1, 2, 3, 4, 5, 6, 6, 7, 7, 8});
  CHECK(glb.get<float>(primitive["attributes"]["POSITION"].get<std::size_t>()).size() == 27);
}

}  // namespace gvd::test_write_glb
