// Cuts the faces of a mesh along the bisectors of its diagram.
//
// The points of pieces on an edge are collected from both faces of the edge, sorted along it and numbered once, so that
// the two faces share vertices and no gap opens between them. Each face is then tiled by its pieces (FaceTiling), and
// the polygons are cut into triangles. A face whose pieces do not tile it stays whole, with the vertices on its edges.
// The triangles of a face are consecutive, in the order of the faces.
//
// Two repairs follow (cut_triangles.cpp), after which no edge has four faces and none has length 0. Finally, regions
// that touch themselves at a vertex are separated there (part_touching_regions.cpp).
#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <variant>

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

constexpr const char* kCutStep = "cut";

/// Faces between two calls of the progress callback.
constexpr std::int32_t kCutStride = 1 << 8;

/// A point of a piece on an edge, at `t` along the edge's own direction.
struct EdgePoint {
  EdgeId edge;
  double t;
  VertexId vertex;
};

double parameter_on(const Mesh& mesh, EdgeId e, FaceId f, const Bary& bary) {
  const VertexId end = mesh.to(mesh.halfedge(e));
  return bary[std::ranges::find(mesh.vertices(f), end) - mesh.vertices(f).begin()];
}

VertexId add_vertex(const Vec3& at, std::vector<Vec3>& positions) {
  positions.push_back(at);
  return VertexId(positions.size() - 1);
}

/// Collects the points of pieces on edges, sorted by edge and t. If a point coincides with the previous point or with
/// an end of the edge, it gets the same vertex, and otherwise a new one.
std::vector<EdgePoint> number_edge_points(const Mesh& mesh, const std::vector<FacePiece>& pieces, double tolerance,
                                          std::vector<Vec3>& positions) {
  std::vector<EdgePoint> points;
  for (const FacePiece& piece : pieces) {
    for (const Bary& bary : piece.corners) {
      const SurfacePoint point = make_surface_point(piece.face, bary);
      if (point.kind() != SurfacePoint::Kind::edge) continue;
      const EdgeId e = mesh.edge(halfedge(point));
      points.push_back({e, parameter_on(mesh, e, piece.face, point.bary), {}});
    }
  }
  std::sort(points.begin(), points.end(),
            [](const EdgePoint& a, const EdgePoint& b) { return std::tie(a.edge, a.t) < std::tie(b.edge, b.t); });
  const EdgePoint* before = nullptr;
  for (EdgePoint& point : points) {
    const HalfedgeId h = mesh.halfedge(point.edge);
    const Vec3 &from = mesh.position(mesh.from(h)), &to = mesh.position(mesh.to(h));
    const Vec3 at = (1 - point.t) * from + point.t * to;
    if (before && before->edge != point.edge) before = nullptr;
    if (coincide(at, from, tolerance)) {
      point.vertex = mesh.from(h);
    } else if (coincide(at, to, tolerance)) {
      point.vertex = mesh.to(h);
    } else if (before &&
               (point.t - before->t <= kCutWeld || coincide(positions[before->vertex.index()], at, tolerance))) {
      point.vertex = before->vertex;
    } else {
      point.vertex = add_vertex(at, positions);
    }
    before = &point;
  }
  return points;
}

std::span<const EdgePoint> points_on(const std::vector<EdgePoint>& sorted, EdgeId e) {
  return {std::to_address(std::ranges::lower_bound(sorted, e, {}, &EdgePoint::edge)),
          std::to_address(std::ranges::upper_bound(sorted, e, {}, &EdgePoint::edge))};
}

/// The border of f: its corners and the vertices on its edges, in order, each once.
std::vector<FaceTiling::Corner> border_of(const Mesh& mesh, FaceId f, const std::vector<EdgePoint>& edge_points,
                                          const std::vector<Vec3>& positions) {
  std::vector<FaceTiling::Corner> border;
  for (const HalfedgeId h : Mesh::halfedges(f)) {
    const auto add = [&](double t, VertexId v) {
      const bool known = std::ranges::find(border, v, &FaceTiling::Corner::vertex) != border.end();
      if (!known && v != mesh.to(h)) border.push_back({edge_point(h, t).bary, positions[v.index()], v});
    };
    add(0, mesh.from(h));
    const auto points = points_on(edge_points, mesh.edge(h));
    const bool along = mesh.halfedge(mesh.edge(h)) == h;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const EdgePoint& point = along ? points[k] : points[points.size() - 1 - k];
      add(along ? point.t : 1 - point.t, point.vertex);
    }
  }
  return border;
}

FaceTiling::Corner corner_of(const Mesh& mesh, FaceId f, const std::vector<EdgePoint>& edge_points, const Bary& bary) {
  const SurfacePoint point = make_surface_point(f, bary);
  FaceTiling::Corner corner{point.bary, position(mesh, point), {}};
  if (point.kind() == SurfacePoint::Kind::vertex) corner.vertex = vertex(mesh, point);
  if (point.kind() == SurfacePoint::Kind::edge) {
    const EdgeId e = mesh.edge(halfedge(point));
    const auto points = points_on(edge_points, e);
    // number_edge_points has added this corner.
    corner.vertex = std::ranges::lower_bound(points, parameter_on(mesh, e, f, point.bary), {}, &EdgePoint::t)->vertex;
  }
  return corner;
}

/// Cuts the polygons of face f into triangles. `polygons` counts the polygons of all faces so far.
void add_polygons(FaceId f, FaceTiling& tiling, std::int32_t& polygons, CutTriangles& cut) {
  for (const FaceTiling::Polygon& polygon : tiling.polygons()) {
    std::vector<Vec2> plane_points;
    for (const std::size_t number : polygon.corners) {
      FaceTiling::Corner& corner = tiling.corners()[number];
      if (!corner.vertex.valid()) corner.vertex = add_vertex(corner.position, cut.positions);
      plane_points.push_back(tiling.plane_point(number));
    }
    const auto vertex = [&](std::size_t i) { return tiling.corners()[polygon.corners[i]].vertex; };
    for (const auto& [a, b, c] : triangulate_plane_polygon(plane_points)) {
      cut.triangles.push_back({{vertex(a), vertex(b), vertex(c)}, f, polygon.generator, polygons});
    }
    ++polygons;
  }
}

/// Returns why the triangles are no manifold mesh, where they are none.
std::optional<Error> build_cut_mesh(CutTriangles cut, CutMesh& result) {
  std::vector<std::array<VertexId, 3>> faces;
  for (const CutTriangle& t : cut.triangles) {
    faces.push_back(t.corners);
    result.parent.push_back(t.parent);
    result.label.push_back(t.label);
  }
  auto built = Mesh::try_to_build(std::move(cut.positions), std::move(faces));
  if (const Error* const error = std::get_if<Error>(&built)) {
    return Error(ErrorCode::no_valid_result,
                 std::string("cutting along the bisectors gives no manifold mesh: ") + error->what(), error->element());
  }
  result.mesh = std::get<Mesh>(std::move(built));
  return std::nullopt;
}

/// The parent of a face at v. If regions were separated, the face has the label of v, because v may lie on the border
/// of two regions.
FaceId parent_at(const CutMesh& cut, VertexId v, GeneratorId label, bool is_separated) {
  FaceId face = Mesh::face(cut.mesh.halfedge(v));
  for_each_outgoing(cut.mesh, v, [&](HalfedgeId h) {
    if (is_separated && cut.label[face] != label) face = Mesh::face(h);
  });
  return cut.parent[face];
}

/// The smaller of two labels of faces at a vertex. A valid label comes before an invalid one.
GeneratorId smaller_label(GeneratorId a, GeneratorId b) { return !a.valid() || (b.valid() && b < a) ? b : a; }

}  // namespace

OrError<CutMesh> try_to_cut_faces(const Mesh& mesh, const Diagram& diagram, const Progress& progress) {
  check_belongs(mesh, diagram);
  const double tolerance = position_tolerance(mesh);
  const FaceShares shares(diagram);
  CutMesh result;
  result.input_vertices = mesh.vertex_count();
  CutTriangles cut{mesh.positions(), {}};
  const std::vector<EdgePoint> edge_points = number_edge_points(mesh, diagram.pieces, tolerance, cut.positions);
  std::int32_t polygons = 0;
  auto piece = diagram.pieces.begin();
  for (const FaceId f : mesh.faces()) {
    if (f.value() % kCutStride == 0) report_progress(progress, kCutStep, double(f.value()) / mesh.face_count());
    const auto first = piece;
    while (piece != diagram.pieces.end() && piece->face == f) ++piece;
    std::vector<FaceTiling::Corner> border = border_of(mesh, f, edge_points, cut.positions);
    const auto of_face = shares.of(f);
    const GeneratorId whole = !of_face.empty() ? of_face.front().generator : diagram.face_label[f];
    if (first == piece && border.size() == 3) {
      cut.triangles.push_back({mesh.vertices(f), f, whole, polygons++});
      continue;
    }
    FaceTiling tiling(std::move(border), tolerance);
    for (const FacePiece& own : std::span(std::to_address(first), std::to_address(piece))) {
      FaceTiling::Polygon polygon{own.generator, {}};
      for (const Bary& bary : own.corners) {
        polygon.corners.push_back(tiling.find_or_add(corner_of(mesh, f, edge_points, bary)));
      }
      tiling.add(std::move(polygon));
    }
    const bool fits = first != piece && tiling.fit();
    if (!fits) tiling.leave_whole(whole);
    if (!fits && first != piece) ++result.uncut_faces;
    add_polygons(f, tiling, polygons, cut);
  }
  if (piece != diagram.pieces.end()) {
    throw Error(ErrorCode::precondition, "the diagram's pieces are not sorted by face", piece->face.value());
  }
  report_progress(progress, kCutStep, 1);
  split_doubled_edges(cut);
  separate_coincident_corners(cut, mesh.positions().size(), tolerance);
  report_progress(progress, kCutStep, 1);
  if (auto error = build_cut_mesh(std::move(cut), result)) return *std::move(error);
  part_touching_regions(diagram.cells, tolerance, result);
  return result;
}

CutMesh cut_faces(const Mesh& mesh, const Diagram& diagram, const Progress& progress) {
  return value_or_throw(try_to_cut_faces(mesh, diagram, progress));
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
  // With weights, only the sums of distance and weight are continuous across bisectors.
  IdVector<VertexId, double> sums = diagram.vertex_distance;
  for (const VertexId v : sums.ids()) sums[v] += diagram.weight(diagram.vertex_label[v]);
  for (VertexId v(given); v.value() < cut.mesh.vertex_count(); v = VertexId(v.value() + 1)) {
    // A new vertex on the border of two regions has faces in both, whose distances differ.
    const FaceId parent = parent_at(cut, v, result.label[v], known > given);
    const SurfacePoint point = closest_point_on_face(mesh, parent, cut.mesh.position(v)).point;
    result.distance[v] = interpolate_at(mesh, sums, point) - diagram.weight(result.label[v]);
  }
  return result;
}

}  // namespace gvd
