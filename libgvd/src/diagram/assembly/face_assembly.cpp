#include "diagram/assembly/face_assembly.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "diagram/assembly/branch_placement.hpp"
#include "diagram/assembly/branch_search.hpp"
#include "diagram/assembly/face_polygon.hpp"
#include "diagram/assembly/find_pairs_to_unite.hpp"
#include "diagram/assembly/label_intervals.hpp"
#include "diagram/assembly/split_polygon.hpp"

namespace gvd {
namespace {

class FaceAssembly {
 public:
  FaceAssembly(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
               FaceDiagram& diagram)
      : face_(f),
        boundary_(boundary),
        distances_(distances),
        diagram_(diagram),
        intervals_(boundary, distances),
        search_(distances, intervals_),
        placement_(distances.can_confirm()) {}

  void run() {
    FacePolygon polygon;
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      polygon.push_back({at(boundary_[i].id), boundary_[i].bary(), boundary_[i].next, static_cast<int>(i)});
    }
    if (polygon.size() > 3) intervals_.unite_by_paths();
    open_.push_back(std::move(polygon));
    while (!open_.empty()) {
      const FacePolygon next = std::move(open_.back());
      open_.pop_back();
      solve(next);
    }
  }

 private:
  /// Takes one step with a polygon, and puts what remains of it on open_.
  void solve(const FacePolygon& polygon) {
    if (polygon.size() == 2) return join(polygon[0], polygon[1]);
    if (split(polygon)) return;
    if (const auto confirmed = search_.find_confirmed(polygon)) {
      polygon.size() == 3 ? join_three(polygon, confirmed->point)
                          : close_interval(polygon, confirmed->corner, confirmed->point);
    } else if (const auto pairs = find_pairs_to_unite(polygon, distances_); !pairs.empty()) {
      unite(polygon, pairs);
    } else if (polygon.size() == 3) {
      join_three(polygon, place_last_branch(polygon));
    } else {
      contract(polygon);
    }
  }

  /// Splits the polygon along its united intervals. False where none are.
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
    // Where the face has three crossings, the straight arcs may lie anywhere in it.
    return boundary_.size() == 3 ? placement_.place_in_face(polygon, wanted)
                                 : placement_.place_in_polygon(polygon, wanted);
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
    close_interval(polygon, chosen, placement_.place_at_interval(polygon, chosen, wanted));
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

  FaceId face_;
  const std::vector<BoundaryCrossing>& boundary_;
  const FaceDistances& distances_;
  FaceDiagram& diagram_;
  LabelIntervals intervals_;
  BranchSearch search_;
  BranchPlacement placement_;
  std::vector<FacePolygon> open_;  // polygons that remain to be assembled
};

}  // namespace

void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
                   FaceDiagram& diagram) {
  if (boundary.empty()) return;
  FaceAssembly(f, boundary, distances, diagram).run();
}

}  // namespace gvd
