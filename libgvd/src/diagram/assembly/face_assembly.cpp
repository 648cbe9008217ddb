#include "diagram/assembly/face_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "diagram/assembly/branch_search.hpp"
#include "diagram/assembly/face_polygon.hpp"
#include "diagram/assembly/label_intervals.hpp"

namespace gvd {
namespace {

using Bary = std::array<double, 3>;

/// A face's only branch point keeps this much of every barycentric coordinate, so that it lies inside the face: ten
/// times the gap that crossings keep from the corners, and a millionth of a triangle's height at the most that it is
/// moved.
constexpr double kInside = 1e-6;

/// The way to a branch point that can't lie where it is wanted is halved this often: to the last digits of a
/// coordinate.
constexpr int kHalvings = 45;

/// And a last part of the way is not gone: at the limit three points lie on one line, and an arc would pass through
/// another's end. What is wanted up to kByTie beyond the limit, in barycentric coordinates, lies there by rounding;
/// what is wanted farther out is a guess, and no guess needs to be cut close.
constexpr double kShort = 1e-12, kShortOfGuess = 0.125, kByTie = 1e-9;

class FaceAssembly {
 public:
  FaceAssembly(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
               FaceDiagram& diagram)
      : face_(f),
        boundary_(boundary),
        distances_(distances),
        diagram_(diagram),
        runs_(boundary, distances),
        search_(distances, runs_) {}

  void run() {
    FacePolygon polygon;
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      polygon.push_back({at(boundary_[i].id), boundary_[i].bary(), boundary_[i].next, static_cast<int>(i)});
    }
    if (polygon.size() > 3) runs_.unite_by_paths();
    open_.push_back(std::move(polygon));
    while (!open_.empty()) {
      const FacePolygon next = std::move(open_.back());
      open_.pop_back();
      solve(next);
    }
  }

 private:
  /// Takes one step with a polygon, and puts what is left of it on open_.
  void solve(const FacePolygon& polygon) {
    if (polygon.size() == 2) return join(polygon[0], polygon[1], polygon[1].next, polygon[0].next);
    if (part_linked_runs(polygon)) return;
    if (const auto sure = search_.find_confirmed(polygon)) {
      polygon.size() == 3 ? join_three(polygon, sure->point) : close_run(polygon, sure->run, sure->point);
    } else if (const auto pairs = pairs_to_unite(polygon); !pairs.empty()) {
      unite(polygon, pairs);
    } else if (polygon.size() == 3) {
      finish_branch(polygon);
    } else {
      contract(polygon);
    }
  }

  /// Two runs i < j of a polygon that have one generator.
  struct Pair {
    double lead;  ///< how much farther it is than the nearest other one, half way between the two; negative: nearer
    std::size_t i, j;
    bool operator<(const Pair& other) const { return std::tie(lead, i, j) < std::tie(other.lead, other.i, other.j); }
    bool crosses(const Pair& other) const {
      return parts(other.i) != parts(other.j) && !ends_at(other.i) && !ends_at(other.j);
    }

   private:
    bool parts(std::size_t k) const { return i < k && k < j; }
    bool ends_at(std::size_t k) const { return i == k || j == k; }
  };

  /// Joins the two runs of each pair to one piece, which parts the polygon.
  void unite(const FacePolygon& polygon, const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs) runs_.unite(polygon[pair.i].run, polygon[pair.j].run);
    search_.clear_failed_searches();
    part_linked_runs(polygon);
  }

  /// Parts the polygon wherever two of its runs, not next to each other, are known to be one piece. False where there
  /// are none. Pieces don't cross, so each lies within the last one begun: a stack.
  bool part_linked_runs(const FacePolygon& polygon) {
    const auto parts_before = open_.size();
    FacePolygon rest;
    std::map<int, std::vector<std::size_t>> met;  // piece -> places of its runs in rest
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t now = rest.size();
      auto& places = met[runs_.piece(polygon[k].run)];
      // Some of them have gone out of rest with a part since.
      while (!places.empty() && (places.back() >= now || !runs_.are_one_piece(rest[places.back()].run, polygon[k].run)))
        places.pop_back();
      rest.push_back(polygon[k]);
      const bool around = !places.empty() && places.back() == 0 && k + 1 == polygon.size();
      if (places.empty() || places.back() + 1 == now || around) {
        places.push_back(now);
        continue;
      }
      const auto begin = rest.begin() + static_cast<std::ptrdiff_t>(places.back() + 1);
      open_.emplace_back(begin, rest.end());
      rest.erase(begin, rest.end());
    }
    if (open_.size() == parts_before) return false;
    open_.push_back(std::move(rest));
    return true;
  }

  void join(const PolygonCorner& begin, const PolygonCorner& end, GeneratorId left, GeneratorId right) {
    diagram_.arcs.push_back({face_, begin.end, end.end, left, right});
  }

  /// Pairs whose generator is the nearest one between the two runs, the surest first, and none that crosses a surer
  /// one. Where there are none and no three different generators follow each other, the best pair whatever it is.
  std::vector<Pair> pairs_to_unite(const FacePolygon& polygon) const {
    const std::vector<Pair> pairs = pairs_of_one_generator(polygon);
    std::vector<Pair> chosen;
    for (const Pair& pair : pairs) {
      const bool fits = std::none_of(chosen.begin(), chosen.end(), [&](const Pair& c) { return c.crosses(pair); });
      if (pair.lead <= 0 && fits) chosen.push_back(pair);
    }
    // A sure metric has ruled out every triple by now: two runs of one cell are one piece, though their paths come in
    // by different sides.
    const bool must = distances_.can_confirm() || !triple_exists(polygon);
    if (chosen.empty() && !pairs.empty() && must) chosen.push_back(pairs.front());
    return chosen;
  }

  /// All pairs, ascending.
  std::vector<Pair> pairs_of_one_generator(const FacePolygon& polygon) const {
    std::map<GeneratorId, std::vector<std::size_t>> runs;
    for (std::size_t i = 0; i < polygon.size(); ++i) runs[polygon[i].next].push_back(i);
    std::vector<Pair> pairs;
    for (const auto& [generator, places] : runs) {
      for (std::size_t b = 1; b < places.size(); ++b) {
        for (std::size_t a = 0; a < b; ++a)
          pairs.push_back({lead(polygon, places[a], places[b]), places[a], places[b]});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  double lead(const FacePolygon& polygon, std::size_t i, std::size_t j) const {
    const Bary between = mix(middle(polygon, i), middle(polygon, j), 0.5);
    double others = std::numeric_limits<double>::infinity();
    for (const PolygonCorner& c : polygon) {
      if (c.next != polygon[i].next) others = std::min(others, distances_.at(c.next, between));
    }
    const double own = distances_.at(polygon[i].next, between);
    return std::isinf(own) ? own : own - others;
  }

  static bool triple_exists(const FacePolygon& polygon) {
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
      if (polygon[i].next != polygon[(i + 2) % n].next) return true;
    }
    return false;
  }

  /// How far a triangle may be turned the wrong way round.
  double beyond() const { return distances_.can_confirm() ? kTurnedByTie : 0; }

  /// The point nearest to `wanted` on the way to it from `safe` that `valid` accepts.
  template <class Valid>
  static Bary approach(const Bary& safe, const std::optional<Bary>& wanted, Valid valid) {
    if (!wanted) return safe;
    if (valid(*wanted)) return *wanted;
    double from = 0, to = 1;
    for (int step = 0; step < kHalvings; ++step) {
      const double t = 0.5 * (from + to);
      (valid(mix(safe, *wanted, t)) ? from : to) = t;
    }
    const double rest = (1 - from) * apart(safe, *wanted);
    return mix(safe, *wanted, from * (1 - (rest > kByTie ? kShortOfGuess : kShort)));
  }

  BranchPointId add_branch(const Bary& p) { return diagram_.branches.push_back({face_, p, 0}); }

  void finish_branch(const FacePolygon& polygon) {
    // Where the polygon is all of the face's crossings, a lone branch point may lie anywhere in the face.
    const bool whole = boundary_.size() == 3;
    const Bary safe = centre(polygon);
    const auto valid = [&](const Bary& p) {
      return whole ? *std::min_element(p.begin(), p.end()) >= (distances_.can_confirm() ? kInsideExactly : kInside)
                   : is_inside(polygon, p, beyond());
    };
    const auto wanted = search_.guess(polygon, 1, safe);
    join_three(polygon, approach(safe, wanted, valid));
  }

  void join_three(const FacePolygon& polygon, const Bary& p) {
    const BranchPointId b = add_branch(p);
    for (std::size_t i = 0; i < 3; ++i) {
      diagram_.arcs.push_back({face_, polygon[i].end, at(b), polygon[(i + 2) % 3].next, polygon[i].next});
    }
  }

  /// Contracts the three consecutive runs whose branch point no other generator comes near.
  void contract(const FacePolygon& polygon) {
    const std::size_t n = polygon.size();
    std::size_t chosen = n;
    double best = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (polygon[(i + n - 1) % n].next == polygon[(i + 1) % n].next) continue;
      const double now = search_.lead(polygon, i);
      if (chosen == n || now > best) std::tie(chosen, best) = std::tuple(i, now);
    }
    contract_run(polygon, chosen);
  }

  /// Closes run i of the polygon with a branch point between its two neighbours.
  void contract_run(const FacePolygon& polygon, std::size_t i) {
    const std::size_t n = polygon.size();
    const PolygonCorner &first = polygon[i], &second = polygon[(i + 1) % n];
    std::vector<Bary> rest{Bary{}};  // the branch point, then the remaining corners
    for (std::size_t k = 2; k < n; ++k) rest.push_back(polygon[(i + k) % n].bary);
    const auto valid = [&](const Bary& p) {
      rest[0] = p;
      return is_convex(rest, beyond()) && is_inside(polygon, p, beyond());
    };
    // What is valid is the quadrilateral of the run's ends and the corners next to them: all in all its middle is.
    const FacePolygon around{polygon[(i + n - 1) % n], first, second, polygon[(i + 2) % n]};
    const auto wanted = search_.guess(polygon, i, middle(polygon, i));
    close_run(polygon, i, approach(centre(around), wanted, valid));
  }

  /// Joins the two ends of run i to a branch point at p, and goes on with what is left.
  void close_run(const FacePolygon& polygon, std::size_t i, const Bary& p) {
    const std::size_t n = polygon.size();
    const PolygonCorner &first = polygon[i], &second = polygon[(i + 1) % n];
    const GeneratorId x = polygon[(i + n - 1) % n].next, y = first.next, z = second.next;
    const BranchPointId b = add_branch(p);
    diagram_.arcs.push_back({face_, first.end, at(b), x, y});
    diagram_.arcs.push_back({face_, second.end, at(b), y, z});
    FacePolygon smaller{{at(b), p, z, second.run}};
    for (std::size_t k = 2; k < n; ++k) smaller.push_back(polygon[(i + k) % n]);
    open_.push_back(std::move(smaller));
  }

  FaceId face_;
  const std::vector<BoundaryCrossing>& boundary_;
  const FaceDistances& distances_;
  FaceDiagram& diagram_;
  LabelIntervals runs_;
  BranchSearch search_;
  std::vector<FacePolygon> open_;  // what is left to do
};

}  // namespace

void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
                   FaceDiagram& diagram) {
  if (boundary.empty()) return;
  FaceAssembly(f, boundary, distances, diagram).run();
}

}  // namespace gvd
