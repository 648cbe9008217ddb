#include "integrals/sampled_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/barycentric.hpp"
#include "base/parallel_chunks.hpp"
#include "geodesic/windows/departures/departures.hpp"
#include "geodesic/windows/departures/nearest_paths.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/surface_normal.hpp"
#include "integrals/cell_sums.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {
namespace {

/// Divisions of the sides of a face that a bisector may cross. With 2, 4 and 5 the error of the centroids is 1.9, 0.7
/// and 0.5 times that with 3.
constexpr int kDivisions = 3;

/// The centroids of the equal triangles into which a triangle with so many divisions of its sides falls.
std::vector<Bary> division_centroids(int divisions) {
  std::vector<Bary> points;
  const auto add = [&](double i, double j) {
    const double x = i / divisions, y = j / divisions;
    points.push_back({1 - x - y, x, y});
  };
  for (int i = 0; i < divisions; ++i) {
    for (int j = 0; i + j < divisions; ++j) {
      add(i + 1.0 / 3, j + 1.0 / 3);
      if (i + j + 1 < divisions) add(i + 2.0 / 3, j + 2.0 / 3);
    }
  }
  return points;
}

/// What the threads read.
struct Field {
  const WorkingMesh& working;
  const WindowField& windows;
  Departures departures;
  const std::vector<SurfacePoint>& generators;
  const Density& density;
  const WatchedGenerators& watched;
};

/// Sums over the faces of the working mesh, one after the other.
class FaceSampler {
 public:
  explicit FaceSampler(const Field& field)
      : sums(field.watched),
        field_(field),
        mesh_(field.working.mesh()),
        paths_(mesh_, field.windows, field.departures),
        inside_(division_centroids(1)),
        crossed_(division_centroids(kDivisions)) {}

  void add(FaceId face) {
    face_ = face;
    paths_.enter(face);
    double spread = 0;
    for (int i = 0; i < 3; ++i) spread += std::pow(mesh_.length(Mesh::halfedge(face, i)), 2) / 36;
    if (has_one_label()) {
      for (const Bary& point : inside_) add(point, mesh_.area(face), spread);
    } else {
      const double share = 1 / static_cast<double>(crossed_.size());
      for (const Bary& point : crossed_) add(point, share * mesh_.area(face), share * spread);
      add_segments();
    }
  }

  CellSums sums;
  std::vector<BisectorSegment> segments;

 private:
  GeneratorId label(std::size_t corner) const { return field_.windows.label[mesh_.vertices(face_)[corner]]; }
  bool has_one_label() const { return label(0) == label(1) && label(1) == label(2); }
  double density_at(const Bary& point) const {
    return field_.density.at(field_.working.parent(face_), field_.working.parent_bary(face_, point));
  }

  /// Adds a point that stands for a triangle. `spread` is the mean squared distance of the triangle's points from it.
  void add(const Bary& point, double area, double spread) {
    const NearestPath path = paths_.at(paths_.position(point));
    if (path.generator.valid()) sums.add(path.generator, area, area * density_at(point), path, spread);
  }

  /// Segments between the middles of the sides that have two labels, and the centroid where there are three labels.
  void add_segments() {
    const auto vertices = mesh_.vertices(face_);
    const auto corner = [&](std::size_t i) { return mesh_.position(vertices[i % 3]); };
    const Vec3 centroid = (corner(0) + corner(1) + corner(2)) / 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const GeneratorId a = label(i), b = label((i + 1) % 3), c = label((i + 2) % 3);
      if (a == b || !a.valid() || !b.valid()) continue;
      const Vec3 middle = 0.5 * (corner(i) + corner(i + 1));
      if (c != a && c != b) add_segment(a, b, middle, centroid);
      if (c == a) add_segment(a, b, middle, 0.5 * (corner(i + 1) + corner(i + 2)));
    }
  }

  /// The segments zigzag about the bisector. What counts is their length across the way between the generators.
  void add_segment(GeneratorId a, GeneratorId b, const Vec3& from, const Vec3& to) {
    const Mesh& input = field_.working.input();
    const Vec3 between = position(input, field_.generators[b.index()]) - position(input, field_.generators[a.index()]);
    const Vec3 across = (to - from).cross(face_normal(mesh_, face_));
    const double length = between.norm() > 0 ? std::abs(across.dot(between)) / between.norm() : across.norm();
    segments.push_back({std::min(a, b), std::max(a, b), from, to, length, density_at({1.0 / 3, 1.0 / 3, 1.0 / 3})});
  }

  const Field& field_;
  const Mesh& mesh_;
  NearestPaths paths_;
  const std::vector<Bary> inside_, crossed_;
  FaceId face_;
};

IdVector<VertexId, double> input_distances(const Mesh& input, const WindowField& field) {
  IdVector<VertexId, double> distances;
  for (std::int32_t v = 0; v < input.vertex_count(); ++v) distances.push_back(field.distance[VertexId(v)]);
  return distances;
}

}  // namespace

SampledCells sample_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const SampleOptions& options,
                          const Progress& progress) {
  const WorkingMesh working(mesh, generators, progress);
  PropagationOptions propagation;
  propagation.departures = true;
  propagation.threads = options.threads;
  const WindowField windows =
      propagate_windows(working.mesh(), working.generator_vertices().raw(), propagation, progress);
  const Field field{working, windows, Departures(working, generators), generators, options.density, options.watched};
  const auto faces = cut_into_chunks(static_cast<std::size_t>(working.mesh().face_count()), kScanChunk);
  std::vector<CellSums> sums(faces.size(), CellSums(options.watched));
  std::vector<std::vector<BisectorSegment>> segments(faces.size());
  ParallelChunks(options.threads, progress).run(faces.size(), {steps::kCells}, [&](std::size_t i) {
    FaceSampler sampler(field);
    for (std::size_t f = faces[i].begin; f < faces[i].end; ++f) sampler.add(FaceId(static_cast<std::int64_t>(f)));
    sums[i] = std::move(sampler.sums);
    segments[i] = std::move(sampler.segments);
  });
  SampledCells cells{CellSums::join(generators.size(), sums), {}, input_distances(mesh, windows)};
  for (const auto& part : segments) cells.segments.insert(cells.segments.end(), part.begin(), part.end());
  sort_by_cells(cells.segments);
  return cells;
}

}  // namespace gvd
