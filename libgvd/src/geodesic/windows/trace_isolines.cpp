// Curves of equal distance, from the exact distances on edges and in faces.
//
// Idea: along an edge, each source reaches a level within one interval, whose ends follow in closed form. The union of
// the intervals is the part of the edge within the level; its ends are the crossings. Crossings are stored once, with
// the edge. The two faces of the edge read them, and join the crossings on their sides by arcs (FaceContours). At each
// crossing, one arc therefore arrives and one leaves, so that a curve can only close or end on the boundary.
// Source: the sources of Mitchell, Mount and Papadimitriou (1987).
// Invariant: the nearer side is on the left. Round a face, crossings that leave the near part and crossings that enter
// it alternate, because the states of an edge's ends are those of the vertices.
#include "geodesic/windows/trace_isolines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/windows/face_contours.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

constexpr StepPart kEdgePart{"isolines", 0, 0.3}, kFacePart{"isolines", 0.3, 1};

/// Number of edges or faces in a chunk.
constexpr std::size_t kChunk = 1024;

/// A gap between two intervals of at most this size, relative to the edge and the level, is rounding. Distances have a
/// relative error of 1e-13.
constexpr double kSeam = 1e-12;

/// The rounding of a point's position, relative to its largest coordinate: a coordinate is a sum of three products,
/// each of which rounds by 2^-53 of the largest one, in each of two points that are compared.
constexpr double kCoordinateRounding = 0x1p-50;

/// Where a curve crosses an edge.
struct LevelCrossing {
  EdgeId edge;
  std::int32_t level;  // index
  double t;            // from the start of the edge, mesh units
  bool leaves;         // whether the edge leaves the near part here
};

/// A curve in a face, from one crossing to another.
struct Arc {
  std::int32_t from, to;  // indices of crossings; FaceContour::kClosed if it closes inside the face
  std::int32_t level;     // index
  std::size_t end;        // its points are those of the list from the previous arc's end to here
};

/// The curves in a chunk of faces.
struct ArcList {
  std::vector<Arc> arcs = {};
  std::vector<SurfacePoint> points = {};  // points of all arcs, between their crossings
};

/// The part of an edge within a distance, for one source: begin > end if it is empty.
struct Reach {
  double begin, end;
};

/// The part of an edge that a source reaches within a level. A source also reaches along the edge from the ends of its
/// interval. The result may extend beyond the edge.
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
  std::vector<LevelCrossing> crossings = {};
  std::vector<std::int32_t> first = {};  // [edge] index of its first crossing, and the end
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

/// Appends the crossings of an edge. `sources` and `reaches` are scratch memory that is reused for every edge.
void cross_edge(const LevelSets& sets, EdgeId e, std::vector<EdgeSource>& sources, std::vector<Reach>& reaches,
                std::vector<LevelCrossing>& found) {
  const Mesh& mesh = sets.mesh;
  const HalfedgeId h = mesh.halfedge(e);
  const double length = mesh.length(h), start = sets.field.distance[mesh.from(h)],
               end = sets.field.distance[mesh.to(h)];
  // Distances change at most as fast as points move. On fine meshes, most edges lie between two levels.
  const double lowest = std::max(start, end) < kInfinity ? 0.5 * (start + end - length) : std::min(start, end) - length;
  const double slack = kSeam * (length + lowest);
  const auto first = std::lower_bound(sets.levels.begin(), sets.levels.end(), lowest - slack);
  const auto last = std::upper_bound(first, sets.levels.end(), 0.5 * (start + end + length) + slack);
  if (first == last) return;
  collect_edge_sources(mesh, sets.field, h, sources);
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

/// More crossings than these would fill the memory: each takes up to a kilobyte until its curve is written.
constexpr double kMostCrossings = 2e7;

/// Refuses levels that cross edges too often. The crossings are counted by the distances at the ends of the edges, so
/// that there are at least as many as counted.
void check_crossings(const LevelSets& sets) {
  const Mesh& mesh = sets.mesh;
  if (double(mesh.edge_count()) * double(sets.levels.size()) <= kMostCrossings) return;
  IdVector<VertexId, std::int64_t> levels_below;
  for (const double d : sets.field.distance) {
    levels_below.push_back(std::ranges::lower_bound(sets.levels, d) - sets.levels.begin());
  }
  double crossings = 0;
  for (const EdgeId e : mesh.edges()) {
    const VertexId from = mesh.from(mesh.halfedge(e)), to = mesh.to(mesh.halfedge(e));
    if (!std::isfinite(sets.field.distance[from]) || !std::isfinite(sets.field.distance[to])) continue;
    crossings += double(std::abs(levels_below[to] - levels_below[from]));
  }
  if (crossings <= kMostCrossings) return;
  throw Error(ErrorCode::invalid_option, fmt::format("the curves would cross edges {:.2g} times, more than {:.2g}; "
                                                     "give fewer levels",
                                                     crossings, kMostCrossings));
}

void find_crossings(LevelSets& sets, const ParallelChunks& parallel) {
  const std::int32_t edges = sets.mesh.edge_count();
  sets.crossings = parallel.collect(cut_into_chunks(edges, kChunk), kEdgePart, [&](const Chunk& chunk) {
    std::vector<LevelCrossing> found;
    std::vector<EdgeSource> sources;
    std::vector<Reach> reaches;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) cross_edge(sets, EdgeId(i), sources, reaches, found);
    return found;
  });
  sets.first.assign(edges + 1, 0);
  for (const LevelCrossing& crossing : sets.crossings) ++sets.first[crossing.edge.index() + 1];
  for (std::size_t e = 1; e < sets.first.size(); ++e) sets.first[e] += sets.first[e - 1];
}

/// Finds the arcs in face after face. An object serves one thread.
class FaceTracer {
 public:
  FaceTracer(const LevelSets& sets, double tolerance) : sets_(sets), contours_(tolerance) {}

  void trace(FaceId f, ArcList& found) {
    const Mesh& mesh = sets_.mesh;
    collect_crossings(f);
    const auto levels = levels_inside(f);
    if (of_face_.empty() && levels.empty()) return;
    const FaceLayout layout(mesh, f);
    collect_face_sources(mesh, sets_.field, f, layout, sources_);
    contours_.enter(layout, sources_);
    for (auto begin = of_face_.begin(); begin != of_face_.end();) {
      const auto end = std::find_if(begin, of_face_.end(), [&](const Seen& c) { return c.level != begin->level; });
      trace_level(f, layout, begin->level, {std::to_address(begin), std::to_address(end)}, found);
      begin = end;
    }
    for (auto level = levels.begin(); level != levels.end(); ++level) {
      const auto index = std::int32_t(std::to_address(level) - sets_.levels.data());
      if (std::ranges::none_of(of_face_, [&](const Seen& c) { return c.level == index; })) {
        trace_level(f, layout, index, {}, found);
      }
    }
  }

 private:
  /// A crossing on a side of the face.
  struct Seen {
    std::int32_t crossing;
    std::int32_t level;
    std::int32_t side;
    bool is_own;  // whether the side is the edge's own halfedge
  };

  /// The crossings of all sides, by level, counter-clockwise.
  void collect_crossings(FaceId f) {
    const Mesh& mesh = sets_.mesh;
    of_face_.clear();
    for (std::int32_t i = 0; i < 3; ++i) {
      const HalfedgeId h = Mesh::halfedge(f, i);
      const EdgeId e = mesh.edge(h);
      const bool is_own = mesh.halfedge(e) == h;
      const std::int32_t first = sets_.first[e.index()], last = sets_.first[e.index() + 1];
      for (std::int32_t k = first; k < last; ++k) {
        const std::int32_t at = is_own ? k : first + last - 1 - k;
        of_face_.push_back({at, sets_.crossings[at].level, i, is_own});
      }
    }
    std::ranges::stable_sort(of_face_, {}, &Seen::level);
  }

  /// The levels that may occur inside the face although they are above the distances of all corners. Few faces have
  /// any.
  std::span<const double> levels_inside(FaceId f) const {
    const Mesh& mesh = sets_.mesh;
    const auto& length = mesh.shape(f).length;
    double most = 0, limit = kInfinity;
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = sets_.field.distance[mesh.vertices(f)[i]];
      most = std::max(most, d);
      limit = std::min(limit, d + std::max(length[i], length[(i + 2) % 3]));
    }
    const auto first = std::lower_bound(sets_.levels.begin(), sets_.levels.end(), most);
    const auto last = std::lower_bound(first, sets_.levels.end(), limit);
    return {std::to_address(first), std::to_address(last)};
  }

  void trace_level(FaceId f, const FaceLayout& layout, std::int32_t level, std::span<const Seen> seen, ArcList& found) {
    const Mesh& mesh = sets_.mesh;
    sides_.clear();
    for (const Seen& c : seen) {
      const LevelCrossing& crossing = sets_.crossings[c.crossing];
      const double t = std::min(1.0, crossing.t / mesh.length(crossing.edge));
      const Vec2 &from = layout.corner[c.side], &to = layout.corner[(c.side + 1) % 3];
      sides_.push_back({std::int32_t(sides_.size()), c.side, from + (c.is_own ? t : 1 - t) * (to - from),
                        crossing.leaves == c.is_own});
    }
    std::array<bool, 3> is_near{};
    for (std::size_t i = 0; i < 3; ++i) is_near[i] = sets_.field.distance[mesh.vertices(f)[i]] <= sets_.levels[level];
    curves_.clear();
    contours_.trace(sets_.levels[level], is_near, sides_, curves_);
    for (const FaceContour& curve : curves_) {
      const auto crossing = [&](std::int32_t id) {
        return id == FaceContour::kClosed ? FaceContour::kClosed : seen[id].crossing;
      };
      for (const Vec2& p : curve.points) {
        Bary bary = layout.bary(p);
        for (double& weight : bary) weight = std::clamp(weight, 0.0, 1.0);
        found.points.push_back(make_surface_point(f, bary));
      }
      found.arcs.push_back({crossing(curve.from), crossing(curve.to), level, found.points.size()});
    }
  }

  const LevelSets& sets_;
  FaceContours contours_;
  std::vector<FaceSource> sources_;
  std::vector<Seen> of_face_;
  std::vector<SideCrossing> sides_;  // crossings of one level
  std::vector<FaceContour> curves_;  // curves of one level
};

/// Whether two points have the same position, up to the rounding of distances on the edges and of coordinates.
bool is_same(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, double level) {
  const Vec3 p = position(mesh, a), q = position(mesh, b);
  return (q - p).norm() <= kSeam * level + kCoordinateRounding * p.cwiseAbs().maxCoeff();
}

/// Leaves out one of two consecutive points at the same position if the other one has a face in common with the points
/// before and after them. The ends of an open curve stay, because they are on the boundary.
void drop_repeated(const Mesh& mesh, Isoline& line) {
  const auto are_same = [&](const SurfacePoint& a, const SurfacePoint& b) { return is_same(mesh, a, b, line.level); };
  const auto are_neighbours = [&](const SurfacePoint& a, const SurfacePoint& b) {
    return find_common_view(mesh, a, b).has_value();
  };
  std::vector<SurfacePoint> kept;
  kept.reserve(line.points.size());
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const SurfacePoint& p = line.points[i];
    if (!kept.empty() && are_same(kept.back(), p)) {
      const bool is_last = i + 1 == line.points.size();
      if (is_last ? line.closed && are_neighbours(kept.back(), kept.front())
                  : are_neighbours(kept.back(), line.points[i + 1])) {
        continue;
      }
      if (kept.size() > 1 && are_neighbours(kept[kept.size() - 2], p)) kept.pop_back();
    }
    kept.push_back(p);
  }
  if (line.closed && kept.size() > 1 && are_same(kept.back(), kept.front()) &&
      are_neighbours(kept[kept.size() - 2], kept.front())) {
    kept.pop_back();
  }
  line.points = std::move(kept);
}

/// Whether a curve is just a point.
bool is_point(const Mesh& mesh, const Isoline& line) {
  const std::size_t count = line.points.size();
  return count < (line.closed ? 3 : 2) ||
         (count == 2 && is_same(mesh, line.points.front(), line.points.back(), line.level));
}

/// Joins arcs to curves: first curves that begin on the boundary, then closed curves, then curves inside faces; all
/// sorted by level. Repeated points are left out, and so are curves that are just a point.
std::vector<Isoline> join_arcs(const LevelSets& sets, const std::vector<ArcList>& lists) {
  const Mesh& mesh = sets.mesh;
  std::vector<Isoline> lines;
  const auto add = [&](Isoline&& line) {
    drop_repeated(mesh, line);
    if (!is_point(mesh, line)) lines.push_back(std::move(line));
  };

  std::vector<std::pair<Arc, std::span<const SurfacePoint>>> arcs;  // each with its points
  std::vector<std::int32_t> leaving(sets.crossings.size(),
                                    -1);                       // [crossing] the arc from it that is not taken; -1: none
  std::vector<bool> is_entered(sets.crossings.size(), false);  // [crossing]
  for (const ArcList& list : lists) {
    std::size_t begin = 0;
    for (const Arc& arc : list.arcs) {
      if (arc.from != FaceContour::kClosed) {
        leaving[arc.from] = std::int32_t(arcs.size());
        is_entered[arc.to] = true;
      }
      arcs.push_back({arc, {list.points.data() + begin, list.points.data() + arc.end}});
      begin = arc.end;
    }
  }

  // Follows the arcs from a crossing to the boundary, or round to the crossing itself, and removes them from `leaving`.
  const auto follow = [&](std::size_t first, bool closed) {
    Isoline line{sets.levels[sets.crossings[first].level], closed, {}};
    for (std::size_t at = first;;) {
      const HalfedgeId h = mesh.halfedge(sets.crossings[at].edge);
      const SurfacePoint point = edge_point(h, std::min(1.0, sets.crossings[at].t / mesh.length(h)));
      line.points.push_back(make_surface_point(point.face, point.bary));
      const std::int32_t next = std::exchange(leaving[at], -1);
      if (next < 0) return line;
      const auto& [arc, points] = arcs[next];
      line.points.insert(line.points.end(), points.begin(), points.end());
      at = arc.to;
    }
  };
  for (const bool closed : {false, true}) {
    for (std::size_t i = 0; i < leaving.size(); ++i) {
      if (leaving[i] >= 0 && (closed || !is_entered[i])) add(follow(i, closed));
    }
  }
  for (const auto& [arc, points] : arcs) {
    if (arc.from == FaceContour::kClosed) add({sets.levels[arc.level], true, {points.begin(), points.end()}});
  }
  std::ranges::stable_sort(lines, {}, &Isoline::level);
  return lines;
}

}  // namespace

std::vector<Isoline> trace_isolines(const Mesh& mesh, const WindowField& field, const std::vector<double>& levels,
                                    double mean_edge, const IsolineOptions& options) {
  const ParallelChunks parallel(options.threads, options.progress);
  const double tolerance = options.chord_tolerance * mean_edge;
  LevelSets sets{mesh, field, levels};
  check_crossings(sets);
  find_crossings(sets, parallel);
  const auto arcs = parallel.map(cut_into_chunks(mesh.face_count(), kChunk), kFacePart, [&](const Chunk& chunk) {
    ArcList found;
    FaceTracer tracer(sets, tolerance);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) tracer.trace(FaceId(i), found);
    return found;
  });
  return join_arcs(sets, arcs);
}

}  // namespace gvd
