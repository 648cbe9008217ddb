#pragma once

#include <cstdint>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/front.hpp"
#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The ways to spread generators over the surface. Distances are geodesic.
enum class Sampling {
  farthest,         ///< `count` points, each as far as possible from all before it
  random,           ///< `count` points, independent and uniform by area
  vertices,         ///< `count` different vertices, independent of area and distances
  poisson,          ///< `count` points, random but evenly spaced (blue noise)
  covering_radius,  ///< farthest points, until every point of the surface is within `radius` of one
};
/// The names of the ways that spread `count` points.
inline const Choices<Sampling> kSamplingNames{{"farthest", Sampling::farthest},
                                              {"random", Sampling::random},
                                              {"vertices", Sampling::vertices},
                                              {"poisson", Sampling::poisson}};

struct SamplingOptions {
  Sampling kind = Sampling::farthest;
  std::int32_t count = 1;       ///< >= 1; ignored for covering_radius
  std::uint64_t seed = 0;       ///< the same seed gives the same points on every platform
  double radius = 0;            ///< mesh units, > 0; only for covering_radius
  bool blue_noise = false;      ///< only for covering_radius: choose points in random order instead of the farthest
  Front front = Front::circle;  ///< shape of the front in the marches that compute distances
  Progress progress;            ///< may be empty
};

/// Spreads generators over `mesh`.
///
/// farthest and covering_radius choose vertices. They first split long edges of a copy of the mesh at their midpoints,
/// so that points on edges and in faces can be chosen, too. farthest splits edges longer than twice the even spacing of
/// `count` points, and more if there are fewer than `count` vertices; covering_radius splits edges longer than a
/// quarter of the radius. The seed determines the first point of each component. random and poisson choose points
/// inside faces. vertices chooses vertices of `mesh`, each with the same probability.
///
/// Properties: (1) exactly `count` points, no two of them coincident; (2) the same options give the same points;
/// (3) farthest: the components get one point each in the order of their first face. Every further point is the vertex
///   farthest from all points before it, and of equally far vertices the one with the least id. Each component
///   therefore has a point if `count` is at least their number. covering_radius: the same, but with the farthest corner
///   of the face with the largest distance bound;
/// (4) covering_radius: no point of any face is farther than `radius` from its nearest generator, by the distances of
///   `front`;
/// (5) covering_radius with blue_noise: no two generators of a component are nearer to each other than 0.85 of
///   `radius`, by the same distances. They come in random order.
///
/// Throws Error{invalid_option} if count < 1 or the radius is not a finite number > 0; Error{interrupted} if the
/// progress callback cancels; Error{precondition} if the mesh does not allow such points: random and poisson need a
/// finite area > 0; vertices needs `count` vertices; `count` points must be distinct within rounding; splitting may add
/// at most kMaxSamplingVertices vertices. For a covering this means a radius of at least some 0.0015 times the square
/// root of the area.
///
/// Cost: farthest O(n log n log count), for n the larger of faces and count; random O(n + count log n); vertices O(n);
/// poisson a local march from each of 5 count candidates, O(n log n) in all. Memory: O(n).
///
/// Source: farthest: Eldar et al., The farthest point strategy for progressive image sampling, 1997, with geodesic
/// distances as in Peyre and Cohen, Geodesic remeshing using front propagation, 2006. poisson: Yuksel, Sample
/// elimination for generating Poisson disk sample sets, 2015.
std::vector<SurfacePoint> sample_generators(const Mesh& mesh, const SamplingOptions& options);

/// The same, and an error about the number of points is returned: more than the mesh has room for.
OrError<std::vector<SurfacePoint>> try_to_sample_generators(const Mesh& mesh, const SamplingOptions& options);

/// The side of the equilateral triangles that `count` generators span if they are spread evenly over `area`. Mesh
/// units.
double even_spacing(double area, std::int64_t count);

/// The number of generators that span triangles with this side, rounded to a whole number; at least 1. It may be too
/// large for an integer type.
double even_count(double area, double spacing);

/// The largest number of vertices that splitting edges may add; they take about 3 GB.
inline constexpr std::int32_t kMaxSamplingVertices = 1 << 23;

}  // namespace gvd
