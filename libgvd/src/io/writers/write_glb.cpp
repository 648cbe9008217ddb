// Binary glTF 2.0 (Khronos; ISO/IEC 12113): a header, a JSON chunk, a chunk of numbers.
//
// The JSON chunk describes views of the numbers, and comes before them in the file. So the surface and the lines
// are described first, which adds up the bytes, and then written in the same order.
// Each region is a primitive with a material, and with vertices of its own: a vertex on a border or a crease comes once
// for each region and normal. Positions are 32-bit floats, which `check_single_precision` has allowed.
// Invariant: every view begins where the one before it ends, so that the description and the numbers agree.
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/io/label_color.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125;             // accessor.componentType
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;    // bufferView.target
constexpr int kLines = 1, kTriangles = 4;                     // primitive.mode
constexpr const char *kScalar = "SCALAR", *kVector = "VEC3";  // accessor.type
/// Bytes of the file header and the headers of both chunks.
constexpr std::uint64_t kHeadBytes = 12 + 8 + 8;

/// A colour channel of sRGB (IEC 61966-2-1) as a linear factor of glTF. Rounded to four digits, which 8 bits need, so
/// that the last bit of pow does not matter.
double to_linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  const double linear = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  return std::round(1e4 * linear) / 1e4;
}

Json make_material(const std::string& name, const Rgb& color) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {to_linear(color.red), to_linear(color.green), to_linear(color.blue), 1}},
            {"metallicFactor", 0},
            {"roughnessFactor", 0.9}}},
          {"doubleSided", true}};
}

class GlbWriter {
 public:
  explicit GlbWriter(const LabelledMesh& labelled)
      : mesh_(labelled.mesh),
        has_labels_(labelled.face_label != nullptr),
        regions_(collect_regions(labelled)),
        surface_(split_shading_vertices(labelled.mesh, labelled.face_label, regions_)),
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
  /// Appends a buffer view of `bytes` bytes at the end of the buffer; returns its index. Vertices are three floats.
  std::size_t add_view(std::uint64_t bytes, int target) {
    Json& views = gltf_["bufferViews"];
    views.push_back({{"buffer", 0}, {"byteOffset", binary_bytes_}, {"byteLength", bytes}, {"target", target}});
    if (target == kVertexBuffer) views.back()["byteStride"] = 12;
    binary_bytes_ += bytes;
    return views.size() - 1;
  }

  /// Appends an accessor of `count` elements, `offset` bytes into a view; returns its index.
  std::size_t add_accessor(std::size_t view, std::uint64_t offset, std::size_t count, const char* type) {
    gltf_["accessors"].push_back({{"bufferView", view},
                                  {"byteOffset", offset},
                                  {"componentType", std::string_view(type) == kScalar ? kUnsignedInt : kFloat},
                                  {"count", count},
                                  {"type", type}});
    return gltf_["accessors"].size() - 1;
  }

  /// Adds their bounds to an accessor of positions.
  template <class ForEachPoint>
  void set_bounds(std::size_t accessor, ForEachPoint for_each_point) {
    Eigen::AlignedBox3f box;
    for_each_point([&box](const Vec3& p) { box.extend(p.cast<float>()); });
    gltf_["accessors"][accessor]["min"] = {box.min().x(), box.min().y(), box.min().z()};
    gltf_["accessors"][accessor]["max"] = {box.max().x(), box.max().y(), box.max().z()};
  }

  /// A primitive of the last material.
  Json make_primitive(Json attributes, std::size_t indices, int mode) const {
    return {{"attributes", std::move(attributes)},
            {"indices", indices},
            {"material", gltf_["materials"].size() - 1},
            {"mode", mode}};
  }

  void add_node(const std::string& name, Json primitives) {
    const std::size_t index = gltf_["meshes"].size();
    gltf_["meshes"].push_back({{"name", name}, {"primitives", std::move(primitives)}});
    gltf_["nodes"].push_back({{"name", name}, {"mesh", index}});
    gltf_["scenes"][0]["nodes"].push_back(index);
  }

  /// Positions, normals and indices have one view each. Every region has its own part of them: programs that copy what
  /// an accessor holds would otherwise copy the whole mesh for each region.
  void describe_surface() {
    gltf_["asset"] = {{"version", "2.0"}, {"generator", "libgvd"}};
    gltf_["scene"] = 0;
    const std::uint64_t vertex_bytes = 12 * std::uint64_t{surface_.vertices.size()};
    const std::size_t positions = add_view(vertex_bytes, kVertexBuffer),
                      normals = add_view(vertex_bytes, kVertexBuffer);
    const std::size_t corners = add_view(12 * std::uint64_t(mesh_.face_count()), kIndexBuffer);
    Json primitives = Json::array();
    std::uint64_t index_offset = 0;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const Region& region = regions_[r];
      gltf_["materials"].push_back(
          make_material(has_labels_ ? region_name(region.label) : "surface", label_color(region.label)));
      Json attributes = add_region_vertices(r, positions, normals);
      const std::size_t indices = add_accessor(corners, index_offset, 3 * region.faces.size(), kScalar);
      primitives.push_back(make_primitive(std::move(attributes), indices, kTriangles));
      if (has_labels_) primitives.back()["extras"] = {{"label", region.label.value()}};
      index_offset += 12 * region.faces.size();
    }
    add_node("surface", std::move(primitives));
  }

  /// Appends the accessors of region r's positions and normals in these views; returns the attributes of its primitive.
  Json add_region_vertices(std::size_t r, std::size_t position_view, std::size_t normal_view) {
    const std::uint64_t offset = 12 * std::uint64_t{surface_.first[r]};
    const std::size_t count = surface_.first[r + 1] - surface_.first[r];
    const std::size_t positions = add_accessor(position_view, offset, count, kVector);
    set_bounds(positions, [&](auto visit) {
      for (std::size_t i = surface_.first[r]; i < surface_.first[r + 1]; ++i) visit(position_of(i));
    });
    return {{"POSITION", positions}, {"NORMAL", add_accessor(normal_view, offset, count, kVector)}};
  }

  const Vec3& position_of(std::size_t shading_vertex) const {
    return mesh_.position(surface_.vertices[shading_vertex].vertex);
  }

  /// All bisectors and curves are one primitive of line segments.
  void describe_lines() {
    std::size_t points = 0;
    for (const OutputLine& line : lines_) points += line.points.size();
    if (points == 0) return;
    const std::size_t segments = points - lines_.size();
    const std::size_t positions = add_accessor(add_view(12 * points, kVertexBuffer), 0, points, kVector);
    set_bounds(positions, [this](auto visit) {
      for (const OutputLine& line : lines_) {
        for (const Vec3& p : line.points) visit(p);
      }
    });
    const std::size_t view = add_view(8 * segments, kIndexBuffer);
    gltf_["materials"].push_back(make_material("bisectors", Rgb{0, 0, 0}));
    add_node(
        "bisectors",
        Json::array({make_primitive({{"POSITION", positions}}, add_accessor(view, 0, 2 * segments, kScalar), kLines)}));
  }

  void write_surface(ByteWriter& out) const {
    for (std::size_t i = 0; i < surface_.vertices.size(); ++i) out.floats(position_of(i));
    for (const ShadingVertex& vertex : surface_.vertices) out.floats(vertex.normal);
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      for (const FaceId f : regions_[r].faces) {
        for (int i = 0; i < 3; ++i) out.binary(surface_.of_corner[Mesh::halfedge(f, i)] - surface_.first[r]);
      }
    }
  }

  void write_lines(ByteWriter& out) const {
    for (const OutputLine& line : lines_) {
      for (const Vec3& p : line.points) out.floats(p);
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

  const Mesh& mesh_;
  bool has_labels_;
  std::vector<Region> regions_;
  ShadingVertices surface_;
  std::vector<OutputLine> lines_;
  Json gltf_;
  std::uint64_t binary_bytes_ = 0;
};

}  // namespace

void write_glb(std::ostream& stream, const LabelledMesh& mesh) { GlbWriter(mesh).write(stream); }

}  // namespace gvd::io
