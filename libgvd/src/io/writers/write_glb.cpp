#include "io/writers/write_glb.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "gvd/error.hpp"
#include "gvd/io/label_color.hpp"
#include "io/writers/bisector_lines.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/regions.hpp"

// Binary glTF 2.0 (Khronos; ISO/IEC 12113): a header, a JSON chunk, a chunk of numbers.
namespace gvd::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125;           // accessor.componentType
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;  // bufferView.target
constexpr int kLines = 1, kTriangles = 4;                   // primitive.mode
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
        lines_(collect_bisector_lines(labelled)) {
    describe_surface();
    describe_bisectors();
  }

  void write(std::ostream& stream) {
    gltf_["buffers"] = {{{"byteLength", binary_bytes_}}};
    std::string json = gltf_.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::uint64_t total = kHeadBytes + json.size() + binary_bytes_;
    if (total > std::numeric_limits<std::uint32_t>::max()) {
      throw Error(ErrorCode::unwritable_output, "GLB holds 4 GiB and the mesh needs more; choose PLY or VTP");
    }
    ByteWriter out(stream);
    for (const std::uint32_t word : {kMagic, kVersion, static_cast<std::uint32_t>(total)}) out.binary(word);
    for (const std::uint32_t word : {static_cast<std::uint32_t>(json.size()), kJsonChunk}) out.binary(word);
    out.text(json);
    for (const std::uint32_t word : {static_cast<std::uint32_t>(binary_bytes_), kBinaryChunk}) out.binary(word);
    write_surface(out);
    write_bisectors(out);
    out.finish();
  }

 private:
  /// Appends a buffer view of `bytes` bytes at the end of the buffer; returns its index.
  std::size_t add_view(std::uint64_t bytes, int target) {
    gltf_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary_bytes_}, {"byteLength", bytes}, {"target", target}});
    binary_bytes_ += bytes;
    return gltf_["bufferViews"].size() - 1;
  }

  /// Appends an accessor of indices, `offset` bytes into a view; returns its index.
  std::size_t add_indices(std::size_t view, std::size_t offset, std::size_t count) {
    gltf_["accessors"].push_back({{"bufferView", view},
                                  {"byteOffset", offset},
                                  {"componentType", kUnsignedInt},
                                  {"count", count},
                                  {"type", "SCALAR"}});
    return gltf_["accessors"].size() - 1;
  }

  /// Appends an accessor of positions with its bounds, and its view; returns its index.
  template <class ForEachPoint>
  std::size_t add_positions(std::size_t count, ForEachPoint for_each_point) {
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max()), high = -low;
    for_each_point([&](const Vec3& p) {
      low = low.cwiseMin(p.cast<float>());
      high = high.cwiseMax(p.cast<float>());
    });
    gltf_["accessors"].push_back({{"bufferView", add_view(12 * count, kVertexBuffer)},
                                  {"componentType", kFloat},
                                  {"count", count},
                                  {"type", "VEC3"},
                                  {"min", {low.x(), low.y(), low.z()}},
                                  {"max", {high.x(), high.y(), high.z()}}});
    return gltf_["accessors"].size() - 1;
  }

  void add_primitive(Json& primitives, std::size_t positions, std::size_t indices, int mode) {
    primitives.push_back({{"attributes", {{"POSITION", positions}}},
                          {"indices", indices},
                          {"material", gltf_["materials"].size() - 1},
                          {"mode", mode}});
  }

  void add_node(const std::string& name, Json primitives) {
    const std::size_t index = gltf_["meshes"].size();
    gltf_["meshes"].push_back({{"name", name}, {"primitives", std::move(primitives)}});
    gltf_["nodes"].push_back({{"name", name}, {"mesh", index}});
    gltf_["scenes"][0]["nodes"].push_back(index);
  }

  /// The regions share the positions and one view of indices.
  void describe_surface() {
    gltf_["asset"] = {{"version", "2.0"}, {"generator", "libgvd"}};
    gltf_["scene"] = 0;
    const std::size_t positions = add_positions(mesh_.positions().size(), [this](auto visit) {
      for (const Vec3& p : mesh_.positions()) visit(p);
    });
    const std::size_t view = add_view(std::uint64_t{12} * static_cast<std::uint64_t>(mesh_.face_count()), kIndexBuffer);
    Json primitives = Json::array();
    std::size_t offset = 0;
    for (const Region& region : regions_) {
      gltf_["materials"].push_back(
          make_material(has_labels_ ? region_name(region.label) : "surface", label_color(region.label)));
      add_primitive(primitives, positions, add_indices(view, offset, 3 * region.faces.size()), kTriangles);
      if (has_labels_) primitives.back()["extras"] = {{"label", region.label.value()}};
      offset += 12 * region.faces.size();
    }
    add_node("surface", std::move(primitives));
  }

  /// All bisectors are one primitive of line segments.
  void describe_bisectors() {
    std::size_t points = 0;
    for (const BisectorLine& line : lines_) points += line.points.size();
    if (points == 0) return;
    const std::size_t segments = points - lines_.size();
    const std::size_t positions = add_positions(points, [this](auto visit) {
      for (const BisectorLine& line : lines_) {
        for (const Vec3& p : line.points) visit(p);
      }
    });
    const std::size_t view = add_view(8 * segments, kIndexBuffer);
    gltf_["materials"].push_back(make_material("bisectors", Rgb{0, 0, 0}));
    Json primitives = Json::array();
    add_primitive(primitives, positions, add_indices(view, 0, 2 * segments), kLines);
    add_node("bisectors", std::move(primitives));
  }

  static void write_point(ByteWriter& out, const Vec3& p) {
    for (int i = 0; i < 3; ++i) out.binary(static_cast<float>(p[i]));
  }

  void write_surface(ByteWriter& out) const {
    for (const Vec3& p : mesh_.positions()) write_point(out, p);
    for (const Region& region : regions_) {
      for (const FaceId f : region.faces) {
        for (const VertexId v : mesh_.vertices(f)) out.binary(v.value());
      }
    }
  }

  void write_bisectors(ByteWriter& out) const {
    for (const BisectorLine& line : lines_) {
      for (const Vec3& p : line.points) write_point(out, p);
    }
    std::uint32_t next = 0;
    for (const BisectorLine& line : lines_) {
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
  std::vector<BisectorLine> lines_;
  Json gltf_;
  std::uint64_t binary_bytes_ = 0;
};

}  // namespace

void write_glb(std::ostream& stream, const LabelledMesh& mesh) { GlbWriter(mesh).write(stream); }

}  // namespace gvd::io
