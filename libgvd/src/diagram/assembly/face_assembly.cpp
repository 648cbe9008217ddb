// Joins the crossings of one face by arcs that never cross.
//
// The crossings are the corners of a convex polygon. Two crossings make an arc, three a branch point. If there are
// more, two label intervals of the same generator are united if that generator is the nearest one between them;
// otherwise three consecutive intervals are contracted to a branch point. Both leave smaller problems of the same kind,
// and every step keeps the remaining polygons convex. Therefore the arcs can't cross, whatever the distances are.
//
// Source: sections 4.2 and 4.3 of the paper, which leave open how a face with many crossings is closed.
#include "diagram/assembly/face_assembly.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "diagram/assembly/branch_points.hpp"
#include "diagram/assembly/face_polygon.hpp"

namespace gvd {
namespace {

/// How much farther the generator of interval i is from p than the nearest other generator of the polygon.
double excess_at(const FacePolygon& polygon, const FaceDistances& distances, std::size_t i, const Bary& p) {
  double others = kInfinity;
  for (const PolygonCorner& c : polygon) {
    if (c.next != polygon[i].next) others = std::min(others, distances.at(c.next, p));
  }
  const double own = distances.at(polygon[i].next, p);
  return std::isinf(own) ? own : own - others;
}

/// Segments between two intervals are tried only in polygons with at most this many intervals, because the cost grows
/// with the square of their number. The usual case is two cells whose four intervals alternate.
constexpr std::size_t kFewIntervals = 6;

/// Where these segments begin and end on their intervals, as fractions.
constexpr std::array<double, 5> kEnds{0.5, 0.1, 0.9, 0.3, 0.7};

/// Number of samples of a segment. They follow multiples of the golden ratio, so that any number of them is spread
/// evenly. A channel of the other cell across the segment is found if it is wider than a thirtieth of the segment.
constexpr int kSamples = 48;
constexpr double kGoldenRatio = 0.61803398874989484;

/// The largest excess along the best of several segments between intervals i and j. If it is below 0, the segment stays
/// in the cell, and the two intervals belong to one piece.
double excess_along_segments(const FacePolygon& polygon, const FaceDistances& distances, std::size_t i, std::size_t j) {
  const auto point = [&](std::size_t k, double t) {
    return mix(polygon[k].bary, polygon[(k + 1) % polygon.size()].bary, t);
  };
  double least = kInfinity;
  for (const double begin : kEnds) {
    for (const double end : kEnds) {
      double most = -kInfinity;
      double t = 0.5;
      for (int k = 0; k < kSamples && most < least; ++k, t = std::fmod(t + kGoldenRatio, 1)) {
        most = std::max(most, excess_at(polygon, distances, i, mix(point(i, begin), point(j, end), t)));
      }
      least = std::min(least, most);
    }
  }
  return least;
}

/// All pairs of intervals with the same generator, ascending by excess, then by corners.
std::vector<IntervalPair> collect_pairs(const FacePolygon& polygon, const FaceDistances& distances, bool is_accurate) {
  const auto excess = [&](std::size_t i, std::size_t j) {
    if (is_accurate && polygon.size() <= kFewIntervals) return excess_along_segments(polygon, distances, i, j);
    return excess_at(polygon, distances, i, mix(midpoint(polygon, i), midpoint(polygon, j), 0.5));
  };
  std::map<GeneratorId, std::vector<std::size_t>> corners;
  for (std::size_t i = 0; i < polygon.size(); ++i) corners[polygon[i].next].push_back(i);
  std::vector<IntervalPair> pairs;
  for (const auto& [generator, own] : corners) {
    for (std::size_t b = 1; b < own.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) pairs.push_back({excess(own[a], own[b]), own[a], own[b]});
    }
  }
  std::ranges::sort(pairs, {}, [](const IntervalPair& p) { return std::tuple(p.excess, p.i, p.j); });
  return pairs;
}

bool has_three_different(const FacePolygon& polygon) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (polygon[i].next != polygon[(i + 2) % n].next) return true;
  }
  return false;
}

class FaceAssembly {
 public:
  FaceAssembly(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
               const FacePaths* paths, FaceDiagram& diagram)
      : face_(f),
        boundary_(boundary),
        distances_(distances),
        paths_(paths),
        diagram_(diagram),
        intervals_(boundary),
        search_(distances, paths, intervals_) {}

  void run() {
    FacePolygon polygon;
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      polygon.push_back({at(boundary_[i].id), boundary_[i].bary(), boundary_[i].next, static_cast<int>(i)});
    }
    if (paths_ != nullptr && polygon.size() > 3) intervals_.unite_by_paths(*paths_);
    open_.push_back(std::move(polygon));
    while (!open_.empty()) {
      const FacePolygon next = std::move(open_.back());
      open_.pop_back();
      solve(next);
    }
  }

 private:
  /// Takes one step with a polygon, and puts the rest of it on open_.
  void solve(const FacePolygon& polygon) {
    if (polygon.size() == 2) return join(polygon[0], polygon[1]);
    if (split(polygon)) return;
    if (const auto confirmed = search_.find_confirmed(polygon)) {
      polygon.size() == 3 ? join_three(polygon, confirmed->point)
                          : close_interval(polygon, confirmed->corner, confirmed->point);
    } else if (const auto pairs = find_pairs_to_unite(polygon, distances_, is_accurate()); !pairs.empty()) {
      unite(polygon, pairs);
    } else if (polygon.size() == 3) {
      join_three(polygon, place_last_branch(polygon));
    } else {
      contract(polygon);
    }
  }

  /// Splits the polygon along its united intervals. Returns false if there are none.
  bool split(const FacePolygon& polygon) {
    std::vector<FacePolygon> polygons = split_at_united_intervals(polygon, intervals_);
    for (FacePolygon& smaller : polygons) open_.push_back(std::move(smaller));
    return !polygons.empty();
  }

  /// Joins the two intervals of each pair to one piece, which splits the polygon.
  void unite(const FacePolygon& polygon, const std::vector<IntervalPair>& pairs) {
    for (const IntervalPair& pair : pairs) intervals_.unite(polygon[pair.i].interval, polygon[pair.j].interval);
    search_.clear_failed_searches();
    split(polygon);
  }

  void join(const PolygonCorner& begin, const PolygonCorner& end) {
    diagram_.arcs.push_back({face_, begin.end, end.end, end.next, begin.next});
  }

  BranchPointId add_branch(const Bary& p) { return diagram_.branches.push_back({face_, p, 0}); }

  Bary place_last_branch(const FacePolygon& polygon) const {
    const auto wanted = search_.guess(polygon, 1, centre(polygon));
    // If the face has three crossings, the straight arcs may lie anywhere in it.
    return boundary_.size() == 3 ? place_in_face(polygon, wanted, is_accurate())
                                 : place_in_polygon(polygon, wanted, is_accurate());
  }

  void join_three(const FacePolygon& polygon, const Bary& p) {
    const BranchPointId b = add_branch(p);
    for (std::size_t i = 0; i < 3; ++i) {
      diagram_.arcs.push_back({face_, polygon[i].end, at(b), polygon[(i + 2) % 3].next, polygon[i].next});
    }
  }

  /// Closes the interval whose branch point has the largest clearance from other generators.
  void contract(const FacePolygon& polygon) {
    const std::size_t n = polygon.size();
    std::size_t chosen = n;
    double best = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (polygon[(i + n - 1) % n].next == polygon[(i + 1) % n].next) continue;
      const double clearance = search_.clearance(polygon, i);
      if (chosen == n || clearance > best) std::tie(chosen, best) = std::tuple(i, clearance);
    }
    const auto wanted = search_.guess(polygon, chosen, midpoint(polygon, chosen));
    close_interval(polygon, chosen, place_at_interval(polygon, chosen, wanted, is_accurate()));
  }

  /// Joins the two corners of interval i to a branch point at p, which replaces them in the polygon.
  void close_interval(const FacePolygon& polygon, std::size_t i, const Bary& p) {
    const std::size_t n = polygon.size();
    const PolygonCorner &first = polygon[i], &second = polygon[(i + 1) % n];
    const GeneratorId x = polygon[(i + n - 1) % n].next, y = first.next, z = second.next;
    const BranchPointId b = add_branch(p);
    diagram_.arcs.push_back({face_, first.end, at(b), x, y});
    diagram_.arcs.push_back({face_, second.end, at(b), y, z});
    FacePolygon smaller{{at(b), p, z, second.interval}};
    for (std::size_t k = 2; k < n; ++k) smaller.push_back(polygon[(i + k) % n]);
    open_.push_back(std::move(smaller));
  }

  bool is_accurate() const { return paths_ != nullptr; }

  FaceId face_;
  const std::vector<BoundaryCrossing>& boundary_;
  const FaceDistances& distances_;
  const FacePaths* paths_;  // null if branch points are guessed
  FaceDiagram& diagram_;
  LabelIntervals intervals_;
  BranchSearch search_;
  std::vector<FacePolygon> open_;  // polygons that remain to be assembled
};

}  // namespace

bool IntervalPair::crosses(const IntervalPair& other) const {
  const auto is_between = [this](std::size_t k) { return i < k && k < j; };
  const auto is_end = [this](std::size_t k) { return i == k || j == k; };
  return is_between(other.i) != is_between(other.j) && !is_end(other.i) && !is_end(other.j);
}

std::vector<IntervalPair> find_pairs_to_unite(const FacePolygon& polygon, const FaceDistances& distances,
                                              bool is_accurate) {
  const std::vector<IntervalPair> pairs = collect_pairs(polygon, distances, is_accurate);
  std::vector<IntervalPair> chosen;
  for (const IntervalPair& pair : pairs) {
    const bool fits =
        std::none_of(chosen.begin(), chosen.end(), [&](const IntervalPair& c) { return c.crosses(pair); });
    if (pair.excess <= 0 && fits) chosen.push_back(pair);
  }
  // If the distances are accurate, their paths have confirmed no branch point here, so that two intervals of one cell
  // belong to one piece although their paths enter through different sides.
  const bool must_unite = is_accurate || !has_three_different(polygon);
  if (chosen.empty() && !pairs.empty() && must_unite) chosen.push_back(pairs.front());
  return chosen;
}

void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
                   FaceDiagram& diagram, const FacePaths* paths) {
  if (boundary.empty()) return;
  if (boundary.size() == 2) {  // most faces, which need no lists
    diagram.arcs.push_back({f, at(boundary[0].id), at(boundary[1].id), boundary[1].next, boundary[0].next});
    return;
  }
  FaceAssembly(f, boundary, distances, paths, diagram).run();
}

}  // namespace gvd
