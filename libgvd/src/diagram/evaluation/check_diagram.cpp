#include <algorithm>
#include <cmath>
#include <set>

#include "base/barycentric.hpp"
#include "gvd/check.hpp"

namespace gvd {
namespace {

/// Areas are sums of up to a million rounded terms: relative tolerance.
constexpr double kAreaTolerance = 1e-9;

/// What rounding a corner's coordinates may change the area of a triangle by, as a part of the largest coordinate times
/// the longest edge: a step or two for each corner. It is what remains of the area of thin faces far from the origin.
constexpr double kCornerRounding = 1e-15;

/// How far a generator may lie outside of its cell, as a part of the bounding box's diagonal: rounding, and a thousand
/// times the distance within which a generator is taken for a vertex.
constexpr double kPlaceTolerance = 1e-9;

class Checker {
 public:
  Checker(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {}

  DiagramCheck run() {
    check_ids();
    if (!check_.ok()) return std::move(check_);  // what follows looks these ids up
    find_reached_components();
    check_areas();
    check_vertex_labels();
    check_generators();
    check_bisectors();
    check_branch_points();
    check_cells();
    check_euler();
    check_neighbours();
    return std::move(check_);
  }

 private:
  void violate(const std::string& text) { check_.violations.push_back(text); }
  static std::string name(const char* what, std::size_t i) { return std::string(what) + " " + std::to_string(i); }

  template <class IdType>
  static bool below(IdType id, std::size_t size) {
    return id.valid() && id.index() < size;
  }
  bool is_cell(GeneratorId g) const { return below(g, diagram_.cells.size()); }
  bool is_cell_or_none(GeneratorId g) const { return !g.valid() || is_cell(g); }
  bool is_face(FaceId f) const { return below(f, static_cast<std::size_t>(mesh_.face_count())); }

  /// Whether arrays have the mesh's sizes and every id is one of the diagram or of the mesh.
  void check_ids() {
    const Diagram& d = diagram_;
    const auto all = [](const auto& items, auto good) { return std::all_of(items.begin(), items.end(), good); };
    bool cells_fit = d.cells.size() == d.generators.size();
    for (std::size_t i = 0; i < d.cells.size(); ++i) cells_fit = cells_fit && d.cells.raw()[i].generator.index() == i;
    if (!cells_fit || !all(d.generators, [&](const auto& p) { return is_face(p.face); })) {
      violate("(1) generators, cells and the mesh do not fit");
    }
    if (d.vertex_label.size() != static_cast<std::size_t>(mesh_.vertex_count()) ||
        d.vertex_distance.size() != d.vertex_label.size() ||
        d.face_label.size() != static_cast<std::size_t>(mesh_.face_count()) ||
        !all(d.vertex_label, [&](GeneratorId g) { return is_cell_or_none(g); }) ||
        !all(d.face_label, [&](GeneratorId g) { return is_cell_or_none(g); }) ||
        !all(d.pieces, [&](const FacePiece& p) { return is_face(p.face) && is_cell(p.generator); })) {
      violate("(2) labels or pieces do not fit the mesh and the cells");
    }
    for (std::size_t i = 0; i < d.bisectors.size(); ++i) {
      const Bisector& b = d.bisectors.raw()[i];
      if (!is_cell_or_none(b.left) || !is_cell_or_none(b.right) ||
          !all(b.points, [&](const SurfacePoint& p) { return is_face(p.face); })) {
        violate(name("(3) no such cell or face: bisector", i));
      }
      if (!all(b.ends, [&](BranchPointId e) { return !e.valid() || below(e, d.branch_points.size()); })) {
        violate(name("(4) no such branch point at an end of bisector", i));
      }
    }
  }

  void find_reached_components() {
    component_ = compute_face_components(mesh_);
    std::int32_t count = 0;
    for (const std::int32_t c : component_) count = std::max(count, c + 1);
    reached_.assign(static_cast<std::size_t>(count), 0);
    for (const SurfacePoint& g : diagram_.generators) reached_[static_cast<std::size_t>(component_[g.face])] = 1;
  }
  bool is_reached(FaceId f) const { return reached_[static_cast<std::size_t>(component_[f])] != 0; }

  void check_areas() {
    std::size_t piece = 0;
    double total = 0;
    IdVector<GeneratorId, double> owned(diagram_.cells.size(), 0.0);
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
      const FaceId f(i);
      double share = diagram_.face_label[f].valid() ? 1 : 0;
      const bool cut = piece < diagram_.pieces.size() && diagram_.pieces[piece].face == f;
      if (cut && share > 0) violate("(2) face " + std::to_string(i) + " has a label and pieces");
      if (share > 0) owned[diagram_.face_label[f]] += mesh_.area(f);
      for (; piece < diagram_.pieces.size() && diagram_.pieces[piece].face == f; ++piece) {
        const double part = area_share(diagram_.pieces[piece].corners);
        if (part < -kAreaTolerance) violate(name("(2) negative area in piece", piece));
        share += part;
        owned[diagram_.pieces[piece].generator] += part * mesh_.area(f);
      }
      const double expected = is_reached(f) ? 1 : 0;
      if (std::abs(share - expected) > kAreaTolerance) {
        violate("(2) pieces of face " + std::to_string(i) + " cover " + std::to_string(share) + " of it");
      }
      total += expected * mesh_.area(f);
    }
    const double tolerance = kAreaTolerance * total + area_rounding();
    for (const Cell& c : diagram_.cells) {
      if (std::abs(c.area - owned[c.generator]) <= tolerance) continue;
      violate(name("(2) its faces and pieces have another area than cell", c.generator.index()));
    }
    if (piece < diagram_.pieces.size()) violate(name("(2) pieces are not in the order of their faces: piece", piece));
  }

  /// Of all faces and pieces: these have corners of their own, generators and what parts them.
  double area_rounding() const {
    double edges = 0;
    const auto longest = [&](FaceId f) {
      const auto& length = mesh_.shape(f).length;
      return *std::max_element(length.begin(), length.end());
    };
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) edges += longest(FaceId(f));
    for (const FacePiece& piece : diagram_.pieces) edges += longest(piece.face);
    return kCornerRounding * mesh_.largest_coordinate() * edges;
  }

  void check_vertex_labels() {
    const auto check = [&](VertexId v, GeneratorId g) {
      if (diagram_.vertex_label[v] != g) violate(name("(2) another label than a face at it: vertex", v.index()));
    };
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
      const GeneratorId g = diagram_.face_label[FaceId(i)];
      if (!g.valid()) continue;
      for (const VertexId v : mesh_.vertices(FaceId(i))) check(v, g);
    }
    for (const FacePiece& piece : diagram_.pieces) {
      for (const Bary& corner : piece.corners) {
        for (std::size_t k = 0; k < 3; ++k) {
          // Exactly the vertex: a crossing may come as near as rounding.
          const bool at_vertex = corner[(k + 1) % 3] == 0 && corner[(k + 2) % 3] == 0;
          if (at_vertex) check(mesh_.vertices(piece.face)[k], piece.generator);
        }
      }
    }
  }

  /// A point of an edge belongs to the faces on both sides. In a face without area other points lie in the same place,
  /// and its cell may have got there by one of them, from the other side.
  bool is_in_cell(const SurfacePoint& p, GeneratorId g) const {
    if (p.kind() == SurfacePoint::Kind::vertex) return diagram_.vertex_label[vertex(mesh_, p)] == g;
    if (is_in_cell_within_face(p, g)) return true;
    if (p.kind() != SurfacePoint::Kind::edge) return false;
    const HalfedgeId h = halfedge(p), twin = mesh_.twin(h);
    return twin.valid() &&
           is_in_cell_within_face(edge_point(twin, p.bary[static_cast<std::size_t>(Mesh::corner(h))]), g);
  }

  bool is_in_cell_within_face(const SurfacePoint& p, GeneratorId g) const {
    if (diagram_.face_label[p.face].valid()) return diagram_.face_label[p.face] == g;
    const auto pieces = std::equal_range(diagram_.pieces.begin(), diagram_.pieces.end(), FacePiece{p.face, g, {}},
                                         [](const FacePiece& a, const FacePiece& b) { return a.face < b.face; });
    return std::any_of(pieces.first, pieces.second,
                       [&](const FacePiece& piece) { return piece.generator == g && contains(piece, p); });
  }

  /// Whether a piece contains a point of its face, its outline included.
  bool contains(const FacePiece& piece, const SurfacePoint& p) const {
    const Vec3 at = position(mesh_, p);
    bool inside = false;
    for (std::size_t i = 0, n = piece.corners.size(); i < n; ++i) {
      const Bary &a = piece.corners[i], &b = piece.corners[(i + 1) % n];
      const Vec3 from = position(mesh_, {piece.face, a}), along = position(mesh_, {piece.face, b}) - from;
      const double t = along.squaredNorm() > 0 ? std::clamp((at - from).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
      if ((from + t * along - at).norm() <= kPlaceTolerance * mesh_.bbox_diagonal()) return true;
      // The ray from p along the second coordinate crosses this side.
      if ((a[2] > p.bary[2]) == (b[2] > p.bary[2])) continue;
      const double where = a[1] + (b[1] - a[1]) * (p.bary[2] - a[2]) / (b[2] - a[2]);
      if (where > p.bary[1]) inside = !inside;
    }
    return inside;
  }

  void check_generators() {
    for (std::size_t i = 0; i < diagram_.generators.size(); ++i) {
      const SurfacePoint& p = diagram_.generators[i];
      const GeneratorId g(static_cast<std::int64_t>(i));
      if (!is_in_cell(p, g)) violate(name("(1) outside of its cell: generator", i));
      // A cell may have no area where the faces round its generator have none.
      if (!(diagram_.cells[g].area >= 0)) violate(name("(1) negative area: the cell of generator", i));
    }
  }

  bool share_face(const SurfacePoint& p, const SurfacePoint& q) const {
    const auto faces_p = faces_around(mesh_, p), faces_q = faces_around(mesh_, q);
    return std::find_first_of(faces_p.begin(), faces_p.end(), faces_q.begin(), faces_q.end()) != faces_p.end();
  }

  void check_bisectors() {
    for (std::size_t i = 0; i < diagram_.bisectors.size(); ++i) {
      const Bisector& b = diagram_.bisectors[BisectorId(static_cast<std::int64_t>(i))];
      const std::size_t n = b.points.size();
      if (n < 2 || !b.left.valid() || !b.right.valid() || b.left == b.right) {
        violate(name("(3) separates nothing: bisector", i));
        continue;
      }
      for (std::size_t k = 0; k + (b.closed ? 0 : 1) < n; ++k) {
        if (share_face(b.points[k], b.points[(k + 1) % n])) continue;
        violate(name("(3) leaves its faces: bisector", i) + " after point " + std::to_string(k));
        break;
      }
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const bool resolved =
            b.closed || b.ends[end].valid() || is_on_boundary(mesh_, end == 0 ? b.points.front() : b.points.back());
        if (!resolved) violate(name("(4) unresolved end of bisector", i));
      }
    }
  }

  void check_branch_points() {
    IdVector<BranchPointId, std::vector<GeneratorId>> cells(diagram_.branch_points.size());
    for (const Bisector& b : diagram_.bisectors) {
      if (b.ends[0].valid()) cells[b.ends[0]].push_back(b.right);
      if (b.ends[1].valid()) cells[b.ends[1]].push_back(b.left);
    }
    for (std::size_t i = 0; i < diagram_.branch_points.size(); ++i) {
      const BranchPointId id(static_cast<std::int64_t>(i));
      auto named = diagram_.branch_points[id].generators;
      if (cells[id].size() < 3) violate(name("(5) fewer than three ends at branch point", i));
      std::sort(named.begin(), named.end());
      std::sort(cells[id].begin(), cells[id].end());
      if (named != cells[id]) violate(name("(5) other generators than its bisectors at branch point", i));
    }
  }

  void check_cells() {
    for (const Cell& c : diagram_.cells) {
      const auto i = c.generator.index();
      if (c.components != 1) violate(name("(6) not connected: cell", i));
      const std::int32_t twice_genus = 2 * c.components - c.boundary_loops - c.euler_characteristic;
      if (twice_genus < 0 || twice_genus % 2 != 0) violate(name("(6) impossible Euler characteristic of cell", i));
    }
  }

  // As disjoint sets the insides of the cells, the bisectors without their ends (-1 each, 0 when closed), the branch
  // points
  // (+1) and the mesh's boundary make up the surface. The boundary's runs and the bisector ends on it cancel, loop by
  // loop, and the inside of a cell counts as much as the cell, for the loops round it count 0.
  void check_euler() {
    std::int64_t cells = 0, open = 0;
    for (const Cell& c : diagram_.cells) cells += c.euler_characteristic;
    for (const Bisector& b : diagram_.bisectors) open += b.closed ? 0 : 1;
    const auto branches = static_cast<std::int64_t>(diagram_.branch_points.size());
    const std::int64_t whole = reached_characteristic();
    if (cells - open + branches != whole) {
      violate("(7) Euler: cells " + std::to_string(cells) + " - bisectors " + std::to_string(open) +
              " + branch points " + std::to_string(branches) + " is not " + std::to_string(whole));
    }
  }

  std::int64_t reached_characteristic() const {
    std::int64_t faces = 0, edges = 0, vertices = 0;
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) faces += is_reached(FaceId(i));
    for (std::int32_t i = 0; i < mesh_.edge_count(); ++i) edges += is_reached(Mesh::face(mesh_.halfedge(EdgeId(i))));
    for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i)
      vertices += is_reached(Mesh::face(mesh_.halfedge(VertexId(i))));
    return vertices - edges + faces;
  }

  void check_neighbours() {
    std::set<std::pair<GeneratorId, GeneratorId>> pairs, listed;
    for (const Bisector& b : diagram_.bisectors) {
      pairs.emplace(b.left, b.right);
      pairs.emplace(b.right, b.left);
    }
    for (const Cell& c : diagram_.cells) {
      for (const GeneratorId g : c.neighbours) listed.emplace(c.generator, g);
    }
    if (pairs != listed) violate("(8) neighbours are not those with a bisector in common");
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  IdVector<FaceId, std::int32_t> component_;
  std::vector<char> reached_;
  DiagramCheck check_;
};

}  // namespace

DiagramCheck check_diagram(const Mesh& mesh, const Diagram& diagram) { return Checker(mesh, diagram).run(); }

}  // namespace gvd
