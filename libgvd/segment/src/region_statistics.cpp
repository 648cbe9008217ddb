#include "gvd/region_statistics.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

#include "base/barycentric.hpp"
#include "face_shares.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

double compute_length(const Mesh& mesh, const Bisector& bisector) {
  double sum = 0;
  const std::size_t count = bisector.points.size();
  for (std::size_t i = bisector.closed ? 0 : 1; i < count; ++i) {
    sum += (position(mesh, bisector.points[i]) - position(mesh, bisector.points[(i + count - 1) % count])).norm();
  }
  return sum;
}

Vec3 corner_position(const Mesh& mesh, FaceId f, const Bary& bary) {
  const auto& [a, b, c] = mesh.vertices(f);
  return interpolate<Vec3>(bary, mesh.position(a), mesh.position(b), mesh.position(c));
}

class RegionMeter {
 public:
  RegionMeter(const Mesh& mesh, const Diagram& diagram)
      : mesh_(mesh), diagram_(diagram), regions_(diagram.generators.size()) {}

  IdVector<GeneratorId, RegionStatistics> run() {
    take_cells();
    add_bisectors();
    add_mesh_boundary();
    measure_radii();
    for (RegionStatistics& region : regions_) {
      region.compactness = 4 * std::numbers::pi * (region.area / region.perimeter) / region.perimeter;
    }
    return std::move(regions_);
  }

 private:
  void take_cells() {
    const double total = compute_area(mesh_);
    for (const Cell& cell : diagram_.cells) {
      RegionStatistics& region = regions_[cell.generator];
      region.area = cell.area;
      region.share = total > 0 ? cell.area / total : 0;
      region.euler_characteristic = cell.euler_characteristic;
      for (const GeneratorId g : cell.neighbours) region.neighbours.push_back({g, 0});
    }
  }

  void add_bisectors() {
    for (const Bisector& bisector : diagram_.bisectors) {
      const double length = compute_length(mesh_, bisector);
      regions_[bisector.left].perimeter += length;
      regions_[bisector.right].perimeter += length;
      if (bisector.left == bisector.right) continue;
      add_border(bisector.left, bisector.right, length);
      add_border(bisector.right, bisector.left, length);
    }
  }

  void add_border(GeneratorId region, GeneratorId neighbour, double length) {
    std::vector<RegionNeighbour>& all = regions_[region].neighbours;
    const auto found = std::lower_bound(all.begin(), all.end(), neighbour,
                                        [](const RegionNeighbour& n, GeneratorId g) { return n.region < g; });
    if (found != all.end() && found->region == neighbour) found->border_length += length;
  }

  void add_mesh_boundary() {
    for (std::int32_t h = 0; h < mesh_.halfedge_count(); ++h) {
      const GeneratorId g = diagram_.face_label[Mesh::face(HalfedgeId(h))];
      if (g.valid() && !mesh_.twin(HalfedgeId(h)).valid()) regions_[g].perimeter += mesh_.length(HalfedgeId(h));
    }
    for (const FacePiece& piece : diagram_.pieces) {
      for (int side = 0; side < 3; ++side) {
        const HalfedgeId h = Mesh::halfedge(piece.face, side);
        if (!mesh_.twin(h).valid()) regions_[piece.generator].perimeter += mesh_.length(h) * covered_part(piece, side);
      }
    }
  }

  /// The part of a face's side that bounds the piece. Corners of pieces that lie on a side have a 0 there. It is
  /// exact, but for the rounding of coordinates that were converted from a split face.
  static double covered_part(const FacePiece& piece, int side) {
    const auto start = static_cast<std::size_t>(side), opposite = static_cast<std::size_t>((side + 2) % 3);
    double sum = 0;
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
      const Bary &a = piece.corners[i], &b = piece.corners[(i + 1) % piece.corners.size()];
      if (a[opposite] > kBarycentricSnap || b[opposite] > kBarycentricSnap) continue;
      sum += std::max(0.0, a[start] - b[start]);  // pieces are counter-clockwise, as the side is
    }
    return sum;
  }

  void measure_radii() {
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      extend(diagram_.vertex_label[VertexId(v)], diagram_.vertex_distance[VertexId(v)]);
    }
    for (const BranchPoint& point : diagram_.branch_points) {
      for (const GeneratorId g : point.generators) extend(g, point.distance);
    }
    std::vector<std::pair<FaceId, GeneratorId>> own;
    for (std::size_t i = 0; i < diagram_.generators.size(); ++i) {
      const GeneratorId g(i);
      for (const FaceId f : faces_around(mesh_, diagram_.generators[i])) own.emplace_back(f, g);
    }
    std::sort(own.begin(), own.end());
    for (const FacePiece& piece : diagram_.pieces) {
      if (!std::binary_search(own.begin(), own.end(), std::pair(piece.face, piece.generator))) continue;
      const Vec3 from = position(mesh_, diagram_.generators[piece.generator.index()]);
      for (const Bary& b : piece.corners) {
        extend(piece.generator, (corner_position(mesh_, piece.face, b) - from).norm());
      }
    }
  }

  void extend(GeneratorId g, double distance) {
    if (g.valid()) regions_[g].radius = std::max(regions_[g].radius, distance);
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  IdVector<GeneratorId, RegionStatistics> regions_;
};

}  // namespace

IdVector<GeneratorId, RegionStatistics> compute_region_statistics(const Mesh& mesh, const Diagram& diagram) {
  check_belongs(mesh, diagram);
  return RegionMeter(mesh, diagram).run();
}

}  // namespace gvd
