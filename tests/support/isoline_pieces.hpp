#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "gvd/exact_field.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test {

/// The default tolerance of isolines, in mean edges, and rounding.
inline constexpr double kIsolineTolerance = 1e-4 + 1e-9;

/// A straight piece of an isoline, in a face that has both ends.
struct IsolinePiece {
  SurfacePoint from, to;

  SurfacePoint at(double t) const {
    Bary bary{};
    for (std::size_t i = 0; i < 3; ++i) bary[i] = (1 - t) * from.bary[i] + t * to.bary[i];
    return make_surface_point(from.face, bary);
  }
};

inline std::vector<IsolinePiece> pieces_of(const Mesh& mesh, const Isoline& line) {
  std::vector<IsolinePiece> pieces;
  for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i) {
    const auto shared =
        find_common_view(mesh, line.points[(i + line.points.size() - 1) % line.points.size()], line.points[i]);
    REQUIRE(shared);
    pieces.push_back({shared->first, shared->second});
  }
  return pieces;
}

inline double length_of(const Mesh& mesh, const Isoline& line) {
  double length = 0;
  for (const IsolinePiece& piece : pieces_of(mesh, line))
    length += (position(mesh, piece.to) - position(mesh, piece.from)).norm();
  return length;
}

/// The largest difference of a piece's points from the level, mean edges. `distance`: of a surface point.
template <class Distance>
double worst_of(const Mesh& mesh, const std::vector<Isoline>& lines, const Distance& distance) {
  double worst = 0;
  for (const Isoline& line : lines) {
    for (const IsolinePiece& piece : pieces_of(mesh, line)) {
      for (const double t : {0.0, 0.25, 0.5, 0.75}) {
        worst = std::max(worst, std::abs(distance(piece.at(t)) - line.level));
      }
    }
  }
  return worst / mesh.mean_edge_length();
}

/// Counts random segments inside faces whose ends lie on different sides of a level, while they cross its isolines an
/// even number of times, or the other way round.
template <class Distance>
int count_misses(const Mesh& mesh, double level, const std::vector<Isoline>& lines, int segments,
                 const Distance& distance) {
  std::map<FaceId, std::vector<PlaneSegment>> in_face;
  for (const Isoline& line : lines) {
    for (const IsolinePiece& piece : pieces_of(mesh, line)) {
      const FaceLayout layout(mesh, piece.from.face);
      in_face[piece.from.face].push_back({layout.at(piece.from.bary), layout.at(piece.to.bary)});
    }
  }
  Random random(5);
  const auto inside = [&](FaceId f) {
    const double u = random.real(0, 1), v = random.real(0, 1);
    return make_surface_point(f, u + v < 1 ? Bary{u, v, 1 - u - v} : Bary{1 - u, 1 - v, u + v - 1});
  };
  int misses = 0;
  for (int i = 0; i < segments; ++i) {
    const FaceId f(random.below(mesh.face_count()));
    const SurfacePoint a = inside(f), b = inside(f);
    const double from = distance(a) - level, to = distance(b) - level;
    if (std::min(std::abs(from), std::abs(to)) < 2 * kIsolineTolerance * mesh.mean_edge_length()) continue;
    const FaceLayout layout(mesh, f);
    const PlaneSegment segment{layout.at(a.bary), layout.at(b.bary)};
    int crossed = 0;
    for (const PlaneSegment& piece : in_face[f]) {
      crossed += !lie_on_one_side(segment, piece.from, piece.to) && !lie_on_one_side(piece, segment.from, segment.to);
    }
    misses += (crossed % 2 == 1) != ((from > 0) != (to > 0));
  }
  return misses;
}

}  // namespace gvd::test
