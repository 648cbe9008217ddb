// Writes binary glTF 2.0 (Khronos; ISO/IEC 12113): a header, a chunk of JSON, and a chunk of numbers.
//
// The chunk of JSON describes views of the numbers and comes before them in the file. So the writer first describes the
// surface and the lines, which adds up the bytes, and then writes the numbers in the same order.
// The surface is one primitive, which a renderer draws at once however many regions it has. Each region has vertices of
// its own, with its colour in COLOR_0 and its label in _LABEL: a vertex on a border, a crease or a seam occurs once for
// each region, normal and texture coordinate. glTF has no 32-bit integers for such attributes and takes colours as
// linear, so both are floats. Positions are 32-bit floats, too, which `check_single_precision` has allowed. Far from
// the origin they are relative to the translation of both nodes (single_precision.cpp).
// Invariant: every view begins where the previous one ends, so that the description and the numbers agree.
#include <array>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "gvd/error.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125;                              // accessor.componentType
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;                     // bufferView.target
constexpr int kLines = 1, kTriangles = 4;                                      // primitive.mode
constexpr const char *kScalar = "SCALAR", *kPair = "VEC2", *kVector = "VEC3";  // accessor.type
/// Size in bytes of the file header and of the headers of both chunks.
constexpr std::uint64_t kHeadBytes = 12 + 8 + 8;

Json make_material(const std::string& name, const std::array<double, 3>& color) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {color[0], color[1], color[2], 1}}, {"metallicFactor", 0}, {"roughnessFactor", 0.9}}},
          {"doubleSided", true}};
}

class GlbWriter {
 public:
  explicit GlbWriter(const ColoredMesh& labelled)
      : labelled_(labelled),
        mesh_(labelled.mesh),
        translation_(glb_translation(labelled.mesh)),
        surface_(split_shading_vertices(labelled)),
        lines_(collect_lines(labelled)) {
    describe_surface();
    describe_lines();
  }

  void write(std::ostream& stream) {
    gltf_["buffers"] = {{{"byteLength", binary_bytes_}}};
    std::string text = gltf_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::uint64_t total = kHeadBytes + text.size() + binary_bytes_;
    if (total > std::numeric_limits<std::uint32_t>::max()) {
      throw Error(ErrorCode::unwritable_output, "GLB holds 4 GiB and the mesh needs more; choose PLY or VTP");
    }
    ByteWriter out(stream);
    for (const std::uint32_t word : {kMagic, kVersion, std::uint32_t(total)}) out.binary(word);
    for (const std::uint32_t word : {std::uint32_t(text.size()), kJsonChunk}) out.binary(word);
    out.text(text);
    for (const std::uint32_t word : {std::uint32_t(binary_bytes_), kBinaryChunk}) out.binary(word);
    write_surface(out);
    write_lines(out);
    out.finish();
  }

 private:
  /// Appends a buffer view of `bytes` bytes at the end of the buffer; returns its index.
  std::size_t add_view(std::uint64_t bytes, int target) {
    Json& views = gltf_["bufferViews"];
    views.push_back({{"buffer", 0}, {"byteOffset", binary_bytes_}, {"byteLength", bytes}, {"target", target}});
    binary_bytes_ += bytes;
    return views.size() - 1;
  }

  /// Appends an accessor for the `count` elements of a view: floats for vertices, integers for indices. Returns its
  /// index.
  std::size_t add_accessor(std::size_t view, std::size_t count, const char* type) {
    const bool of_vertices = gltf_["bufferViews"][view]["target"] == kVertexBuffer;
    gltf_["accessors"].push_back({{"bufferView", view},
                                  {"componentType", of_vertices ? kFloat : kUnsignedInt},
                                  {"count", count},
                                  {"type", type}});
    return gltf_["accessors"].size() - 1;
  }

  /// A position relative to the nodes.
  Eigen::Vector3f local(const Vec3& p) const { return (p - translation_).cast<float>(); }

  /// Adds the bounds of the points to an accessor of positions.
  template <class ForEachPoint>
  void set_bounds(std::size_t accessor, ForEachPoint for_each_point) {
    Eigen::AlignedBox3f box;
    for_each_point([&](const Vec3& p) { box.extend(local(p)); });
    gltf_["accessors"][accessor]["min"] = {box.min().x(), box.min().y(), box.min().z()};
    gltf_["accessors"][accessor]["max"] = {box.max().x(), box.max().y(), box.max().z()};
  }

  /// Makes a primitive with the last material.
  Json make_primitive(Json attributes, std::size_t indices, int mode) const {
    return {{"attributes", std::move(attributes)},
            {"indices", indices},
            {"material", gltf_["materials"].size() - 1},
            {"mode", mode}};
  }

  void add_node(const std::string& name, Json primitives) {
    const std::size_t index = gltf_["meshes"].size();
    gltf_["meshes"].push_back({{"name", name}, {"primitives", std::move(primitives)}});
    Json node = {{"name", name}, {"mesh", index}};
    if (!translation_.isZero(0)) node["translation"] = {translation_.x(), translation_.y(), translation_.z()};
    gltf_["nodes"].push_back(std::move(node));
    gltf_["scenes"][0]["nodes"].push_back(index);
  }

  /// Gives positions, normals, colours, labels, texture coordinates and indices one view each.
  void describe_surface() {
    gltf_["asset"] = {{"version", "2.0"}, {"generator", "libgvd"}};
    gltf_["scene"] = 0;
    const std::size_t count = surface_.vertices.size();
    const auto add_attribute = [&](const char* type) {
      const std::uint64_t bytes = type == kVector ? 12 : type == kPair ? 8 : 4;
      return add_accessor(add_view(bytes * count, kVertexBuffer), count, type);
    };
    Json attributes = {{"POSITION", add_attribute(kVector)}};
    set_bounds(attributes["POSITION"], [this](auto visit) {
      for (const ShadingVertex& vertex : surface_.vertices) visit(mesh_.position(vertex.vertex));
    });
    attributes["NORMAL"] = add_attribute(kVector);
    if (has_labels()) {
      attributes["COLOR_0"] = add_attribute(kVector);
      attributes["_LABEL"] = add_attribute(kScalar);
    }
    if (labelled_.has_texture()) attributes["TEXCOORD_0"] = add_attribute(kPair);
    const auto corners = std::size_t(mesh_.halfedge_count());
    const std::size_t indices = add_accessor(add_view(4 * std::uint64_t{corners}, kIndexBuffer), corners, kScalar);
    // The colours of vertices are multiplied by the colour of the material.
    gltf_["materials"].push_back(has_labels() ? make_material("regions", {1, 1, 1})
                                              : make_material("surface", to_linear(kUnlabelledColor)));
    add_node("surface", Json::array({make_primitive(std::move(attributes), indices, kTriangles)}));
  }

  bool has_labels() const { return labelled_.face_label != nullptr; }

  /// Describes all bisectors and curves as one primitive of line segments.
  void describe_lines() {
    std::size_t points = 0;
    for (const OutputLine& line : lines_) points += line.points.size();
    if (points == 0) return;
    const std::size_t segments = points - lines_.size();
    const std::size_t positions = add_accessor(add_view(12 * points, kVertexBuffer), points, kVector);
    set_bounds(positions, [this](auto visit) {
      for (const OutputLine& line : lines_) {
        for (const Vec3& p : line.points) visit(p);
      }
    });
    const std::size_t view = add_view(8 * segments, kIndexBuffer);
    gltf_["materials"].push_back(make_material("bisectors", {0, 0, 0}));
    add_node(
        "bisectors",
        Json::array({make_primitive({{"POSITION", positions}}, add_accessor(view, 2 * segments, kScalar), kLines)}));
  }

  void write_surface(ByteWriter& out) const {
    const std::vector<ShadingVertex>& vertices = surface_.vertices;
    for (const ShadingVertex& vertex : vertices) out.floats(local(mesh_.position(vertex.vertex)));
    for (const ShadingVertex& vertex : vertices) out.floats(vertex.normal);
    if (has_labels()) {
      std::vector<std::array<double, 3>> linear{to_linear(kUnlabelledColor)};  // for label -1
      for (const Rgb& color : labelled_.colors) linear.push_back(to_linear(color));
      for (const ShadingVertex& vertex : vertices) out.floats(linear[std::size_t(vertex.label.value() + 1)]);
      for (const ShadingVertex& vertex : vertices) out.binary(static_cast<float>(vertex.label.value()));
    }
    if (labelled_.has_texture()) {
      for (const ShadingVertex& vertex : vertices) {
        const auto& [u, v] = vertex.texture;
        for (const double number : {u, 1 - v}) out.binary(static_cast<float>(number));  // in glTF v runs downwards
      }
    }
    for (const std::uint32_t index : surface_.of_corner) out.binary(index);
  }

  void write_lines(ByteWriter& out) const {
    for (const OutputLine& line : lines_) {
      for (const Vec3& p : line.points) out.floats(local(p));
    }
    std::uint32_t next = 0;
    for (const OutputLine& line : lines_) {
      for (std::size_t i = 1; i < line.points.size(); ++i, ++next) {
        out.binary(next);
        out.binary(next + 1);
      }
      ++next;
    }
  }

  const ColoredMesh& labelled_;
  const Mesh& mesh_;
  Vec3 translation_;  ///< of all nodes
  ShadingVertices surface_;
  std::vector<OutputLine> lines_;
  Json gltf_;
  std::uint64_t binary_bytes_ = 0;
};

}  // namespace

void write_glb(std::ostream& stream, const ColoredMesh& mesh) { GlbWriter(mesh).write(stream); }

}  // namespace gvd::io
