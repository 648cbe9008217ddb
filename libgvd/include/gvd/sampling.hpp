#pragma once

#include <cstdint>
#include <vector>

#include "gvd/front.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// How generators are spread over the surface. Distances are geodesic.
enum class Sampling {
  farthest,         ///< `count` points, each as far as possible from all before it
  random,           ///< `count` points, independent and uniform by area
  poisson,          ///< `count` points, random and yet evenly apart (blue noise)
  covering_radius,  ///< as many farthest points as leave no point of the surface farther than `radius` from all of them
};

struct SamplingOptions {
  Sampling kind = Sampling::farthest;
  std::int32_t count = 1;       ///< >= 1; not looked at by covering_radius
  std::uint64_t seed = 0;       ///< any; the same seed gives the same points on every platform
  double radius = 0;            ///< mesh units, > 0; only looked at by covering_radius
  Front front = Front::circle;  ///< of the distances
  Progress progress;            ///< may be empty
};

/// Spreads generators over `mesh`.
///
/// farthest and covering_radius choose vertices. The mesh is taken as if edges were split at their midpoints, longest
/// first, while they are so long that a generator fits in between (twice the spacing that `count` points have on an
/// average; a quarter of `radius`), or while there are fewer vertices than `count`: then points on edges and in faces
/// come out too. The first point of each component is drawn by the seed. random and poisson lie inside faces.
///
/// Properties: (1) exactly `count` points, no two of them coincident; (2) the same options give the same points;
/// (3) farthest: components in the order of their first face get one point each, then every point is the farthest
/// vertex
///   from all before it, the least vertex id among equals; so each component has a point if `count` is at least their
///   number; covering_radius: the same with the farthest corner of the face that may reach farthest;
/// (4) covering_radius: no point of any face is farther than `radius` from its nearest generator, by the distances of
///   `front`.
///
/// Throws Error{invalid_option} where count < 1 or the radius is not a finite number > 0; Error{precondition} where the
/// mesh has no room (random and poisson need an area that is finite and > 0, and all need `count` places that rounding
/// can tell apart, and no more than kMaxSamplingVertices vertices added, which for a covering means a radius of some
/// 0.0015 times the square root of the area, or more); Error{interrupted} where the progress callback cancels.
///
/// Cost: farthest O(n log n log count), for n the larger of faces and count; random O(n + count log n); poisson a march
/// to the neighbours from each of 5 count candidates, O(n log n) in all. Memory: O(n).
///
/// Source: farthest: Eldar et al., The farthest point strategy for progressive image sampling, 1997, with geodesic
/// distances as in Peyre and Cohen, Geodesic remeshing using front propagation, 2006. poisson: Yuksel, Sample
/// elimination for generating Poisson disk sample sets, 2015.
std::vector<SurfacePoint> sample_generators(const Mesh& mesh, const SamplingOptions& options);

/// Most vertices that splitting edges for a sampling may add: some 3 GB.
inline constexpr std::int32_t kMaxSamplingVertices = 1 << 23;

}  // namespace gvd
