#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "repair/cell_topology.hpp"

// The steps of a repair: a list of new generators, the dual near some cells, new generators for defects, and the search
// for those that were added in vain.

namespace gvd {

// added_generators.cpp

/// Least distance between two generators that are near along the surface (`are_near`), as a fraction of the bounding
/// box's diagonal. Shorter edges can have length zero in programs that work in single precision (1.2e-7).
inline constexpr double kMinAddedSpacing = 1e-6;

/// Whether two points are near each other along the surface: one connected part of the surface within the Euclidean
/// distance `radius` of `a` holds both. Points on the two banks of a slit, or on two sheets that touch, are near in
/// space only. Where the radius is less than the surface's features, this agrees with the geodesic distance.
/// Cost: O(k log k) for k faces within the radius; O(1) where the points are farther apart than that in space.
bool are_near(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, double radius);

/// Generators to be added to a diagram: at most `max_count`, each with a least distance from all others.
class AddedGenerators {
 public:
  /// The mesh must outlive this. Cost: O(n).
  AddedGenerators(const Mesh& mesh, const std::vector<SurfacePoint>& existing, std::size_t max_count);

  std::size_t size() const { return points_.size(); }
  bool is_full() const { return points_.size() == max_count_; }
  std::size_t room() const { return max_count_ - points_.size(); }
  /// Empties the list, but not the set of points that others keep their distance from.
  std::vector<SurfacePoint> take() { return std::exchange(points_, {}); }

  /// Adds the point unless the list is full or a generator is too close (kMinAddedSpacing). Cost: that of `clearance`.
  bool add(const SurfacePoint& point) {
    if (is_full() || !(clearance(point) > spacing_)) return false;
    insert(point);
    points_.push_back(point);
    return true;
  }

  /// Adds the first point that `add` accepts, in descending order of value(point). False where it accepts none.
  template <class Value>
  bool add_best(const std::vector<SurfacePoint>& candidates, Value value) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < candidates.size(); ++i) order.emplace_back(-value(candidates[i]), i);
    std::sort(order.begin(), order.end());
    return std::any_of(order.begin(), order.end(), [&](const auto& entry) { return add(candidates[entry.second]); });
  }

  /// Euclidean distance from the nearest generator of the point's component, those added included; mesh units.
  /// Generators of other components don't count. Nor do those that coincide with the point in space and are not near it
  /// along the surface, as on the two banks of a slit. Infinite where no generator counts. Cost: O(k) for the k
  /// generators of the component.
  double clearance(const SurfacePoint& point) const;

  /// Position of a generator of the diagram.
  const Vec3& position_of(GeneratorId g) const { return positions_[g]; }

  /// Component of every face, as compute_face_components numbers them.
  const IdVector<FaceId, std::int32_t>& component() const { return component_; }

 private:
  void insert(const SurfacePoint& point) {
    of_component_[component_[point.face]].push_back(all_.push_back(point));
    positions_.push_back(position(mesh_, point));
  }

  const Mesh& mesh_;
  double spacing_;  // kMinAddedSpacing in mesh units
  std::size_t max_count_;
  IdVector<FaceId, std::int32_t> component_;
  std::vector<std::vector<GeneratorId>> of_component_;  // indices of all_, ascending; as many lists as faces
  IdVector<GeneratorId, SurfacePoint> all_;             // the diagram's generators, then the added ones
  IdVector<GeneratorId, Vec3> positions_;
  std::vector<SurfacePoint> points_;
};

/// The numbers of added generators and of defects, by round.
using RepairHistory = std::vector<std::pair<std::int64_t, std::size_t>>;

/// The number of generators that a repair is likely to have to add in all. Adding those of the rounds since the last
/// one with the most defects has removed some; the others are assumed to take as many each. It is at least what the
/// topology needs: three vertices for each component and boundary loop, four for each component of a closed surface.
/// Nothing where the defects get no fewer and the topology needs no more generators than there are. `generators`: how
/// many there are now. `history`: of one round at least.
std::optional<std::int64_t> estimate_added(const MeshSummary& mesh, std::size_t generators,
                                           const RepairHistory& history);

/// What became of the defects until a repair ended at a limit, and what helps: behind "N generators were added in M
/// rounds". That is more generators, or a higher `max_added` where that was the limit. But where as many were added as
/// the default allows, no estimate tells how many are needed, and the defects have grown by more than chance, added
/// ones make it worse. `generators` and `history` as in `estimate_added`; `usual`: the default of `max_added`.
std::string advise_at_limit(const MeshSummary& mesh, std::size_t generators, const RepairHistory& history,
                            bool is_max_added, std::int64_t usual);

/// The farthest vertices of the largest cells from their generators, at most `count`, one in each cell, for generators
/// that no defect asks for. Cost: O(n log n).
std::vector<SurfacePoint> propose_farthest(const Mesh& mesh, const Diagram& diagram, std::size_t count);

// local_dual.cpp

/// A flag for each cell of a diagram.
using CellFlags = IdVector<GeneratorId, char>;

/// The cells that are at most `rings` bisectors away from the given ones. Cost: O(cells).
CellFlags grow_rings(const Diagram& diagram, const std::vector<GeneratorId>& cells, int rings);

/// The faces of a mesh that meet some cells of a diagram, as a mesh of their own.
///
/// Faces that meet at a vertex only, without a fan of such faces between them, get a vertex each. No shortest path that
/// stays in the cells passes such a vertex. Why: if a cell holds a vertex, all faces round it belong to the part.
class MeshPart {
 public:
  /// `in_part`: which cells. The diagram is one of the mesh. Cost: O(n).
  MeshPart(const Mesh& mesh, const Diagram& diagram, const CellFlags& in_part) : part_face_(mesh.face_count()) {
    choose_faces(mesh, diagram, in_part);
    build(mesh);
  }

  const Mesh& mesh() const { return part_; }
  /// The number of its faces.
  std::size_t size() const { return whole_face_.size(); }

  /// Nothing for a point of a face outside of the part.
  std::optional<SurfacePoint> to_part(const SurfacePoint& point) const {
    const FaceId f = part_face_[point.face];
    return f.valid() ? std::optional(SurfacePoint{f, point.bary}) : std::nullopt;
  }
  SurfacePoint to_whole(const SurfacePoint& point) const { return {whole_face_[point.face], point.bary}; }

  /// Whether a face of the part meets other cells too, or an edge that is on the boundary of the part alone.
  bool is_fringe(FaceId of_part) const { return fringe_[of_part] != 0; }

 private:
  void choose_faces(const Mesh& mesh, const Diagram& diagram, const CellFlags& in_part);
  void build(const Mesh& mesh);
  void number_fan(const Mesh& mesh, HalfedgeId outgoing, VertexId v, std::vector<std::array<VertexId, 3>>& faces) const;

  Mesh part_;
  IdVector<FaceId, FaceId> whole_face_;  // of each face of the part
  IdVector<FaceId, FaceId> part_face_;   // of each face of the whole mesh; invalid outside of the part
  IdVector<FaceId, char> fringe_;        // of each face of the part
};

/// The diagram and the dual near some cells of a diagram, after generators have been removed and added there. Only the
/// faces of these cells and of two rings of cells round them are computed again.
///
/// Why it is right. A shortest path from a generator stays in its cell. New generators take area away from cells, and
/// the cells round a removed one share what was its own. The fringe of the part consists of the faces in which other
/// cells begin. As long as no new cell reaches it, all shortest paths to points of the part's cells stay in the part.
/// In the fringe, other generators may be nearer. A cell that meets no face of the fringe is the same in the diagram of
/// the whole mesh. docs/developer/proofs.md has the proof.
class LocalDual {
 public:
  /// `removed`: cells whose generators go, also to be listed in `cells`. Mesh and diagram must outlive this. Cost:
  /// O(n).
  LocalDual(const Mesh& mesh, const Diagram& diagram, const std::vector<GeneratorId>& cells,
            const std::vector<GeneratorId>& removed, const DiagramOptions& options);

  const MeshPart& part() const { return part_; }

  struct Result {
    Diagram diagram;  ///< of the part; its first generators are those kept, in their order, then the added ones
    CellFlags inner;  ///< cells that are the same in the diagram of the whole mesh
    /// The defects of the dual whose cells are all inner. Flipped triangles follow where there are no others.
    std::vector<DualDefect> defects;
  };
  /// The part with these points of the whole mesh added. Nothing where the part can't tell: a new cell reaches its
  /// fringe, or a point lies outside. Nothing too where a point coincides with another generator, or a component of the
  /// mesh is left without any.
  std::optional<Result> compute(const std::vector<SurfacePoint>& added) const;

  /// Generators of the whole diagram that are kept, in the order of the part's.
  const std::vector<GeneratorId>& kept() const { return kept_; }

 private:
  /// `stays`: the cells of the part.
  LocalDual(const Mesh& mesh, const Diagram& diagram, CellFlags stays, const std::vector<GeneratorId>& removed,
            const DiagramOptions& options);
  bool add_generators(const std::vector<SurfacePoint>& added, std::vector<SurfacePoint>& generators) const;
  CellFlags find_inner_cells(const Diagram& diagram) const;
  std::vector<DualDefect> find_defects(const Result& result) const;

  const Diagram& diagram_;
  MeshPart part_;
  DiagramOptions options_;
  std::vector<GeneratorId> kept_;
};

// propose_generators.cpp

/// The point of the bisector's polyline nearest to its middle, by arc length from the first
/// point; of a closed one, opposite to that. Cost: O(points).
SurfacePoint find_midpoint(const Mesh& mesh, const Bisector& bisector);

struct ProposedGenerators {
  std::vector<SurfacePoint> points;
  std::optional<NarrowTip> narrow;  ///< the first tip at which a defect can't be repaired
};

/// New generators that repair defects of the dual.
///
/// | property that fails | new generators                                                                            |
/// | ------------------- | ----------------------------------------------------------------------------------------- |
/// | component_reached   | the component's first vertex                                                              |
/// | cell_is_disc        | round a tip: two more points at the generator's distance from the tip (`TipRings`); else  |
/// |                     | thirds of the cell's shortest non-contractible loop, else as for enough_neighbours        |
/// | one_boundary_arc    | of each boundary arc of the cell the point nearest to the generator; of these the farthest |
/// | bisector_has_face   | closed: its point farthest from the two generators; open: the farther of its two ends     |
/// | one_bisector        | the midpoint of that bisector of the pair that is shortest relative to its distance       |
/// | one_branch_point    | of the branch points of the same cells the one that is farthest from its generators       |
/// | enough_neighbours   | the cell's farthest vertex, else the farthest point of its bisectors                      |
/// | the others          | of the branch point and its bisectors the point farthest from all generators              |
///
/// A candidate that is too close to a generator along the surface (kMinAddedSpacing) is skipped for the next best one.
/// One call repairs at most one defect of each cell, in the order of `defects`, because the repair often removes the
/// cell's other defects too. None at all where the surface round a tip is too narrow: others would not help.
/// Returns at most `max_count` points; none where every candidate is too close.
/// Throws Error{interrupted} if `progress`, which hears of each defect, cancels.
/// Cost: O(n log n), and for each defect that of the elements of its cells and of the generators of its component.
ProposedGenerators propose_generators(const Mesh& mesh, const Diagram& diagram, const std::vector<DualDefect>& defects,
                                      std::size_t max_count, const Progress& progress = {});

class DefectRepair;  // propose_generators.cpp

/// Lists points of which one may make discs of a cell as one more generator: opposite points (`find_opposite_points`),
/// a second point at the generator's distance from a tip or the opposite one of the shortest loop, then vertices, from
/// the farthest one to the generator. Too close ones are left out, as above.
class DiscCandidates {
 public:
  /// `count`: the most points of a cell. Mesh and diagram must outlive this. Cost: O(n).
  DiscCandidates(const Mesh& mesh, const Diagram& diagram, std::size_t count);
  DiscCandidates(const DiscCandidates&) = delete;
  DiscCandidates& operator=(const DiscCandidates&) = delete;
  ~DiscCandidates();

  /// The points of a cell that is no disc. Cost: O(n), cutting the mesh once, and two exact fields on the cell's faces
  /// for each opposite point.
  std::vector<SurfacePoint> list(GeneratorId cell);

 private:
  AddedGenerators added_;
  std::unique_ptr<DefectRepair> repair_;
};

struct NearbyGenerators {
  std::vector<SurfacePoint> points;
  std::int64_t events = 0;  ///< windows propagated (DiagramReport) to find them
};

/// Repairs what generators that are about to be added to a diagram leave wrong near them, or make wrong. Rounds of
/// `propose_generators` on a part of the mesh save rounds on all of it.
///
/// Returns more generators to add, at most `max_count`. None where the part is more than a quarter of the mesh, or
/// can't tell (LocalDual). Flipped triangles are not repaired: other repairs often remove them.
/// Cost: for each round a diagram of the part.
NearbyGenerators propose_nearby(const Mesh& mesh, const Diagram& diagram, const std::vector<SurfacePoint>& added,
                                std::size_t max_count, const DiagramOptions& options);

// fewer_generators.cpp

/// The ids of the first `points`, as many as a list holds, perhaps among others, in the same order. No two generators
/// coincide, so a point tells one also where ids have changed. Cost: O(n).
std::vector<GeneratorId> find_in_order(const std::vector<SurfacePoint>& points,
                                       const std::vector<SurfacePoint>& generators);

/// What a search among the generators of a right dual may do.
struct GeneratorSearch {
  std::size_t kept = 0;             ///< the first generators, which stay
  std::vector<SurfacePoint> fixed;  ///< of other generators that stay, too, in their order
  std::size_t least = 0;            ///< it ends with so many generators
  std::int64_t most_events = 0;     ///< windows propagated (DiagramReport) in all diagrams, after which the search ends
  DiagramOptions diagram;
  std::optional<DualProperty> only = {};  ///< the property that counts; nothing: all
  /// Whether the dual of these generators is right. If so, it has made the diagram of the search theirs.
  std::function<bool(const std::vector<SurfacePoint>&)> accept;
};

/// Looks for generators without which the dual has no defect either, among those that a repair has added. It tries to
/// leave one out, and to put a single one in the place of two that are near each other.
///
/// Candidates for the place of two are the points that would repair the defects that the two leave. In the cells with
/// these defects, branch points and some vertices are candidates, too. Afterwards no single added generator can be left
/// out, as far as parts of the mesh tell, unless the search has ended at its limit.
/// `diagram`: without defects. Returns false where the search ended at its limit. Deterministic.
bool search_fewer_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search);

/// Leaves out generators until `search.least` are left, where the surface is flattest for the distances between them.
///
/// `diagram`: without defects. Returns whether so many are left; without success they are as few as it came to.
/// Deterministic.
bool exchange_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search);

// repair_slivers.cpp

/// Faces with a Q below kSliverQ, ascending. Cost: O(n).
std::vector<FaceId> find_slivers(const Mesh& remesh);

/// Adds generators beside slivers, at most `max_count`, where that leaves fewer of them.
///
/// `remesh`: that of `diagram`, without defects. `accept(generators)`: whether their remesh is right and has fewer
/// slivers; if so, it has made `diagram` and `remesh` theirs. Deterministic. Cost: six remeshes at most.
void repair_slivers(const Mesh& mesh, const Diagram& diagram, const Mesh& remesh, std::size_t max_count,
                    const std::function<bool(const std::vector<SurfacePoint>&)>& accept);

}  // namespace gvd
