// Maps regions to the plane, by exact logarithms or by convex combinations.
//
// The logarithm of a point is the length of the shortest path to it, and the direction in which the path leaves the
// generator. Shortest paths stay in the cell; a point of the border has one to each of its generators. Logarithms are
// computed for vertices, so that neighbouring faces fit together. But if the paths to two corners of a face pass on
// different sides of an obstacle, the three logarithms do not belong together. Such a face is placed by the path to its
// centre, and rotated by the angle between the path's directions at its two ends.
// A flat map first places its border as a star around the generator, with the exact distances and with angles from the
// triangles of two distances and a side. For a flat region that gives the region itself, and mean value weights
// reproduce its inside. If the map flips a face, the convex hull of the star replaces it, with sides bent outwards, and
// then a circle. With a convex border the map is one-to-one by Tutte's theorem.
// Source: M. Floater, Mean value coordinates, 2003.
// Invariant: a map writes only the faces of its own island.
#include "chart_maps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "base/plane.hpp"
#include "chart_surface.hpp"
#include "geodesic/face_layout.hpp"
#include "mesh/flatten_disc.hpp"

namespace gvd {
namespace {

constexpr StepPart kPaths{"charts", 0, 0.8}, kTears{"charts", 0.8, 0.9};

/// Number of vertices or faces in a task. A path takes a few microseconds.
constexpr std::size_t kPathChunk = 256;

IdVector<VertexId, Vec2> find_logarithms(const ChartSurface& surface) {
  IdVector<VertexId, Vec2> logs(std::size_t(surface.mesh().vertex_count()), kNowhere);
  const auto chunks = cut_into_chunks(logs.size(), kPathChunk);
  surface.parallel().run(chunks.size(), kPaths, [&](std::size_t k) {
    for (std::size_t i = chunks[k].begin; i < chunks[k].end; ++i) {
      const GeodesicPath path = surface.path(VertexId(i));
      if (path.complete) logs[VertexId(i)] = surface.field().departure(path);
    }
  });
  return logs;
}

/// Whether the logarithms of the corners belong to paths on different sides of an obstacle, or one is missing.
bool is_torn(const Mesh& mesh, FaceId f, const PlaneCorners& corners) {
  for (const HalfedgeId h : Mesh::halfedges(f)) {
    const auto i = std::size_t(Mesh::corner(h));
    // The negation also holds if a coordinate is NaN.
    if (!((corners[(i + 1) % 3] - corners[i]).norm() <= kTear * mesh.length(h))) return true;
  }
  return false;
}

/// Places the corners of a face by the path to its centre. At the centre, the logarithm rotates directions by the angle
/// from the path's arrival to its departure. Returns nothing if rounding hides one of these directions.
std::optional<PlaneCorners> lay_by_centre(const ChartSurface& surface, FaceId f) {
  const FaceId parent = surface.parent(f);
  const FaceLayout layout(surface.surface(), parent);
  PlaneCorners corners;
  std::array<Vec2, 3> in_parent;
  Bary centre{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const SurfacePoint point = surface.point(f, i);
    in_parent[std::size_t(i)] = layout.at(point.bary);
    for (std::size_t k = 0; k < 3; ++k) centre[k] += point.bary[k] / 3;
  }
  const GeodesicPath path = surface.field().path(make_surface_point(parent, centre), surface.label(f));
  const Vec2 log = surface.field().departure(path), at = layout.at(centre);
  if (!path.complete || path.points.size() < 2 || !(log.norm() > 0)) return std::nullopt;
  const auto before = locate_in_face(surface.surface(), parent, path.points[1]);
  if (!before || *before == at) return std::nullopt;
  const Vec2 arrival = (at - *before).normalized(), departure = log.normalized();
  const double cosine = arrival.dot(departure), sine = cross(arrival, departure);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 d = in_parent[i] - at;
    corners[i] = log + Vec2(cosine * d.x() - sine * d.y(), sine * d.x() + cosine * d.y());
  }
  return corners;
}

}  // namespace

std::vector<PlaneCorners> map_by_logarithms(const ChartSurface& surface, IdVector<FaceId, char>& torn) {
  const Mesh& mesh = surface.mesh();
  const IdVector<VertexId, Vec2> logs = find_logarithms(surface);
  std::vector<PlaneCorners> corners(std::size_t(mesh.face_count()), {kNowhere, kNowhere, kNowhere});
  torn.assign(corners.size(), 0);
  const auto chunks = cut_into_chunks(corners.size(), kPathChunk);
  surface.parallel().run(chunks.size(), kTears, [&](std::size_t k) {
    for (std::size_t i = chunks[k].begin; i < chunks[k].end; ++i) {
      const FaceId f(i);
      if (!surface.label(f).valid()) continue;
      for (std::size_t c = 0; c < 3; ++c) corners[i][c] = logs[mesh.vertices(f)[c]];
      if (!is_torn(mesh, f, corners[i])) continue;
      torn[f] = 1;
      const bool all_known = std::ranges::all_of(corners[i], [](const Vec2& p) { return p.allFinite(); });
      // If the path to the centre has no direction, the face is about as small as rounding, and the corners' logarithms
      // will do.
      const PlaneCorners otherwise = all_known ? corners[i] : PlaneCorners{kNowhere, kNowhere, kNowhere};
      corners[i] = lay_by_centre(surface, f).value_or(otherwise);
    }
  });
  return corners;
}

namespace {

/// Traces the border of an island that is a disc, counter-clockwise.
std::vector<VertexId> trace_border(const Mesh& mesh, const Island& island) {
  for (const FaceId f : island.faces) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      if (!mesh.twin(h).valid()) return trace_boundary_loop(mesh, h);
    }
  }
  return {};
}

/// How the border of a disc is placed.
enum class Border {
  star,    ///< around the generator, by exact distances
  convex,  ///< the convex hull of the star, bent outwards
  circle,
};

struct FlatMap {
  Border border;
  double even_share;  ///< share of even spacing in the angles between vertices
  DiscWeights weights;
};

/// A twentieth of even spacing separates directions that nearly coincide, and a tenth separates vertices that nearly
/// coincide. The last map depends only on connectivity.
constexpr std::array<FlatMap, kFlatMaps> kMaps{{{Border::star, 0, DiscWeights::mean_value},
                                                {Border::convex, 0.05, DiscWeights::mean_value},
                                                {Border::circle, 0.1, DiscWeights::mean_value},
                                                {Border::circle, 1, DiscWeights::uniform}}};

/// Share of a circle in a convex border. Without it, three vertices on the same side would lie on a line.
constexpr double kBulge = 0.1;

/// The angles of the border's vertices, beginning with 0 and ending with a full turn. For a star they are the angles of
/// the triangles of two distances and a side; for a circle they are proportional to the sides.
std::vector<double> find_angles(const IslandBorder& border, const FlatMap& map) {
  const std::size_t n = border.side.size();
  std::vector<double> angles{0};
  for (std::size_t i = 0; i < n; ++i) {
    double angle = border.side[i];
    if (map.border != Border::circle) {
      const double a = border.distance[i], b = border.distance[(i + 1) % n];
      // The law of cosines in terms of the sine of half the angle, which is accurate for small angles, too.
      const double sine = std::sqrt(std::max(0.0, (angle - (a - b)) * (angle + (a - b)) / (4 * a * b)));
      angle = 2 * std::asin(std::min(1.0, sine));
    }
    angles.push_back(angles.back() + angle);
  }
  scale_and_even(angles, 2 * std::numbers::pi, map.even_share);
  return angles;
}

/// Moves points at ascending angles outwards onto their convex hull, which contains the origin, and bends the hull's
/// sides. In polar coordinates a line is 1 / r = c cos(angle - a). Between two of its points, a convex curve has 1 / r
/// at most as large as on the line through them. Adding a constant to 1 / r makes this strict.
void make_convex(const std::vector<double>& angle, std::vector<double>& radius) {
  const std::size_t n = radius.size(), first = std::size_t(std::ranges::max_element(radius) - radius.begin());
  const auto point = [&](std::size_t i) -> Vec2 { return radius[i % n] * unit_vector(angle[i % n]); };
  std::vector<std::size_t> hull;
  for (std::size_t i = first; i <= first + n; ++i) {
    while (hull.size() > 1 && orientation(point(hull[hull.size() - 2]), point(hull.back()), point(i)) <= 0) {
      hull.pop_back();
    }
    hull.push_back(i);
  }
  std::vector<double> inverse(n);
  const double round = 1 / radius[first];
  for (std::size_t k = 0; k + 1 < hull.size(); ++k) {
    const auto angle_to = [&](std::size_t i) {
      return angle[i % n] - angle[hull[k] % n] + (i >= n && hull[k] < n ? angle[n] : 0);
    };
    const double to = 1 / radius[hull[k + 1] % n], from = 1 / radius[hull[k] % n], all = angle_to(hull[k + 1]);
    for (std::size_t i = hull[k]; i < hull[k + 1]; ++i) {
      const double at = angle_to(i);
      inverse[i % n] = (from * std::sin(all - at) + to * std::sin(at)) / std::sin(all);
    }
  }
  for (std::size_t i = 0; i < n; ++i) radius[i] = 1 / ((1 - kBulge) * inverse[i] + kBulge * round);
}

/// Places the border. Returns nothing if it does not go around the origin exactly once, counter-clockwise.
std::vector<DiscBorderPoint> lay_border(const IslandBorder& border, const FlatMap& map) {
  const std::size_t n = border.vertices.size();
  std::vector<double> radius(n, 1);
  if (map.border != Border::circle) radius = border.distance;
  const auto is_usable = [](double r) { return r > 0 && std::isfinite(r); };
  if (radius.empty() || !std::ranges::all_of(radius, is_usable)) return {};
  const std::vector<double> angles = find_angles(border, map);
  for (std::size_t i = 0; i < n; ++i) {
    if (orientation(Vec2::Zero(), unit_vector(angles[i]), unit_vector(angles[i + 1])) <= 0) return {};
  }
  if (map.border == Border::convex) make_convex(angles, radius);
  const std::vector<Vec2> points = lay_round(angles, radius);
  std::vector<DiscBorderPoint> laid;
  for (std::size_t i = 0; i < n; ++i) laid.push_back({border.vertices[i], points[i]});
  return laid;
}

/// Number of directions that are tried for the axes of an island, over a quarter of a turn.
constexpr int kTurns = 32;

/// The matrix that scales the points to the area `area`, and rotates them so that their box is small and wider than
/// high.
Eigen::Matrix2d fit(const std::vector<DiscBorderPoint>& border, double area, double laid_area) {
  Eigen::Matrix2d best = Eigen::Matrix2d::Identity();
  double least = kInfinity;
  for (int k = 0; k < 2 * kTurns; ++k) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(std::numbers::pi / 2 * k / kTurns).toRotationMatrix();
    Box2 box;
    for (const DiscBorderPoint& b : border) box.extend(turn * b.point);
    const Vec2 size = box.sizes();
    if (size.x() < size.y() || !(size.prod() < least)) continue;
    least = size.prod();
    best = turn;
  }
  return std::sqrt(area / laid_area) * best;
}

}  // namespace

IslandBorder measure_border(const ChartSurface& surface, const Island& island) {
  const Mesh& mesh = surface.mesh();
  IslandBorder border{trace_border(mesh, island), {}, {}};
  const std::size_t n = border.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    border.side.push_back((mesh.position(border.vertices[(i + 1) % n]) - mesh.position(border.vertices[i])).norm());
  }
  if (surface.is_on_boundary(island.generator)) return border;
  for (const VertexId v : border.vertices) border.distance.push_back(surface.path(v).length);
  return border;
}

bool map_flat(const Mesh& mesh, const Island& island, const IslandBorder& measured, int attempt,
              std::vector<PlaneCorners>& corners) {
  const FlatMap& map = kMaps[std::size_t(attempt)];
  const std::vector<DiscBorderPoint> border = lay_border(measured, map);
  if (border.empty()) return false;
  const auto disc = flatten_disc(mesh, island.faces, border, map.weights);
  if (!disc) return false;
  double area = 0;
  for (const FaceId f : island.faces) area += mesh.area(f);
  const double laid = 0.5 * twice_signed_area(border.size(), [&](std::size_t i) { return border[i].point; });
  const Eigen::Matrix2d to_plane = fit(border, area, laid);
  for (const FaceId f : island.faces) {
    for (std::size_t c = 0; c < 3; ++c) corners[f.index()][c] = to_plane * disc->at(mesh.vertices(f)[c]);
  }
  return true;
}

}  // namespace gvd
