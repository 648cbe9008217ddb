#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/assembly/face_assembly.hpp"
#include "diagram/assembly/form_distances.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "support/random.hpp"

namespace gvd::test {

/// A label interval on the boundary of a face: the crossing that it begins at, and its cell.
struct BoundaryInterval {
  int corner;
  double t;
  int next;
};

inline DistanceForm form(int generator, double a, double b, double c) { return {GeneratorId(generator), {a, b, c}}; }

/// Forms of `count` generators, nearly equal everywhere.
inline std::vector<DistanceForm> flat_forms(int count) {
  std::vector<DistanceForm> forms;
  for (int g = 0; g < count; ++g) forms.push_back(form(g, 1 + 0.01 * g, 1 - 0.02 * g, 1 + 0.01 * (g % 2)));
  return forms;
}

/// One face, assembled. `intervals`: all of the boundary, counter-clockwise.
struct AssembledFace {
  std::vector<BoundaryCrossing> boundary;
  FaceDiagram diagram;

  AssembledFace(const std::vector<BoundaryInterval>& intervals, const std::vector<DistanceForm>& forms)
      : AssembledFace(intervals, FormDistances(forms)) {}
  AssembledFace(const std::vector<BoundaryInterval>& intervals, const FaceDistances& distances,
                const FacePaths* paths = nullptr) {
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const int previous = intervals[(i + intervals.size() - 1) % intervals.size()].next;
      boundary.push_back({CrossingId(static_cast<std::int64_t>(i)), intervals[i].corner, intervals[i].t,
                          GeneratorId(previous), GeneratorId(intervals[i].next)});
    }
    assemble_face(FaceId(0), boundary, distances, diagram, paths);
  }

  WorkingPieces pieces() const { return pieces_of(diagram.arcs); }
  WorkingPieces pieces_of(const std::vector<FaceArc>& arcs) const {
    WorkingPieces result;
    result.pieces.resize(1);  // earlier content must have no effect
    trace_pieces(boundary, arcs, diagram, result);
    return result;
  }

  Bary position(const ArcEnd& end) const {
    if (end.branch.valid()) return diagram.branches[end.branch].bary;
    return boundary[end.crossing.index()].bary();
  }
};

/// `count` crossings at random places, some of them close together or close to a corner, between random ones of `cells`
/// cells. Empty where chance left no room.
inline std::vector<BoundaryInterval> random_intervals(Random& random, int count, int cells) {
  std::vector<BoundaryInterval> intervals;
  const int edges = 1 + random.below(3);
  for (int i = 0; i < count; ++i) {
    const double t = random.below(4) == 0
                         ? (random.below(2) == 0 ? 1e-7 + random.real(0, 1e-5) : 1 - 1e-7 - random.real(0, 1e-5))
                         : random.real(0.001, 0.999);
    intervals.push_back({random.below(edges), t, random.below(cells)});
  }
  std::sort(intervals.begin(), intervals.end(), [](const BoundaryInterval& a, const BoundaryInterval& b) {
    return std::pair(a.corner, a.t) < std::pair(b.corner, b.t);
  });
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const BoundaryInterval& before = intervals[(i + intervals.size() - 1) % intervals.size()];
    for (int tries = 0;
         intervals[i].next == before.next || (i + 1 == intervals.size() && intervals[i].next == intervals[0].next);
         ++tries) {
      if (tries == 20) return {};
      intervals[i].next = random.below(cells);
    }
    if (i > 0 && before.corner == intervals[i].corner && intervals[i].t - before.t < kCrossingGap) return {};
  }
  return intervals;
}

/// The crossings of the lower envelope of linear forms with the boundary of the face.
inline std::vector<BoundaryInterval> envelope_intervals(const std::vector<DistanceForm>& forms) {
  std::vector<BoundaryInterval> intervals;
  for (int corner = 0; corner < 3; ++corner) {
    const auto from = static_cast<std::size_t>(corner), to = static_cast<std::size_t>((corner + 1) % 3);
    int current = 0;
    for (std::size_t g = 1; g < forms.size(); ++g) {
      if (forms[g].corner[from] < forms[current].corner[from]) current = static_cast<int>(g);
    }
    for (double t = 0;;) {
      double soonest = 1;
      int next = current;
      const DistanceForm& own = forms[current];
      for (std::size_t g = 0; g < forms.size(); ++g) {
        const double a = forms[g].corner[from] - own.corner[from], b = forms[g].corner[to] - own.corner[to];
        if (b >= 0 || a / (a - b) <= t || a / (a - b) >= soonest) continue;
        soonest = a / (a - b);
        next = static_cast<int>(g);
      }
      if (next == current) break;
      intervals.push_back({corner, soonest, next});
      t = soonest;
      current = next;
    }
  }
  return intervals;
}

}  // namespace gvd::test
