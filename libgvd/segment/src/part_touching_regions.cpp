// Separates regions of a cut mesh that touch themselves at a vertex.
//
// In a diagram no cell touches itself: the cells at a branch point are different, and so are the cells at a crossing.
// But two branch points that are closer than rounding, as where four cells nearly meet, become a single vertex of the
// cut mesh, and so can two bisectors that pass a vertex on both sides. The labels around that vertex are then a b a c,
// so the faces with label a are not a disc as a mesh, although their cell is. One of the two sectors of a gives its
// corner at the vertex, a tiny part of its faces, to a neighbour. A strip of a cell that is thinner than rounding may
// also have vanished at the vertex, so that the two sectors of a are no longer connected; then the sector between them
// gives its corner to a.
//
// A sector gives its corner only to a label that has a bisector with its own, so that no label crosses the border of a
// given region. It never gives it to a label that lies on both of its sides and is already connected, because that
// would close a ring.
// Invariant: open regions keep their topology or become connected, and each change reduces the number of sectors at its
// vertex.
#include "part_touching_regions.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/union_find.hpp"
#include "cut_triangles.hpp"
#include "gvd/segment.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// The part of an edge that a corner takes. A face loses about a millionth of its area, which is less than the chord
/// tolerance leaves undecided.
constexpr double kCornerShare = 0x1p-10;

/// The shortest side of a corner in tolerances of positions, so that its vertices stay distinct; at most half of an
/// edge.
constexpr double kCornerTolerances = 16;

/// Consecutive faces around a vertex with the same label, as the halfedges that leave the vertex, counter-clockwise.
struct Sector {
  GeneratorId label;
  std::vector<HalfedgeId> halfedges;
};

struct VertexSectors {
  std::vector<Sector> sectors;  ///< counter-clockwise
  bool closed = false;          ///< whether the last sector is beside the first
};

VertexSectors collect_sectors(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, VertexId v) {
  VertexSectors found{{}, !mesh.is_boundary(v)};
  std::vector<Sector>& sectors = found.sectors;
  for_each_outgoing(mesh, v, [&](HalfedgeId h) {
    const GeneratorId g = label[Mesh::face(h)];
    if (sectors.empty() || sectors.back().label != g) sectors.push_back({g, {}});
    sectors.back().halfedges.push_back(h);
  });
  if (found.closed && sectors.size() > 1 && sectors.front().label == sectors.back().label) {
    std::vector<HalfedgeId>& first = sectors.front().halfedges;
    first.insert(first.begin(), sectors.back().halfedges.begin(), sectors.back().halfedges.end());
    sectors.pop_back();
  }
  return found;
}

/// The vertices at which a label may have several sectors: labels change four times around them, or twice between
/// boundary and boundary.
std::vector<VertexId> find_candidates(const CutMesh& cut) {
  const Mesh& mesh = cut.mesh;
  IdVector<VertexId, std::int32_t> changes(mesh.vertex_count(), 0);
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.valid() || cut.label[Mesh::face(h)] == cut.label[Mesh::face(twin)]) continue;
    ++changes[mesh.from(h)];
    ++changes[mesh.to(h)];
  }
  std::vector<VertexId> found;
  for (const VertexId v : mesh.vertices()) {
    if (changes[v] >= (mesh.is_boundary(v) ? 2 : 4)) found.push_back(v);
  }
  return found;
}

/// A round of changes to different faces.
class CornerRound {
 public:
  CornerRound(const IdVector<GeneratorId, Cell>& cells, double tolerance, const CutMesh& cut)
      : cells_(cells),
        least_side_(kCornerTolerances * tolerance),
        cut_(cut),
        mesh_(cut.mesh),
        parts_(std::size_t(mesh_.face_count())),
        positions_(mesh_.positions()) {}

  /// Changes corners, and returns whether any corner changed its label.
  bool run(const std::vector<VertexId>& candidates) {
    for (const EdgeId e : mesh_.edges()) {
      const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
      if (!twin.valid() || cut_.label[Mesh::face(h)] != cut_.label[Mesh::face(twin)]) continue;
      parts_.unite(Mesh::face(h).value(), Mesh::face(twin).value());
    }
    for (const VertexId v : candidates) visit(v);
    return !edits_.empty();
  }

  /// Makes the mesh in which the changed corners are faces of their own.
  CutMesh make_mesh() && {
    CutMesh made;
    made.input_vertices = cut_.input_vertices;
    made.uncut_faces = cut_.uncut_faces;
    std::vector<std::array<VertexId, 3>> faces;
    for (const FaceId f : mesh_.faces()) {
      const auto edit = edits_.find(f);
      const std::vector<CutTriangle> triangles =
          edit == edits_.end() ? std::vector{CutTriangle{mesh_.vertices(f), f, cut_.label[f]}} : split(f, edit->second);
      for (const CutTriangle& t : triangles) {
        faces.push_back(t.corners);
        made.parent.push_back(cut_.parent[f]);
        made.label.push_back(t.label);
      }
    }
    made.mesh = Mesh(std::move(positions_), std::move(faces));
    return made;
  }

 private:
  /// The change of a face at one of its corners.
  struct Edit {
    HalfedgeId outgoing;          ///< the halfedge of the face that leaves the corner
    VertexId on_next, on_before;  ///< new vertices on the sides after and before the corner; invalid if there is none
    std::optional<GeneratorId> corner;  ///< the new label of the corner between the two
  };

  void visit(VertexId v) {
    const VertexSectors round = collect_sectors(mesh_, cut_.label, v);
    std::map<GeneratorId, int> count;
    for (const Sector& sector : round.sectors) ++count[sector.label];
    if (std::ranges::all_of(count, [](const auto& label) { return label.second == 1; })) return;
    // First connect regions, so that parts that are separated afterwards are connected elsewhere.
    for (const bool connects : {true, false}) {
      for (std::size_t i = 0; i < round.sectors.size(); ++i) {
        const std::optional<GeneratorId> taker =
            connects ? find_label_to_connect(round, i) : find_label_to_part(round, i, count[round.sectors[i].label]);
        if (!taker || !give_corner(v, round.sectors[i], *taker)) continue;
        --count[round.sectors[i].label];
        if (!connects) continue;
        --count[*taker];
        const auto [before, after] = neighbours(round, i);
        parts_.unite(part_of(*before), part_of(*after));
      }
    }
  }

  std::pair<const Sector*, const Sector*> neighbours(const VertexSectors& round, std::size_t i) const {
    const std::size_t n = round.sectors.size();
    const Sector* const before = i > 0 || round.closed ? &round.sectors[(i + n - 1) % n] : nullptr;
    const Sector* const after = i + 1 < n || round.closed ? &round.sectors[(i + 1) % n] : nullptr;
    return {before, after};
  }

  std::int32_t part_of(const Sector& sector) { return parts_.find(Mesh::face(sector.halfedges.front()).value()); }

  /// Whether the two cells have a common bisector.
  bool may_give(GeneratorId from, GeneratorId to) const {
    return from.valid() && to.valid() && std::ranges::binary_search(cells_[from].neighbours, to);
  }

  /// The label on both sides of a sector, if its faces there are not connected.
  std::optional<GeneratorId> find_label_to_connect(const VertexSectors& round, std::size_t i) {
    const auto [before, after] = neighbours(round, i);
    if (before == nullptr || after == nullptr || before == after || before->label != after->label) return std::nullopt;
    const bool connects = part_of(*before) != part_of(*after);
    return connects && may_give(round.sectors[i].label, after->label) ? std::optional(after->label) : std::nullopt;
  }

  /// A label to which sector i, one of `count` sectors with the same label, can give its corner; it must be on one side
  /// of the sector only.
  std::optional<GeneratorId> find_label_to_part(const VertexSectors& round, std::size_t i, int count) const {
    const auto [before, after] = neighbours(round, i);
    if (count < 2 || (before != nullptr && after != nullptr && before->label == after->label)) return std::nullopt;
    for (const Sector* side : {before, after}) {
      if (side != nullptr && may_give(round.sectors[i].label, side->label)) return side->label;
    }
    return std::nullopt;
  }

  /// Gives the corners of a sector's faces at v to a label. Returns false if another change of this round affects one
  /// of the faces, or if an edge is too short.
  bool give_corner(VertexId v, const Sector& sector, GeneratorId to) {
    std::map<FaceId, Edit> edits;
    std::map<EdgeId, VertexId> points;
    std::vector<Vec3> positions;
    for (const HalfedgeId h : sector.halfedges) {
      edits[Mesh::face(h)] = {h, {}, {}, to};
      for (const EdgeId e : {mesh_.edge(h), mesh_.edge(Mesh::previous(h))}) {
        if (points.contains(e)) continue;
        const std::optional<Vec3> at = corner_point(v, e);
        if (!at) return false;
        points[e] = VertexId(positions_.size() + positions.size());
        positions.push_back(*at);
      }
    }
    for (const auto& [e, point] : points) {
      for (const HalfedgeId h : {mesh_.halfedge(e), mesh_.twin(mesh_.halfedge(e))}) {
        if (!h.valid()) continue;
        const bool leaves = mesh_.from(h) == v;
        Edit& edit = edits[Mesh::face(h)];
        edit.outgoing = leaves ? h : Mesh::next(h);
        (leaves ? edit.on_next : edit.on_before) = point;
      }
    }
    if (std::ranges::any_of(edits, [&](const auto& edit) { return edits_.contains(edit.first); })) return false;
    edits_.merge(edits);
    positions_.insert(positions_.end(), positions.begin(), positions.end());
    return true;
  }

  /// A point on an edge near its end v.
  std::optional<Vec3> corner_point(VertexId v, EdgeId e) const {
    const HalfedgeId h = mesh_.halfedge(e);
    const Vec3& from = mesh_.position(v);
    const Vec3& to = mesh_.position(mesh_.from(h) == v ? mesh_.to(h) : mesh_.from(h));
    const double length = (to - from).norm();
    const double share = std::clamp(least_side_ / length, kCornerShare, 0.5);
    const Vec3 at = from + share * (to - from);
    return at == from || at == to ? std::nullopt : std::optional(at);
  }

  /// The triangles of a face with new vertices on its sides.
  std::vector<CutTriangle> split(FaceId f, const Edit& edit) const {
    const VertexId a = mesh_.from(edit.outgoing), b = mesh_.to(edit.outgoing),
                   c = mesh_.from(Mesh::previous(edit.outgoing));
    const VertexId p = edit.on_next, q = edit.on_before;
    const GeneratorId own = cut_.label[f];
    if (!q.valid()) return {{{a, p, c}, f, own}, {{p, b, c}, f, own}};
    if (!p.valid()) return {{{a, b, q}, f, own}, {{q, b, c}, f, own}};
    return {{{a, p, q}, f, edit.corner.value_or(own)}, {{p, b, c}, f, own}, {{p, c, q}, f, own}};
  }

  const IdVector<GeneratorId, Cell>& cells_;
  const double least_side_;
  const CutMesh& cut_;
  const Mesh& mesh_;
  UnionFind parts_;  // connected faces with one label
  std::map<FaceId, Edit> edits_;
  std::vector<Vec3> positions_;
};

}  // namespace

void part_touching_regions(const IdVector<GeneratorId, Cell>& cells, double tolerance, CutMesh& cut) {
  for (auto candidates = find_candidates(cut); !candidates.empty(); candidates = find_candidates(cut)) {
    CornerRound round(cells, tolerance, cut);
    if (!round.run(candidates)) return;
    CutMesh made = std::move(round).make_mesh();
    cut = std::move(made);
  }
}

}  // namespace gvd
