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
#include <array>
#include <cmath>
#include <cstdint>
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
  const double rest = level - s.offset;
  if (beyond_begin < 0 && beyond_end < 0 && (rest < s.depth || s.x <= s.begin || s.x >= s.end)) return {1, 0};
  const double half = std::sqrt(std::max(0.0, rest * rest - s.depth * s.depth));
  return {beyond_begin < 0 ? s.x - half : s.begin - beyond_begin, beyond_end < 0 ? s.x + half : s.end + beyond_end};
}

class IsolineTracer {
 public:
  IsolineTracer(const Mesh& mesh, const WindowField& field, const std::vector<double>& levels,
                const IsolineOptions& options)
      : mesh_(mesh),
        field_(field),
        levels_(levels),
        tolerance_(options.chord_tolerance * mesh.mean_edge_length()),
        parallel_(options.threads, options.progress) {}

  std::vector<Isoline> run() {
    crossings_ = parallel_.collect(cut_into_chunks(mesh_.edge_count(), kChunk), kEdgePart, [&](const Chunk& chunk) {
      std::vector<Crossing> found;
      std::vector<EdgeSource> sources;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) cross_edge(EdgeId(i), sources, found);
      return found;
    });
    first_crossing_.assign(mesh_.edge_count() + 1, 0);
    for (const Crossing& crossing : crossings_) ++first_crossing_[crossing.edge.index() + 1];
    for (std::size_t e = 1; e < first_crossing_.size(); ++e) first_crossing_[e] += first_crossing_[e - 1];
    arcs_ = parallel_.collect(cut_into_chunks(mesh_.face_count(), kChunk), kFacePart, [&](const Chunk& chunk) {
      std::vector<Arc> found;
      FaceWork work;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) cross_face(FaceId(i), work, found);
      return found;
    });
    return join_arcs();
  }

 private:
  static constexpr std::size_t kChunk = 1024;

  /// A crossing as seen from a face.
  struct Side {
    std::int32_t crossing;
    std::int32_t level;
    bool leaves;  // counter-clockwise round the face
    Vec2 at;      // in the layout of the face
  };

  /// What one thread needs for a face.
  struct FaceWork {
    FaceId face;
    std::optional<FaceLayout> layout;
    std::vector<FaceSource> sources;
    std::vector<Side> sides;  // by level, counter-clockwise
    std::vector<SurfacePoint>* points = nullptr;
    double level = 0;

    double distance(const Vec2& p) const {
      double d = kInfinity;
      nearest_source(sources, p, d);
      return d;
    }
  };

  void cross_edge(EdgeId e, std::vector<EdgeSource>& sources, std::vector<Crossing>& found) const {
    const HalfedgeId h = mesh_.halfedge(e);
    const double length = mesh_.length(h), start = field_.distance[mesh_.from(h)], end = field_.distance[mesh_.to(h)];
    collect_edge_sources(mesh_, field_, h, sources);
    double least = kInfinity;
    for (const EdgeSource& s : sources) least = std::min(least, s.straight(std::clamp(s.x, s.begin, s.end)));
    const auto first = std::lower_bound(levels_.begin(), levels_.end(), least);
    const auto last = std::upper_bound(first, levels_.end(), 0.5 * (start + end + length));
    std::vector<Reach> reaches;
    for (auto level = first; level != last; ++level) {
      reaches.clear();
      for (const EdgeSource& s : sources) {
        const auto [from, to] = reach_of(s, *level);
        if (from <= to && from <= length && to >= 0) reaches.push_back({std::max(from, 0.0), std::min(to, length)});
      }
      merge(reaches, kSeam * (length + *level));
      const auto index = static_cast<std::int32_t>(level - levels_.begin());
      for (const auto& [from, to] : reaches) {
        if (from > 0 || start > *level) found.push_back({e, index, from, false});
        if (to < length || end > *level) found.push_back({e, index, to, true});
      }
    }
  }

  static void merge(std::vector<Reach>& reaches, double seam) {
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

  void cross_face(FaceId f, FaceWork& work, std::vector<Arc>& found) const {
    collect_sides(f, work);
    if (work.sides.empty()) return;
    collect_face_sources(mesh_, field_, f, *work.layout, work.sources);
    for (auto begin = work.sides.begin(); begin != work.sides.end();) {
      const auto end =
          std::find_if(begin, work.sides.end(), [&](const Side& side) { return side.level != begin->level; });
      work.level = levels_[begin->level];
      pair_sides({begin, end}, work, found);
      begin = end;
    }
  }

  void collect_sides(FaceId f, FaceWork& work) const {
    work.face = f;
    work.sides.clear();
    work.layout.emplace(mesh_, f);
    for (int i = 0; i < 3; ++i) {
      const HalfedgeId h = Mesh::halfedge(f, i);
      const EdgeId e = mesh_.edge(h);
      const bool is_own = mesh_.halfedge(e) == h;
      const Vec2 &from = work.layout->corner[i], &to = work.layout->corner[(i + 1) % 3];
      const std::int32_t first = first_crossing_[e.index()], last = first_crossing_[e.index() + 1];
      for (std::int32_t k = first; k < last; ++k) {
        const std::int32_t at = is_own ? k : first + last - 1 - k;
        const Crossing& c = crossings_[at];
        const double t = c.t / mesh_.length(e);
        work.sides.push_back({at, c.level, c.leaves == is_own, from + (is_own ? t : 1 - t) * (to - from)});
      }
    }
    std::ranges::stable_sort(work.sides, {}, &Side::level);
  }

  /// Pairs the crossings of one level: each one that leaves the near side with the next or with the last that enters
  /// it.
  void pair_sides(std::span<const Side> sides, FaceWork& work, std::vector<Arc>& found) const {
    const std::size_t n = sides.size();
    Vec2 middle = Vec2::Zero();
    for (const Side& side : sides) middle += side.at / double(n);
    const std::size_t step = n > 2 && work.distance(middle) <= work.level ? 1 : n - 1;
    for (std::size_t i = 0; i < n; ++i) {
      if (!sides[i].leaves) continue;
      const Side& end = sides[(i + step) % n];
      Arc& arc = found.emplace_back(Arc{sides[i].crossing, end.crossing, {}});
      work.points = &arc.points;
      halve(sides[i].at, end.at, kMostHalvings, work);
    }
  }

  /// Adds the points between two points of a curve.
  void halve(const Vec2& a, const Vec2& b, int halvings, FaceWork& work) const {
    const std::optional<Vec2> middle = halvings > 0 ? find_middle(a, b, work) : std::nullopt;
    if (!middle) return;
    halve(a, *middle, halvings - 1, work);
    std::array<double, 3> bary = work.layout->bary(*middle);
    for (double& weight : bary) weight = std::clamp(weight, 0.0, 1.0);
    work.points->push_back(make_surface_point(work.face, bary));
    halve(*middle, b, halvings - 1, work);
  }

  /// The point on the level beside the middle of a straight piece. None where the middle is near enough to the level,
  /// or where the level is not beside it within the face.
  std::optional<Vec2> find_middle(const Vec2& a, const Vec2& b, const FaceWork& work) const {
    const Vec2 middle = 0.5 * (a + b);
    const double beyond = work.distance(middle) - work.level;  // distances change at most as fast as points move
    if (!(std::abs(beyond) > std::max(tolerance_, kOnLevel * work.level))) return std::nullopt;
    const Vec2 to_near = turned_left(b - a).normalized(), across = beyond > 0 ? to_near : Vec2(-to_near);
    const std::array<double, 3> bary = work.layout->bary(middle), rate = work.layout->bary_rate(across);
    double reach = (b - a).norm();
    for (int i = 0; i < 3; ++i) {
      if (rate[i] < 0) reach = std::min(reach, bary[i] / -rate[i]);
    }
    const double sign = beyond > 0 ? -1 : 1;
    const auto offset = [&](double s) { return sign * (work.distance(middle + s * across) - work.level); };
    const double at_end = reach > 0 ? offset(reach) : -1;
    if (!(at_end > 0)) return std::nullopt;
    const double s = find_root({0, reach, -std::abs(beyond), at_end}, kOnLevel * (work.level + reach), offset);
    return Vec2(middle + s * across);
  }

  /// Curves that begin on the boundary, then closed ones.
  std::vector<Isoline> join_arcs() {
    std::vector<std::int32_t> leaving(crossings_.size(), -1);
    std::vector<bool> is_entered(crossings_.size(), false);
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      leaving[arcs_[i].from] = static_cast<std::int32_t>(i);
      is_entered[arcs_[i].to] = true;
    }
    std::vector<Isoline> lines;
    for (const bool closed : {false, true}) {
      for (std::size_t i = 0; i < crossings_.size(); ++i) {
        if (leaving[i] < 0 || (!closed && is_entered[i])) continue;
        Isoline line = follow(static_cast<std::int32_t>(i), leaving);
        line.closed = closed;
        if (closed && line.points.size() > 1 && is_same(line.points.front(), line.points.back()))
          line.points.pop_back();
        if (line.points.size() > (closed ? 2 : 1)) lines.push_back(std::move(line));
      }
    }
    std::ranges::stable_sort(lines, {}, &Isoline::level);
    return lines;
  }

  /// Follows the arcs from a crossing to the boundary, or round to it. Takes them from `leaving`.
  Isoline follow(std::int32_t at, std::vector<std::int32_t>& leaving) {
    Isoline line{levels_[crossings_[at].level], false, {}};
    for (;;) {
      const HalfedgeId h = mesh_.halfedge(crossings_[at].edge);
      const SurfacePoint point = edge_point(h, std::min(1.0, crossings_[at].t / mesh_.length(h)));
      append(line.points, make_surface_point(point.face, point.bary));
      const std::int32_t arc = std::exchange(leaving[at], -1);
      if (arc < 0) return line;
      for (const SurfacePoint& p : arcs_[arc].points) append(line.points, p);
      at = arcs_[arc].to;
    }
  }

  bool is_same(const SurfacePoint& a, const SurfacePoint& b) const { return position(mesh_, a) == position(mesh_, b); }
  void append(std::vector<SurfacePoint>& points, const SurfacePoint& point) const {
    if (points.empty() || !is_same(points.back(), point)) points.push_back(point);
  }

  const Mesh& mesh_;
  const WindowField& field_;
  const std::vector<double>& levels_;
  double tolerance_;  // mesh units
  ParallelChunks parallel_;
  std::vector<Crossing> crossings_;           // by edge, level and t
  std::vector<std::int32_t> first_crossing_;  // [edge], and one for the end
  std::vector<Arc> arcs_;
};

}  // namespace

std::vector<Isoline> trace_isolines(const Mesh& mesh, const WindowField& field, const std::vector<double>& levels,
                                    const IsolineOptions& options) {
  return IsolineTracer(mesh, field, levels, options).run();
}

}  // namespace gvd
