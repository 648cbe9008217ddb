#include <algorithm>
#include <span>
#include <string>
#include <tuple>

#include "base/ear_clipping.hpp"
#include "face_shares.hpp"
#include "face_tiling.hpp"
#include "gvd/error.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"
#include "separate_coincident_corners.hpp"
#include "split_doubled_edges.hpp"

namespace gvd {
namespace {

class Cutter {
 public:
  Cutter(const Mesh& mesh, const Diagram& diagram)
      : mesh_(mesh), diagram_(diagram), shares_(diagram), tolerance_(position_tolerance(mesh)) {
    triangles_.positions = mesh.positions();
  }

  CutMesh run() {
    collect_edge_points();
    number_edge_points();
    auto piece = diagram_.pieces.begin();
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
      const FaceId f(i);
      const auto first = piece;
      while (piece != diagram_.pieces.end() && piece->face == f) ++piece;
      cut_face(f, {first, piece});
    }
    if (piece != diagram_.pieces.end()) {
      throw Error(ErrorCode::precondition, "the diagram's pieces are not sorted by face", piece->face.value());
    }
    build_mesh();
    return std::move(result_);
  }

 private:
  /// A point of a piece on an edge, at `t` along the edge's own direction.
  struct EdgePoint {
    EdgeId edge;
    double t;
    VertexId vertex;
  };

  double parameter(EdgeId e, FaceId f, const std::array<double, 3>& bary) const {
    const VertexId end = mesh_.to(mesh_.halfedge(e));
    const auto& corners = mesh_.vertices(f);
    return bary[std::find(corners.begin(), corners.end(), end) - corners.begin()];
  }

  void collect_edge_points() {
    for (const FacePiece& piece : diagram_.pieces) {
      for (const auto& bary : piece.corners) {
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
    for (std::size_t i = 0; i < edge_points_.size(); ++i) {
      EdgePoint& point = edge_points_[i];
      const HalfedgeId h = mesh_.halfedge(point.edge);
      const Vec3 at = (1 - point.t) * mesh_.position(mesh_.from(h)) + point.t * mesh_.position(mesh_.to(h));
      const EdgePoint* const before = i > 0 && edge_points_[i - 1].edge == point.edge ? &edge_points_[i - 1] : nullptr;
      if (coincide(at, mesh_.position(mesh_.from(h)), tolerance_)) {
        point.vertex = mesh_.from(h);
      } else if (coincide(at, mesh_.position(mesh_.to(h)), tolerance_)) {
        point.vertex = mesh_.to(h);
      } else if (before && (point.t - before->t <= kCutWeld ||
                            coincide(triangles_.positions[before->vertex.index()], at, tolerance_))) {
        point.vertex = before->vertex;
      } else {
        point.vertex = add_vertex(at);
      }
    }
  }

  VertexId add_vertex(const Vec3& at) {
    triangles_.positions.push_back(at);
    return VertexId(static_cast<std::int64_t>(triangles_.positions.size()) - 1);
  }

  std::span<const EdgePoint> points_on(EdgeId e) const {
    const auto [first, last] = std::equal_range(edge_points_.begin(), edge_points_.end(), EdgePoint{e, 0, {}},
                                                [](const EdgePoint& a, const EdgePoint& b) { return a.edge < b.edge; });
    return {first, last};
  }

  /// The corners of f and the vertices on its edges, in order, each once.
  std::vector<FaceTiling::Corner> border_of(FaceId f) const {
    std::vector<FaceTiling::Corner> border;
    for (int i = 0; i < 3; ++i) {
      const HalfedgeId h = Mesh::halfedge(f, i);
      const auto add = [&](double t, VertexId v) {
        const bool known = std::any_of(border.begin(), border.end(), [v](const auto& c) { return c.vertex == v; });
        if (!known && v != mesh_.to(h)) border.push_back({edge_point(h, t).bary, triangles_.positions[v.index()], v});
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

  FaceTiling::Corner corner_of(FaceId f, const std::array<double, 3>& bary) const {
    const SurfacePoint point = make_surface_point(f, bary);
    FaceTiling::Corner corner{point.bary, position(mesh_, point), {}};
    if (point.kind() == SurfacePoint::Kind::vertex) corner.vertex = vertex(mesh_, point);
    if (point.kind() == SurfacePoint::Kind::edge) {
      const EdgeId e = mesh_.edge(halfedge(point));
      const double t = parameter(e, f, point.bary);
      const auto points = points_on(e);
      const auto found = std::lower_bound(points.begin(), points.end(), t,
                                          [](const EdgePoint& p, double value) { return p.t < value; });
      corner.vertex = found->vertex;  // collect_edge_points has added this corner
    }
    return corner;
  }

  void cut_face(FaceId f, std::span<const FacePiece> pieces) {
    std::vector<FaceTiling::Corner> border = border_of(f);
    const auto shares = shares_.of(f);
    const GeneratorId whole = !shares.empty() ? shares.front().generator : diagram_.face_label[f];
    if (pieces.empty() && border.size() == 3) {
      add_triangle(mesh_.vertices(f), f, whole);
      ++polygons_;
      return;
    }
    FaceTiling tiling(std::move(border), tolerance_);
    for (const FacePiece& piece : pieces) {
      FaceTiling::Polygon polygon{piece.generator, {}};
      for (const auto& bary : piece.corners) polygon.corners.push_back(tiling.find_or_add(corner_of(f, bary)));
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
      for (const auto& triangle : triangulate_plane_polygon(plane_points)) {
        std::array<VertexId, 3> vertices;
        for (std::size_t i = 0; i < 3; ++i) vertices[i] = tiling.corners()[polygon.corners[triangle[i]]].vertex;
        add_triangle(vertices, f, polygon.generator);
      }
      ++polygons_;
    }
  }

  void add_triangle(const std::array<VertexId, 3>& vertices, FaceId parent, GeneratorId label) {
    triangles_.faces.push_back(vertices);
    triangles_.parent.push_back(parent);
    triangles_.label.push_back(label);
    triangles_.polygon.push_back(polygons_);
  }

  void build_mesh() {
    split_doubled_edges(triangles_);
    separate_coincident_corners(triangles_, static_cast<std::size_t>(mesh_.vertex_count()), tolerance_);
    result_.parent = std::move(triangles_.parent);
    result_.label = std::move(triangles_.label);
    try {
      result_.mesh = Mesh(std::move(triangles_.positions), std::move(triangles_.faces));
    } catch (const Error& error) {
      throw Error(ErrorCode::no_valid_result,
                  std::string("cutting along the bisectors gives no manifold mesh: ") + error.what(), error.element());
    }
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  FaceShares shares_;
  double tolerance_;
  std::vector<EdgePoint> edge_points_;  ///< sorted by edge and t
  CutTriangles triangles_;
  std::int32_t polygons_ = 0;  ///< number of polygons so far
  CutMesh result_;
};

}  // namespace

CutMesh cut_faces(const Mesh& mesh, const Diagram& diagram) {
  check_belongs(mesh, diagram);
  return Cutter(mesh, diagram).run();
}

}  // namespace gvd
