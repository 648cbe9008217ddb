#include "diagram/assembly/branch_search.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace gvd {
namespace {

using Bary = FaceDistances::Bary;

/// Run i of a polygon and the ones before and after it.
struct Neighbours {
  const PolygonCorner &before, &run, &after;
  Neighbours(const FacePolygon& polygon, std::size_t i)
      : before(polygon[(i + polygon.size() - 1) % polygon.size()]),
        run(polygon[i]),
        after(polygon[(i + 1) % polygon.size()]) {}
  bool differ() const { return before.next != after.next; }
};

bool is_in_face(const std::optional<Bary>& p) { return p && *std::min_element(p->begin(), p->end()) > -kBeyondFace; }

}  // namespace

std::optional<BranchSearch::Triple> BranchSearch::find_confirmed(const FacePolygon& polygon) {
  if (!distances_.can_confirm()) return std::nullopt;
  const Bary inside = centre(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!is_new_try(polygon, i, Search::nearby)) continue;
    if (const auto p = confirmed_point(polygon, i, mix(middle(polygon, i), inside, 0.5))) return Triple{i, *p};
  }
  // Distances have ridges, where the search can get stuck: wherever three paths may meet, then.
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Neighbours near(polygon, i);
    if (!near.differ() || !is_new_try(polygon, i, Search::everywhere)) continue;
    for (const Bary& start : distances_.equidistant_points(near.before.next, near.run.next, near.after.next)) {
      if (const auto p = confirmed_point(polygon, i, start)) return Triple{i, *p};
    }
  }
  return std::nullopt;
}

/// Whether run i between its two neighbours has not been searched for a branch point yet; from now on it has. Most runs
/// keep their neighbours when one is closed: without this, hundreds of generators in one face take minutes.
bool BranchSearch::is_new_try(const FacePolygon& polygon, std::size_t i, Search search) {
  const Neighbours near(polygon, i);
  return tried_.insert({search, near.before.run, near.run.run, near.after.run}).second;
}

/// The branch point that run i and its neighbours make, looked for from `start` on.
std::optional<Bary> BranchSearch::confirmed_point(const FacePolygon& polygon, std::size_t i, const Bary& start) {
  const Neighbours near(polygon, i);
  if (!near.differ()) return std::nullopt;
  const auto p = distances_.equidistant(near.before.next, near.run.next, near.after.next, start);
  if (!p || !distances_.is_branch_point(near.before.next, near.run.next, near.after.next, *p)) return std::nullopt;
  for (const PolygonCorner* corner : {&near.before, &near.run, &near.after}) {
    if (!runs_.path_enters_through(corner->run, *p)) return std::nullopt;
  }
  return p;
}

/// Distances have ridges, where the search gets stuck; where a sure metric finds nothing in the face, it looks again
/// from the polygon's corners and the face's. By a tie, that is where such a point is: at a vertex, or on an edge that
/// is a bisector.
std::optional<Bary> BranchSearch::guess(const FacePolygon& polygon, std::size_t i, const Bary& start) const {
  const Neighbours near(polygon, i);
  const auto look = [&](const Bary& from) {
    return distances_.equidistant(near.before.next, near.run.next, near.after.next, from);
  };
  const auto first = look(start);
  if (!distances_.can_confirm() || is_in_face(first)) return first;
  std::vector<Bary> starts{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const PolygonCorner& corner : polygon) starts.push_back(corner.bary);
  for (const Bary& other : starts) {
    const auto p = look(other);
    if (is_in_face(p)) return p;
  }
  return first;
}

double BranchSearch::lead(const FacePolygon& polygon, std::size_t i) const {
  const Neighbours near(polygon, i);
  const auto p = guess(polygon, i, middle(polygon, i));
  if (!is_in_face(p)) return -std::numeric_limits<double>::max();
  const double own = distances_.at(near.run.next, *p);
  double least = std::numeric_limits<double>::infinity();
  for (const PolygonCorner& c : polygon) {
    if (c.next == near.before.next || c.next == near.run.next || c.next == near.after.next) continue;
    least = std::min(least, distances_.at(c.next, *p) - own);
  }
  return least;
}

}  // namespace gvd
