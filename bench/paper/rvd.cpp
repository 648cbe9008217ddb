// Diagrams of straight distances: the restricted Voronoi diagram [29], and the localized one [28].
//
// The cell of a generator is what its three-dimensional Voronoi cell cuts out of the surface. The Delaunay
// triangulation of the generators names the planes that can bound a cell. A walk along Delaunay edges finds the
// generator nearest to each vertex; a face with one label lies in its convex cell. Straight distances know nothing of
// the surface, so cells come through thin plates. The localized diagram divides such islands among the cells that touch
// them, in rounds, until there is none: cells are connected then. Borders are still bisectors of straight distances,
// or those of former islands that touched each other, which are no bisectors.
//
// Sources: Yan, Levy, Liu, Sun, Wang 2009 and Yan, Bao, Zhang, Wonka 2014; full titles are with the declarations.
// Invariant: both cells of a bisector plane are clipped by one form up to its sign, and points on the sides of a face
// stay there. So the pieces of all cells cover every face once, and those of neighbouring faces meet on their edge.
#include "rvd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "clocks.hpp"
#include "comparators.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "pieces.hpp"

#ifdef GVD_HAS_PEERS
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#endif

namespace gvd::paper {

#ifdef GVD_HAS_PEERS
std::vector<std::vector<GeneratorId>> find_delaunay_neighbours(const std::vector<Vec3>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<GeneratorId, Kernel>;
  using Structure = CGAL::Triangulation_data_structure_3<VertexBase>;
  using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
  std::vector<std::pair<Kernel::Point_3, GeneratorId>> sites;
  for (const Vec3& p : points) sites.push_back({{p.x(), p.y(), p.z()}, GeneratorId(sites.size())});
  const Delaunay delaunay(sites.begin(), sites.end());
  std::vector<std::vector<GeneratorId>> neighbours(points.size());
  for (auto v = delaunay.finite_vertices_begin(); v != delaunay.finite_vertices_end(); ++v) {
    std::vector<Delaunay::Vertex_handle> around;
    delaunay.finite_adjacent_vertices(v, std::back_inserter(around));
    for (const Delaunay::Vertex_handle& other : around) neighbours[v->info().index()].push_back(other->info());
  }
  for (auto& list : neighbours) std::sort(list.begin(), list.end());
  return neighbours;
}
#else
std::vector<std::vector<GeneratorId>> find_delaunay_neighbours(const std::vector<Vec3>& points) {
  std::vector<std::vector<GeneratorId>> neighbours(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j != i) neighbours[i].push_back(GeneratorId(j));
    }
  }
  return neighbours;
}
#endif

namespace {

/// Cells by straight distances in space, face by face: what RVD and LRVD clip with.
class EuclideanCells {
 public:
  /// Both must outlive this. `positions`: of the generators, mesh units.
  EuclideanCells(const Mesh& mesh, const std::vector<Vec3>& positions) : mesh_(mesh), positions_(positions) {}

  /// |p - b|^2 - |p - a|^2 at the corners of a face: > 0 where a is nearer. It is linear, and 0 in the bisector plane.
  /// Swapping a and b negates it exactly, so that both cells are clipped at the same line.
  LinearForm bisector_form(FaceId f, GeneratorId a, GeneratorId b) const {
    const Vec3 &p = positions_[a.index()], &q = positions_[b.index()];
    const Vec3 normal = p - q, twice_middle = p + q;
    LinearForm form{};
    for (std::size_t i = 0; i < 3; ++i) form[i] = normal.dot(2 * mesh_.position(mesh_.vertices(f)[i]) - twice_middle);
    return form;
  }

  /// The part of a polygon of face f that is nearer to g than to the other generators; g itself is left out. Where two
  /// are equally near to the whole polygon, the lower one has it.
  Polygon clip(FaceId f, Polygon polygon, GeneratorId g, std::span<const GeneratorId> others) const {
    for (const GeneratorId other : others) {
      if (other == g) continue;
      polygon = clip_polygon(polygon, bisector_form(f, g, other), g < other);
      if (polygon.empty()) break;
    }
    return polygon;
  }

  double squared_distance(const Vec3& p, GeneratorId g) const { return (p - positions_[g.index()]).squaredNorm(); }

 private:
  const Mesh& mesh_;
  const std::vector<Vec3>& positions_;
};

/// The pieces of a face may miss this fraction of its area by rounding.
constexpr double kCovered = 1e-9;

/// Cuts one face after the other. The cells that intersect a face are found from neighbour to neighbour: a convex face
/// is cut into convex pieces, so that sides connect all of them.
class FaceClipper {
 public:
  FaceClipper(const Mesh& mesh, const std::vector<Vec3>& positions,
              const std::vector<std::vector<GeneratorId>>& neighbours)
      : mesh_(mesh), cells_(mesh, positions), neighbours_(neighbours), queued_(positions.size(), FaceId()) {
    for (std::size_t i = 0; i < positions.size(); ++i) all_.emplace_back(i);
  }

  Pieces clip_all() {
    for (const Vec3& p : mesh_.positions()) label_.push_back(walk_to_nearest(p));
    for (const FaceId f : mesh_.faces()) cut_face(f);
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

  /// Begins with the cell that has a corner and goes on to all cells that intersect the face.
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

  /// Adds the part of the face in one cell, and queues the cells on the other sides of its planes.
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

  /// Whether the pieces from `first` on add up to the whole face.
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

std::vector<Vec3> find_positions(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  std::vector<Vec3> positions;
  for (const SurfacePoint& g : generators) positions.push_back(position(mesh, g));
  return positions;
}

namespace {

/// The pieces of the restricted Voronoi diagram; adds the times to `result`.
Pieces time_voronoi_cells(const Mesh& mesh, const std::vector<Vec3>& positions, Comparison& result) {
  const double start = bench::cpu_milliseconds();
  const auto neighbours = find_delaunay_neighbours(positions);
  const double triangulated = bench::cpu_milliseconds();
  Pieces pieces = clip_to_voronoi_cells(mesh, positions, neighbours);
  result.field_ms += triangulated - start;
  result.diagram_ms += bench::cpu_milliseconds() - triangulated;
  return pieces;
}

}  // namespace

Comparison compute_rvd(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  Comparison result;
  Pieces pieces = time_voronoi_cells(mesh, find_positions(mesh, generators), result);
  collect_pieces(mesh, generators, std::move(pieces), result);
  return result;
}

namespace {

/// The rounds of the localized diagram [28]: islands become pieces of the cells that touch them.
class IslandSweeper {
 public:
  IslandSweeper(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const std::vector<Vec3>& positions)
      : mesh_(mesh), generators_(generators), cells_(mesh, positions) {}

  /// Divides all islands that cells touch among these; whether there was one.
  bool sweep(Pieces& pieces) {
    const auto contacts = find_contacts(mesh_, pieces);
    parts_ = find_cell_parts(mesh_, generators_, pieces, contacts);
    find_touching_cells(pieces, contacts);
    Pieces swept;
    bool changed = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::vector<GeneratorId>& around = touching_[part(i)];
      if (around.empty()) {
        swept.push_back(std::move(pieces[i]));
      } else {
        divide(pieces[i], around, swept);
        changed = true;
      }
    }
    pieces = std::move(swept);
    return changed;
  }

 private:
  int part(std::size_t piece) const { return parts_.part_of[piece]; }

  /// Only components with their generator count as cells: two islands can't feed on each other.
  void find_touching_cells(const Pieces& pieces, const std::vector<Contact>& contacts) {
    std::vector<std::set<GeneratorId>> touching(parts_.area.size());
    const auto add = [&](std::int32_t from, std::int32_t to) {
      const int island = part(from), cell = part(to);
      if (!parts_.is_island(island) || parts_.has_generator[cell] == 0) return;
      touching[island].insert(pieces[to].generator);
    };
    for (const Contact& c : contacts) {
      add(c.left, c.right);
      add(c.right, c.left);
    }
    touching_.clear();
    for (const auto& cells : touching) touching_.emplace_back(cells.begin(), cells.end());
  }

  /// Cuts a piece of an island by the bisector planes of the cells round it.
  void divide(const FacePiece& piece, const std::vector<GeneratorId>& cells, Pieces& swept) const {
    for (const GeneratorId g : cells) {
      Polygon polygon = cells_.clip(piece.face, piece.corners, g, cells);
      if (!polygon.empty()) swept.push_back({piece.face, g, std::move(polygon)});
    }
  }

  const Mesh& mesh_;
  const std::vector<SurfacePoint>& generators_;
  EuclideanCells cells_;
  CellParts parts_;
  std::vector<std::vector<GeneratorId>> touching_;  // [component] the cells that touch an island, ascending
};

}  // namespace

Comparison compute_lrvd(const Mesh& mesh, const std::vector<SurfacePoint>& generators, int most_rounds) {
  const std::vector<Vec3> positions = find_positions(mesh, generators);
  Comparison result;
  Pieces pieces = time_voronoi_cells(mesh, positions, result);
  const double start = bench::cpu_milliseconds();
  IslandSweeper sweeper(mesh, generators, positions);
  result.rounds = 0;
  while (result.rounds < most_rounds && sweeper.sweep(pieces)) ++result.rounds;
  result.diagram_ms += bench::cpu_milliseconds() - start;
  collect_pieces(mesh, generators, std::move(pieces), result);
  return result;
}

}  // namespace gvd::paper
