#include "diagram/assembly/branch_search.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace gvd {
namespace {

/// A polygon's interval i and the intervals before and after it, each by the corner that it begins at.
struct Neighbours {
  const PolygonCorner &before, &own, &after;
  Neighbours(const FacePolygon& polygon, std::size_t i)
      : before(polygon[(i + polygon.size() - 1) % polygon.size()]),
        own(polygon[i]),
        after(polygon[(i + 1) % polygon.size()]) {}
  bool differ() const { return before.next != after.next; }
};

bool is_in_face(const std::optional<Bary>& p) { return p && *std::min_element(p->begin(), p->end()) > -kBeyondFace; }

}  // namespace

std::optional<BranchSearch::Confirmed> BranchSearch::find_confirmed(const FacePolygon& polygon) {
  if (!distances_.can_confirm()) return std::nullopt;
  const Bary inside = centre(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!is_first_search(polygon, i, Search::from_nearby)) continue;
    if (const auto p = confirmed_point(polygon, i, mix(midpoint(polygon, i), inside, 0.5))) return Confirmed{i, *p};
  }
  // The search stagnates at ridges of the distances. So now it starts from every candidate.
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Neighbours near(polygon, i);
    if (!near.differ() || !is_first_search(polygon, i, Search::everywhere)) continue;
    for (const Bary& start : distances_.equidistant_points(near.before.next, near.own.next, near.after.next)) {
      if (const auto p = confirmed_point(polygon, i, start)) return Confirmed{i, *p};
    }
  }
  return std::nullopt;
}

/// Whether this search for interval i and its neighbours has not been made yet; records it. Most intervals keep their
/// neighbours when one is closed: without the record, hundreds of generators in one face take minutes.
bool BranchSearch::is_first_search(const FacePolygon& polygon, std::size_t i, Search search) {
  const Neighbours near(polygon, i);
  return failed_.insert({search, near.before.interval, near.own.interval, near.after.interval}).second;
}

/// The confirmed branch point of interval i and its neighbours, searched from `start`.
std::optional<Bary> BranchSearch::confirmed_point(const FacePolygon& polygon, std::size_t i, const Bary& start) {
  const Neighbours near(polygon, i);
  if (!near.differ()) return std::nullopt;
  const auto p = distances_.equidistant(near.before.next, near.own.next, near.after.next, start);
  if (!p || !distances_.is_branch_point(near.before.next, near.own.next, near.after.next, *p)) return std::nullopt;
  for (const PolygonCorner* corner : {&near.before, &near.own, &near.after}) {
    if (!intervals_.path_enters_through(corner->interval, *p)) return std::nullopt;
  }
  return p;
}

/// Where the first search of accurate distances ends outside of the face, others start at the polygon's corners and the
/// face's. By a tie the point lies there: at a vertex, or on an edge that is a bisector.
std::optional<Bary> BranchSearch::guess(const FacePolygon& polygon, std::size_t i, const Bary& start) const {
  const Neighbours near(polygon, i);
  const auto search = [&](const Bary& from) {
    return distances_.equidistant(near.before.next, near.own.next, near.after.next, from);
  };
  const auto first = search(start);
  if (!distances_.can_confirm() || is_in_face(first)) return first;
  std::vector<Bary> starts{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const PolygonCorner& corner : polygon) starts.push_back(corner.bary);
  for (const Bary& other : starts) {
    const auto p = search(other);
    if (is_in_face(p)) return p;
  }
  return first;
}

double BranchSearch::clearance(const FacePolygon& polygon, std::size_t i) const {
  const Neighbours near(polygon, i);
  const auto p = guess(polygon, i, midpoint(polygon, i));
  if (!is_in_face(p)) return -std::numeric_limits<double>::max();
  const double own = distances_.at(near.own.next, *p);
  double least = std::numeric_limits<double>::infinity();
  for (const PolygonCorner& c : polygon) {
    if (c.next == near.before.next || c.next == near.own.next || c.next == near.after.next) continue;
    least = std::min(least, distances_.at(c.next, *p) - own);
  }
  return least;
}

}  // namespace gvd
