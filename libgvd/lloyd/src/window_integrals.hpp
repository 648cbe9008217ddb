#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "base/barycentric.hpp"
#include "base/parallel_chunks.hpp"
#include "base/plane.hpp"
#include "geodesic/windows/nearest_paths.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/cell_moments.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// A path to a point of a cell, reduced to what the energy's slope at the generator needs.
struct PathSample {
  GeneratorId generator;
  float angle;    ///< tangent angle at which the path departs, radians
  double weight;  ///< distance times the mass of the point, mesh units cubed; a double, because a float may overflow
};

/// The samples of generator g among sorted samples. Cost: O(log k).
std::span<const PathSample> samples_of(const std::vector<PathSample>& sorted, GeneratorId g);

/// Marks generators whose single paths are wanted, by a number other than 0. Empty: none.
using WatchedGenerators = IdVector<GeneratorId, char>;

/// The integrals over all cells.
struct CellIntegrals {
  IdVector<GeneratorId, CellMoments> moments;
  std::vector<PathSample> samples;  ///< of watched generators, sorted by generator
};

/// Sums over points of the cells. Each thread has its own.
class CellSums {
 public:
  /// `watched` must outlive this object.
  explicit CellSums(const WatchedGenerators& watched) : watched_(&watched) {}

  /// Adds a point of cell g that stands for a part of the surface. `spread` is the mean squared distance of the part
  /// from the point, square mesh units, >= 0. Fast if consecutive points belong to the same cell.
  void add(GeneratorId g, double area, double mass, const NearestPath& path, double spread) {
    if (sums_.empty() || sums_.back().generator != g) sums_.push_back({g, {}});
    CellMoments& sum = sums_.back().moments;
    sum.area += area;
    sum.mass += mass;
    if (!path.generator.valid()) return;  // no generator reaches the point
    sum.energy += mass * (path.distance * path.distance + spread);
    sum.centroid += mass * path.log;
    if (watched_->empty() || !(*watched_)[path.generator]) return;
    const double angle = std::atan2(path.log.y(), path.log.x());
    samples_.push_back({path.generator, static_cast<float>(angle), mass * path.distance});
  }

  /// Joins the sums of all parts of the surface, in the order of the parts. If the parts do not depend on the number of
  /// threads, the result does not either.
  static CellIntegrals join(std::size_t cells, const std::vector<CellSums>& parts);

 private:
  struct Sum {
    GeneratorId generator;
    CellMoments moments;  // `centroid` is not yet divided by the mass
  };

  const WatchedGenerators* watched_;
  std::vector<Sum> sums_;
  std::vector<PathSample> samples_;
};

/// The density of the surface, and the generators whose single paths are wanted.
struct Integrand {
  const Density& density;
  const WatchedGenerators& watched;
};

/// Integrates over all cells of an exact diagram, using the windows from which it was traced.
///
/// Quadrature: whole faces, and the triangles into which each piece is cut, are divided into `divisions`^2 equal
/// triangles with three inner points each. This rule is exact for quadratic functions, and thus if all paths to a
/// triangle come straight from one image. Distances and log maps are exact at the points. Triangles crossed by a ridge,
/// behind a vertex with curvature, have an error. On the bunny with 69,451 faces and 100 generators it is 5e-6 of the
/// whole energy with one division, and 3e-8 with three. The result does not depend on the number of threads.
/// Cost: O(windows).
CellIntegrals integrate_over_windows(const WorkingMesh& working, const WindowField& field, const Diagram& diagram,
                                     const Integrand& integrand, const ParallelChunks& parallel, int divisions = 1);

/// Calls read(working, field) with all windows of these generators and their departures, and returns the result.
template <class Read>
auto read_windows(const Mesh& mesh, const std::vector<SurfacePoint>& generators, PropagationOptions options,
                  const Progress& progress, const Read& read) {
  const WorkingMesh working(mesh, generators, progress);
  options.departures = true;
  return read(working, propagate_windows(working.mesh(), working.generator_vertices().raw(), options, progress));
}

/// Places a point in a triangle by its least barycentric coordinate. In a thin part that can be very wrong, but no
/// integral notices it.
inline PlacedInTriangle place_in_triangle(const std::array<Bary, 3>& corners, const Bary& point) {
  const Vec2 a = affine_point(corners[0]), b = affine_point(corners[1]), c = affine_point(corners[2]),
             p = affine_point(point);
  const double area = twice_signed_area(a, b, c);
  const double v = twice_signed_area(a, p, c) / area, w = twice_signed_area(a, b, p) / area;
  const Bary local{1 - v - w, v, w};
  return {local, -std::min({local[0], local[1], local[2]})};
}

}  // namespace gvd
