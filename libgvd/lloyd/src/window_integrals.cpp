// Integrates over all cells, with exact distances and log maps.
//
// Each thread sums over its own part of the surface. Points of the same cell are mostly consecutive, so a part has a
// list of sums over runs of points instead of a table of all cells. The parts are joined in order, and sorting is
// stable, so the result does not depend on the number of threads.
// The quadrature has three inner points in each whole face and in each triangle of a piece, which is exact for
// quadratic functions (G. Strang and G. Fix, An Analysis of the Finite Element Method, 1973, section 4.3). Paths are
// looked up in the windows of the working mesh; if generators have split a face, in its parts.
#include "window_integrals.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/ear_clipping.hpp"
#include "base/plane.hpp"
#include "base/triangle_lattice.hpp"
#include "diagram/cell_parts.hpp"
#include "diagram/diagram_windows.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {
namespace {

using BaryTriangle = std::array<Bary, 3>;

/// The quadrature points of a triangle, in its own barycentric coordinates.
std::vector<Bary> quadrature_points(int divisions) {
  std::vector<Bary> points;
  const double unit = 1.0 / divisions;
  const auto add = [&](int i, int j, double sign) {
    for (const auto& [u, v] : {std::pair(1.0, 1.0), std::pair(4.0, 1.0), std::pair(1.0, 4.0)}) {
      const double x = (i + sign * u / 6) * unit, y = (j + sign * v / 6) * unit;
      points.push_back({1 - x - y, x, y});
    }
  };
  for_each_lattice_triangle(divisions,
                            [&](int i, int j, bool is_upright) { is_upright ? add(i, j, 1) : add(i + 1, j + 1, -1); });
  return points;
}

/// The input of all threads.
struct Paths {
  const WorkingMesh& working;
  const WindowField& field;
  Departures departures;
  SplitFaces split;
};

/// Integrates over faces of the input, face by face.
class FaceIntegrator {
 public:
  FaceIntegrator(const Paths& paths, const Integrand& integrand, const std::vector<Bary>& points)
      : sums(integrand.watched),
        input_(paths.working.input()),
        paths_(paths.working.mesh(), paths.field, paths.departures),
        split_(paths.split),
        density_(integrand.density),
        points_(points) {}

  void enter(FaceId face) {
    face_ = face;
    parts_ = split_.parts_of(face);
    if (parts_.empty()) paths_.enter(face);
  }
  /// Adds a part of the face. The triangles must lie within the part, because outside it no path of its generator may
  /// be known.
  void add(const FacePart& part) {
    corners_.clear();
    for (const Bary& corner : part.corners) corners_.push_back(affine_point(corner));
    const auto add_corners = [&](std::size_t a, std::size_t b, std::size_t c) {
      add({part.corners[a], part.corners[b], part.corners[c]}, part.generator);
    };
    if (is_convex()) {
      for (std::size_t k = 1; k + 1 < corners_.size(); ++k) add_corners(0, k, k + 1);
    } else {
      for (const auto& [a, b, c] : triangulate_plane_polygon(corners_)) add_corners(a, b, c);
    }
  }
  /// Adds a triangle of the face that belongs to generator g.
  void add(const BaryTriangle& triangle, GeneratorId g) {
    const double area = input_.area(face_) * twice_signed_area(affine_point(triangle[0]), affine_point(triangle[1]),
                                                               affine_point(triangle[2]));
    const double weight = area / double(points_.size());
    for (const Bary& local : points_) {
      const Bary point = compose(triangle, local);
      sums.add(g, weight, weight * density_.at(face_, point), find(point, g), 0);
    }
  }

  CellSums sums;

 private:
  bool is_convex() const {
    const std::size_t n = corners_.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (twice_signed_area(corners_[i], corners_[(i + 1) % n], corners_[(i + 2) % n]) < 0) return false;
    }
    return true;
  }
  /// The path from generator g to a point. If no path of g comes near the point, as in cells of approximate diagrams,
  /// returns the path from the nearest generator.
  NearestPath find(const Bary& point, GeneratorId g) {
    SurfacePoint place{face_, point};
    if (!parts_.empty()) {
      place = locate_in_parts(parts_, [&](const BaryTriangle& corners) { return place_in_triangle(corners, point); });
      paths_.enter(place.face);
    }
    const Vec2 at = paths_.position(place.bary);
    const NearestPath path = paths_.at(at, g);
    return path.generator.valid() ? path : paths_.at(at);
  }

  const Mesh& input_;
  NearestPaths paths_;
  const SplitFaces& split_;
  const Density& density_;
  const std::vector<Bary>& points_;
  FaceId face_;
  std::span<const SplitFaces::Part> parts_;  // of the face, if it is split
  std::vector<Vec2> corners_;                // of the current part, in affine coordinates of the face
};

}  // namespace

std::span<const PathSample> samples_of(const std::vector<PathSample>& sorted, GeneratorId g) {
  return {std::to_address(std::ranges::lower_bound(sorted, g, {}, &PathSample::generator)),
          std::to_address(std::ranges::upper_bound(sorted, g, {}, &PathSample::generator))};
}

CellIntegrals CellSums::join(std::size_t cells, const std::vector<CellSums>& parts) {
  CellIntegrals all;
  all.moments.resize(cells);
  for (const CellSums& part : parts) {
    for (const auto& [generator, moments] : part.sums_) {
      CellMoments& cell = all.moments[generator];
      cell.area += moments.area;
      cell.mass += moments.mass;
      cell.energy += moments.energy;
      cell.centroid += moments.centroid;
    }
    all.samples.insert(all.samples.end(), part.samples_.begin(), part.samples_.end());
  }
  for (CellMoments& cell : all.moments) {
    if (cell.mass > 0) cell.centroid /= cell.mass;
  }
  std::ranges::stable_sort(all.samples, {}, &PathSample::generator);
  return all;
}

CellIntegrals integrate_over_windows(const WorkingMesh& working, const WindowField& field, const Diagram& diagram,
                                     const Integrand& integrand, const ParallelChunks& parallel, int divisions) {
  const Paths paths{working, field, Departures(working, diagram.generators), SplitFaces(working)};
  const std::vector<Bary> points = quadrature_points(divisions);
  const std::vector<Chunk> chunks = cut_into_chunks(diagram.face_label.size(), kScanChunk);
  std::vector<CellSums> sums(chunks.size(), CellSums(integrand.watched));
  parallel.run(chunks.size(), {steps::kCells}, [&](std::size_t chunk) {
    FaceIntegrator integrator(paths, integrand, points);
    for (FaceId face(chunks[chunk].begin); face.index() < chunks[chunk].end; face = FaceId(face.value() + 1)) {
      integrator.enter(face);
      for_each_cell_part(diagram, face, [&](const FacePart& part) { integrator.add(part); });
    }
    sums[chunk] = std::move(integrator.sums);
  });
  return CellSums::join(diagram.generators.size(), sums);
}

IdVector<GeneratorId, CellMoments> compute_cell_moments(const Mesh& mesh, const Diagram& diagram, int threads,
                                                        const Density& density) {
  if (diagram.face_label.count() != mesh.face_count()) {
    throw Error(ErrorCode::precondition, "the diagram was not made of this mesh: the number of faces differs");
  }
  check_density(mesh, density);
  const Progress silent;
  const auto read = [&](const WorkingMesh& working, const WindowField& field) {
    return integrate_over_windows(working, field, diagram, {density, {}}, ParallelChunks(threads, silent)).moments;
  };
  PropagationOptions options;
  options.offsets = from_zero(diagram.weights);
  options.threads = threads;
  return read_windows(mesh, diagram.generators, options, silent, read);
}

}  // namespace gvd
