// glTF 2.0, binary (.glb) and as JSON (.gltf): the triangles of a scene, moved by the transforms of its nodes.
//
// A scene is a forest of nodes; a node may have a mesh, a mesh has primitives, and a primitive is a list of triangles
// with accessors for positions and indices. Accessors are numbers in buffers: the binary chunk, data URIs, or files
// beside the mesh. Vertices with several normals
// or materials come several times, so that the soup is marked as unwelded, as that of an STL is.
// Of attributes besides positions, the first set of texture coordinates is read; its v runs downwards. Materials,
// skins, morph targets and animations are left out: the surface is that of the stored positions.
// Source: Khronos, glTF 2.0 (ISO/IEC 12113), sections 3.5 to 3.7 and 4.4.
// Invariant: every node is visited at most once, and what primitives unfold to is counted before it takes memory.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/gltf_buffers.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/stored_numbers.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {
namespace {

using Json = nlohmann::json;
using Transform = Eigen::Matrix4d;

constexpr std::string_view kMark = "glTF";
constexpr std::uint32_t kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr std::size_t kTriangleList = 4, kTriangleStrip = 5, kTriangleFan = 6;  // primitive.mode

/// How far the last row of a matrix may be from 0 0 0 1, absolute: products of matrices of 32-bit floats are that
/// exact.
constexpr double kAffine = 1e-5;

/// The extension that compresses single primitives.
constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// The beginnings of the names of extensions that say nothing about the triangles but how they are painted, lit or
/// described. A mesh that needs any other extension may be compressed, or stand elsewhere.
constexpr std::array<std::string_view, 12> kHarmless{
    "KHR_materials_", "EXT_materials_",        "ADOBE_materials_",      "KHR_texture_",
    "EXT_texture_",   "MSFT_texture_dds",      "KHR_lights_",           "EXT_lights_",
    "KHR_xmp",        "KHR_animation_pointer", "KHR_mesh_quantization", "FB_ngon_encoding"};
constexpr std::string_view kTextureTransform = "KHR_texture_transform";

/// Numbers of an accessor: `size` for each of its elements.
struct Accessor {
  std::vector<double> numbers;
  std::size_t size = 1;
};

/// A file: its description, and the numbers of its buffers.
class GltfFile {
 public:
  GltfFile(std::string_view bytes, std::string_view name, const std::optional<std::filesystem::path>& folder)
      : bytes_(bytes), name_(name), folder_(folder), limit_(bytes.size(), name) {
    is_binary_ = bytes.starts_with(kMark);
    if (!is_binary_ && !is_json(bytes)) refuse("the file begins neither with 'glTF' nor, as JSON, with '{'");
    gltf_ = Json::parse(is_binary_ ? read_chunks() : bytes);
    if (!gltf_.is_object()) refuse("the scene's description is no JSON object");
    check_version();
  }

  const Json& description() const { return gltf_; }
  const std::string& name() const { return name_; }
  /// Counts what the file unfolds to.
  void spend(std::uint64_t bytes) { limit_.spend(bytes); }

  /// A list of the description; empty where there is none.
  const Json& array(const char* key) const {
    static const Json kNone = Json::array();
    const auto found = gltf_.find(key);
    return found == gltf_.end() ? kNone : *found;
  }

  const Json& item(const char* key, std::size_t i) const {
    const Json& items = array(key);
    if (i >= items.size()) refuse(fmt::format("there is no item {} of {}", i, key));
    return items.at(i);
  }

  /// A member that is a whole number from 0.
  std::size_t number(const Json& object, const char* key, std::optional<std::size_t> otherwise = {}) const {
    const auto found = object.find(key);
    if (found == object.end() && otherwise) return *otherwise;
    if (found == object.end() || !found->is_number_unsigned()) refuse(fmt::format("'{}' is no index or count", key));
    return as_size(*found);
  }

  /// A value that is a whole number from 0.
  std::size_t index(const Json& value, const char* what) const {
    if (!value.is_number_unsigned()) refuse(fmt::format("an index of {} is no whole number", what));
    return as_size(value);
  }

  /// Numbers or vectors of two or three numbers; those that stand for fractions are divided, -128 as -127.
  Accessor read_accessor(std::size_t a) {
    const Json& accessor = item("accessors", a);
    if (accessor.contains("sparse")) refuse(fmt::format("accessor {} is sparse, which is not read", a));
    if (!accessor.contains("bufferView")) refuse(fmt::format("accessor {} has no numbers", a));
    const StoredNumber stored = stored_number(number(accessor, "componentType"));
    const std::string type = accessor.at("type");
    Accessor read{{}, type == "SCALAR" ? 1U : type == "VEC2" ? 2U : type == "VEC3" ? 3U : 0U};
    if (read.size == 0) refuse(fmt::format("accessor {} has the type {}", a, gvd::quoted(type)));
    const std::size_t v = number(accessor, "bufferView");
    const std::string_view view = find_view(v);
    const std::size_t count = number(accessor, "count"), begin = number(accessor, "byteOffset", 0);
    const std::size_t element = read.size * stored.size;
    const std::size_t given = number(item("bufferViews", v), "byteStride", 0);
    const std::size_t stride = given == 0 ? element : given;
    if (count == 0) return read;
    if (stride < element) {
      refuse(fmt::format("accessor {} has elements of {}, and its view steps by {} ('byteStride'); {}", a,
                         byte_count(element), stride, kExportAgain));
    }
    const std::size_t first = number(item("bufferViews", v), "byteOffset", 0) + begin;
    if (first % stored.size != 0 || stride % stored.size != 0) {
      refuse(
          fmt::format("accessor {} has numbers of {} bytes at byte {} of its buffer and each {} bytes on, which are "
                      "no multiples of {}; {}",
                      a, stored.size, first, stride, stored.size, kExportAgain));
    }
    if (begin > view.size() || element > view.size() - begin || count - 1 > (view.size() - begin - element) / stride) {
      refuse(fmt::format("accessor {} has {}, and its view has {}", a, counted(count, "element", "elements"),
                         byte_count(view.size())));
    }
    limit_.spend(std::uint64_t(count) * read.size * sizeof(double));
    read.numbers.reserve(count * read.size);
    const bool is_fraction = accessor.value("normalized", false) && stored.kind != StoredNumber::Kind::real;
    const double scale = is_fraction ? largest(stored) : 1, least = is_fraction ? -scale : -kInfinity;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < read.size; ++k) {
        const double number = stored.read(view.data() + begin + i * stride + k * stored.size);
        read.numbers.push_back(std::max(number, least) / scale);
      }
    }
    return read;
  }

  /// The files beside this one that it refers to, with buffers and images.
  std::vector<std::filesystem::path> other_files() const {
    std::vector<std::filesystem::path> files;
    for (const char* kind : {"buffers", "images"}) {
      for (const Json& described : array(kind)) {
        const auto address = described.find("uri");
        if (address == described.end() || !address->is_string()) continue;
        if (auto file = gltf_file(address->get_ref<const std::string&>())) files.push_back(*std::move(file));
      }
    }
    return files;
  }

  [[noreturn]] void refuse(const std::string& message) const {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name_, message));
  }

 private:
  /// The largest size for numbers beyond it: nothing has so many elements, and a remainder would pass for a count.
  static std::size_t as_size(const Json& value) {
    return std::size_t(std::min<std::uint64_t>(value.get<std::uint64_t>(), std::numeric_limits<std::size_t>::max()));
  }

  std::uint32_t word(std::size_t at) const {
    if (at + 4 > bytes_.size()) refuse(fmt::format("the file ends at byte {}, inside a header", bytes_.size()));
    return static_cast<std::uint32_t>(StoredNumber{.size = 4}.read_bits(bytes_.data() + at));
  }

  /// Finds the binary chunk, and returns the description.
  std::string_view read_chunks() {
    if (word(4) != kVersion) refuse(fmt::format("the file has version {} of glTF, and only 2 is read", word(4)));
    const std::size_t whole = word(8);
    if (whole <= kHeaderBytes) {
      refuse(fmt::format("the header says that the file has {}, which is no more than the header itself; {}",
                         byte_count(whole), kExportAgain));
    }
    bytes_ = bytes_.substr(0, whole);  // what follows the file's own length is no part of it
    std::string_view json;
    for (std::size_t at = kHeaderBytes; at < bytes_.size();) {
      const std::size_t length = word(at), begin = at + kChunkHeaderBytes;
      const std::uint32_t kind = word(at + 4);
      if (length > bytes_.size() - begin) {
        refuse(fmt::format("byte {}: a chunk should have {}, and the file has {} more", at, byte_count(length),
                           bytes_.size() - begin));
      }
      if (kind == kJsonChunk && json.empty()) json = bytes_.substr(begin, length);
      if (kind == kBinaryChunk && binary_.empty()) binary_ = bytes_.substr(begin, length);
      at = begin + length;
    }
    if (whole > bytes_.size()) {
      refuse(fmt::format("the header says that the file has {} bytes, and it has {}; copy it again", whole,
                         bytes_.size()));
    }
    return json;
  }

  void check_version() const {
    const auto asset = gltf_.find("asset");
    if (asset == gltf_.end()) return;  // it should be there, and nothing depends on it
    const std::string version = asset->value("version", "2.0"), least = asset->value("minVersion", "2.0");
    if (!version.starts_with("2.") || least != "2.0") {
      refuse(fmt::format("the file has version {} of glTF, and only 2.0 is read",
                         gvd::quoted(least == "2.0" ? version : least)));
    }
  }

  /// The bytes of a buffer. Each one, and each file, is read once. Addresses may be long: they are compared once for
  /// each buffer, and not for each view.
  std::string_view find_buffer(std::size_t b) {
    const auto known = buffers_.find(b);
    if (known != buffers_.end()) return known->second;
    const Json& buffer = item("buffers", b);
    const std::string_view stored = read_buffer(buffer, b);
    const std::size_t length = number(buffer, "byteLength", stored.size());
    if (length > stored.size()) {
      refuse(
          fmt::format("buffer {} should have {}, and has {}; {}", b, byte_count(length), stored.size(), kExportAgain));
    }
    return buffers_[b] = stored.substr(0, length);  // a chunk is padded
  }

  std::string_view read_buffer(const Json& buffer, std::size_t b) {
    const auto address = buffer.find("uri");
    if (address == buffer.end()) {
      if (is_binary_ && b == 0) return binary_;
      refuse(fmt::format("buffer {} has no address, and only the first one of a .glb may lack it", b));
    }
    const auto& uri = address->get_ref<const std::string&>();
    const auto [content, is_new] = contents_.try_emplace(uri);
    if (is_new) content->second = read_gltf_buffer(uri, b, folder_, limit_, name_);
    return content->second;
  }

  StoredNumber stored_number(std::size_t component_type) const {
    using Kind = StoredNumber::Kind;
    constexpr std::size_t kByte = 5120, kFloat = 5126;
    static constexpr std::array<StoredNumber, 7> kTypes{{{Kind::signed_integer, 1},
                                                         {Kind::unsigned_integer, 1},
                                                         {Kind::signed_integer, 2},
                                                         {Kind::unsigned_integer, 2},
                                                         {Kind::signed_integer, 4},
                                                         {Kind::unsigned_integer, 4},
                                                         {Kind::real, 4}}};
    if (component_type < kByte || component_type > kFloat) {
      refuse(fmt::format("an accessor has the component type {}", component_type));
    }
    return kTypes[component_type - kByte];
  }

  /// Counts of a file may be beyond 63 bits.
  static std::string byte_count(std::size_t count) {
    return fmt::format("{} {}", count, count == 1 ? "byte" : "bytes");
  }

  /// The number that stands for 1 in normalized integers.
  static double largest(const StoredNumber& stored) {
    return std::exp2(8.0 * double(stored.size) - (stored.kind == StoredNumber::Kind::signed_integer ? 1 : 0)) - 1;
  }

  std::string_view find_view(std::size_t v) {
    const Json& view = item("bufferViews", v);
    const std::size_t b = number(view, "buffer");
    const std::string_view buffer = find_buffer(b);
    const std::size_t begin = number(view, "byteOffset", 0), length = number(view, "byteLength");
    if (begin > buffer.size() || length > buffer.size() - begin) {
      refuse(fmt::format("view {} has {} from {} on, and buffer {} has {}", v, byte_count(length), begin, b,
                         buffer.size()));
    }
    return buffer.substr(begin, length);
  }

  std::string_view bytes_, binary_;
  bool is_binary_ = false;
  std::string name_;
  std::optional<std::filesystem::path> folder_;
  ExpansionLimit limit_;
  Json gltf_;
  std::map<std::size_t, std::string_view> buffers_;
  std::map<std::string_view, std::string> contents_;  // by address, which `gltf_` holds
};

/// The triangles of a file's scene.
class GltfParser {
 public:
  GltfParser(std::string_view bytes, std::string_view name, const std::optional<std::filesystem::path>& folder)
      : file_(bytes, name, folder) {
    soup_.unwelded = true;
  }

  PolygonSoup parse() {
    refuse_extensions(file_.description());
    visited_.assign(file_.array("nodes").size(), 0);
    for (const auto& [node, transform] : find_roots()) add_tree(node, transform);
    if (left_out_ > 0) {
      soup_.notes.push_back(
          fmt::format("{} left out", counted(left_out_, "list of points or lines is", "lists of points or lines are")));
    }
    finish_appearance();
    return std::move(soup_);
  }

 private:
  using Placed = std::pair<std::size_t, Transform>;  // a node and the transform of its parent

  void refuse_extensions(const Json& object) const {
    for (const Json& extension : object.value("extensionsRequired", Json::array())) {
      const auto& name = extension.get_ref<const std::string&>();
      if (std::ranges::any_of(kHarmless, [&](std::string_view begin) { return name.starts_with(begin); })) continue;
      file_.refuse(
          fmt::format("the mesh needs glTF's extension {}, which is not read; export it without", printable(name)));
    }
  }

  /// The roots of the scene. Without scenes these are all nodes without a parent; without nodes, every mesh has one.
  std::vector<Placed> find_roots() {
    std::vector<Placed> roots;
    if (!file_.array("scenes").empty()) {
      const Json& scene = file_.item("scenes", file_.number(file_.description(), "scene", 0));
      for (const Json& node : scene.value("nodes", Json::array())) {
        roots.emplace_back(file_.index(node, "nodes"), Transform::Identity());
      }
      return roots;
    }
    std::vector<char> is_child(visited_.size(), 0);
    for (const Json& node : file_.array("nodes")) {
      for (const Json& child : node.value("children", Json::array())) {
        if (file_.index(child, "nodes") < is_child.size()) is_child[file_.index(child, "nodes")] = 1;
      }
    }
    for (std::size_t n = 0; n < is_child.size(); ++n) {
      if (is_child[n] == 0) roots.emplace_back(n, Transform::Identity());
    }
    for (std::size_t m = 0; visited_.empty() && m < file_.array("meshes").size(); ++m)
      add_mesh(m, Transform::Identity());
    return roots;
  }

  void add_tree(std::size_t root, const Transform& placed) {
    std::vector<Placed> waiting{{root, placed}};
    while (!waiting.empty()) {
      const auto [n, parent] = waiting.back();
      waiting.pop_back();
      const Json& node = file_.item("nodes", n);
      if (std::exchange(visited_[n], 1) != 0) file_.refuse(fmt::format("node {} has two parents", n));
      const Transform transform = parent * transform_of(node, n);
      if (node.contains("mesh")) add_mesh(file_.number(node, "mesh"), transform);
      const Json children = node.value("children", Json::array());
      for (std::size_t i = children.size(); i-- > 0;)
        waiting.emplace_back(file_.index(children[i], "nodes"), transform);
    }
  }

  /// A matrix, by columns, or a translation, a rotation as quaternion (x, y, z, w) and a scale.
  Transform transform_of(const Json& node, std::size_t n) const {
    const auto matrix = node.find("matrix");
    if (matrix != node.end()) {
      const Transform made(matrix->get<std::array<double, 16>>().data());
      if (matrix->size() > 16 || !((made.row(3) - Transform::Identity().row(3)).cwiseAbs().maxCoeff() <= kAffine)) {
        file_.refuse(
            fmt::format("node {} has a matrix of {} that is no affine transform: it needs 16, and the "
                        "last row 0 0 0 1; {}",
                        n, counted(std::int64_t(matrix->size()), "number", "numbers"), kExportAgain));
      }
      return made;
    }
    const auto t = numbers_of(node, n, "translation", std::array{0.0, 0.0, 0.0});
    const auto s = numbers_of(node, n, "scale", std::array{1.0, 1.0, 1.0});
    const auto r = numbers_of(node, n, "rotation", std::array{0.0, 0.0, 0.0, 1.0});
    if (!(Eigen::Vector4d(r.data()).norm() > 0)) {
      file_.refuse(fmt::format("node {} has a rotation of length 0; {}", n, kExportAgain));
    }
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    transform.translate(Vec3(t[0], t[1], t[2])).rotate(Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized());
    return transform.scale(Vec3(s[0], s[1], s[2])).matrix();
  }

  /// A member of node n that is a list of numbers, all of which have a meaning.
  template <std::size_t kCount>
  std::array<double, kCount> numbers_of(const Json& node, std::size_t n, const char* key,
                                        const std::array<double, kCount>& otherwise) const {
    const auto found = node.find(key);
    if (found == node.end()) return otherwise;
    if (found->size() != kCount) {
      file_.refuse(fmt::format("node {} has a {} of {}, and it needs {}; {}", n, key,
                               counted(std::int64_t(found->size()), "number", "numbers"), kCount, kExportAgain));
    }
    return found->get<std::array<double, kCount>>();
  }

  void add_mesh(std::size_t m, const Transform& transform) {
    std::map<std::size_t, std::size_t> first_vertex;  // of each accessor of positions
    for (const Json& primitive : file_.item("meshes", m).at("primitives")) {
      const std::size_t mode = file_.number(primitive, "mode", kTriangleList);
      if (mode > kTriangleFan) file_.refuse(fmt::format("mesh {} has the unknown mode {}; {}", m, mode, kExportAgain));
      if (mode < kTriangleList) {
        ++left_out_;
        continue;
      }
      if (primitive.value("extensions", Json::object()).contains(kDraco)) {
        file_.refuse("the mesh is compressed by Draco, which is not read; export it without compression");
      }
      const std::size_t positions = file_.number(primitive.at("attributes"), "POSITION");
      const auto [known, is_new] = first_vertex.try_emplace(positions, soup_.positions.size());
      const std::size_t count = file_.number(file_.item("accessors", positions), "count");
      if (is_new) add_positions(positions, transform);
      std::vector<double> corners = read_indices(primitive, count);
      check_corners(corners.size(), mode, m);
      for (double& corner : corners) corner = require_vertex(corner, count) + double(known->second);
      const std::size_t begin = soup_.corners.size();
      add_triangles(corners, mode, transform.topLeftCorner<3, 3>().determinant() < 0);
      add_texture(primitive.at("attributes"), begin, {known->second, count});
    }
  }

  /// The vertices of a primitive.
  struct Vertices {
    std::size_t first, count;
  };

  /// Gives the corners from `begin` on their texture coordinates.
  void add_texture(const Json& attributes, std::size_t begin, const Vertices& vertices) {
    has_second_set_ |= attributes.contains("TEXCOORD_1");
    if (!attributes.contains("TEXCOORD_0")) return;
    const std::size_t accessor = file_.number(attributes, "TEXCOORD_0");
    const Json& described = file_.item("accessors", accessor);
    if (described.contains("sparse") || !described.contains("bufferView")) {
      has_sparse_ = true;
      return;
    }
    const Accessor read = file_.read_accessor(accessor);
    if (read.size != 2 || read.numbers.size() / 2 != vertices.count) {
      file_.refuse(fmt::format("accessor {} has no texture coordinates for {}", accessor,
                               counted(std::int64_t(vertices.count), "vertex", "vertices")));
    }
    std::vector<Uv>& texture = soup_.appearance.texture;
    texture.resize(begin, kNoTexture);
    for (std::size_t c = begin; c < soup_.corners.size(); ++c) {
      const double* uv = read.numbers.data() + 2 * (std::size_t(soup_.corners[c]) - vertices.first);
      texture.push_back({uv[0], 1 - uv[1]});
    }
  }

  /// Corners of primitives without texture coordinates have none. Names what else could paint the surface.
  void finish_appearance() {
    std::vector<Uv>& texture = soup_.appearance.texture;
    std::ranges::none_of(texture, is_finite) ? texture.clear() : texture.resize(soup_.corners.size(), kNoTexture);
    std::vector<std::string>& unread = soup_.appearance.unread;
    if (has_sparse_) unread.emplace_back("sparse texture coordinates");
    if (has_second_set_) unread.emplace_back("the second texture coordinates");
    if (!file_.array("images").empty()) unread.emplace_back(kUnreadImages);
    if (file_.array("materials").size() > 1) unread.emplace_back("materials");
    if (std::ranges::find(file_.array("extensionsUsed"), Json(kTextureTransform)) !=
        file_.array("extensionsUsed").end())
      unread.emplace_back("transforms of texture coordinates");
  }

  std::vector<double> read_indices(const Json& primitive, std::size_t vertices) {
    if (primitive.contains("indices")) {
      const std::size_t accessor = file_.number(primitive, "indices");
      Accessor indices = file_.read_accessor(accessor);
      if (indices.size == 1) return std::move(indices.numbers);
      file_.refuse(fmt::format("accessor {} has vectors of {} numbers, and indices are single numbers; {}", accessor,
                               indices.size, kExportAgain));
    }
    file_.spend(std::uint64_t(vertices) * sizeof(double));
    std::vector<double> all(vertices);
    std::iota(all.begin(), all.end(), 0.0);
    return all;
  }

  /// Refuses corners that are no whole triangles: some of them are lost.
  void check_corners(std::size_t corners, std::size_t mode, std::size_t mesh) const {
    if (mode == kTriangleList ? corners % 3 == 0 : corners == 0 || corners > 2) return;
    constexpr std::array<const char*, 3> kNames{"list", "strip", "fan"};
    file_.refuse(fmt::format("mesh {} has a {} of triangles with {}, of which the last triangle lacks some; {}", mesh,
                             kNames.at(mode - kTriangleList), counted(std::int64_t(corners), "corner", "corners"),
                             kExportAgain));
  }

  double require_vertex(double corner, std::size_t count) const {
    if (corner >= 0 && corner < double(count) && corner == std::floor(corner)) return corner;
    file_.refuse(fmt::format("an index is {}, and there are {}", corner, counted(count, "vertex", "vertices")));
  }

  void add_positions(std::size_t accessor, const Transform& transform) {
    const Accessor read = file_.read_accessor(accessor);
    if (read.size != 3) {
      file_.refuse(fmt::format("positions have {}, and three are needed; {}",
                               counted(std::int64_t(read.size), "coordinate", "coordinates"), kExportAgain));
    }
    check_counts(soup_.positions.size() + read.numbers.size() / 3, 0, file_.name());
    for (std::size_t i = 0; i < read.numbers.size(); i += 3) {
      const Eigen::Vector4d p =
          transform * Eigen::Vector4d(read.numbers[i], read.numbers[i + 1], read.numbers[i + 2], 1);
      const auto v = std::ssize(soup_.positions);
      if (!p.allFinite()) {
        throw Error(ErrorCode::precondition,
                    fmt::format("{}: a coordinate of vertex {} is not a finite number", file_.name(), v), v);
      }
      soup_.positions.emplace_back(p.head<3>());
    }
  }

  /// Triangle i of a list, a strip or a fan. A transform that mirrors turns the triangles round.
  void add_triangles(const std::vector<double>& corners, std::size_t mode, bool is_mirrored) {
    const std::size_t step = mode == kTriangleList ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      const bool is_turned = mode == kTriangleStrip && i % 2 == 1;
      std::array<std::size_t, 3> triangle{mode == kTriangleFan ? 0 : i, i + 1, i + 2};
      if (is_turned != is_mirrored) std::swap(triangle[1], triangle[2]);
      for (const std::size_t k : triangle) soup_.corners.push_back(static_cast<std::int32_t>(corners[k]));
      soup_.close_polygon();
    }
    check_counts(0, soup_.polygon_count(), file_.name());
  }

  GltfFile file_;
  std::vector<char> visited_;  // nodes
  std::int64_t left_out_ = 0;
  bool has_sparse_ = false, has_second_set_ = false;  // of texture coordinates
  PolygonSoup soup_;
};

/// The result of `work`, which reads the description of a file.
template <class Work>
auto name_errors(std::string_view name, const Work& work) {
  try {
    return work();
  } catch (const Json::exception& error) {  // a member is missing or has another type
    const std::string_view what(error.what());
    const std::size_t end_of_code = what.find("] ");  // "[json.exception.type_error.302] type must be ..."
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: the scene's description is damaged, a member is missing or has a wrong type ({}); "
                            "export the file again",
                            name, printable(what.substr(end_of_code == what.npos ? 0 : end_of_code + 2), 120)));
  }
}

}  // namespace

PolygonSoup parse_gltf(std::string_view bytes, std::string_view name,
                       const std::optional<std::filesystem::path>& folder) {
  return name_errors(name, [&] { return GltfParser(bytes, name, folder).parse(); });
}

std::vector<std::filesystem::path> list_gltf_files(std::string_view bytes, std::string_view name) {
  return name_errors(name, [&] { return GltfFile(bytes, name, std::nullopt).other_files(); });
}

}  // namespace gvd
