#include "diagram/face_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "diagram/union_find.hpp"

namespace gvd {
namespace {

using Bary = std::array<double, 3>;

/// A face's only branch point keeps this much of every barycentric coordinate, so that it lies inside the face: ten
/// times the gap that crossings keep from the corners, and a millionth of a triangle's height at the most that it is
/// moved.
constexpr double kInside = 1e-6;

/// The same where the metric is as good as exact: a branch point on a side, by a tie, is not moved by more than
/// rounding. A little below what such a metric puts its points inside by, so that these are taken as they are.
constexpr double kInsideExactly = 0.6 * kInsideFace;

/// How far beyond its opposite side a triangle's corner may lie, in barycentric coordinates. A branch point at a
/// vertex, by a tie, lies kInsideFace from it, as near as the crossings round it, and on whichever side of them; below
/// the 1e-11 from which a piece counts as turned.
constexpr double kTurnedByTie = 4.8e-12;

/// The way to a branch point that can't lie where it is wanted is halved this often: to the last digits of a
/// coordinate.
constexpr int kHalvings = 45;

/// And a last part of the way is not gone: at the limit three points lie on one line, and an arc would pass through
/// another's end. What is wanted up to kByTie beyond the limit, in barycentric coordinates, lies there by rounding;
/// what is wanted farther out is a guess, and no guess needs to be cut close.
constexpr double kShort = 1e-12, kShortOfGuess = 0.125, kByTie = 1e-9;

/// A path this near to a crossing, as a part of the edge, may belong to either of its cells.
constexpr double kNearCrossing = 1e-9;

/// One corner of the polygon that is left: a crossing, or a branch point that stands for two of them.
struct Corner {
  ArcEnd end;
  Bary bary;
  GeneratorId next;  ///< generator of the run from here to the next corner
  int run;           ///< that run: the one of the face's boundary that follows crossing `run`
};

using Polygon = std::vector<Corner>;

double signed_area(const Bary& a, const Bary& b, const Bary& c) {
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

Bary mix(const Bary& a, const Bary& b, double t) {
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

double apart(const Bary& p, const Bary& q) { return std::hypot(q[1] - p[1], q[2] - p[2]); }

/// Whether a, b, c go round counter-clockwise, but for c being up to `beyond` on the other side.
bool turns_left(const Bary& a, const Bary& b, const Bary& c, double beyond) {
  const double area = signed_area(a, b, c);
  return area >= 0 || area >= -beyond * std::max({apart(a, b), apart(b, c), apart(c, a)});
}

bool is_convex(const std::vector<Bary>& polygon, double beyond) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (!turns_left(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n], beyond)) return false;
  }
  return true;
}

class FaceAssembly {
 public:
  FaceAssembly(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceMetric& metric, FaceDiagram& diagram)
      : face_(f), boundary_(boundary), metric_(metric), diagram_(diagram), linked_(0) {}

  void run() {
    Polygon polygon;
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      polygon.push_back({at(boundary_[i].id), boundary_[i].bary(), boundary_[i].next, linked_.add()});
    }
    if (polygon.size() > 3) link_runs(polygon);
    open_.push_back(std::move(polygon));
    while (!open_.empty()) {
      const Polygon next = std::move(open_.back());
      open_.pop_back();
      solve(next);
    }
  }

 private:
  /// Unites the runs of one generator that are known to be one piece: the shortest path to the middle of the one comes
  /// into the face through the other.
  void link_runs(const Polygon& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto entry = metric_.entry(polygon[i].next, middle_of_run(i));
      if (!entry) return;
      const int run = run_at(*entry);
      if (polygon[static_cast<std::size_t>(run)].next == polygon[i].next) linked_.unite(run, static_cast<int>(i));
    }
  }

  double place(std::size_t crossing) const { return boundary_[crossing].corner + boundary_[crossing].t; }

  /// The run that contains a place on the boundary, counted as corner + t.
  int run_at(double where) const {
    const auto after = std::upper_bound(boundary_.begin(), boundary_.end(), where,
                                        [](double w, const BoundaryCrossing& c) { return w < c.corner + c.t; });
    const auto i = static_cast<std::size_t>(after - boundary_.begin());
    return static_cast<int>((i + boundary_.size() - 1) % boundary_.size());
  }

  /// A point half way along run i on the boundary.
  Bary middle_of_run(std::size_t i) const {
    const double begin = place(i), end = place((i + 1) % boundary_.size());
    const double half = 0.5 * (begin + end + (end > begin ? 0 : 3));
    const double where = half < 3 ? half : half - 3;
    const auto corner = std::min<std::size_t>(static_cast<std::size_t>(where), 2);
    Bary bary{0, 0, 0};
    bary[corner] = 1 - (where - static_cast<double>(corner));
    bary[(corner + 1) % 3] = where - static_cast<double>(corner);
    return bary;
  }

  /// Takes one step with a polygon, and puts what is left of it on open_.
  void solve(const Polygon& polygon) {
    if (polygon.size() == 2) return join(polygon[0], polygon[1], polygon[1].next, polygon[0].next);
    if (part_linked_runs(polygon)) return;
    if (const auto sure = sure_triple(polygon)) {
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
  void unite(const Polygon& polygon, const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs) linked_.unite(polygon[pair.i].run, polygon[pair.j].run);
    tried_.clear();  // paths may come by more runs now
    part_linked_runs(polygon);
  }

  /// Parts the polygon wherever two of its runs, not next to each other, are known to be one piece. False where there
  /// are none. Pieces don't cross, so each lies within the last one begun: a stack.
  bool part_linked_runs(const Polygon& polygon) {
    const auto parts_before = open_.size();
    Polygon rest;
    std::map<int, std::vector<std::size_t>> met;  // piece -> places of its runs in rest
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t now = rest.size();
      auto& places = met[linked_.find(polygon[k].run)];
      // Some of them have gone out of rest with a part since.
      while (!places.empty() && (places.back() >= now || !is_linked(rest[places.back()], polygon[k])))
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

  bool is_linked(const Corner& a, const Corner& b) { return linked_.find(a.run) == linked_.find(b.run); }

  void join(const Corner& begin, const Corner& end, GeneratorId left, GeneratorId right) {
    diagram_.arcs.push_back({face_, begin.end, end.end, left, right});
  }

  /// Corners first .. last (cyclic) as a polygon of its own.
  static Polygon part(const Polygon& polygon, std::size_t first, std::size_t last) {
    Polygon result;
    for (std::size_t k = first; k < last; ++k) result.push_back(polygon[k % polygon.size()]);
    return result;
  }

  /// Pairs whose generator is the nearest one between the two runs, the surest first, and none that crosses a surer
  /// one. Where there are none and no three different generators follow each other, the best pair whatever it is.
  std::vector<Pair> pairs_to_unite(const Polygon& polygon) const {
    const std::vector<Pair> pairs = pairs_of_one_generator(polygon);
    std::vector<Pair> chosen;
    for (const Pair& pair : pairs) {
      const bool fits = std::none_of(chosen.begin(), chosen.end(), [&](const Pair& c) { return c.crosses(pair); });
      if (pair.lead <= 0 && fits) chosen.push_back(pair);
    }
    // A sure metric has ruled out every triple by now: two runs of one cell are one piece, though their paths come in
    // by different sides.
    const bool must = metric_.is_sure() || !triple_exists(polygon);
    if (chosen.empty() && !pairs.empty() && must) chosen.push_back(pairs.front());
    return chosen;
  }

  /// All pairs, ascending.
  std::vector<Pair> pairs_of_one_generator(const Polygon& polygon) const {
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

  double lead(const Polygon& polygon, std::size_t i, std::size_t j) const {
    const Bary between = mix(middle(polygon, i), middle(polygon, j), 0.5);
    double others = std::numeric_limits<double>::infinity();
    for (const Corner& c : polygon) {
      if (c.next != polygon[i].next) others = std::min(others, metric_.at(c.next, between));
    }
    const double own = metric_.at(polygon[i].next, between);
    return std::isinf(own) ? own : own - others;
  }

  static bool triple_exists(const Polygon& polygon) {
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
      if (polygon[i].next != polygon[(i + 2) % n].next) return true;
    }
    return false;
  }

  /// Run i with the runs before and after it meets in a point that the metric is sure of.
  struct Triple {
    std::size_t run;
    Bary point;
  };
  std::optional<Triple> sure_triple(const Polygon& polygon) {
    if (!metric_.is_sure()) return std::nullopt;
    const Bary inside = centre(polygon);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      if (!is_new_try(polygon, i, Search::nearby)) continue;
      const Bary start = mix(middle(polygon, i), inside, 0.5);
      if (const auto p = sure_point(polygon, i, start)) return Triple{i, *p};
    }
    // Distances have ridges, where the search can get stuck: wherever three paths may meet, then.
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
      const GeneratorId x = polygon[(i + n - 1) % n].next, y = polygon[i].next, z = polygon[(i + 1) % n].next;
      if (x == z || !is_new_try(polygon, i, Search::everywhere)) continue;
      for (const Bary& start : metric_.meeting_points(x, y, z)) {
        if (const auto p = sure_point(polygon, i, start)) return Triple{i, *p};
      }
    }
    return std::nullopt;
  }

  /// Whether run i between its two neighbours has not been searched for a branch point yet; from now on it has. Most
  /// runs keep their neighbours when one is closed: without this, hundreds of generators in one face take minutes.
  enum class Search { nearby, everywhere };
  bool is_new_try(const Polygon& polygon, std::size_t i, Search search) {
    const std::size_t n = polygon.size();
    return tried_.insert({search, polygon[(i + n - 1) % n].run, polygon[i].run, polygon[(i + 1) % n].run}).second;
  }

  /// The branch point that run i and its neighbours make, looked for from `start` on.
  std::optional<Bary> sure_point(const Polygon& polygon, std::size_t i, const Bary& start) {
    const std::size_t n = polygon.size();
    const Corner &before = polygon[(i + n - 1) % n], &run = polygon[i], &after = polygon[(i + 1) % n];
    if (before.next == after.next) return std::nullopt;
    const auto p = metric_.equidistant(before.next, run.next, after.next, start);
    if (!p || !metric_.is_branch_point(before.next, run.next, after.next, *p)) return std::nullopt;
    return comes_by(before, *p) && comes_by(run, *p) && comes_by(after, *p) ? p : std::nullopt;
  }

  /// Whether the shortest path to p of the generator of this corner's run comes into the face by that run.
  bool comes_by(const Corner& corner, const Bary& p) {
    const auto entry = metric_.entry(corner.next, p);
    if (!entry) return false;
    const auto belongs = [&](std::size_t run) {
      return linked_.find(static_cast<int>(run)) == linked_.find(corner.run);
    };
    const auto n = boundary_.size(), run = static_cast<std::size_t>(run_at(*entry));
    if (belongs(run)) return true;
    // Where a crossing is as near as rounding, the path may as well come by the run beyond it.
    for (std::size_t i = run; is_near_crossing(*entry, i); i = (i + n - 1) % n) {
      if (belongs((i + n - 1) % n)) return true;
      if (i == (run + 1) % n) break;
    }
    for (std::size_t i = (run + 1) % n; is_near_crossing(*entry, i); i = (i + 1) % n) {
      if (belongs(i)) return true;
      if (i == run) break;
    }
    return false;
  }

  bool is_near_crossing(double where, std::size_t i) const {
    const double apart = std::abs(where - place(i));
    return std::min(apart, 3 - apart) <= std::max(kNearCrossing, metric_.place_error(boundary_[i]));
  }

  static Bary middle(const Polygon& polygon, std::size_t i) {
    return mix(polygon[i].bary, polygon[(i + 1) % polygon.size()].bary, 0.5);
  }
  static Bary centre(const Polygon& polygon) {
    Bary sum{0, 0, 0};
    for (const Corner& c : polygon) {
      for (std::size_t k = 0; k < 3; ++k) sum[k] += c.bary[k] / static_cast<double>(polygon.size());
    }
    return sum;
  }

  /// In the convex polygon, or on its boundary. Crossings of one edge span a polygon without area: then branch points
  /// lie on that edge, and the pieces between them have no area either, but never a negative one.
  bool inside(const Polygon& polygon, const Bary& p) const {
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
      if (!turns_left(polygon[i].bary, polygon[(i + 1) % n].bary, p, beyond())) return false;
    }
    return *std::min_element(p.begin(), p.end()) >= 0;
  }

  /// How far a triangle may be turned the wrong way round.
  double beyond() const { return metric_.is_sure() ? kTurnedByTie : 0; }

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

  /// A point that is equally far from the three generators, looked for from `start` on. Distances have ridges, where
  /// the search gets stuck; where a sure metric finds nothing in the face, it looks again from the polygon's corners
  /// and the face's. By a tie, that is where such a point is: at a vertex, or on an edge that is a bisector.
  std::optional<Bary> branch_between(const Polygon& polygon, const std::array<GeneratorId, 3>& g,
                                     const Bary& start) const {
    const auto first = metric_.equidistant(g[0], g[1], g[2], start);
    if (!metric_.is_sure() || is_in_face(first)) return first;
    std::vector<Bary> starts{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Corner& corner : polygon) starts.push_back(corner.bary);
    for (const Bary& other : starts) {
      const auto p = metric_.equidistant(g[0], g[1], g[2], other);
      if (is_in_face(p)) return p;
    }
    return first;
  }

  static bool is_in_face(const std::optional<Bary>& p) {
    return p && *std::min_element(p->begin(), p->end()) > -kBeyondFace;
  }

  BranchPointId add_branch(const Bary& p) { return diagram_.branches.push_back({face_, p, 0}); }

  void finish_branch(const Polygon& polygon) {
    // Where the polygon is all of the face's crossings, a lone branch point may lie anywhere in the face.
    const bool whole = boundary_.size() == 3;
    const Bary safe = centre(polygon);
    const auto valid = [&](const Bary& p) {
      return whole ? *std::min_element(p.begin(), p.end()) >= (metric_.is_sure() ? kInsideExactly : kInside)
                   : inside(polygon, p);
    };
    const auto wanted = branch_between(polygon, {polygon[0].next, polygon[1].next, polygon[2].next}, safe);
    join_three(polygon, approach(safe, wanted, valid));
  }

  void join_three(const Polygon& polygon, const Bary& p) {
    const BranchPointId b = add_branch(p);
    for (std::size_t i = 0; i < 3; ++i) {
      diagram_.arcs.push_back({face_, polygon[i].end, at(b), polygon[(i + 2) % 3].next, polygon[i].next});
    }
  }

  /// Contracts the three consecutive runs whose branch point no other generator comes near.
  void contract(const Polygon& polygon) {
    const std::size_t n = polygon.size();
    std::size_t chosen = n;
    double best = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (polygon[(i + n - 1) % n].next == polygon[(i + 1) % n].next) continue;
      const double now = lead_of_triple(polygon, i);
      if (chosen == n || now > best) std::tie(chosen, best) = std::tuple(i, now);
    }
    contract_run(polygon, chosen);
  }

  /// How much nearer run i and its neighbours are than all others, where they meet. A triple that meets outside of the
  /// face, or nowhere, is the last choice.
  double lead_of_triple(const Polygon& polygon, std::size_t i) const {
    const std::size_t n = polygon.size();
    const GeneratorId x = polygon[(i + n - 1) % n].next, y = polygon[i].next, z = polygon[(i + 1) % n].next;
    const auto p = branch_between(polygon, {x, y, z}, middle(polygon, i));
    if (!is_in_face(p)) return -std::numeric_limits<double>::max();
    double lead = std::numeric_limits<double>::infinity();
    for (const Corner& c : polygon) {
      if (c.next != x && c.next != y && c.next != z) lead = std::min(lead, metric_.at(c.next, *p) - metric_.at(y, *p));
    }
    return lead;
  }

  /// Closes run i of the polygon with a branch point between its two neighbours.
  void contract_run(const Polygon& polygon, std::size_t i) {
    const std::size_t n = polygon.size();
    const Corner &first = polygon[i], &second = polygon[(i + 1) % n];
    const GeneratorId x = polygon[(i + n - 1) % n].next, y = first.next, z = second.next;
    std::vector<Bary> rest{Bary{}};  // the branch point, then the remaining corners
    for (std::size_t k = 2; k < n; ++k) rest.push_back(polygon[(i + k) % n].bary);
    const auto valid = [&](const Bary& p) {
      rest[0] = p;
      return is_convex(rest, beyond()) && inside(polygon, p);
    };
    // What is valid is the quadrilateral of the run's ends and the corners next to them: all in all its middle is.
    const Polygon around{polygon[(i + n - 1) % n], first, second, polygon[(i + 2) % n]};
    const auto wanted = branch_between(polygon, {x, y, z}, middle(polygon, i));
    close_run(polygon, i, approach(centre(around), wanted, valid));
  }

  /// Joins the two ends of run i to a branch point at p, and goes on with what is left.
  void close_run(const Polygon& polygon, std::size_t i, const Bary& p) {
    const std::size_t n = polygon.size();
    const Corner &first = polygon[i], &second = polygon[(i + 1) % n];
    const GeneratorId x = polygon[(i + n - 1) % n].next, y = first.next, z = second.next;
    const BranchPointId b = add_branch(p);
    diagram_.arcs.push_back({face_, first.end, at(b), x, y});
    diagram_.arcs.push_back({face_, second.end, at(b), y, z});
    Polygon smaller{{at(b), p, z, second.run}};
    for (std::size_t k = 2; k < n; ++k) smaller.push_back(polygon[(i + k) % n]);
    open_.push_back(std::move(smaller));
  }

  FaceId face_;
  const std::vector<BoundaryCrossing>& boundary_;
  const FaceMetric& metric_;
  FaceDiagram& diagram_;
  std::vector<Polygon> open_;                          // what is left to do
  UnionFind linked_;                                   // runs of the boundary that are one piece
  std::set<std::tuple<Search, int, int, int>> tried_;  // searches for a branch point of three runs that found none
};

}  // namespace

void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceMetric& metric,
                   FaceDiagram& diagram) {
  if (boundary.empty()) return;
  FaceAssembly(f, boundary, metric, diagram).run();
}

}  // namespace gvd
