#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "gvd/io/label_color.hpp"
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

/// The position of every corner of every triangle, in order.
std::vector<Corner> corner_positions(const Glb& glb, const Json& primitive) {
  const auto values = glb.get<float>(primitive["attributes"]["POSITION"].get<std::size_t>());
  std::vector<Corner> corners;
  for (const std::uint32_t i : glb.get<std::uint32_t>(primitive["indices"].get<std::size_t>())) {
    corners.push_back({values.at(3 * i), values.at(3 * i + 1), values.at(3 * i + 2)});
  }
  return corners;
}

/// The same of the faces with one label.
std::vector<Corner> corner_positions(const Labelled& labelled, GeneratorId label) {
  std::vector<Corner> corners;
  for (int f = 0; f < labelled.mesh.face_count(); ++f) {
    if (labelled.face_label[FaceId(f)] != label) continue;
    for (const VertexId v : labelled.mesh.vertices(FaceId(f))) {
      const Eigen::Vector3f p = labelled.mesh.position(v).cast<float>();
      corners.push_back({p.x(), p.y(), p.z()});
    }
  }
  return corners;
}

TEST_CASE("a labelled GLB has one primitive a region, with its colour") {
  const Labelled labelled;
  const Glb glb(to_bytes(labelled.view(), OutputFormat::glb));
  CHECK(glb.json["asset"]["version"] == "2.0");
  CHECK(glb.json["scenes"][0]["nodes"] == Json({0, 1}));
  const Json& primitives = glb.json["meshes"][0]["primitives"];
  REQUIRE(primitives.size() == 4);
  const std::vector<int> labels{0, 1, 2, -1};
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& primitive = primitives[i];
    CHECK(primitive["mode"] == 4);
    CHECK(primitive["extras"]["label"] == labels[i]);
    const Json& material = glb.json["materials"].at(primitive["material"].get<std::size_t>());
    CHECK(material["name"] == (i == 3 ? "unlabelled" : "region_" + std::to_string(i)));
    const double red = label_color(GeneratorId(labels[i])).red / 255.0;
    CHECK(material["pbrMetallicRoughness"]["baseColorFactor"][0].get<double>() ==
          Approx(std::pow((red + 0.055) / 1.055, 2.4)).margin(1e-4));
    CHECK(corner_positions(glb, primitive) == corner_positions(labelled, GeneratorId(labels[i])));
  }
}

TEST_CASE("each region of a GLB has vertices of its own, within the bounds that it names") {
  const Labelled labelled;
  const Glb glb(to_bytes(labelled.view(), OutputFormat::glb));
  std::size_t vertices = 0;
  for (const Json& primitive : glb.json["meshes"][0]["primitives"]) {
    const auto index = primitive["attributes"]["POSITION"].get<std::size_t>();
    const auto values = glb.get<float>(index);
    vertices += values.size() / 3;
    const auto indices = glb.get<std::uint32_t>(primitive["indices"].get<std::size_t>());
    CHECK(3 * (*std::max_element(indices.begin(), indices.end()) + 1) == values.size());
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (std::size_t i = 0; i < values.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], values[i]);
      high[i % 3] = std::max(high[i % 3], values[i]);
    }
    CHECK(glb.json["accessors"][index]["min"].get<std::array<float, 3>>() == low);
    CHECK(glb.json["accessors"][index]["max"].get<std::array<float, 3>>() == high);
    // Views that several accessors share must name their stride.
    CHECK(glb.json["bufferViews"][glb.json["accessors"][index]["bufferView"].get<std::size_t>()]["byteStride"] == 12);
  }
  CHECK(vertices <= 72);
}

TEST_CASE("the normals of a GLB have length 1 and point out of the surface") {
  const Labelled labelled;
  const Glb glb(to_bytes(labelled.view(), OutputFormat::glb));
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
  const Glb glb(to_bytes(labelled.view(), OutputFormat::glb));
  const Json& primitive = glb.json["meshes"][1]["primitives"][0];
  CHECK(primitive["mode"] == 1);
  CHECK(glb.get<std::uint32_t>(primitive["indices"].get<std::size_t>()) ==
        std::vector<std::uint32_t>{0, 1, 1, 2, 3, 4, 5, 6, 6, 7, 7, 8});
  CHECK(glb.get<float>(primitive["attributes"]["POSITION"].get<std::size_t>()).size() == 27);
}

TEST_CASE("a plain GLB is one grey surface") {
  const Glb glb(to_bytes(LabelledMesh{make_sphere(1)}, OutputFormat::glb));
  CHECK(glb.json["meshes"].size() == 1);
  CHECK(glb.json["meshes"][0]["primitives"].size() == 1);
  CHECK(glb.json["materials"][0]["name"] == "surface");
}

}  // namespace gvd::test_write_glb
