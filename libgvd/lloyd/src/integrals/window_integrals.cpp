// Quadrature over the faces and pieces of all cells, with exact distances and log maps at the points.
#include "window_integrals.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "base/ear_clipping.hpp"
#include "base/plane.hpp"
#include "geodesic/windows/departures/departures.hpp"
#include "geodesic/windows/departures/nearest_paths.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "integrals/cell_sums.hpp"
#include "mesh/split_faces.hpp"

namespace gvd {
namespace {

using Triangle = std::array<Bary, 3>;
constexpr Triangle kWholeFace{Bary{1, 0, 0}, Bary{0, 1, 0}, Bary{0, 0, 1}};

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
  for (int i = 0; i < divisions; ++i) {
    for (int j = 0; i + j < divisions; ++j) {
      add(i, j, 1);
      if (i + j + 1 < divisions) add(i + 1, j + 1, -1);
    }
  }
  return points;
}

/// By the least barycentric coordinate. In a thin part it can be wrong by much, which no integral notices.
PlacedInTriangle place_in_triangle(const Triangle& corners, const Bary& point) {
  const Vec2 a = affine_point(corners[0]), b = affine_point(corners[1]), c = affine_point(corners[2]),
             p = affine_point(point);
  const double area = twice_signed_area(a, b, c);
  const double v = twice_signed_area(a, p, c) / area, w = twice_signed_area(a, b, p) / area;
  const Bary local{1 - v - w, v, w};
  return {local, -std::min({local[0], local[1], local[2]})};
}

/// What the threads read.
struct Paths {
  const WorkingMesh& working;
  const WindowField& field;
  Departures departures;
  SplitFaces split;
};

/// Integrates over faces of the input, one after the other.
class FaceIntegrator {
 public:
  FaceIntegrator(const Paths& paths, const Quadrature& quadrature, const std::vector<Bary>& points)
      : sums(quadrature.watched),
        input_(paths.working.input()),
        paths_(paths.working.mesh(), paths.field, paths.departures),
        split_(paths.split),
        density_(quadrature.density),
        points_(points) {}

  void enter(FaceId face) {
    face_ = face;
    parts_ = split_.parts_of(face);
    if (parts_.empty()) paths_.enter(face);
  }
  /// Adds a piece of the face. Its triangles lie within the piece: beyond it, no path of its generator may be known.
  void add(const FacePiece& piece) {
    corners_.clear();
    for (const Bary& corner : piece.corners) corners_.push_back(affine_point(corner));
    const auto add_corners = [&](std::size_t a, std::size_t b, std::size_t c) {
      add({piece.corners[a], piece.corners[b], piece.corners[c]}, piece.generator);
    };
    if (is_convex()) {
      for (std::size_t k = 1; k + 1 < corners_.size(); ++k) add_corners(0, k, k + 1);
    } else {
      for (const auto& [a, b, c] : triangulate_plane_polygon(corners_)) add_corners(a, b, c);
    }
  }
  /// Adds a triangle of the face, which belongs to generator g.
  void add(const Triangle& triangle, GeneratorId g) {
    const double area = input_.area(face_) * twice_signed_area(affine_point(triangle[0]), affine_point(triangle[1]),
                                                               affine_point(triangle[2]));
    const double weight = area / static_cast<double>(points_.size());
    for (const Bary& local : points_) {
      const Bary point = interpolate_bary(triangle, local);
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
  static Bary interpolate_bary(const Triangle& t, const Bary& local) {
    Bary point{};
    for (std::size_t i = 0; i < 3; ++i) point[i] = local[0] * t[0][i] + local[1] * t[1][i] + local[2] * t[2][i];
    return point;
  }
  /// The nearest generator's path where no path of g comes near: in cells of approximate diagrams.
  NearestPath find(const Bary& point, GeneratorId g) {
    Vec2 at;
    if (!parts_.empty()) {
      const SurfacePoint inside =
          locate_in_parts(parts_, [&](const Triangle& corners) { return place_in_triangle(corners, point); });
      paths_.enter(inside.face);
      at = paths_.position(inside.bary);
    } else {
      at = paths_.position(point);
    }
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
  std::vector<Vec2> corners_;                // of the current piece; an affine map of the face
};

/// The pieces of each face follow each other, ascending by face.
class PieceRange {
 public:
  PieceRange(const Diagram& diagram, FaceId first)
      : pieces_(diagram.pieces),
        next_(std::lower_bound(pieces_.begin(), pieces_.end(), first,
                               [](const FacePiece& piece, FaceId f) { return piece.face < f; })) {}

  template <class Visit>
  void for_each_in(FaceId face, Visit visit) {
    for (; next_ != pieces_.end() && next_->face == face; ++next_) visit(*next_);
  }

 private:
  const std::vector<FacePiece>& pieces_;
  std::vector<FacePiece>::const_iterator next_;
};

}  // namespace

CellIntegrals integrate_over_windows(const WorkingMesh& working, const WindowField& field, const Diagram& diagram,
                                     const Quadrature& quadrature, const ParallelChunks& parallel) {
  const Paths paths{working, field, Departures(working, diagram.generators), SplitFaces(working)};
  const std::vector<Bary> points = quadrature_points(quadrature.divisions);
  const std::vector<Chunk> chunks = cut_into_chunks(diagram.face_label.size(), kScanChunk);
  std::vector<CellSums> sums(chunks.size(), CellSums(quadrature.watched));
  parallel.run(chunks.size(), {steps::kCells}, [&](std::size_t chunk) {
    FaceIntegrator integrator(paths, quadrature, points);
    PieceRange pieces(diagram, FaceId(chunks[chunk].begin));
    for (std::size_t i = chunks[chunk].begin; i < chunks[chunk].end; ++i) {
      const FaceId face(i);
      integrator.enter(face);
      if (diagram.face_label[face].valid()) integrator.add(kWholeFace, diagram.face_label[face]);
      pieces.for_each_in(face, [&](const FacePiece& piece) { integrator.add(piece); });
    }
    sums[chunk] = std::move(integrator.sums);
  });
  return CellSums::join(diagram.generators.size(), sums);
}

CellIntegrals integrate_cells(const Mesh& mesh, const Diagram& diagram, const Quadrature& quadrature, int threads) {
  const Progress silent;
  const WorkingMesh working(mesh, diagram.generators);
  PropagationOptions propagation;
  propagation.departures = true;
  propagation.threads = threads;
  const WindowField field = propagate_windows(working.mesh(), working.generator_vertices().raw(), propagation, silent);
  return integrate_over_windows(working, field, diagram, quadrature, ParallelChunks(threads, silent));
}

IdVector<GeneratorId, CellMoments> compute_cell_moments(const Mesh& mesh, const Diagram& diagram, int threads,
                                                        const Density& density) {
  if (diagram.face_label.size() != static_cast<std::size_t>(mesh.face_count())) {
    throw Error(ErrorCode::precondition, "the diagram was not made of this mesh: the number of faces differs");
  }
  check_density(mesh, density);
  return integrate_cells(mesh, diagram, {density, {}}, threads).moments;
}

}  // namespace gvd
