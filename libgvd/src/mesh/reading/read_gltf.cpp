// Reads glTF 2.0: the triangles of a scene, placed by the transforms of its nodes.
//
// A scene is a forest of nodes; a node may have a mesh, a mesh has primitives, and a primitive is a list of triangles
// with accessors for positions and indices (gltf_file.hpp). A vertex with several normals or materials occurs several
// times, so the soup is marked as unwelded, like the soup of an STL. The first set of texture coordinates is read, too;
// its v runs downwards. Other attributes, materials, skins, morph targets and animations are ignored, so the surface
// has the stored positions.
// Source: Khronos, glTF 2.0 (ISO/IEC 12113), sections 3.5 and 3.7.
// Invariant: every node is visited at most once, and the size of each primitive is counted before memory is allocated
// for it.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/gltf_file.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

using Json = nlohmann::json;
using Transform = Eigen::Matrix4d;

constexpr std::size_t kTriangleList = 4, kTriangleStrip = 5, kTriangleFan = 6;  // primitive.mode

/// How far the last row of a matrix may differ from 0 0 0 1. Absolute; products of matrices of 32-bit floats are at
/// least that accurate.
constexpr double kAffine = 1e-5;

/// The extension that compresses single primitives.
constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// Prefixes of the names of extensions that only say how triangles are painted, lit or described. A mesh that requires
/// any other extension may be compressed, or placed differently.
constexpr std::array<std::string_view, 12> kHarmless{
    "KHR_materials_", "EXT_materials_",        "ADOBE_materials_",      "KHR_texture_",
    "EXT_texture_",   "MSFT_texture_dds",      "KHR_lights_",           "EXT_lights_",
    "KHR_xmp",        "KHR_animation_pointer", "KHR_mesh_quantization", "FB_ngon_encoding"};
constexpr std::string_view kTextureTransform = "KHR_texture_transform";

/// Collects the triangles of a file's scene.
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

  /// The roots of the scene. A file without scenes has all nodes without a parent as roots; in a file without nodes,
  /// every mesh is placed once.
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

  /// The transform of node n: a matrix, stored by columns, or a translation, a rotation as quaternion (x, y, z, w) and
  /// a scale.
  Transform transform_of(const Json& node, std::size_t n) const {
    const auto matrix = node.find("matrix");
    if (matrix != node.end()) {
      const Transform made(matrix->get<std::array<double, 16>>().data());
      if (matrix->size() > 16 || !((made.row(3) - Transform::Identity().row(3)).cwiseAbs().maxCoeff() <= kAffine)) {
        file_.refuse(
            fmt::format("node {} has a matrix of {} that is not an affine transform: it needs 16, and the "
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

  /// A member of node n that is a list of kCount numbers, or `otherwise` if it is missing.
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
    std::map<std::size_t, std::size_t> first_vertex;  // the first vertex of each accessor of positions
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
      for (double& corner : corners) {
        if (!(corner >= 0 && corner < double(count) && corner == std::floor(corner))) {
          file_.refuse(fmt::format("an index is {}, and there are {}", corner, counted(count, "vertex", "vertices")));
        }
        corner += double(known->second);
      }
      const std::size_t begin = soup_.corners.size();
      add_triangles(corners, mode, transform.topLeftCorner<3, 3>().determinant() < 0);
      add_texture(primitive.at("attributes"), begin, {known->second, count});
    }
  }

  /// The vertices of a primitive.
  struct Vertices {
    std::size_t first, count;
  };

  /// Adds texture coordinates for the corners from `begin` on.
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

  /// Fills in the corners of primitives without texture coordinates, and notes which other attributes could paint the
  /// surface.
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

  /// Refuses a number of corners that does not make whole triangles, because some corners must be missing.
  void check_corners(std::size_t corners, std::size_t mode, std::size_t mesh) const {
    if (mode == kTriangleList ? corners % 3 == 0 : corners == 0 || corners > 2) return;
    constexpr std::array<const char*, 3> kNames{"list", "strip", "fan"};
    file_.refuse(fmt::format("mesh {} has a {} of triangles with {}, of which the last triangle lacks some; {}", mesh,
                             kNames.at(mode - kTriangleList), counted(std::int64_t(corners), "corner", "corners"),
                             kExportAgain));
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

  /// Adds the triangles of a list, a strip or a fan. A transform that mirrors reverses them.
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
  std::vector<char> visited_;  // whether each node was visited
  std::int64_t left_out_ = 0;
  bool has_sparse_ = false, has_second_set_ = false;  // of texture coordinates
  PolygonSoup soup_;
};

/// Returns the result of `work`, which reads the description of a file, and turns exceptions of the JSON library into
/// Error.
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
