// Cuts the faces of a mesh along the bisectors of its diagram.
//
// The points of pieces on an edge are collected from both faces of the edge, sorted along it and numbered once, so that
// the two faces share vertices and the surface stays closed. Each face is then tiled by its pieces (FaceTiling), and
// the polygons are cut into triangles. A face whose pieces do not tile it stays whole, with the vertices on its edges.
// The triangles of a face follow each other, in the order of the faces.
//
// Two repairs follow (cut_triangles.cpp): no edge has four faces, and none is without a length.
// At last, regions that touch themselves at a vertex are parted there (part_touching_regions.cpp).
#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "base/ear_clipping.hpp"
#include "cut_triangles.hpp"
#include "face_shares.hpp"
#include "face_tiling.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/vertex_ring.hpp"
#include "part_touching_regions.hpp"

namespace gvd {
namespace {

/// Faces between two calls of the progress callback.
constexpr std::int32_t kCutStride = 1 << 8;

class Cutter {
 public:
  Cutter(const Mesh& mesh, const Diagram& diagram, const Progress& progress)
      : mesh_(mesh), diagram_(diagram), progress_(progress), shares_(diagram), tolerance_(position_tolerance(mesh)) {
    cut_.positions = mesh.positions();
    result_.input_vertices = mesh.vertex_count();
  }

  CutMesh run() {
    collect_edge_points();
    number_edge_points();
    auto piece = diagram_.pieces.begin();
    for (const FaceId f : mesh_.faces()) {
      if (f.value() % kCutStride == 0) report(double(f.value()) / mesh_.face_count());
      const auto first = piece;
      while (piece != diagram_.pieces.end() && piece->face == f) ++piece;
      cut_face(f, {std::to_address(first), std::to_address(piece)});
    }
    if (piece != diagram_.pieces.end()) {
      throw Error(ErrorCode::precondition, "the diagram's pieces are not sorted by face", piece->face.value());
    }
    report(1);
    split_doubled_edges(cut_);
    separate_coincident_corners(cut_, mesh_.positions().size(), tolerance_);
    report(1);
    build_mesh();
    part_touching_regions(diagram_.cells, tolerance_, result_);
    return std::move(result_);
  }

 private:
  void report(double fraction) const { report_progress(progress_, "cut", fraction); }

  /// A point of a piece on an edge, at `t` along the edge's own direction.
  struct EdgePoint {
    EdgeId edge;
    double t;
    VertexId vertex;
  };

  double parameter(EdgeId e, FaceId f, const Bary& bary) const {
    const VertexId end = mesh_.to(mesh_.halfedge(e));
    return bary[std::ranges::find(mesh_.vertices(f), end) - mesh_.vertices(f).begin()];
  }

  void collect_edge_points() {
    for (const FacePiece& piece : diagram_.pieces) {
      for (const Bary& bary : piece.corners) {
        const SurfacePoint point = make_surface_point(piece.face, bary);
        if (point.kind() != SurfacePoint::Kind::edge) continue;
        const EdgeId e = mesh_.edge(halfedge(point));
        edge_points_.push_back({e, parameter(e, piece.face, point.bary), {}});
      }
    }
    std::sort(edge_points_.begin(), edge_points_.end(),
              [](const EdgePoint& a, const EdgePoint& b) { return std::tie(a.edge, a.t) < std::tie(b.edge, b.t); });
  }

  /// Gives each edge point a vertex: that of the point before it or an end of the edge if they coincide, or a new one.
  void number_edge_points() {
    const EdgePoint* before = nullptr;
    for (EdgePoint& point : edge_points_) {
      const HalfedgeId h = mesh_.halfedge(point.edge);
      const Vec3 at = (1 - point.t) * mesh_.position(mesh_.from(h)) + point.t * mesh_.position(mesh_.to(h));
      if (before && before->edge != point.edge) before = nullptr;
      if (coincide(at, mesh_.position(mesh_.from(h)), tolerance_)) {
        point.vertex = mesh_.from(h);
      } else if (coincide(at, mesh_.position(mesh_.to(h)), tolerance_)) {
        point.vertex = mesh_.to(h);
      } else if (before && (point.t - before->t <= kCutWeld ||
                            coincide(cut_.positions[before->vertex.index()], at, tolerance_))) {
        point.vertex = before->vertex;
      } else {
        point.vertex = add_vertex(at);
      }
      before = &point;
    }
  }

  VertexId add_vertex(const Vec3& at) {
    cut_.positions.push_back(at);
    return VertexId(cut_.positions.size() - 1);
  }

  std::span<const EdgePoint> points_on(EdgeId e) const {
    return {std::to_address(std::ranges::lower_bound(edge_points_, e, {}, &EdgePoint::edge)),
            std::to_address(std::ranges::upper_bound(edge_points_, e, {}, &EdgePoint::edge))};
  }

  /// The corners of f and the vertices on its edges, in order, each once.
  std::vector<FaceTiling::Corner> border_of(FaceId f) const {
    std::vector<FaceTiling::Corner> border;
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      const auto add = [&](double t, VertexId v) {
        const bool known = std::ranges::find(border, v, &FaceTiling::Corner::vertex) != border.end();
        if (!known && v != mesh_.to(h)) border.push_back({edge_point(h, t).bary, cut_.positions[v.index()], v});
      };
      add(0, mesh_.from(h));
      const auto points = points_on(mesh_.edge(h));
      const bool along = mesh_.halfedge(mesh_.edge(h)) == h;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const EdgePoint& point = along ? points[k] : points[points.size() - 1 - k];
        add(along ? point.t : 1 - point.t, point.vertex);
      }
    }
    return border;
  }

  FaceTiling::Corner corner_of(FaceId f, const Bary& bary) const {
    const SurfacePoint point = make_surface_point(f, bary);
    FaceTiling::Corner corner{point.bary, position(mesh_, point), {}};
    if (point.kind() == SurfacePoint::Kind::vertex) corner.vertex = vertex(mesh_, point);
    if (point.kind() == SurfacePoint::Kind::edge) {
      const EdgeId e = mesh_.edge(halfedge(point));
      const auto points = points_on(e);
      // collect_edge_points has added this corner.
      corner.vertex = std::ranges::lower_bound(points, parameter(e, f, point.bary), {}, &EdgePoint::t)->vertex;
    }
    return corner;
  }

  void cut_face(FaceId f, std::span<const FacePiece> pieces) {
    std::vector<FaceTiling::Corner> border = border_of(f);
    const auto shares = shares_.of(f);
    const GeneratorId whole = !shares.empty() ? shares.front().generator : diagram_.face_label[f];
    if (pieces.empty() && border.size() == 3) {
      cut_.triangles.push_back({mesh_.vertices(f), f, whole, polygons_++});
      return;
    }
    FaceTiling tiling(std::move(border), tolerance_);
    for (const FacePiece& piece : pieces) {
      FaceTiling::Polygon polygon{piece.generator, {}};
      for (const Bary& bary : piece.corners) polygon.corners.push_back(tiling.find_or_add(corner_of(f, bary)));
      tiling.add(std::move(polygon));
    }
    const bool fits = !pieces.empty() && tiling.fit();
    if (!fits) tiling.leave_whole(whole);
    if (!fits && !pieces.empty()) ++result_.uncut_faces;
    add_polygons(f, tiling);
  }

  void add_polygons(FaceId f, FaceTiling& tiling) {
    for (const FaceTiling::Polygon& polygon : tiling.polygons()) {
      std::vector<Vec2> plane_points;
      for (const std::size_t number : polygon.corners) {
        FaceTiling::Corner& corner = tiling.corners()[number];
        if (!corner.vertex.valid()) corner.vertex = add_vertex(corner.position);
        plane_points.push_back(tiling.plane_point(number));
      }
      const auto vertex = [&](std::size_t i) { return tiling.corners()[polygon.corners[i]].vertex; };
      for (const auto& [a, b, c] : triangulate_plane_polygon(plane_points)) {
        cut_.triangles.push_back({{vertex(a), vertex(b), vertex(c)}, f, polygon.generator, polygons_});
      }
      ++polygons_;
    }
  }

  void build_mesh() {
    std::vector<std::array<VertexId, 3>> faces;
    for (const CutTriangle& t : cut_.triangles) {
      faces.push_back(t.corners);
      result_.parent.push_back(t.parent);
      result_.label.push_back(t.label);
    }
    try {
      result_.mesh = Mesh(std::move(cut_.positions), std::move(faces));
    } catch (const Error& error) {
      throw Error(ErrorCode::no_valid_result,
                  std::string("cutting along the bisectors gives no manifold mesh: ") + error.what(), error.element());
    }
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  const Progress& progress_;
  FaceShares shares_;
  double tolerance_;
  std::vector<EdgePoint> edge_points_;  // sorted by edge and t
  CutTriangles cut_;
  std::int32_t polygons_ = 0;  // number of polygons so far
  CutMesh result_;
};

/// The parent of a face at v, one with the label of v where regions were separated: the vertex may lie on their border.
FaceId parent_at(const CutMesh& cut, VertexId v, GeneratorId label, bool is_separated) {
  FaceId face = Mesh::face(cut.mesh.halfedge(v));
  for_each_outgoing(cut.mesh, v, [&](HalfedgeId h) {
    if (is_separated && cut.label[face] != label) face = Mesh::face(h);
  });
  return cut.parent[face];
}

/// The smaller one of two labels of faces at a vertex; a label comes before none.
GeneratorId smaller_label(GeneratorId a, GeneratorId b) { return !a.valid() || (b.valid() && b < a) ? b : a; }

}  // namespace

CutMesh cut_faces(const Mesh& mesh, const Diagram& diagram, const Progress& progress) {
  check_belongs(mesh, diagram);
  return Cutter(mesh, diagram, progress).run();
}

CutVertices carry_to_cut_vertices(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut) {
  const std::int32_t given = cut.input_vertices, known = mesh.vertex_count();
  if (diagram.vertex_label.count() != known || diagram.vertex_distance.count() != known || known < given ||
      cut.mesh.vertex_count() < given) {
    throw Error(ErrorCode::precondition, "the diagram or the cut mesh was made of another mesh");
  }
  CutVertices result{diagram.vertex_label, diagram.vertex_distance};
  result.label.resize(given);
  result.distance.resize(given);
  result.label.resize(cut.mesh.vertex_count());
  result.distance.resize(cut.mesh.vertex_count(), kInfinity);
  for (const FaceId f : cut.mesh.faces()) {
    for (const VertexId v : cut.mesh.vertices(f)) {
      if (v.value() >= given) result.label[v] = smaller_label(result.label[v], cut.label[f]);
    }
  }
  // With weights, only their sums with the distances are continuous across bisectors.
  IdVector<VertexId, double> sums = diagram.vertex_distance;
  for (const VertexId v : sums.ids()) sums[v] += diagram.weight(diagram.vertex_label[v]);
  for (VertexId v(given); v.value() < cut.mesh.vertex_count(); v = VertexId(v.value() + 1)) {
    // A new vertex on the border of two regions has faces of both, whose distances differ.
    const FaceId parent = parent_at(cut, v, result.label[v], known > given);
    const SurfacePoint point = closest_point_on_face(mesh, parent, cut.mesh.position(v)).point;
    result.distance[v] = interpolate_at(mesh, sums, point) - diagram.weight(result.label[v]);
  }
  return result;
}

}  // namespace gvd
