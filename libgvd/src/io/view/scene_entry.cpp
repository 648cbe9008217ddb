// Encodes a scene for the page: an entry of JSON that refers to arrays of numbers.
//
// Arrays are little-endian, deflated and in Base64; integers have the narrowest width that holds them. Equal arrays are
// stored once, so scenes of the same mesh share its arrays. Positions are relative to a frame around all scenes, so
// that 32-bit floats suffice for a mesh of any size and place. Positions and the corners of pieces make up most of a
// page, and are rounded to what a screen can show.
// Pieces of cut faces are triangulated here, so that the page draws what it reads and needs no geometry of its own.
// Invariant: equal scenes give equal bytes; docs/developer/viewer.md lists the members of an entry.
#include "io/view/scene_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/barycentric.hpp"
#include "base/ear_clipping.hpp"
#include "io/view/view_blobs.hpp"
#include "io/writers/byte_writer.hpp"

namespace gvd::io {
namespace {

/// Triangles up to this doubled area, in barycentric coordinates, are left out. It is 1e-14 of the face's doubled area,
/// about a hundred times the rounding error of products of coordinates in [0, 1].
constexpr double kShareLeftOut = 1e-14;

using nlohmann::json;

// Colour code of a face in the page: 0 if no generator reaches it, 1 if its pieces are drawn instead, else 2 + label.
constexpr std::uint32_t kUnreachedCode = 0;
constexpr std::uint32_t kCutCode = 1;
constexpr std::uint32_t kFirstLabelCode = 2;

/// Distances on lattices have 16 bits, so that a scale of 256 colours has 256 steps for each colour.
constexpr double kLatticeParts = 65535;

std::uint32_t code_of(GeneratorId label) {
  return label.valid() ? kFirstLabelCode + std::uint32_t(label.value()) : kUnreachedCode;
}

class SceneEncoder {
 public:
  SceneEncoder(const ViewScene& scene, const std::vector<Rgb>& colors, const ViewFrame& frame, ViewBlobs& blobs)
      : scene_(scene), colors_(colors), frame_(frame), blobs_(blobs) {}

  json run() {
    json entry;
    entry["name"] = scene_.name;
    if (scene_.iteration) entry["iteration"] = *scene_.iteration;
    entry["wireframe"] = scene_.wireframe;
    entry["smooth"] = scene_.smooth;
    entry["positions"] = points(scene_.mesh->positions());
    entry["faces"] = faces(*scene_.mesh);
    if (!scene_.vertex_distance.empty()) entry["distances"] = distances(scene_.vertex_distance);
    if (!scene_.face_label.empty() || !scene_.pieces.empty()) entry["codes"] = codes();
    if (entry.contains("codes")) entry["fills"] = fills();
    if (!scene_.pieces.empty()) entry["pieces"] = pieces();
    if (!scene_.bisectors.empty()) entry["bisectors"] = polylines(scene_.bisectors);
    if (!scene_.borders.empty()) entry["borders"] = polylines(scene_.borders);
    if (!scene_.isolines.empty()) entry["isolines"] = polylines(scene_.isolines);
    if (!scene_.paths.empty()) entry["paths"] = polylines(scene_.paths);
    if (!scene_.vertex_paths.vertices.empty()) entry["vertex_paths"] = vertex_paths();
    if (!scene_.generators.empty()) entry["generators"] = points(scene_.generators);
    if (!scene_.added_generators.empty()) entry["added_generators"] = points(scene_.added_generators);
    if (!scene_.branch_points.empty()) entry["branch_points"] = points(scene_.branch_points);
    if (!scene_.texture.empty()) entry["texture"] = texture();
    if (scene_.surface_distance) entry["surface_distance"] = surface_distance(*scene_.surface_distance);
    if (scene_.overlay) entry["overlay"] = overlay(*scene_.overlay);
    if (!scene_.vertex_generators.empty()) entry["vertex_generators"] = points(scene_.vertex_generators);
    entry["cells"] = cells();
    entry["figures"] = figures();
    return entry;
  }

 private:
  json points(const std::vector<Vec3>& given) {
    std::vector<double> values;
    values.reserve(3 * given.size());
    for (const Vec3& p : given) append(values, p);
    return blobs_.add_coordinates(values);
  }

  void append(std::vector<double>& values, const Vec3& p) const {
    for (int i = 0; i < 3; ++i) values.push_back((p[i] - frame_.origin[i]) / frame_.scale);
  }

  json faces(const Mesh& mesh) {
    std::vector<std::uint32_t> corners;
    corners.reserve(mesh.halfedge_count());
    for (const FaceId f : mesh.faces()) {
      for (const VertexId v : mesh.vertices(f)) corners.push_back(std::uint32_t(v.value()));
    }
    return blobs_.add_integers(corners);
  }

  json distances(const IdVector<VertexId, double>& given) {
    std::vector<float> values;
    values.reserve(given.size());
    for (const double d : given) values.push_back(float(d / frame_.scale));
    return blobs_.add_floats(values);
  }

  /// Three numbers for each corner, because the page reads coordinates in threes; the third is 0. Numbers that are not
  /// finite become 0, too.
  json texture() {
    std::vector<double> values;
    for (const Uv& uv : scene_.texture) {
      const bool is_placed = is_finite(uv);
      values.insert(values.end(), {is_placed ? uv[0] : 0, is_placed ? uv[1] : 0, 0});
    }
    return blobs_.add_coordinates(values);
  }

  /// The values of the lattice as multiples of a 65535th of the largest value.
  json surface_distance(const ViewSurfaceDistance& given) {
    json entry{{"other", given.other},
               {"reference", given.reference},
               {"scale_end", given.scale_end},
               {"vertices", distances(given.samples.at_vertex)}};
    const std::vector<double>& lattice = given.samples.lattice;
    if (lattice.empty()) return entry;
    const double largest = *std::max_element(lattice.begin(), lattice.end());
    std::vector<std::uint32_t> steps, values;
    for (const std::int32_t k : given.samples.steps) steps.push_back(std::uint32_t(k));
    for (const double d : lattice) {
      values.push_back(largest > 0 ? std::uint32_t(std::lround(kLatticeParts * (d / largest))) : 0);
    }
    entry["steps"] = blobs_.add_integers(steps);
    entry["lattice"] = blobs_.add_integers(values);
    entry["lattice_unit"] = largest / kLatticeParts;
    return entry;
  }

  json overlay(const ViewOverlay& given) {
    return {{"name", given.name}, {"positions", points(given.mesh->positions())}, {"faces", faces(*given.mesh)}};
  }

  json codes() {
    IdVector<FaceId, std::uint32_t> codes(scene_.mesh->face_count(), kUnreachedCode);
    for (const FaceId f : scene_.face_label.ids()) codes[f] = code_of(scene_.face_label[f]);
    for (const FacePiece& piece : scene_.pieces) codes[piece.face] = kCutCode;
    return blobs_.add_integers(codes.raw());
  }

  /// Red, green and blue of every label that occurs.
  json fills() {
    std::vector<std::uint32_t> channels;
    for (const Rgb& color : colors_) channels.insert(channels.end(), {color.red, color.green, color.blue});
    return blobs_.add_integers(channels);
  }

  /// Stores corners as two of their barycentric coordinates, and triangles as indices into the corners of their piece.
  json pieces() {
    std::vector<std::uint32_t> faces, codes, corner_counts, triangle_counts, triangles;
    std::vector<double> corners;
    for (const FacePiece& piece : scene_.pieces) {
      std::vector<Vec2> polygon;
      for (const auto& b : piece.corners) {
        polygon.push_back(affine_point(b));
        corners.insert(corners.end(), {b[1], b[2]});
      }
      const auto clipped = triangulate_polygon(polygon);
      for (const auto& triangle : clipped) triangles.insert(triangles.end(), triangle.begin(), triangle.end());
      faces.push_back(std::uint32_t(piece.face.value()));
      codes.push_back(code_of(piece.generator));
      corner_counts.push_back(std::uint32_t(polygon.size()));
      triangle_counts.push_back(std::uint32_t(clipped.size()));
    }
    return {{"faces", blobs_.add_integers(faces)},
            {"codes", blobs_.add_integers(codes)},
            {"corner_counts", blobs_.add_integers(corner_counts)},
            {"corners", blobs_.add_shares(corners)},
            {"triangle_counts", blobs_.add_integers(triangle_counts)},
            {"triangles", blobs_.add_integers(triangles)}};
  }

  json vertex_paths() {
    json entry = polylines(scene_.vertex_paths.points);
    std::vector<std::uint32_t> vertices;
    for (const VertexId v : scene_.vertex_paths.vertices) vertices.push_back(std::uint32_t(v.value()));
    entry["vertices"] = blobs_.add_integers(vertices);
    return entry;
  }

  json polylines(const std::vector<std::vector<Vec3>>& given) {
    std::vector<double> values;
    std::vector<std::uint32_t> counts;
    for (const std::vector<Vec3>& polyline : given) {
      for (const Vec3& p : polyline) append(values, p);
      counts.push_back(std::uint32_t(polyline.size()));
    }
    return {{"points", blobs_.add_coordinates(values)}, {"counts", blobs_.add_integers(counts)}};
  }

  json cells() const {
    json list = json::array();
    for (const GeneratorId label : scene_.cells.ids()) {
      const Cell& cell = scene_.cells[label];
      json neighbours = json::array();
      for (const GeneratorId g : cell.neighbours) neighbours.push_back(g.value());
      list.push_back({{"area", cell.area},
                      {"euler_characteristic", cell.euler_characteristic},
                      {"neighbours", std::move(neighbours)}});
      if (!scene_.cell_energy.empty()) list.back()["energy"] = scene_.cell_energy[label];
    }
    return list;
  }

  json figures() const {
    json list = json::array();
    for (const ViewFigure& figure : scene_.figures) list.push_back({figure.name, figure.value});
    return list;
  }

  const ViewScene& scene_;
  const std::vector<Rgb>& colors_;
  const ViewFrame& frame_;
  ViewBlobs& blobs_;
};

}  // namespace

ViewFrame compute_view_frame(const std::vector<ViewScene>& scenes) {
  Eigen::AlignedBox3d box;
  const auto include = [&](const Mesh& mesh) {
    for (const Vec3& p : mesh.positions()) box.extend(p);
  };
  for (const ViewScene& scene : scenes) {
    include(*scene.mesh);
    if (scene.overlay) include(*scene.overlay->mesh);
  }
  // Coordinates are halved before they are added, because the sum of two large ones may overflow.
  const Vec3 half = box.max() / 2 - box.min() / 2;
  const double radius = half.stableNorm();
  return {box.min() / 2 + box.max() / 2, radius > 0 && std::isfinite(radius) ? radius : 1};
}

std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& [a, b, c] : triangulate_plane_polygon(corners)) {
    if (twice_signed_area(corners[a], corners[b], corners[c]) <= kShareLeftOut) continue;
    triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
  }
  return triangles;
}

json make_scene_entry(const ViewScene& scene, const std::vector<Rgb>& colors, const ViewFrame& frame,
                      ViewBlobs& blobs) {
  return SceneEncoder(scene, colors, frame, blobs).run();
}

}  // namespace gvd::io
