// Finds the edges of a remesh whose flip improves distance and triangle shapes together.
//
// A dual has an edge wherever two cells meet, however short their bisector is. So vertices with three and four edges
// lie beside others with eight, and edges cross creases that no generator is on. A flip mends both, and moves no
// vertex. Each face takes part in at most one flip, so that any flip can be undone by itself if triangles intersect.
#include "flip_edges.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "dual/flipped_triangles.hpp"
#include "dual/self_intersections.hpp"
#include "gvd/quality.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/vertex_ring.hpp"
#include "raise_angles.hpp"

namespace gvd {
namespace {

/// The least gain of a flip, in units of 1 - Q. Smaller gains are left to the moves of the vertices that follow.
constexpr double kLeastGain = 0.02;

/// A flip after which the triangles lose more than this of Q is dropped before its distances are computed.
constexpr double kMostLost = 0.2;

/// The number of samples of two triangles.
constexpr double kSamples = 18;

struct Flip {
  EdgeFlip edge;
  double gain = 0;
};

class EdgeFlipper {
 public:
  EdgeFlipper(const FlipSearch& search, const Mesh& mesh)
      : search_(search), mesh_(mesh), valence_(mesh.vertex_count(), 0), is_used_(mesh.face_count(), 0) {
    for (const EdgeId e : mesh.edges()) {
      ++valence_[mesh.from(mesh.halfedge(e))];
      ++valence_[mesh.to(mesh.halfedge(e))];
    }
  }

  std::vector<EdgeFlip> run() {
    std::vector<Flip> flips;
    for (const EdgeId e : mesh_.edges()) {
      report_progress(search_.progress, "placement", 1);
      if (may_flip(e)) offer(e, flips);
    }
    std::stable_sort(flips.begin(), flips.end(), [](const Flip& a, const Flip& b) { return a.gain > b.gain; });
    std::vector<EdgeFlip> chosen;
    for (const Flip& flip : flips) {
      if (take(flip.edge)) chosen.push_back(flip.edge);
    }
    drop_intersecting(chosen);
    return chosen;
  }

 private:
  bool may_flip(EdgeId e) const {
    if (mesh_.is_boundary(e)) return false;
    const VertexId a = mesh_.from(mesh_.halfedge(e)), b = mesh_.to(mesh_.halfedge(e));
    const auto follows = [&](VertexId v) { return (*search_.on_crease)[v.index()] || is_held(v); };
    return !follows(a) || !follows(b);
  }

  bool is_held(VertexId v) const { return search_.plan->roles[v.index()] == VertexRole::held; }

  EdgeFlip find_flip(EdgeId e) const {
    const HalfedgeId h = mesh_.halfedge(e), back = mesh_.twin(h);
    return {Mesh::face(h), Mesh::face(back), mesh_.from(h), mesh_.to(h), mesh_.opposite(h), mesh_.opposite(back)};
  }

  void offer(EdgeId e, std::vector<Flip>& flips) const {
    const EdgeFlip flip = find_flip(e);
    const auto old_faces = flip.before(), new_faces = flip.after();
    const std::array<Triangle, 2> was{corners(old_faces.first), corners(old_faces.second)};
    const std::array<Triangle, 2> is{corners(new_faces.first), corners(new_faces.second)};
    const double gain = q(is[0]) + q(is[1]) - q(was[0]) - q(was[1]);
    if (gain < -kMostLost || least_angle(is) < std::min(least_angle(was), kLeastFlippedAngle)) return;
    if (is_flipped(is[0], normal(new_faces.first, flip.left))) return;
    if (is_flipped(is[1], normal(new_faces.second, flip.right))) return;
    const Distances before = measure(was, is), after = measure(is, was);
    const double worth = search_.shape * (is_free(flip) ? 1 : kShapeAtCrease), area = mean_area(flip);
    if (after.largest > before.largest && after.largest > worth * area) return;
    const double all = gain + (before.squares - after.squares) / (worth * area * area);
    if (all > kLeastGain) flips.push_back({flip, all});
  }

  Triangle corners(const std::array<VertexId, 3>& face) const {
    return {mesh_.position(face[0]), mesh_.position(face[1]), mesh_.position(face[2])};
  }
  static double q(const Triangle& t) { return compute_q(t[0], t[1], t[2]); }
  static double least_angle(const std::array<Triangle, 2>& pair) {
    const auto angle = [](const Triangle& t) { return compute_min_angle(t[0], t[1], t[2]); };
    return std::min(angle(pair[0]), angle(pair[1]));
  }

  Vec3 normal(const std::array<VertexId, 3>& face, FaceId f) const {
    Vec3 sum = (*search_.at_faces)[f.index()];
    for (const VertexId v : face) sum += (*search_.at_generators)[v.index()];
    return sum;
  }

  /// Square distances of two triangles and the surface from each other.
  struct Distances {
    double squares = 0;  ///< over the area of the triangles, the mean of both directions
    double largest = 0;
  };

  /// The distances between the surface and `pair`. Samples of `pair` are measured from the surface. The points of the
  /// surface that are nearest to samples of `pair` and of `other` are measured from `pair`; without them, triangles
  /// that cut through a thin part would seem near.
  Distances measure(const std::array<Triangle, 2>& pair, const std::array<Triangle, 2>& other) const {
    const Mesh triangles = make_pair(pair);
    Distances distances;
    for (const auto& [sample, foot] : find_feet(triangles)) {
      add((sample.position - foot).squaredNorm(), sample.area / 2, distances);
      add(square_distance(triangles, foot), sample.area / 4, distances);
    }
    for (const auto& [sample, foot] : find_feet(make_pair(other))) {
      add(square_distance(triangles, foot), sample.area / 4, distances);
    }
    return distances;
  }

  static void add(double square, double area, Distances& distances) {
    distances.squares += area * square;
    distances.largest = std::max(distances.largest, square);
  }

  static Mesh make_pair(const std::array<Triangle, 2>& pair) {
    const auto& [a, b, c] = pair[0];
    const auto& [p, q, r] = pair[1];
    return {{a, b, c, p, q, r}, {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(3), VertexId(4), VertexId(5)}}};
  }

  /// Samples of two triangles, and the points of the surface that are nearest to them.
  std::vector<std::pair<AreaSample, Vec3>> find_feet(const Mesh& pair) const {
    std::vector<std::pair<AreaSample, Vec3>> feet;
    FaceId nearest(0);
    for (const AreaSample& sample : sample_surface(pair, kSamples)) {
      nearest = search_.tree->nearest_face(sample.position, nearest).face;
      const SurfacePoint found = closest_point_on_face(*search_.surface, nearest, sample.position).point;
      feet.emplace_back(sample, position(*search_.surface, found));
    }
    return feet;
  }

  static double square_distance(const Mesh& pair, const Vec3& at) {
    const double distance = std::min(closest_point_on_face(pair, FaceId(0), at).distance,
                                     closest_point_on_face(pair, FaceId(1), at).distance);
    return distance * distance;
  }

  bool is_free(const EdgeFlip& flip) const {
    const auto role = [&](VertexId v) { return search_.plan->roles[v.index()]; };
    return std::max({role(flip.from), role(flip.to), role(flip.left_apex), role(flip.right_apex)}) == VertexRole::free;
  }

  /// The mean area of the cells of the four vertices of a flip.
  double mean_area(const EdgeFlip& flip) const {
    const auto area = [&](VertexId v) { return search_.plan->areas[v.index()]; };
    return (area(flip.from) + area(flip.to) + area(flip.left_apex) + area(flip.right_apex)) / 4;
  }

  bool are_joined(VertexId v, VertexId w) const {
    if (new_edges_.contains(std::minmax(v, w))) return true;
    bool found = false;
    for_each_neighbour(mesh_, v, [&](VertexId other, HalfedgeId) { found |= other == w; });
    return found;
  }

  bool take(const EdgeFlip& flip) {
    if (is_used_[flip.left] || is_used_[flip.right]) return false;
    if (valence_[flip.from] <= 3 || valence_[flip.to] <= 3 || are_joined(flip.left_apex, flip.right_apex)) return false;
    is_used_[flip.left] = is_used_[flip.right] = 1;
    --valence_[flip.from];
    --valence_[flip.to];
    new_edges_.insert(std::minmax(flip.left_apex, flip.right_apex));
    return true;
  }

  /// Takes back flips until no triangle of one intersects another.
  void drop_intersecting(std::vector<EdgeFlip>& flips) const {
    while (!flips.empty()) {
      const Mesh flipped(mesh_.positions(), apply_flips(mesh_.face_vertices(), flips));
      IdVector<FaceId, char> intersects(mesh_.face_count(), 0);
      for (const FacePair& pair : find_self_intersections(flipped, search_.threads, search_.progress)) {
        intersects[pair.first] = intersects[pair.second] = 1;
      }
      const auto is_wrong = [&](const EdgeFlip& f) { return intersects[f.left] || intersects[f.right]; };
      if (std::erase_if(flips, is_wrong) == 0) return;
    }
  }

  const FlipSearch& search_;
  const Mesh& mesh_;
  IdVector<VertexId, std::int32_t> valence_;  // without the edges that flips add
  IdVector<FaceId, char> is_used_;
  std::set<std::pair<VertexId, VertexId>> new_edges_;
};

}  // namespace

std::vector<EdgeFlip> flip_edges(const FlipSearch& search, const Mesh& mesh) { return EdgeFlipper(search, mesh).run(); }

std::vector<std::array<VertexId, 3>> apply_flips(std::vector<std::array<VertexId, 3>> faces,
                                                 const std::vector<EdgeFlip>& flips) {
  for (const EdgeFlip& flip : flips) std::tie(faces[flip.left.index()], faces[flip.right.index()]) = flip.after();
  return faces;
}

std::vector<std::array<VertexId, 3>> undo_flips(std::vector<std::array<VertexId, 3>> faces,
                                                const std::vector<EdgeFlip>& flips) {
  for (auto flip = flips.rbegin(); flip != flips.rend(); ++flip) {
    std::tie(faces[flip->left.index()], faces[flip->right.index()]) = flip->before();
  }
  return faces;
}

}  // namespace gvd
