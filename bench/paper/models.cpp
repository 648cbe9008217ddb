// The meshes of the evaluation: a mesh that stands for each model of the paper, and variants of it.
//
// A mesh is resampled if its number of faces differs from the paper's by more than 3 %, since times grow with it.
// Variants have the same surface with worse triangles, as in table 3: edges are collapsed by quadric errors (Garland
// and Heckbert 1997), or vertices are moved towards random neighbours. Moves and collapses that fold the surface are
// left out. Remeshers take an edge length and not a number of faces: the length is searched, at most kMostTries times.
// Equal seeds give equal meshes.
#include "models.hpp"

#include <fmt/format.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "baseline.hpp"
#include "command_line.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/openmesh.hpp"
#include "gvd/quality.hpp"
#include "remesh_isotropic.hpp"
#ifdef GVD_HAS_PEERS
#include "peers.hpp"
#endif

namespace gvd::paper {

using Corners = std::array<VertexId, 3>;

std::string Models::find_path(const Wanted& wanted) const {
  for (const std::string& file : wanted.files) {
    for (const std::string& folder : folders_) {
      for (const char* extension : {"obj", "off", "ply", "stl"}) {
        std::string path = fmt::format("{}/{}.{}", folder, file, extension);
        if (std::filesystem::exists(path)) return path;
      }
    }
  }
  return GVD_SOURCE_DIR "/data/figure.obj";
}

FoundMesh Models::find(const Wanted& wanted) const {
  const std::string path = find_path(wanted);
  const std::string file = std::filesystem::path(path).filename().string();
  Mesh mesh = bench::read_named_mesh(path).mesh;
  const int faces = static_cast<int>(scale_ * (wanted.faces == 0 ? mesh.face_count() : wanted.faces));
  const bool is_near = std::abs(mesh.face_count() - faces) <= kFacesTolerance * faces;
  if (is_near || compute_mesh_summary(mesh).boundary_loops > 0) return {file, std::move(mesh)};
  return {fmt::format("{}, resampled", file), resample(mesh, faces)};
}

namespace {

constexpr int kRemeshRounds = 6;
/// Edges end a little shorter than asked for: measured on kitten, 10k to 60k faces.
constexpr double kEdgeLengthFactor = 1.07;

/// What a try found: logarithms of the edge length and of the number of faces over the wanted one.
struct Try {
  double length = 0;
  double excess = 0;
};

/// The next length to try. Between a try with too many faces and one with too few, the line through both says; else as
/// if the number went with the square of the length.
double predict_length(const Try& last, const std::optional<Try>& many, const std::optional<Try>& few) {
  if (!many || !few) return last.length + 0.5 * last.excess;
  const double share = many->excess / (many->excess - few->excess);
  return many->length + std::clamp(share, 0.1, 0.9) * (few->length - many->length);
}

}  // namespace

Mesh search_edge_length(const Remesher& remesh, double area, int faces) {
  double length = std::log(kEdgeLengthFactor * std::sqrt(4 / std::sqrt(3.0) * area / faces));
  std::optional<Try> many, few;
  std::optional<Mesh> nearest;
  double least = 0;
  for (int i = 0; i < kMostTries; ++i) {
    Mesh mesh = remesh(std::exp(length));
    const double excess = std::log(double(mesh.face_count()) / faces);
    if (!nearest || std::abs(excess) < least) {
      least = std::abs(excess);
      nearest = std::move(mesh);
    }
    if (std::abs(nearest->face_count() - faces) <= kFacesTolerance * faces) break;
    const Try last{length, excess};
    (excess > 0 ? many : few) = last;
    length = predict_length(last, many, few);
  }
  return *std::move(nearest);
}

Mesh resample(const Mesh& mesh, int faces) {
  const MeshSummary summary = compute_mesh_summary(mesh);
  if (summary.boundary_loops > 0) throw Error(ErrorCode::precondition, "only closed meshes are resampled");
  data::Triangles input{mesh.positions(), {}};
  for (const auto& [a, b, c] : mesh.face_vertices()) input.faces.push_back({a.value(), b.value(), c.value()});
  const ClosestPointTree tree(mesh);
  const auto project = [&](const Vec3& p) { return position(mesh, tree.query(p).point); };
  const auto remesh = [&](double edge_length) {
    const data::Triangles output = data::remesh_isotropic(input, edge_length, kRemeshRounds, project);
    std::vector<Corners> corners;
    for (const auto& [a, b, c] : output.faces) corners.push_back({VertexId(a), VertexId(b), VertexId(c)});
    return Mesh(output.positions, std::move(corners));
  };
  return search_edge_length(remesh, summary.area, faces);
}

#ifdef GVD_HAS_PEERS
bool has_cgal_remeshing() { return true; }

Mesh remesh_with_cgal(const Mesh& mesh, int faces) {
  const MeshSummary summary = compute_mesh_summary(mesh);
  if (summary.boundary_loops > 0) throw Error(ErrorCode::precondition, "only closed meshes are remeshed");
  const auto remesh = [&](double length) { return bench::remesh_isotropically(mesh, length, kRemeshRounds); };
  return search_edge_length(remesh, summary.area, faces);
}
#else
bool has_cgal_remeshing() { return false; }

Mesh remesh_with_cgal(const Mesh&, int) {
  throw Error(ErrorCode::precondition, "this build has no CGAL: configure with -DGVD_WITH_CGAL_GPL=ON");
}
#endif

namespace {

struct Traits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Traits>;

constexpr double kMostTurn = 60;  // degrees

}  // namespace

Mesh decimate(const Mesh& mesh, int faces) {
  using Decimater = OpenMesh::Decimater::DecimaterT<Surface>;
  auto surface = to_openmesh<Surface>(mesh);
  surface.update_face_normals();
  Decimater decimater(surface);
  OpenMesh::Decimater::ModQuadricT<Surface>::Handle error;
  decimater.add(error);
  decimater.module(error).unset_max_err();
  OpenMesh::Decimater::ModNormalFlippingT<Surface>::Handle turn;
  decimater.add(turn);
  decimater.module(turn).set_max_normal_deviation(kMostTurn);
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
  surface.garbage_collection();
  return from_openmesh(surface);
}

namespace {

/// The jitter's step is at most this part of the way to a neighbour.
constexpr double kLongestStep = 0.45;
constexpr double kLeastQ = 0.1;
/// A round in so many parts ends within a few percent of the share asked for.
constexpr std::size_t kJitterParts = 8;
constexpr double kLeastCosine = 0.5;

/// The normal of a face, twice as long as its area.
Vec3 normal(const std::vector<Vec3>& positions, const Corners& corners) {
  const auto& [a, b, c] = corners;
  const Vec3& origin = positions[a.index()];
  return (positions[b.index()] - origin).cross(positions[c.index()] - origin);
}

/// The positions of a mesh, moved one by one, each by a part of the way to a neighbour. Faces and edges stay, so that
/// only shapes become worse.
class Jitter {
 public:
  Jitter(const Mesh& mesh, std::uint64_t seed)
      : positions_(mesh.positions()), faces_(positions_.size()), random_(seed) {
    for (const Corners& corners : mesh.face_vertices()) {
      for (const VertexId v : corners) faces_[v.index()].push_back(corners);
    }
  }

  /// Moves every `step`th vertex from `first` on.
  void move_some(std::size_t first, std::size_t step) {
    for (std::size_t v = first; v < positions_.size(); v += step) move(v);
  }

  const std::vector<Vec3>& positions() const { return positions_; }

 private:
  /// Not a distribution of the standard library: those differ between platforms.
  double draw() { return double(random_() >> 11) * 0x1p-53; }

  void move(std::size_t v) {
    const Corners& face = faces_[v][random_() % faces_[v].size()];
    const Vec3 target = positions_[face[random_() % 3].index()];
    const Vec3 before = positions_[v];
    std::vector<Vec3> normals;
    for (const Corners& corners : faces_[v]) normals.push_back(normal(positions_, corners));
    positions_[v] += kLongestStep * draw() * (target - before);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (!is_allowed(faces_[v][i], normals[i])) positions_[v] = before;
    }
  }

  /// Whether a moved triangle is neither folded over nor a needle.
  bool is_allowed(const Corners& corners, const Vec3& normal_before) const {
    const Vec3 now = normal(positions_, corners);
    if (now.dot(normal_before) < kLeastCosine * now.norm() * normal_before.norm()) return false;
    const auto& [a, b, c] = corners;
    return compute_q(positions_[a.index()], positions_[b.index()], positions_[c.index()]) >= kLeastQ;
  }

  std::vector<Vec3> positions_;
  std::vector<std::vector<Corners>> faces_;  ///< per vertex
  std::mt19937_64 random_;
};

}  // namespace

Mesh jitter(const Mesh& mesh, double percent_below_30, std::uint64_t seed) {
  Jitter jitter(mesh, seed);
  Mesh moved = mesh;
  for (std::size_t part = 0; part < kMostJitterRounds * kJitterParts; ++part) {
    if (compute_triangle_quality(moved).percent_below_30 >= percent_below_30) break;
    jitter.move_some(part % kJitterParts, kJitterParts);
    moved = Mesh(jitter.positions(), mesh.face_vertices());
  }
  return moved;
}

namespace {

/// Twenty regular triangles: the corners of three golden rectangles.
Mesh make_icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;  // the golden ratio
  std::vector<Vec3> positions{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  constexpr std::array<std::array<int, 3>, 20> kFaces{{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                       {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                       {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                       {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
  std::vector<Corners> faces;
  for (const auto& [a, b, c] : kFaces) faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return Mesh(std::move(positions), std::move(faces));
}

Mesh push_to_sphere(const Mesh& mesh) {
  std::vector<Vec3> positions = mesh.positions();
  for (Vec3& p : positions) p = p / p.norm();
  return Mesh(std::move(positions), mesh.face_vertices());
}

}  // namespace

Mesh make_icosphere(int subdivisions) {
  Mesh sphere = push_to_sphere(make_icosahedron());
  for (int i = 0; i < subdivisions; ++i) sphere = push_to_sphere(bench::refine_flat(sphere));
  return sphere;
}

}  // namespace gvd::paper
