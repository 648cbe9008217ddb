#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// An image with the interval of an edge that it reaches by straight paths. Positions are measured along the edge's
/// own halfedge, from 0 to its length. Mesh units.
struct EdgeSource {
  double begin, end;  ///< the interval
  double x, depth;    ///< the image: its foot on the edge's line, and its distance from it, >= 0, on either side
  double offset;      ///< distance from the generator to the image
  GeneratorId generator;

  /// Makes the source of the parallel paths from a segment of a curve, whose lengths are start + slope t. A negative
  /// depth, which no image has, marks such a source; `x` is the slope then.
  static EdgeSource parallel(double begin, double end, double slope, double start, GeneratorId g) {
    return {begin, end, slope, -1, start, g};
  }
  bool is_parallel() const { return depth < 0; }

  /// Length of the straight path to t. It lies on the surface only for t in [begin, end].
  double straight(double t) const {
    if (is_parallel()) [[unlikely]]
      return offset + x * t;
    return offset + std::sqrt((t - x) * (t - x) + depth * depth);
  }
  /// Derivative of straight(t). `length` is straight(t), and must differ from `offset` unless paths are parallel.
  double slope(double t, double length) const { return is_parallel() ? x : (t - x) / (length - offset); }
  /// The least length of a straight path to the interval.
  double least() const { return is_parallel() ? straight(x > 0 ? begin : end) : straight(std::clamp(x, begin, end)); }
  /// Length of the path to t that runs straight to the nearest point of the interval and then along the edge. It is
  /// continuous in t.
  double distance(double t) const {
    const double nearest = std::clamp(t, begin, end);
    return straight(nearest) + std::abs(t - nearest);
  }
};

/// The straight paths from one image, or from one segment of a curve, that enter a face through the same opening.
/// Points are in the coordinates of the face's layout (FaceLayout).
struct FaceSource {
  enum class Kind : std::uint8_t {
    window,    ///< from an image, through an interval of a side
    corner,    ///< from a corner of the face, which is both image and opening
    parallel,  ///< from a segment of a curve at right angles, through an interval of a side
  };
  Vec2 image;       ///< for parallel paths, their direction: use direction()
  Vec2 begin, end;  ///< the opening's left and right end, as seen from the image
  double offset;    ///< distance from the generator to the image; -infinity, which bounds nothing, for parallel paths
  GeneratorId generator;
  HalfedgeId halfedge;  ///< the side of the opening; for a corner the halfedge that leaves it
  Kind kind;
  double distance_begin, distance_end;  ///< distance from the generator to the opening's two ends

  static FaceSource corner(const Vec2& at, double distance, GeneratorId g, HalfedgeId leaving) {
    return {at, at, at, distance, g, leaving, Kind::corner, distance, distance};
  }
  bool is_corner() const { return kind == Kind::corner; }
  bool is_parallel() const { return kind == Kind::parallel; }
  /// The unit vector of parallel paths.
  const Vec2& direction() const { return image; }

  /// A path whose angle with its opening is smaller than this, in radians, is taken to enter at the nearer end.
  /// Rounding alone would decide where it crosses the opening, and the path round that end is longer by at most half
  /// the square of the angle, 5e-19 of itself.
  static constexpr double kEdgeOn = 1e-9;

  struct Path {
    double distance;  ///< length of the whole path
    Vec2 from;        ///< beginning of its last straight piece
  };
  /// The shortest path of this source to p: straight if the image sees p through the opening, otherwise round an end of
  /// the opening. It always lies on the surface, so its length is an upper bound of the distance; the length is
  /// continuous in p. It is always inlined, because a call would take a quarter of the time of the innermost loop over
  /// sources.
  [[gnu::always_inline]] Path shortest_path(const Vec2& p) const {
    if (is_parallel()) [[unlikely]]
      return shortest_parallel_path(p);
    const Vec2 ray = p - image;
    if (cross(ray, begin - image) < 0) return {distance_begin + (p - begin).norm(), begin};
    if (cross(ray, end - image) > 0) return {distance_end + (p - end).norm(), end};
    return {offset + ray.norm(), image};
  }
  [[gnu::always_inline]] double distance(const Vec2& p) const { return shortest_path(p).distance; }

  /// Tells on which side of the straight line to p an end of the opening lies: > 0 on its left, < 0 on its right. The
  /// value is the distance from the line, times the length of the line unless paths are parallel.
  double beside(const Vec2& p, const Vec2& opening_end) const {
    return is_parallel() ? cross(direction(), opening_end - p) : cross(p - image, opening_end - image);
  }
  /// `shortest_path` for parallel paths. A straight path begins at a point of the segment.
  Path shortest_parallel_path(const Vec2& p) const {
    if (beside(p, begin) < 0) return {distance_begin + (p - begin).norm(), begin};
    if (beside(p, end) > 0) return {distance_end + (p - end).norm(), end};
    return {straight_parallel(p), origin(p)};
  }
  double straight_parallel(const Vec2& p) const { return distance_begin + direction().dot(p - begin); }
  /// Where the straight path to p begins: the image or, for parallel paths, a point of the segment.
  Vec2 origin(const Vec2& p) const { return is_parallel() ? p - straight_parallel(p) * direction() : image; }
  /// The point where the path to p enters the face. It is the point of the opening that is nearest to the line from the
  /// image to p.
  Vec2 entry(const Vec2& p) const {
    if (is_corner()) return image;
    // Twice the areas of the triangles between the line from the image to p and the two ends. Both are >= 0 if the line
    // crosses the opening.
    const double to_begin = beside(p, begin), to_end = -beside(p, end);
    const double sine = to_begin + to_end, square = is_parallel() ? 1 : (p - image).squaredNorm();  // times lengths
    if (to_begin <= 0 || to_end <= 0 || sine * sine <= kEdgeOn * kEdgeOn * (end - begin).squaredNorm() * square) {
      return distance_begin + (p - begin).norm() < distance_end + (p - end).norm() ? begin : end;
    }
    return begin + to_begin / (to_begin + to_end) * (end - begin);
  }
};

/// The sources of an edge or of a face, sorted by generator. One object is used for list after list, to save
/// allocations.
template <class Source>
class SourcesByGenerator {
 public:
  /// Copies a list and sorts it. Sources of the same generator keep their order. Cost: O(k log k) for k sources.
  void build(const std::vector<Source>& sources) {
    // Numbers are sorted several times faster than sources.
    order_.resize(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
      order_[i] = static_cast<std::uint64_t>(sources[i].generator.value()) << 32 | i;
    }
    std::sort(order_.begin(), order_.end());
    sources_.resize(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) sources_[i] = sources[static_cast<std::uint32_t>(order_[i])];
  }

  std::vector<Source>& all() { return sources_; }
  const std::vector<Source>& all() const { return sources_; }

  /// The sources of generator g. They are found by binary search, because a large face beside hundreds of small cells
  /// has thousands of sources.
  /// Cost: O(log k + sources of g).
  std::span<const Source> of(GeneratorId g) const {
    const auto begin =
        std::partition_point(sources_.begin(), sources_.end(), [g](const Source& s) { return s.generator < g; });
    const auto end = std::find_if(begin, sources_.end(), [g](const Source& s) { return s.generator != g; });
    return {std::to_address(begin), std::to_address(end)};
  }

 private:
  std::vector<Source> sources_;       // ascending by generator
  std::vector<std::uint64_t> order_;  // generator and index of each
};

/// The interface between a distance solver and a tracer: the solver's distances on edges and in faces near bisectors.
/// Several threads may call it at once.
class DistanceField {
 public:
  virtual ~DistanceField() = default;

  /// The edges on which more than one generator may be the nearest, ascending.
  virtual std::vector<EdgeId> contested_edges(const ParallelChunks& parallel) const = 0;
  /// Overwrites `sources` with all sources that reach edge e, those of its two ends first. The least of their distances
  /// is the distance to the nearest generator.
  virtual void collect(EdgeId e, std::vector<EdgeSource>& sources) const = 0;
  /// The same for the inside of face f, in the coordinates of `layout`.
  virtual void collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const = 0;
};

/// The edges of a mesh for which `is_wanted(EdgeId)` is true, ascending. Throws: gvd::Error (interrupted).
template <class Wanted>
std::vector<EdgeId> find_edges(const Mesh& mesh, const ParallelChunks& parallel, const Wanted& is_wanted) {
  const auto edges = cut_into_chunks(mesh.edge_count(), kScanChunk);
  return parallel.collect(edges, steps::kLabels, [&](const Chunk& chunk) {
    std::vector<EdgeId> found;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (is_wanted(EdgeId(i))) found.emplace_back(i);
    }
    return found;
  });
}

}  // namespace gvd
