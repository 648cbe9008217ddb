// Distances of one surface from another: the largest one, the root of their mean square, and samples for pictures.
//
// Faces are cut into equal triangles, whose corners and centroids are samples. The largest distance is searched for by
// branch and bound: over a triangle the distance from one face of the other surface is convex, so its largest value is
// at a corner and bounds the distance from all faces. If the closest points of the corners are in two faces, the bound
// is the largest distance of a corner plus the largest distance of the triangle of the closest points from the faces.
// Without this bound, flat surfaces that agree would be cut as finely as possible along all edges. The same holds round
// a vertex, where the closest points lie in faces round it that are nearly flat. A distance also changes by no more
// than the distance between two points, which gives the bound for long triangles that cross many faces. A triangle that
// may hold a farther point is cut in four, and one that is hardly wider than its longest side is that side, which is
// cut in two: a needle of length n times its width takes n pieces instead of n^2. If there are too many pieces, those
// with the largest bounds come first. Sums and pieces are joined in the order of the chunks, so the results do not
// depend on the number of threads.

#include "gvd/surface_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "base/triangle_lattice.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

void check_faces(const Mesh& from, const Mesh& to) {
  if (from.face_count() == 0 || to.face_count() == 0) {
    throw Error(ErrorCode::precondition, "a mesh without faces has no distance from another one");
  }
}

/// The least number of triangles that the faces are cut into, unless the meshes are small. On ten remeshes of real
/// meshes, the RMS distance differs by at most 1 % from that of 2^18 triangles.
constexpr double kLeastTriangles = 1 << 15;
/// For small meshes, this many triangles for each face of the two meshes are enough.
constexpr double kTrianglesPerFace = 8;
/// The number of elements in a chunk. Within a chunk, each search for a closest point begins at the one found before.
constexpr std::size_t kFacesPerChunk = 128;
/// With more pieces than this, a round cuts those with the largest bounds: half of all, or as many as this.
constexpr std::size_t kLeastCutsInRound = 1 << 18;
/// The search for the largest distance ends, with the bound known then, once it has cut as many pieces as the first
/// number plus the second one for each face of `from`. A cut takes 2 to 6 microseconds.
constexpr std::size_t kLeastMaxCuts = 1 << 20, kMaxCutsPerFace = 4;

/// The largest number of faces round a vertex that are considered for a bound. In a larger fan, such as a triangulated
/// n-gon, each piece near the vertex would cost as much as the fan has faces, while smaller pieces meet only few of
/// them.
constexpr int kMostFanFaces = 64;

/// A point of the surface and the closest point of the other one.
struct Sample {
  Vec3 position;
  double distance = 0;
  FaceId nearest;
};

/// Distances below this fraction of the largest coordinate are rounding: four units of it. Dimensionless.
constexpr double kDistanceRounding = 4 * std::numeric_limits<double>::epsilon();

double rounding_of(const Mesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions()) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return kDistanceRounding * largest;
}

constexpr StepPart kOfVertices{"distance", 0, 0.3}, kOfFaces{"distance", 0.3, 0.6};

/// The closest points of the vertices. Each search starts from the face nearest to the vertex before. `enough` is
/// passed to `nearest_face`.
std::vector<Sample> sample_vertices(const Mesh& from, const ClosestPointTree& tree, double enough,
                                    const ParallelChunks& parallel) {
  return parallel.collect(cut_into_chunks(from.vertex_count(), kFacesPerChunk), kOfVertices, [&](const Chunk& chunk) {
    std::vector<Sample> samples;
    FaceId near(0);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Vec3& at = from.position(VertexId(i));
      const NearestFace nearest = tree.nearest_face(at, near, enough);
      near = nearest.face;
      samples.push_back({at, nearest.distance, near});
    }
    return samples;
  });
}

using Corners = std::array<Sample, 3>;

/// A triangle within a face, or the side of a narrow one, whose last two corners are the same.
struct Piece {
  Corners corners;
  bool is_side = false;
  double width = 0;  ///< no point of the narrow triangle is farther than this from its side; mesh units
  double bound = 0;  ///< no point of the piece is farther than this
};

/// The longest side of a triangle, from corner `start` to the next one, and the height above it; mesh units. No point
/// of the triangle is farther from the side than the height, because the two angles at the side are acute.
struct LongestSide {
  std::size_t start;
  double length, height;
};

LongestSide longest_side(const Corners& corners) {
  const auto side = [&](std::size_t k) -> Vec3 { return corners[(k + 1) % 3].position - corners[k].position; };
  const std::array<double, 3> square{side(0).squaredNorm(), side(1).squaredNorm(), side(2).squaredNorm()};
  const auto start = std::size_t(std::max_element(square.begin(), square.end()) - square.begin());
  const double length = std::sqrt(square[start]);
  return {start, length, length > 0 ? side(start).cross(side((start + 1) % 3)).norm() / length : 0};
}

/// Faces around a vertex that cover a sector of a disc, seen along the normal of the first face. A point in the disc,
/// and in a convex sector, has a face within twice its height above the plane of the first face.
class FlatSector {
 public:
  /// Begins with the face of h, round the start of h.
  FlatSector(const Mesh& mesh, HalfedgeId h)
      : mesh_(mesh), first_(h), at_(mesh.position(mesh.from(h))), normal_(face_normal(mesh, Mesh::face(h))) {}

  /// Adds the face of h, the next one counter-clockwise. False if it is turned over.
  bool add(HalfedgeId h) {
    const Vec3 from = mesh_.position(mesh_.to(h)) - at_, to = mesh_.position(mesh_.opposite(h)) - at_;
    const auto flat = [&](const Vec3& v) -> Vec3 { return v - v.dot(normal_) * normal_; };
    const Vec3 a = flat(from), b = flat(to), edge = b - a;
    const double turn = std::atan2(a.cross(b).dot(normal_), a.dot(b));
    angle_ += turn;
    radius_ = std::min(radius_, std::abs(a.cross(edge).dot(normal_)) / edge.norm());
    height_ = std::max({height_, std::abs(from.dot(normal_)), std::abs(to.dot(normal_))});
    is_closed_ = next_outgoing(mesh_, h) == first_;
    return turn > 0;
  }

  /// Whether the sector is convex. A closed sector goes round the vertex once.
  bool is_convex() const { return angle_ <= std::numbers::pi || (is_closed_ && angle_ < 3 * std::numbers::pi); }

  /// A bound on the distance of the faces from points in the convex hull of points on them that are no farther from the
  /// vertex than `reach`. Faces are linear, so that heights grow from the vertex on. Infinite if the faces do not reach
  /// that far.
  double distance_within(double reach) const {
    return is_convex() && reach <= radius_ ? 2 * height_ * reach / radius_ : kInfinity;
  }

 private:
  const Mesh& mesh_;
  HalfedgeId first_;
  const Vec3& at_;
  Vec3 normal_;
  double angle_ = 0, radius_ = kInfinity, height_ = 0;  // radians, mesh units
  bool is_closed_ = false;
};

/// Bounds on the distances of all points of a triangle, from the closest points of its corners.
class PieceBounds {
 public:
  /// Both must outlive this. A face that is at most `tolerance` farther away than the nearest one counts as nearest,
  /// too; mesh units.
  PieceBounds(const Mesh& to, const ClosestPointTree& tree, double tolerance)
      : to_(to), tree_(tree), tolerance_(tolerance) {}

  /// Returns the least bound found. The costlier bounds are tried only while the least one is above `enough`.
  double find(const Corners& corners, double enough) const {
    double least = by_one_face(corners);
    for (std::size_t k = 0; k < 3; ++k) {
      const Corners turned{corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]};
      const FaceId own = turned[0].nearest, other = turned[1].nearest;
      if (own == other || turned[2].nearest != other) continue;
      if (const HalfedgeId h = common_edge(own, other); h.valid()) return std::min(least, by_two(turned, h));
    }
    if (least > enough) least = std::min(least, by_size(corners));
    return least > enough ? std::min(least, by_fan(corners)) : least;
  }

 private:
  /// The bound by a single face. Over the triangle, the distance from one face is convex, so the largest value is at a
  /// corner. Among the faces nearest to the corners, the one with the least such value counts.
  double by_one_face(const Corners& corners) const {
    double least = kInfinity;
    for (const Sample& candidate : corners) {
      double largest = 0;
      for (const Sample& s : corners) {
        const bool own = s.nearest == candidate.nearest;
        largest = std::max(largest, own ? s.distance : tree_.distance(s.position, candidate.nearest));
      }
      least = std::min(least, largest);
    }
    return least;
  }

  /// The bound by the size of the triangle. The distances of two points differ by no more than the distance between the
  /// points. No point of a triangle is farther from its nearest corner than 1 / sqrt(3) of the longest side, which is
  /// the radius of an equilateral triangle. And no point is farther from the longest side than the height above it,
  /// where a point lies between two corners.
  double by_size(const Corners& corners) const {
    const auto [start, length, height] = longest_side(corners);
    const auto& [a, b, c] = corners;
    const double by_corners = std::max({a.distance, b.distance, c.distance}) + length / std::numbers::sqrt3;
    const double on_side = (corners[start].distance + corners[(start + 1) % 3].distance + length) / 2;
    return std::min(by_corners, on_side + height);
  }

  /// The halfedge of a face whose twin belongs to another face; invalid if they have no edge in common.
  HalfedgeId common_edge(FaceId face, FaceId other) const {
    for (const HalfedgeId h : to_.halfedges(face)) {
      if (to_.twin(h).valid() && to_.face(to_.twin(h)) == other) return h;
    }
    return {};
  }

  /// The bound by two faces: the first corner is nearest to the face of h, and the others are nearest to that of its
  /// twin. The closest points of the corners make a triangle. Cut it where it crosses the edge, if it does: each part
  /// is as near to its face as the ends of the cut are to the edge. All maps between the three triangles are linear in
  /// each part, so the largest values are at corners.
  double by_two(const Corners& corners, HalfedgeId h) const {
    const Vec3 &start = to_.position(to_.from(h)), &end = to_.position(to_.to(h));
    const auto closest = [&](const Sample& s) {
      return gvd::position(to_, closest_point_on_face(to_, s.nearest, s.position).point);
    };
    const auto at = [&](double t) -> Vec3 { return start + t * (end - start); };
    const auto height = [&](const Vec3& p) { return (p - at(foot_on_line(start, end, p))).norm(); };
    const Vec3 single = closest(corners[0]);
    double off_edge = 0, farthest = corners[0].distance;
    for (const Sample& corner : {corners[1], corners[2]}) {
      const Vec3 across = closest(corner);
      const double here = height(single), there = height(across);
      const Vec3 cut = here + there > 0 ? Vec3((there * single + here * across) / (here + there)) : single;
      const double off = (cut - at(std::clamp(foot_on_line(start, end, cut), 0.0, 1.0))).norm();
      if (!std::isfinite(off)) return kInfinity;  // the edge has no length
      off_edge = std::max(off_edge, off);
      farthest = std::max(farthest, corner.distance);
    }
    return farthest + off_edge;
  }

  /// The bound by the faces around a vertex that the faces nearest to the corners have in common. Infinite if there is
  /// no such vertex.
  double by_fan(const Corners& corners) const {
    double least = kInfinity;
    for (const Sample& start : corners) {
      for (const HalfedgeId h : to_.halfedges(start.nearest)) {
        const auto has_vertex = [&](const Sample& s) {
          const auto& vertices = to_.vertices(s.nearest);
          return std::find(vertices.begin(), vertices.end(), to_.from(h)) != vertices.end();
        };
        if (std::ranges::all_of(corners, has_vertex)) least = std::min(least, by_sector(corners, h));
      }
    }
    return least;
  }

  /// The bound by consecutive faces around a vertex, from that of h on, until one of them is as near to each corner as
  /// its nearest face, and the sector is convex. It then holds the triangle of the corners' closest points.
  double by_sector(const Corners& corners, HalfedgeId h) const {
    FlatSector sector(to_, h);
    const HalfedgeId first = h;
    std::array<double, 3> distance{kInfinity, kInfinity, kInfinity};
    double reach = 0;
    int count = 0;
    do {
      if (!sector.add(h)) return kInfinity;
      for (std::size_t k = 0; k < 3; ++k) {
        const Sample& s = corners[k];
        const FaceId face = Mesh::face(h);
        if (distance[k] < kInfinity || tree_.distance(s.position, face) > s.distance + tolerance_) continue;
        const ClosestPoint closest = closest_point_on_face(to_, face, s.position);
        distance[k] = closest.distance;
        reach = std::max(reach, (gvd::position(to_, closest.point) - to_.position(to_.from(first))).norm());
      }
      const double farthest = *std::max_element(distance.begin(), distance.end());
      if (farthest < kInfinity && sector.is_convex()) return farthest + sector.distance_within(reach);
      h = next_outgoing(to_, h);
    } while (h.valid() && h != first && ++count < kMostFanFaces);
    return kInfinity;
  }

  const Mesh& to_;
  const ClosestPointTree& tree_;
  double tolerance_;
};

/// Results for some triangles.
struct Findings {
  double square_sum = 0;      ///< integral of the square distance
  double farthest = 0;        ///< largest distance of a sample
  double bound = 0;           ///< no point of the triangles that were given up is farther than this
  std::vector<Piece> pieces;  ///< that may hold farther points
};

class DistanceMeasure {
 public:
  /// All arguments but `threads` must outlive this.
  DistanceMeasure(const Mesh& from, const Mesh& to, int threads, const Progress& progress)
      : from_(from),
        to_(to),
        tree_(to),
        parallel_(threads, progress),
        absolute_tolerance_(kLeastHausdorffTolerance * std::max(from.bbox_diagonal(), to.bbox_diagonal())),
        rounding_(rounding_of(to)),
        bounds_(to, tree_, absolute_tolerance_ / 2) {
    triangles_ = std::min(kLeastTriangles, kTrianglesPerFace * (from.face_count() + to.face_count()));
  }

  SurfaceDistance run() {
    at_vertex_ = IdVector<VertexId, Sample>(sample_vertices(from_, tree_, rounding_, parallel_));
    for (const Sample& s : at_vertex_) farthest_ = std::max(farthest_, s.distance);
    area_ = compute_area(from_);
    Findings all =
        collect(from_.face_count(), kOfFaces, [&](std::size_t i, Findings& found) { sample_face(FaceId(i), found); });
    SurfaceDistance result;
    result.rms = area_ > 0 ? std::sqrt(all.square_sum / area_) : 0;
    result.hausdorff_bound = search(std::move(all.pieces));
    result.hausdorff = farthest_;
    return result;
  }

 private:
  /// Walks from face to face as long as they get nearer. This crosses fans of needles, where the boxes of the tree are
  /// of no use.
  NearestFace walk(const Vec3& at, FaceId from) const {
    NearestFace best{from, tree_.distance(at, from)};
    for (FaceId last; last != best.face && best.distance > rounding_;) {
      last = best.face;
      for (const HalfedgeId h : Mesh::halfedges(last)) {
        if (const HalfedgeId twin = to_.twin(h); twin.valid()) {
          const double distance = tree_.distance(at, Mesh::face(twin));
          if (distance < best.distance) best = {Mesh::face(twin), distance};
        }
      }
    }
    return best;
  }

  Sample sample(const Vec3& at, FaceId guess) const {
    const NearestFace nearest = tree_.nearest_face(at, guess, rounding_);
    return {at, nearest.distance, nearest.face};
  }

  /// Joins what find(i, findings) adds for the items 0 .. count - 1.
  template <class Find>
  Findings collect(std::size_t count, const StepPart& step, const Find& find) {
    return join(parallel_.map(cut_into_chunks(count, kFacesPerChunk), step, [&](const Chunk& chunk) {
      Findings found;
      found.farthest = farthest_;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) find(i, found);
      return found;
    }));
  }

  /// Cuts pieces until none may contain a farther point, or until too many have been cut. Returns the bound.
  double search(std::vector<Piece> pieces) {
    const std::size_t max_cuts = kLeastMaxCuts + kMaxCutsPerFace * std::size_t(from_.face_count());
    for (std::size_t cuts = 0; !pieces.empty() && cuts < max_cuts;) {
      const std::size_t most = std::max(kLeastCutsInRound, pieces.size() / 2);
      const std::vector<Piece> others = set_aside(pieces, std::min(most, max_cuts - cuts));
      const double done = double(cuts) / double(max_cuts), end = double(cuts + pieces.size()) / double(max_cuts);
      cuts += pieces.size();
      Findings found = collect(pieces.size(), {"distance", 0.6 + 0.4 * done, 0.6 + 0.4 * end},
                               [&](std::size_t i, Findings& all) { cut(pieces[i], all); });
      for (const Piece& piece : others) keep(piece, farthest_, found);
      bound_ = std::max(bound_, found.bound);
      pieces = std::move(found.pieces);
    }
    double bound = std::max(farthest_, bound_);
    for (const Piece& piece : pieces) bound = std::max(bound, piece.bound);
    return bound;
  }

  /// Leaves the `count` pieces with the largest bounds, in their order, and returns the others.
  static std::vector<Piece> set_aside(std::vector<Piece>& pieces, std::size_t count) {
    if (pieces.size() <= count) return {};
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(count), order.end(),
                     [&](std::size_t i, std::size_t k) {
                       return pieces[i].bound != pieces[k].bound ? pieces[i].bound > pieces[k].bound : i < k;
                     });
    std::sort(order.begin(), order.begin() + std::ptrdiff_t(count));
    std::sort(order.begin() + std::ptrdiff_t(count), order.end());
    std::vector<Piece> first, others;
    for (std::size_t k = 0; k < order.size(); ++k) (k < count ? first : others).push_back(pieces[order[k]]);
    pieces = std::move(first);
    return others;
  }

  /// Cuts the face into k * k triangles. Point (i, j) of the lattice has the weights i / k of corner 0, and j / k of
  /// corner 2.
  void sample_face(FaceId f, Findings& found) const {
    const double share = area_ > 0 ? from_.area(f) / area_ : 0;
    const int k = std::max(1, static_cast<int>(std::ceil(std::sqrt(share * triangles_))));
    const double area = from_.area(f) / (k * k);
    const auto& [a, b, c] = from_.vertices(f);
    std::vector<Sample> points;
    for_each_lattice_point(k, [&, a = a, b = b, c = c](int i, int j) {
      if (i == k) return points.push_back(at_vertex_[a]);
      if (i == 0 && (j == 0 || j == k)) return points.push_back(at_vertex_[j == 0 ? b : c]);
      const double s = double(i) / k, t = double(j) / k;
      const Vec3 at = s * from_.position(a) + (1 - s - t) * from_.position(b) + t * from_.position(c);
      points.push_back(sample(at, j == 0 ? at_vertex_[a].nearest : points.back().nearest));
    });
    const auto point = [&](int i, int j) -> const Sample& { return points[std::size_t(lattice_number(k, i, j))]; };
    for_each_lattice_triangle(k, [&](int i, int j, bool is_upright) {
      const Sample &next = point(i + 1, j), &right = point(i, j + 1);
      add_triangle(is_upright ? Corners{next, point(i, j), right} : Corners{right, point(i + 1, j + 1), next}, area,
                   found);
    });
  }

  /// The rule has the weights 3/4 at the centroid and 1/12 at each corner: exact for quadratic functions.
  void add_triangle(const Corners& corners, double area, Findings& found) const {
    const auto& [a, b, c] = corners;
    const Sample centre = sample((a.position + b.position + c.position) / 3, a.nearest);
    const auto square = [](const Sample& s) { return s.distance * s.distance; };
    found.square_sum += area * (0.75 * square(centre) + (square(a) + square(b) + square(c)) / 12);
    found.farthest = std::max(found.farthest, centre.distance);
    for (const Sample& corner : corners) found.farthest = std::max(found.farthest, corner.distance);
    bound_and_keep({.corners = corners}, found);
  }

  void bound_and_keep(Piece piece, Findings& found) const {
    piece.bound = bounds_.find(piece.corners, allowed(found.farthest) - piece.width) + piece.width;
    keep(piece, found.farthest, found);
  }

  /// Keeps a piece that may hold points farther than `farthest`.
  void keep(const Piece& piece, double farthest, Findings& found) const {
    if (piece.bound > allowed(farthest)) {
      found.pieces.push_back(piece);
    } else {
      found.bound = std::max(found.bound, piece.bound);
    }
  }

  double allowed(double farthest) const {
    return farthest + std::max(kHausdorffTolerance * farthest, absolute_tolerance_);
  }

  void cut(const Piece& piece, Findings& found) const {
    if (piece.is_side) return cut_in_two(piece.corners[0], piece.corners[1], piece.width, found);
    const auto [start, length, height] = longest_side(piece.corners);
    if (height > (allowed(found.farthest) - found.farthest) / 2) return cut_in_four(piece.corners, found);
    cut_in_two(piece.corners[start], piece.corners[(start + 1) % 3], height, found);
  }

  /// The middle of two corners. If a face is found that is nearer than half of the largest distance, no nearer one is
  /// looked for: once pieces round it are as small as that, they hold no farther point by their size alone.
  Sample middle(const Sample& a, const Sample& b, Findings& found) const {
    const Vec3 at = (a.position + b.position) / 2;
    const NearestFace near = walk(at, a.nearest);
    if (near.distance <= found.farthest / 2) return {at, near.distance, near.face};
    const Sample between = sample(at, near.face);
    found.farthest = std::max(found.farthest, between.distance);
    return between;
  }

  void cut_in_two(const Sample& a, const Sample& b, double width, Findings& found) const {
    const Sample ab = middle(a, b, found);
    for (const Corners& half : {Corners{a, ab, ab}, Corners{ab, b, b}}) {
      bound_and_keep({.corners = half, .is_side = true, .width = width}, found);
    }
  }

  void cut_in_four(const Corners& corners, Findings& found) const {
    const auto& [a, b, c] = corners;
    const Sample ab = middle(a, b, found), bc = middle(b, c, found), ca = middle(c, a, found);
    for (const Corners& part : {Corners{a, ab, ca}, Corners{ab, b, bc}, Corners{ca, bc, c}, Corners{ab, bc, ca}}) {
      bound_and_keep({.corners = part}, found);
    }
  }

  /// Joins what the chunks found, and keeps the pieces that may hold points farther than any found.
  Findings join(const std::vector<Findings>& chunks) {
    Findings all;
    for (const Findings& found : chunks) farthest_ = std::max(farthest_, found.farthest);
    for (const Findings& found : chunks) {
      all.square_sum += found.square_sum;
      all.bound = std::max(all.bound, found.bound);
      for (const Piece& piece : found.pieces) keep(piece, farthest_, all);
    }
    bound_ = std::max(bound_, all.bound);
    return all;
  }

  const Mesh &from_, &to_;
  ClosestPointTree tree_;
  ParallelChunks parallel_;
  double absolute_tolerance_, rounding_;  // mesh units
  PieceBounds bounds_;
  double triangles_ = 0;  // least number that the faces are cut into
  double area_ = 0;       // of all faces
  double farthest_ = 0;   // the largest distance found
  double bound_ = 0;      // no point of the pieces that are given up is farther than this
  IdVector<VertexId, Sample> at_vertex_;
};

IdVector<FaceId, std::int32_t> choose_steps(const Mesh& mesh) {
  IdVector<FaceId, std::int32_t> steps;
  const double area = compute_area(mesh);
  for (const FaceId f : mesh.faces()) {
    const double share = area > 0 ? mesh.area(f) / area : 0;
    const double wanted = std::floor(std::sqrt(share * kSampledTriangles));
    steps.push_back(static_cast<std::int32_t>(std::clamp(wanted, 1.0, double{DistanceSamples::kMaxSteps})));
  }
  return steps;
}

}  // namespace

SurfaceDistance measure_surface_distance(const Mesh& from, const Mesh& to, int threads, const Progress& progress) {
  check_faces(from, to);
  return DistanceMeasure(from, to, threads, progress).run();
}

DistanceSamples sample_surface_distance(const Mesh& from, const Mesh& to, int threads, const Progress& progress) {
  check_faces(from, to);
  const ClosestPointTree tree(to);
  const ParallelChunks parallel(threads, progress);
  DistanceSamples result;
  result.steps = choose_steps(from);
  const double enough = rounding_of(to);
  for (const Sample& sample : sample_vertices(from, tree, enough, parallel))
    result.at_vertex.push_back(sample.distance);
  const auto chunks = cut_into_chunks(from.face_count(), kFacesPerChunk);
  result.lattice = parallel.collect(chunks, {"view"}, [&](const Chunk& chunk) {
    std::vector<double> distances;
    FaceId near(0);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const std::int32_t k = result.steps[FaceId(i)];
      if (k < 2) continue;
      const auto& [a, b, c] = from.vertices(FaceId(i));
      for_each_lattice_point(k, [&, a = a, b = b, c = c](std::int32_t row, std::int32_t column) {
        const double s = double(row) / k, t = double(column) / k, r = double(k - row - column) / k;
        const Vec3 at = s * from.position(a) + r * from.position(b) + t * from.position(c);
        const NearestFace nearest = tree.nearest_face(at, near, enough);
        near = nearest.face;
        distances.push_back(nearest.distance);
      });
    }
    return distances;
  });
  return result;
}

}  // namespace gvd
