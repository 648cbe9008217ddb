#include "io/view/view_data.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "gvd/error.hpp"
#include "gvd/io/label_color.hpp"
#include "io/view/view_triangulate.hpp"

namespace gvd::io {
namespace {

using nlohmann::json;

// A face's colour code in the page: 0 where nothing reaches it, 1 where its pieces are drawn instead, 2 + label else.
constexpr std::uint32_t kUnreachedCode = 0;
constexpr std::uint32_t kCutCode = 1;
constexpr std::uint32_t kFirstLabelCode = 2;

/// Largest label that the page can tell apart: codes travel through 32-bit floats, which are exact below 2^24.
constexpr std::int32_t kLargestLabel = (1 << 24) - 3;

std::uint32_t code_of(GeneratorId label) {
  return label.valid() ? kFirstLabelCode + static_cast<std::uint32_t>(label.value()) : kUnreachedCode;
}

void check_size(const std::string& what, std::size_t size, std::int32_t wanted) {
  if (size != 0 && size != static_cast<std::size_t>(wanted)) {
    throw Error(ErrorCode::precondition, "the view has " + std::to_string(size) + " " + what + " for a mesh with " +
                                             std::to_string(wanted) + "; give one for each, or none");
  }
}

void check_labels(const ViewScene& scene) {
  const auto check = [&](GeneratorId label, std::int64_t face) {
    const bool known = scene.cells.empty() || label.value() < static_cast<std::int64_t>(scene.cells.size());
    if (!known || label.value() > kLargestLabel) {
      throw Error(ErrorCode::precondition,
                  "face " + std::to_string(face) + " of the view has label " + std::to_string(label.value()) +
                      ", which has no cell",
                  face);
    }
  };
  for (std::size_t f = 0; f < scene.face_label.size(); ++f) check(scene.face_label.raw()[f], std::int64_t(f));
  for (const FacePiece& piece : scene.pieces) check(piece.generator, piece.face.value());
}

void check_pieces(const ViewScene& scene) {
  for (const FacePiece& piece : scene.pieces) {
    if (!piece.face.valid() || piece.face.value() >= scene.mesh->face_count()) {
      throw Error(ErrorCode::precondition,
                  "a piece of the view lies in face " + std::to_string(piece.face.value()) + ", which is not there",
                  piece.face.value());
    }
    for (const auto& corner : piece.corners) {
      if (!std::isfinite(corner[0]) || !std::isfinite(corner[1]) || !std::isfinite(corner[2])) {
        throw Error(
            ErrorCode::precondition,
            "a piece of face " + std::to_string(piece.face.value()) + " of the view has a corner that is no number",
            piece.face.value());
      }
    }
  }
}

void check_finite(const char* what, const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      throw Error(ErrorCode::precondition, std::string(what) + " " + std::to_string(i) + " of the view is not finite",
                  std::int64_t(i));
    }
  }
}

class SceneEncoder {
 public:
  SceneEncoder(const ViewScene& scene, const ViewFrame& frame, ViewBlobs& blobs)
      : scene_(scene), frame_(frame), blobs_(blobs) {}

  json run() {
    json entry;
    entry["name"] = scene_.name;
    entry["wireframe"] = scene_.wireframe;
    entry["smooth"] = scene_.smooth;
    entry["positions"] = points(scene_.mesh->positions());
    entry["faces"] = faces();
    if (!scene_.vertex_distance.empty()) entry["distances"] = distances();
    if (!scene_.face_label.empty() || !scene_.pieces.empty()) entry["codes"] = codes();
    if (entry.contains("codes")) entry["fills"] = fills();
    if (!scene_.pieces.empty()) entry["pieces"] = pieces();
    if (!scene_.bisectors.empty()) entry["bisectors"] = bisectors();
    if (!scene_.generators.empty()) entry["generators"] = points(scene_.generators);
    if (!scene_.added_generators.empty()) entry["added_generators"] = points(scene_.added_generators);
    if (!scene_.branch_points.empty()) entry["branch_points"] = points(scene_.branch_points);
    entry["cells"] = cells();
    entry["figures"] = figures();
    return entry;
  }

 private:
  json points(const std::vector<Vec3>& given) {
    std::vector<float> values;
    values.reserve(3 * given.size());
    for (const Vec3& p : given) append(values, p);
    return blobs_.add_floats(values);
  }

  void append(std::vector<float>& values, const Vec3& p) const {
    for (int i = 0; i < 3; ++i) values.push_back(static_cast<float>((p[i] - frame_.origin[i]) / frame_.scale));
  }

  json faces() {
    std::vector<std::uint32_t> corners;
    corners.reserve(static_cast<std::size_t>(scene_.mesh->halfedge_count()));
    for (int f = 0; f < scene_.mesh->face_count(); ++f) {
      for (const VertexId v : scene_.mesh->vertices(FaceId(f)))
        corners.push_back(static_cast<std::uint32_t>(v.value()));
    }
    return blobs_.add_integers(corners);
  }

  json distances() {
    std::vector<float> values;
    values.reserve(scene_.vertex_distance.size());
    for (const double d : scene_.vertex_distance) values.push_back(static_cast<float>(d / frame_.scale));
    return blobs_.add_floats(values);
  }

  json codes() {
    std::vector<std::uint32_t> codes(static_cast<std::size_t>(scene_.mesh->face_count()), kUnreachedCode);
    for (std::size_t f = 0; f < scene_.face_label.size(); ++f) codes[f] = code_of(scene_.face_label.raw()[f]);
    for (const FacePiece& piece : scene_.pieces) codes[piece.face.index()] = kCutCode;
    return blobs_.add_integers(codes);
  }

  /// Red, green and blue of every label that occurs.
  json fills() {
    std::int64_t labels = static_cast<std::int64_t>(scene_.cells.size());
    for (const GeneratorId label : scene_.face_label) labels = std::max<std::int64_t>(labels, label.value() + 1);
    for (const FacePiece& piece : scene_.pieces) labels = std::max<std::int64_t>(labels, piece.generator.value() + 1);
    std::vector<std::uint32_t> channels;
    for (std::int64_t label = 0; label < labels; ++label) {
      const Rgb color = label_color(GeneratorId(label));
      channels.insert(channels.end(), {color.red, color.green, color.blue});
    }
    return blobs_.add_integers(channels);
  }

  /// Corners by two of their barycentric coordinates, triangles by indices of their piece's corners.
  json pieces() {
    std::vector<std::uint32_t> faces, codes, corner_counts, triangle_counts, triangles;
    std::vector<float> corners;
    for (const FacePiece& piece : scene_.pieces) {
      std::vector<Vec2> polygon;
      for (const auto& b : piece.corners) {
        polygon.emplace_back(b[1], b[2]);
        corners.push_back(static_cast<float>(b[1]));
        corners.push_back(static_cast<float>(b[2]));
      }
      const auto clipped = triangulate_polygon(polygon);
      for (const auto& triangle : clipped) triangles.insert(triangles.end(), triangle.begin(), triangle.end());
      faces.push_back(static_cast<std::uint32_t>(piece.face.value()));
      codes.push_back(code_of(piece.generator));
      corner_counts.push_back(static_cast<std::uint32_t>(polygon.size()));
      triangle_counts.push_back(static_cast<std::uint32_t>(clipped.size()));
    }
    return {{"faces", blobs_.add_integers(faces)},
            {"codes", blobs_.add_integers(codes)},
            {"corner_counts", blobs_.add_integers(corner_counts)},
            {"corners", blobs_.add_floats(corners)},
            {"triangle_counts", blobs_.add_integers(triangle_counts)},
            {"triangles", blobs_.add_integers(triangles)}};
  }

  json bisectors() {
    std::vector<float> values;
    std::vector<std::uint32_t> counts;
    for (const std::vector<Vec3>& polyline : scene_.bisectors) {
      for (const Vec3& p : polyline) append(values, p);
      counts.push_back(static_cast<std::uint32_t>(polyline.size()));
    }
    return {{"points", blobs_.add_floats(values)}, {"counts", blobs_.add_integers(counts)}};
  }

  json cells() const {
    json list = json::array();
    for (const Cell& cell : scene_.cells) {
      json neighbours = json::array();
      for (const GeneratorId g : cell.neighbours) neighbours.push_back(g.value());
      list.push_back({{"area", cell.area},
                      {"euler_characteristic", cell.euler_characteristic},
                      {"neighbours", std::move(neighbours)}});
    }
    return list;
  }

  json figures() const {
    json list = json::array();
    for (const ViewFigure& figure : scene_.figures) list.push_back({figure.name, figure.value});
    return list;
  }

  const ViewScene& scene_;
  const ViewFrame& frame_;
  ViewBlobs& blobs_;
};

}  // namespace

void check_view_scene(const ViewScene& scene) {
  if (scene.mesh == nullptr || scene.mesh->face_count() == 0) {
    throw Error(ErrorCode::precondition, "a scene of the view has no faces; give each a mesh");
  }
  check_size("face labels", scene.face_label.size(), scene.mesh->face_count());
  check_size("vertex distances", scene.vertex_distance.size(), scene.mesh->vertex_count());
  check_pieces(scene);
  check_labels(scene);
  check_finite("generator", scene.generators);
  check_finite("added generator", scene.added_generators);
  check_finite("branch point", scene.branch_points);
  for (const std::vector<Vec3>& polyline : scene.bisectors) check_finite("a bisector's point", polyline);
}

ViewFrame compute_view_frame(const std::vector<ViewScene>& scenes) {
  Vec3 low = scenes.front().mesh->positions().front(), high = low;
  for (const ViewScene& scene : scenes) {
    for (const Vec3& p : scene.mesh->positions()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  // Halved before they are added: the sum of two large coordinates may overflow.
  const Vec3 half = high / 2 - low / 2;
  const double radius = half.stableNorm();
  return {low / 2 + high / 2, radius > 0 && std::isfinite(radius) ? radius : 1};
}

json make_scene_entry(const ViewScene& scene, const ViewFrame& frame, ViewBlobs& blobs) {
  return SceneEncoder(scene, frame, blobs).run();
}

}  // namespace gvd::io
