// Curves of equal distance, from the exact distances on edges and in faces.
//
// Idea: along an edge, each source reaches a level within one interval, whose ends follow in closed form. The union of
// the intervals is the part of the edge within the level; its ends are the crossings. They are stored once, with the
// edge. The two faces of the edge read them, and pair the crossings on their sides without letting curves cross. Each
// crossing so has one curve that comes and one that goes: a curve can only close, or end on the boundary.
// Inside a face, points are added halfway between two others where the straight piece is not near enough to the level.
// They are found by the root of the exact distance on the line that crosses the piece at a right angle.
// Source: the sources of Mitchell, Mount and Papadimitriou (1987); the pairing is that of marching triangles.
// Invariant: the nearer side is on the left. Round a face, crossings that leave the level and those that enter it
// alternate, since the states of an edge's ends are those of the vertices. With more than two of them on a face, the
// distance in their middle decides whether the near or the far parts are connected.
#include "geodesic/windows/trace_isolines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "base/plane.hpp"
#include "base/roots.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/windows/window_queries.hpp"

namespace gvd {
namespace {

constexpr StepPart kEdgePart{"isolines", 0, 0.3}, kFacePart{"isolines", 0.3, 1};

/// Edges or faces of a chunk.
constexpr std::size_t kChunk = 1024;

/// A gap between two intervals, relative to edge and level, that is no more than rounding: distances are right to
/// 1e-13.
constexpr double kSeam = 1e-12;

/// A straight piece in a face is halved at most so often: the error falls to a quarter each time.
constexpr int kMostHalvings = 10;

/// Rounding of a level in a face, relative to it: nearer points count as on the level.
constexpr double kOnLevel = 1e-14;

/// Where a curve crosses an edge.
struct Crossing {
  EdgeId edge;
  std::int32_t level;  // index
  double t;            // from the start of the edge, mesh units
  bool leaves;         // the edge leaves the near side here
};

/// A curve in a face, from one crossing to another.
struct Arc {
  std::int32_t from, to;             // indices of crossings
  std::vector<SurfacePoint> points;  // between them
};

/// The part of an edge within a distance, for one source: begin > end if it is empty.
struct Reach {
  double begin, end;
};

/// Ends may lie beyond the edge. A source reaches on along the edge from the ends of its interval.
Reach reach_of(const EdgeSource& s, double level) {
  const double beyond_begin = level - s.straight(s.begin), beyond_end = level - s.straight(s.end);
  if (s.is_parallel()) {
    // Linear lengths reach a level once. They are least at one end of the interval.
    if (beyond_begin < 0 && beyond_end < 0) return {1, 0};
    const double at = (level - s.offset) / s.x;
    return {beyond_begin < 0 ? at : s.begin - beyond_begin, beyond_end < 0 ? at : s.end + beyond_end};
  }
  const double rest = level - s.offset;
  if (beyond_begin < 0 && beyond_end < 0 && (rest < s.depth || s.x <= s.begin || s.x >= s.end)) return {1, 0};
  const double half = std::sqrt(std::max(0.0, rest * rest - s.depth * s.depth));
  return {beyond_begin < 0 ? s.x - half : s.begin - beyond_begin, beyond_end < 0 ? s.x + half : s.end + beyond_end};
}

/// The crossings of all edges, by edge, level and t.
struct LevelSets {
  const Mesh& mesh;
  const WindowField& field;
  const std::vector<double>& levels;
  std::vector<Crossing> crossings = {};
  std::vector<std::int32_t> first = {};  // [edge] of its crossings, and one for the end
};

/// Sorts intervals and joins those that overlap or are no more than `seam` apart.
void merge(std::vector<Reach>& reaches, double seam) {
  std::ranges::sort(reaches, {}, [](const Reach& r) { return std::pair(r.begin, r.end); });
  std::size_t count = 0;
  for (const Reach& r : reaches) {
    if (count > 0 && r.begin <= reaches[count - 1].end + seam) {
      reaches[count - 1].end = std::max(reaches[count - 1].end, r.end);
    } else {
      reaches[count++] = r;
    }
  }
  reaches.resize(count);
}

void cross_edge(const LevelSets& sets, EdgeId e, std::vector<EdgeSource>& sources, std::vector<Crossing>& found) {
  const Mesh& mesh = sets.mesh;
  const HalfedgeId h = mesh.halfedge(e);
  const double length = mesh.length(h), start = sets.field.distance[mesh.from(h)],
               end = sets.field.distance[mesh.to(h)];
  collect_edge_sources(mesh, sets.field, h, sources);
  double least = kInfinity;
  for (const EdgeSource& s : sources) least = std::min(least, s.least());
  const auto first = std::lower_bound(sets.levels.begin(), sets.levels.end(), least);
  const auto last = std::upper_bound(first, sets.levels.end(), 0.5 * (start + end + length));
  std::vector<Reach> reaches;
  for (auto level = first; level != last; ++level) {
    reaches.clear();
    for (const EdgeSource& s : sources) {
      const auto [from, to] = reach_of(s, *level);
      if (from <= to && from <= length && to >= 0) reaches.push_back({std::max(from, 0.0), std::min(to, length)});
    }
    merge(reaches, kSeam * (length + *level));
    const auto index = std::int32_t(level - sets.levels.begin());
    for (const auto& [from, to] : reaches) {
      if (from > 0 || start > *level) found.push_back({e, index, from, false});
      if (to < length || end > *level) found.push_back({e, index, to, true});
    }
  }
}

void find_crossings(LevelSets& sets, const ParallelChunks& parallel) {
  const std::int32_t edges = sets.mesh.edge_count();
  sets.crossings = parallel.collect(cut_into_chunks(edges, kChunk), kEdgePart, [&](const Chunk& chunk) {
    std::vector<Crossing> found;
    std::vector<EdgeSource> sources;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) cross_edge(sets, EdgeId(i), sources, found);
    return found;
  });
  sets.first.assign(edges + 1, 0);
  for (const Crossing& crossing : sets.crossings) ++sets.first[crossing.edge.index() + 1];
  for (std::size_t e = 1; e < sets.first.size(); ++e) sets.first[e] += sets.first[e - 1];
}

/// Finds the arcs in one face after the other, for one thread.
class FaceTracer {
 public:
  FaceTracer(const LevelSets& sets, double tolerance) : sets_(sets), tolerance_(tolerance) {}

  void trace(FaceId f, std::vector<Arc>& found) {
    collect_sides(f);
    if (sides_.empty()) return;
    collect_face_sources(sets_.mesh, sets_.field, f, *layout_, sources_);
    for (auto begin = sides_.begin(); begin != sides_.end();) {
      const auto end = std::find_if(begin, sides_.end(), [&](const Side& side) { return side.level != begin->level; });
      level_ = sets_.levels[begin->level];
      pair_sides({std::to_address(begin), std::to_address(end)}, found);
      begin = end;
    }
  }

 private:
  /// A crossing as seen from the face.
  struct Side {
    std::int32_t crossing;
    std::int32_t level;
    bool leaves;  // counter-clockwise round the face
    Vec2 at;      // in the layout of the face
  };

  void collect_sides(FaceId f) {
    const Mesh& mesh = sets_.mesh;
    face_ = f;
    sides_.clear();
    layout_.emplace(mesh, f);
    for (int i = 0; i < 3; ++i) {
      const HalfedgeId h = Mesh::halfedge(f, i);
      const EdgeId e = mesh.edge(h);
      const bool is_own = mesh.halfedge(e) == h;
      const Vec2 &from = layout_->corner[i], &to = layout_->corner[(i + 1) % 3];
      const std::int32_t first = sets_.first[e.index()], last = sets_.first[e.index() + 1];
      for (std::int32_t k = first; k < last; ++k) {
        const std::int32_t at = is_own ? k : first + last - 1 - k;
        const Crossing& c = sets_.crossings[at];
        const double t = c.t / mesh.length(e);
        sides_.push_back({at, c.level, c.leaves == is_own, from + (is_own ? t : 1 - t) * (to - from)});
      }
    }
    std::ranges::stable_sort(sides_, {}, &Side::level);
  }

  double distance(const Vec2& p) const {
    double d = kInfinity;
    nearest_source(sources_, p, d);
    return d;
  }

  /// Pairs the crossings of one level: each one that leaves the near side with the next or with the last that enters
  /// it.
  void pair_sides(std::span<const Side> sides, std::vector<Arc>& found) const {
    const std::size_t n = sides.size();
    Vec2 middle = Vec2::Zero();
    for (const Side& side : sides) middle += side.at / double(n);
    const std::size_t step = n > 2 && distance(middle) <= level_ ? 1 : n - 1;
    for (std::size_t i = 0; i < n; ++i) {
      if (!sides[i].leaves) continue;
      const Side& end = sides[(i + step) % n];
      Arc& arc = found.emplace_back(Arc{sides[i].crossing, end.crossing, {}});
      halve(sides[i].at, end.at, kMostHalvings, arc.points);
    }
  }

  /// Adds the points between two points of a curve.
  void halve(const Vec2& a, const Vec2& b, int halvings, std::vector<SurfacePoint>& points) const {
    const std::optional<Vec2> middle = halvings > 0 ? find_middle(a, b) : std::nullopt;
    if (!middle) return;
    halve(a, *middle, halvings - 1, points);
    Bary bary = layout_->bary(*middle);
    for (double& weight : bary) weight = std::clamp(weight, 0.0, 1.0);
    points.push_back(make_surface_point(face_, bary));
    halve(*middle, b, halvings - 1, points);
  }

  /// The point on the level beside the middle of a straight piece. None where the middle is near enough to the level,
  /// or where the level is not beside it within the face.
  std::optional<Vec2> find_middle(const Vec2& a, const Vec2& b) const {
    const Vec2 middle = 0.5 * (a + b);
    const double beyond = distance(middle) - level_;  // distances change at most as fast as points move
    if (!(std::abs(beyond) > std::max(tolerance_, kOnLevel * level_))) return std::nullopt;
    const Vec2 to_near = turned_left(b - a).normalized(), across = beyond > 0 ? to_near : Vec2(-to_near);
    const Bary bary = layout_->bary(middle), rate = layout_->bary_rate(across);
    double limit = kInfinity;  // where the line leaves the face
    for (int i = 0; i < 3; ++i) {
      if (rate[i] < 0) limit = std::min(limit, bary[i] / -rate[i]);
    }
    const double sign = beyond > 0 ? -1 : 1;
    const auto offset = [&](double s) { return sign * (distance(middle + s * across) - level_); };
    // Doubled from the least way that can lead to the level, so that the first crossing is found: curves have sharp
    // corners where paths of two directions meet, and the other side of a corner is near.
    double reach = 0, at_end = -1;
    for (double next = 2 * std::abs(beyond); !(at_end > 0) && reach < limit; next *= 2) {
      reach = std::min(next, limit);
      at_end = offset(reach);
    }
    if (!(at_end > 0)) return std::nullopt;
    const double s = find_root({0, reach, -std::abs(beyond), at_end}, kOnLevel * (level_ + reach), offset);
    return Vec2(middle + s * across);
  }

  const LevelSets& sets_;
  double tolerance_;  // mesh units
  FaceId face_;
  std::optional<FaceLayout> layout_;
  std::vector<FaceSource> sources_;
  std::vector<Side> sides_;  // of the face, by level, counter-clockwise
  double level_ = 0;
};

/// Joins arcs to curves.
class ArcJoiner {
 public:
  ArcJoiner(const LevelSets& sets, const std::vector<Arc>& arcs)
      : sets_(sets), arcs_(arcs), leaving_(sets.crossings.size(), -1), is_entered_(sets.crossings.size(), false) {
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      leaving_[arcs[i].from] = std::int32_t(i);
      is_entered_[arcs[i].to] = true;
    }
  }

  /// Curves that begin on the boundary, then closed ones; by level.
  std::vector<Isoline> run() {
    std::vector<Isoline> lines;
    for (const bool closed : {false, true}) {
      for (std::size_t i = 0; i < leaving_.size(); ++i) {
        if (leaving_[i] < 0 || (!closed && is_entered_[i])) continue;
        Isoline line = follow(std::int32_t(i));
        line.closed = closed;
        if (closed && line.points.size() > 1 && is_same(line.points.front(), line.points.back()))
          line.points.pop_back();
        if (line.points.size() > (closed ? 2 : 1)) lines.push_back(std::move(line));
      }
    }
    std::ranges::stable_sort(lines, {}, &Isoline::level);
    return lines;
  }

 private:
  /// Follows the arcs from a crossing to the boundary, or round to it, and takes them.
  Isoline follow(std::int32_t at) {
    Isoline line{sets_.levels[sets_.crossings[at].level], false, {}};
    for (;;) {
      const HalfedgeId h = sets_.mesh.halfedge(sets_.crossings[at].edge);
      const SurfacePoint point = edge_point(h, std::min(1.0, sets_.crossings[at].t / sets_.mesh.length(h)));
      append(line.points, make_surface_point(point.face, point.bary));
      const std::int32_t arc = std::exchange(leaving_[at], -1);
      if (arc < 0) return line;
      for (const SurfacePoint& p : arcs_[arc].points) append(line.points, p);
      at = arcs_[arc].to;
    }
  }

  bool is_same(const SurfacePoint& a, const SurfacePoint& b) const {
    return position(sets_.mesh, a) == position(sets_.mesh, b);
  }
  void append(std::vector<SurfacePoint>& points, const SurfacePoint& point) const {
    if (points.empty() || !is_same(points.back(), point)) points.push_back(point);
  }

  const LevelSets& sets_;
  const std::vector<Arc>& arcs_;
  std::vector<std::int32_t> leaving_;  // [crossing] the arc that leaves it and has not been taken; -1: none
  std::vector<bool> is_entered_;       // [crossing]
};

}  // namespace

std::vector<Isoline> trace_isolines(const Mesh& mesh, const WindowField& field, const std::vector<double>& levels,
                                    const IsolineOptions& options) {
  const ParallelChunks parallel(options.threads, options.progress);
  const double tolerance = options.chord_tolerance * mesh.mean_edge_length();
  LevelSets sets{mesh, field, levels};
  find_crossings(sets, parallel);
  const auto arcs = parallel.collect(cut_into_chunks(mesh.face_count(), kChunk), kFacePart, [&](const Chunk& chunk) {
    std::vector<Arc> found;
    FaceTracer tracer(sets, tolerance);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) tracer.trace(FaceId(i), found);
    return found;
  });
  return ArcJoiner(sets, arcs).run();
}

}  // namespace gvd
