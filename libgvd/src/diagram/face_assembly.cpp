#include "diagram/face_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "diagram/union_find.hpp"

namespace gvd {
namespace {

using Bary = std::array<double, 3>;

/// A face's only branch point keeps this much of every barycentric coordinate, so that it lies inside the face: ten
/// times the gap that crossings keep from the corners, and a millionth of a triangle's height at the most that it is
/// moved.
constexpr double kInside = 1e-6;

/// The same where the metric is as good as exact: a branch point on a side, by a tie, is not moved by more than
/// rounding.
constexpr double kInsideExactly = 1e-11;

/// The way to a branch point that can't lie where it is wanted is halved this often: to the last digits of a
/// coordinate.
constexpr int kHalvings = 45;

/// Branch points are looked for from the points of a lattice with this many steps a side, where that is needed.
constexpr int kLattice = 4;

/// A path this near to a crossing, as a part of the edge, may belong to either of its cells.
constexpr double kNearCrossing = 1e-9;

/// One corner of the polygon that is left: a crossing, or a branch point that stands for two of them.
struct Corner {
  ArcEnd end;
  Bary bary;
  GeneratorId next;  ///< generator of the run from here to the next corner
  int run;           ///< that run: the one of the face's boundary that follows crossing `run`
};

double signed_area(const Bary& a, const Bary& b, const Bary& c) {
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

Bary mix(const Bary& a, const Bary& b, double t) {
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

bool is_convex(const std::vector<Bary>& polygon) {
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    if (signed_area(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) < 0) return false;
  }
  return true;
}

class FaceAssembly {
 public:
  FaceAssembly(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceMetric& metric, FaceDiagram& diagram)
      : face_(f), boundary_(boundary), metric_(metric), diagram_(diagram), linked_(0) {}

  void run() {
    std::vector<Corner> polygon;
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      polygon.push_back({at(boundary_[i].id), boundary_[i].bary(), boundary_[i].next, linked_.add()});
    }
    if (polygon.size() > 3) link_runs(polygon);
    solve(polygon, true);
  }

 private:
  /// Unites the runs of one generator that are known to be one piece: the shortest path to the middle of the one comes
  /// into the face through the other.
  void link_runs(const std::vector<Corner>& polygon) {
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
    std::size_t i = 0;
    while (i < boundary_.size() && place(i) <= where) ++i;
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

  /// `whole`: the polygon is all of the face's crossings, so that a lone branch point may lie anywhere in the face.
  void solve(const std::vector<Corner>& polygon, bool whole) {
    if (polygon.size() == 2) return join(polygon[0], polygon[1], polygon[1].next, polygon[0].next);
    if (const auto linked = linked_pair(polygon)) {
      unite(polygon, linked->first, linked->second);
    } else if (const auto sure = sure_triple(polygon)) {
      polygon.size() == 3 ? join_three(polygon, sure->point) : close_run(polygon, sure->run, sure->point);
    } else if (const auto pair = pair_to_unite(polygon)) {
      unite(polygon, pair->first, pair->second);
    } else if (polygon.size() == 3) {
      finish_branch(polygon, whole);
    } else {
      contract(polygon);
    }
  }

  /// Joins runs i < j of one generator to one piece, which parts the polygon in two.
  void unite(const std::vector<Corner>& polygon, std::size_t i, std::size_t j) {
    linked_.unite(polygon[i].run, polygon[j].run);
    solve(part(polygon, i + 1, j + 1), false);
    solve(part(polygon, j + 1, i + 1 + polygon.size()), false);
  }

  /// Two runs of the polygon that are known to be one piece.
  std::optional<std::pair<std::size_t, std::size_t>> linked_pair(const std::vector<Corner>& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      for (std::size_t j = i + 2; j < polygon.size(); ++j) {
        const bool around = i == 0 && j + 1 == polygon.size();
        if (!around && linked_.find(polygon[i].run) == linked_.find(polygon[j].run)) return std::pair(i, j);
      }
    }
    return std::nullopt;
  }

  void join(const Corner& begin, const Corner& end, GeneratorId left, GeneratorId right) {
    diagram_.arcs.push_back({face_, begin.end, end.end, left, right});
  }

  /// Corners first .. last (cyclic) as a polygon of its own.
  static std::vector<Corner> part(const std::vector<Corner>& polygon, std::size_t first, std::size_t last) {
    std::vector<Corner> result;
    for (std::size_t k = first; k < last; ++k) result.push_back(polygon[k % polygon.size()]);
    return result;
  }

  /// Two runs i < j of one generator that is the nearest one between them; where no three different generators follow
  /// each other, the best pair whether it is nearest or not.
  std::optional<std::pair<std::size_t, std::size_t>> pair_to_unite(const std::vector<Corner>& polygon) const {
    const std::size_t n = polygon.size();
    std::optional<std::pair<std::size_t, std::size_t>> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 2; j < n; ++j) {
        if (polygon[i].next != polygon[j].next) continue;
        const Bary between = mix(middle(polygon, i), middle(polygon, j), 0.5);
        double others = std::numeric_limits<double>::infinity();
        for (const Corner& c : polygon) {
          if (c.next != polygon[i].next) others = std::min(others, metric_.at(c.next, between));
        }
        const double lead = metric_.at(polygon[i].next, between) - others;
        // A pair without a lead, of infinite distances, is better than none.
        if (!best || lead < least) std::tie(least, best) = std::tuple(lead, std::optional(std::pair(i, j)));
      }
    }
    // A sure metric has ruled out every triple by now: two runs of one cell are one piece, though their paths come in
    // by different sides.
    if (best && least > 0 && !metric_.is_sure() && triple_exists(polygon)) return std::nullopt;
    return best;
  }

  static bool triple_exists(const std::vector<Corner>& polygon) {
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
  std::optional<Triple> sure_triple(const std::vector<Corner>& polygon) {
    if (!metric_.is_sure()) return std::nullopt;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Bary start = mix(middle(polygon, i), centre(polygon), 0.5);
      if (const auto p = sure_point(polygon, i, start)) return Triple{i, *p};
    }
    // Distances have ridges, where the search can get stuck: from all over the face, then.
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      for (int a = 0; a <= kLattice; ++a) {
        for (int b = 0; a + b <= kLattice; ++b) {
          const Bary start{(a + 0.0) / kLattice, (b + 0.0) / kLattice, (kLattice - a - b + 0.0) / kLattice};
          if (const auto p = sure_point(polygon, i, start)) return Triple{i, *p};
        }
      }
    }
    return std::nullopt;
  }

  /// The branch point that run i and its neighbours make, looked for from `start` on.
  std::optional<Bary> sure_point(const std::vector<Corner>& polygon, std::size_t i, const Bary& start) {
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
    // Near a crossing, rounding says which of its two runs the path comes by.
    for (const double where : {*entry, *entry - kNearCrossing, *entry + kNearCrossing}) {
      const double round = where < 0 ? where + 3 : where >= 3 ? where - 3 : where;
      if (linked_.find(run_at(round)) == linked_.find(corner.run)) return true;
    }
    return false;
  }

  static Bary middle(const std::vector<Corner>& polygon, std::size_t i) {
    return mix(polygon[i].bary, polygon[(i + 1) % polygon.size()].bary, 0.5);
  }
  static Bary centre(const std::vector<Corner>& polygon) {
    Bary sum{0, 0, 0};
    for (const Corner& c : polygon) {
      for (std::size_t k = 0; k < 3; ++k) sum[k] += c.bary[k] / static_cast<double>(polygon.size());
    }
    return sum;
  }

  /// In the convex polygon, or on its boundary. Crossings of one edge span a polygon without area: then branch points
  /// lie on that edge, and the pieces between them have no area either, but never a negative one.
  static bool inside(const std::vector<Corner>& polygon, const Bary& p) {
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
      if (signed_area(polygon[i].bary, polygon[(i + 1) % n].bary, p) < 0) return false;
    }
    return true;
  }

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
    return mix(safe, *wanted, from);
  }

  BranchPointId add_branch(const Bary& p) { return diagram_.branches.push_back({face_, p, 0}); }

  void finish_branch(const std::vector<Corner>& polygon, bool whole) {
    const Bary safe = centre(polygon);
    const auto valid = [&](const Bary& p) {
      return whole ? *std::min_element(p.begin(), p.end()) >= (metric_.is_sure() ? kInsideExactly : kInside)
                   : inside(polygon, p);
    };
    const auto wanted = metric_.equidistant(polygon[0].next, polygon[1].next, polygon[2].next, safe);
    join_three(polygon, approach(safe, wanted, valid));
  }

  void join_three(const std::vector<Corner>& polygon, const Bary& p) {
    const BranchPointId b = add_branch(p);
    for (std::size_t i = 0; i < 3; ++i) {
      diagram_.arcs.push_back({face_, polygon[i].end, at(b), polygon[(i + 2) % 3].next, polygon[i].next});
    }
  }

  /// Contracts the three consecutive runs whose branch point no other generator comes near.
  void contract(const std::vector<Corner>& polygon) {
    const std::size_t n = polygon.size();
    std::size_t chosen = n;
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
      const GeneratorId x = polygon[(i + n - 1) % n].next, y = polygon[i].next, z = polygon[(i + 1) % n].next;
      if (x == z) continue;
      const auto p = metric_.equidistant(x, y, z, middle(polygon, i));
      double lead = -1e300;  // a triple without a point of its own is the last choice
      if (p) {
        lead = std::numeric_limits<double>::infinity();
        for (const Corner& c : polygon) {
          if (c.next != x && c.next != y && c.next != z)
            lead = std::min(lead, metric_.at(c.next, *p) - metric_.at(y, *p));
        }
      }
      if (chosen == n || lead > best) std::tie(chosen, best) = std::tuple(i, lead);
    }
    contract_run(polygon, chosen);
  }

  /// Closes run i of the polygon with a branch point between its two neighbours.
  void contract_run(const std::vector<Corner>& polygon, std::size_t i) {
    const std::size_t n = polygon.size();
    const Corner &first = polygon[i], &second = polygon[(i + 1) % n];
    const GeneratorId x = polygon[(i + n - 1) % n].next, y = first.next, z = second.next;
    std::vector<Bary> rest{Bary{}};  // the branch point, then the remaining corners
    for (std::size_t k = 2; k < n; ++k) rest.push_back(polygon[(i + k) % n].bary);
    const auto valid = [&](const Bary& p) {
      rest[0] = p;
      return is_convex(rest) && inside(polygon, p);
    };
    const Bary safe = middle(polygon, i);
    close_run(polygon, i, approach(safe, metric_.equidistant(x, y, z, safe), valid));
  }

  /// Joins the two ends of run i to a branch point at p, and goes on with what is left.
  void close_run(const std::vector<Corner>& polygon, std::size_t i, const Bary& p) {
    const std::size_t n = polygon.size();
    const Corner &first = polygon[i], &second = polygon[(i + 1) % n];
    const GeneratorId x = polygon[(i + n - 1) % n].next, y = first.next, z = second.next;
    const BranchPointId b = add_branch(p);
    diagram_.arcs.push_back({face_, first.end, at(b), x, y});
    diagram_.arcs.push_back({face_, second.end, at(b), y, z});
    std::vector<Corner> smaller{{at(b), p, z, second.run}};
    for (std::size_t k = 2; k < n; ++k) smaller.push_back(polygon[(i + k) % n]);
    solve(smaller, false);
  }

  FaceId face_;
  const std::vector<BoundaryCrossing>& boundary_;
  const FaceMetric& metric_;
  FaceDiagram& diagram_;
  UnionFind linked_;  // runs of the boundary that are one piece
};

}  // namespace

void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceMetric& metric,
                   FaceDiagram& diagram) {
  if (boundary.empty()) return;
  FaceAssembly(f, boundary, metric, diagram).run();
}

}  // namespace gvd
