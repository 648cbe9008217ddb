#include "diagram/face_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace gvd {
namespace {

using Bary = std::array<double, 3>;

/// A face's only branch point keeps this much of every barycentric coordinate, so that it lies inside the face: ten times
/// the gap that crossings keep from the corners, and a millionth of a triangle's height at the most that it is moved.
constexpr double kInside = 1e-6;

/// A branch point that can't lie where it is wanted is tried this many times on the way back, each time kStepBack nearer.
constexpr int kSteps = 8;
constexpr double kStepBack = 0.6;

/// One corner of the polygon that is left: a crossing, or a branch point that stands for two of them.
struct Corner {
  ArcEnd end;
  Bary bary;
  GeneratorId next;  ///< generator of the run from here to the next corner
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
  FaceAssembly(FaceId f, const std::vector<DistanceForm>& forms, FaceDiagram& diagram)
      : face_(f), forms_(forms), diagram_(diagram) {}

  /// `whole`: the polygon is all of the face's crossings, so that a lone branch point may lie anywhere in the face.
  void solve(const std::vector<Corner>& polygon, bool whole) {
    if (polygon.size() == 2) return join(polygon[0], polygon[1], polygon[1].next, polygon[0].next);
    if (const auto pair = pair_to_unite(polygon)) {
      const auto [i, j] = *pair;
      solve(part(polygon, i + 1, j + 1), false);
      solve(part(polygon, j + 1, i + 1 + polygon.size()), false);
    } else if (polygon.size() == 3) {
      finish_branch(polygon, whole);
    } else {
      contract(polygon);
    }
  }

 private:
  const DistanceForm& form(GeneratorId g) const {
    return *std::find_if(forms_.begin(), forms_.end(), [g](const DistanceForm& f) { return f.generator == g; });
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
    const auto middle = [&](std::size_t i) { return mix(polygon[i].bary, polygon[(i + 1) % n].bary, 0.5); };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 2; j < n; ++j) {
        if (polygon[i].next != polygon[j].next) continue;
        const Bary between = mix(middle(i), middle(j), 0.5);
        double others = std::numeric_limits<double>::infinity();
        for (const Corner& c : polygon) {
          if (c.next != polygon[i].next) others = std::min(others, form(c.next).at(between));
        }
        const double lead = form(polygon[i].next).at(between) - others;
        // A pair without a lead, of infinite distances, is better than none.
        if (!best || lead < least) std::tie(least, best) = std::tuple(lead, std::optional(std::pair(i, j)));
      }
    }
    if (best && least > 0 && triple_exists(polygon)) return std::nullopt;
    return best;
  }

  static bool triple_exists(const std::vector<Corner>& polygon) {
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
      if (polygon[i].next != polygon[(i + 2) % n].next) return true;
    }
    return false;
  }

  /// Where three generators are equally near: the forms are linear, so this is a 2 x 2 system.
  std::optional<Bary> equidistant(GeneratorId a, GeneratorId b, GeneratorId c) const {
    const auto &fa = form(a).corner, &fb = form(b).corner, &fc = form(c).corner;
    Bary u{}, v{};
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = fa[k] - fb[k];
      v[k] = fa[k] - fc[k];
    }
    // The point is orthogonal to u and v in barycentric coordinates: their cross product, scaled to sum 1.
    const Bary w{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double sum = w[0] + w[1] + w[2];
    const Bary p{w[0] / sum, w[1] / sum, w[2] / sum};
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return std::nullopt;
    return p;
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
    double t = 1;
    for (int step = 0; step < kSteps; ++step, t *= kStepBack) {
      const Bary p = mix(safe, *wanted, t);
      if (valid(p)) return p;
    }
    return safe;
  }

  BranchPointId add_branch(const Bary& p) { return diagram_.branches.push_back({face_, p, 0}); }

  void finish_branch(const std::vector<Corner>& polygon, bool whole) {
    const Bary centre{(polygon[0].bary[0] + polygon[1].bary[0] + polygon[2].bary[0]) / 3,
                      (polygon[0].bary[1] + polygon[1].bary[1] + polygon[2].bary[1]) / 3,
                      (polygon[0].bary[2] + polygon[1].bary[2] + polygon[2].bary[2]) / 3};
    const auto valid = [&](const Bary& p) {
      return whole ? *std::min_element(p.begin(), p.end()) >= kInside : inside(polygon, p);
    };
    const auto wanted = equidistant(polygon[0].next, polygon[1].next, polygon[2].next);
    const Bary p = approach(centre, wanted, valid);
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
      const auto p = equidistant(x, y, z);
      double lead = -1e300;  // a triple without a point of its own is the last choice
      if (p) {
        lead = std::numeric_limits<double>::infinity();
        for (const Corner& c : polygon) {
          if (c.next != x && c.next != y && c.next != z) lead = std::min(lead, form(c.next).at(*p) - form(y).at(*p));
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
    const Bary p = approach(mix(first.bary, second.bary, 0.5), equidistant(x, y, z), valid);
    const BranchPointId b = add_branch(p);
    diagram_.arcs.push_back({face_, first.end, at(b), x, y});
    diagram_.arcs.push_back({face_, second.end, at(b), y, z});
    std::vector<Corner> smaller{{at(b), p, z}};
    for (std::size_t k = 2; k < n; ++k) smaller.push_back(polygon[(i + k) % n]);
    solve(smaller, false);
  }

  FaceId face_;
  const std::vector<DistanceForm>& forms_;
  FaceDiagram& diagram_;
};

}  // namespace

void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const std::vector<DistanceForm>& forms,
                   FaceDiagram& diagram) {
  if (boundary.empty()) return;
  std::vector<Corner> polygon;
  for (const BoundaryCrossing& c : boundary) polygon.push_back({at(c.id), c.bary(), c.next});
  FaceAssembly(f, forms, diagram).solve(polygon, true);
}

}  // namespace gvd
