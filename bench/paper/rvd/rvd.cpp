#include "rvd/rvd.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/barycentric.hpp"
#include "cpu_clock.hpp"
#include "pieces/collect_pieces.hpp"
#include "rvd/delaunay_neighbours.hpp"
#include "rvd/euclidean_cells.hpp"

namespace gvd::paper {
namespace {

/// The pieces of a face may miss this fraction of its area by rounding.
constexpr double kCovered = 1e-9;

/// Cuts one face after the other. The cells that intersect a face are found from neighbour to neighbour: a convex face
/// is cut into convex pieces, so that sides connect all of them.
class FaceClipper {
 public:
  FaceClipper(const Mesh& mesh, const std::vector<Vec3>& positions,
              const std::vector<std::vector<GeneratorId>>& neighbours)
      : mesh_(mesh), cells_(mesh, positions), neighbours_(neighbours), queued_(positions.size(), FaceId()) {
    for (std::size_t i = 0; i < positions.size(); ++i) all_.emplace_back(static_cast<std::int64_t>(i));
  }

  Pieces clip_all() {
    for (const Vec3& p : mesh_.positions()) label_.push_back(walk_to_nearest(p));
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) cut_face(FaceId(i));
    return std::move(pieces_);
  }

 private:
  /// Cells are convex: they contain a face with its corners.
  void cut_face(FaceId f) {
    const auto& [a, b, c] = mesh_.vertices(f);
    if (label_[a] == label_[b] && label_[b] == label_[c]) {
      pieces_.push_back({f, label_[a], whole_face()});
    } else {
      clip_face(f, label_[a]);
    }
  }

  void clip_face(FaceId f, GeneratorId nearest) {
    const std::size_t first = pieces_.size();
    enqueue(f, nearest);
    for (std::size_t i = 0; i < queue_.size(); ++i) clip_cell(f, queue_[i], neighbours_[queue_[i].index()]);
    queue_.clear();
    if (is_covered(first)) return;
    // Cells of which several meet in a line of the face may have no neighbour there: try all generators.
    pieces_.resize(first);
    for (const GeneratorId g : all_) clip_cell(f, g, all_);
    queue_.clear();
  }

  /// From the last nearest generator along Delaunay edges: one of them always leads closer, if there is a closer one.
  /// Of two that are equally near, the lower one is taken.
  GeneratorId walk_to_nearest(const Vec3& p) {
    double least = cells_.squared_distance(p, nearest_);
    for (bool closer = true; closer;) {
      closer = false;
      for (const GeneratorId g : neighbours_[nearest_.index()]) {
        const double d = cells_.squared_distance(p, g);
        if (!(d < least || (d == least && g < nearest_))) continue;
        least = d;
        nearest_ = g;
        closer = true;
        break;
      }
    }
    return nearest_;
  }

  void enqueue(FaceId f, GeneratorId g) {
    if (std::exchange(queued_[g.index()], f) != f) queue_.push_back(g);
  }

  void clip_cell(FaceId f, GeneratorId g, const std::vector<GeneratorId>& others) {
    Polygon polygon = cells_.clip(f, whole_face(), g, others);
    if (polygon.empty()) return;
    for (const GeneratorId other : others) {
      if (other != g && touches(polygon, cells_.bisector_form(f, g, other))) enqueue(f, other);
    }
    pieces_.push_back({f, g, std::move(polygon)});
  }

  /// Whether a side of the polygon lies in the bisector plane.
  static bool touches(const Polygon& polygon, const LinearForm& form) {
    return std::count_if(polygon.begin(), polygon.end(), [&](const Bary& p) { return is_near_plane(form, p); }) > 1;
  }
  /// Corners of a clipped polygon are in the plane to rounding only.
  static bool is_near_plane(const LinearForm& form, const Bary& p) {
    const double scale = std::max({std::abs(form[0]), std::abs(form[1]), std::abs(form[2])});
    return std::abs(evaluate(form, p)) <= 100 * kZeroValue * scale;
  }

  bool is_covered(std::size_t first) const {
    double share = 0;
    for (std::size_t i = first; i < pieces_.size(); ++i) share += area_share(pieces_[i].corners);
    return std::abs(share - 1) <= kCovered;
  }

  const Mesh& mesh_;
  EuclideanCells cells_;
  const std::vector<std::vector<GeneratorId>>& neighbours_;
  std::vector<GeneratorId> all_;
  IdVector<VertexId, GeneratorId> label_;  // the nearest generator in space
  std::vector<FaceId> queued_;             // [generator] the last face for which it was queued
  std::vector<GeneratorId> queue_;
  GeneratorId nearest_{0};
  Pieces pieces_;
};

}  // namespace

Pieces clip_to_voronoi_cells(const Mesh& mesh, const std::vector<Vec3>& positions,
                             const std::vector<std::vector<GeneratorId>>& neighbours) {
  return FaceClipper(mesh, positions, neighbours).clip_all();
}

Pieces time_voronoi_cells(const Mesh& mesh, const std::vector<Vec3>& positions, Comparison& result) {
  const double start = bench::cpu_milliseconds();
  const auto neighbours = find_delaunay_neighbours(positions);
  const double triangulated = bench::cpu_milliseconds();
  Pieces pieces = clip_to_voronoi_cells(mesh, positions, neighbours);
  result.field_ms += triangulated - start;
  result.diagram_ms += bench::cpu_milliseconds() - triangulated;
  return pieces;
}

std::vector<Vec3> find_positions(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  std::vector<Vec3> positions;
  for (const SurfacePoint& g : generators) positions.push_back(position(mesh, g));
  return positions;
}

Comparison compute_rvd(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  Comparison result;
  Pieces pieces = time_voronoi_cells(mesh, find_positions(mesh, generators), result);
  collect_pieces(mesh, generators, std::move(pieces), result);
  return result;
}

}  // namespace gvd::paper
