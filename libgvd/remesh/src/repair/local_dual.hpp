#pragma once

#include <optional>
#include <vector>

#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/submesh.hpp"

namespace gvd {

/// A flag for each cell of a diagram.
using CellFlags = IdVector<GeneratorId, char>;

/// The cells that are at most `rings` bisectors away from the given ones. Cost: O(cells).
CellFlags grow_rings(const Diagram& diagram, const std::vector<GeneratorId>& cells, int rings);

/// The faces of a mesh that meet some cells of a diagram, as a mesh of their own.
///
/// Faces of the part that meet only at a vertex, without a fan of faces between them, get a vertex each. No shortest
/// path that stays in the cells passes such a vertex: if a cell contained it, all faces around it would belong to the
/// part.
struct CellPart : Submesh {
  /// Per face, whether it meets other cells too, or an edge that is on the boundary of the part alone.
  IdVector<FaceId, char> is_fringe;
};

/// `in_part`: which cells. The diagram is one of the mesh. Cost: O(n).
CellPart cut_out_cells(const Mesh& mesh, const Diagram& diagram, const CellFlags& in_part);

/// The diagram and the dual near some cells of a diagram, after generators have been removed and added there. Only the
/// faces of these cells and of two rings of cells round them are computed again.
///
/// The result is right for the following reason. A shortest path from a generator stays in its cell. New generators
/// take area away from cells, and if a generator is removed, the cells around it share its area. The fringe of the part
/// consists of the faces in which other cells begin. As long as no new cell reaches it, all shortest paths to points of
/// the part's cells stay in the part. In the fringe, other generators may be nearer. A cell that meets no face of the
/// fringe is therefore the same in the diagram of the whole mesh. docs/developer/proofs.md has the proof.
class LocalDual {
 public:
  /// `removed` are the cells whose generators are removed; `cells` must contain them. Mesh and diagram must outlive
  /// this. Cost: O(n).
  LocalDual(const Mesh& mesh, const Diagram& diagram, const std::vector<GeneratorId>& cells,
            const std::vector<GeneratorId>& removed, const DiagramOptions& options);

  const CellPart& part() const { return part_; }

  struct Result {
    Diagram diagram;  ///< of the part; its first generators are those kept, in their order, then the added ones
    CellFlags inner;  ///< cells that are the same in the diagram of the whole mesh
    /// The defects of the dual whose cells are all inner. Flipped triangles follow where there are no others.
    std::vector<DualDefect> defects;
  };
  /// The part with these points of the whole mesh added. Nothing if the part can't tell, because a new cell reaches its
  /// fringe or a point lies outside; nothing either if a point coincides with another generator, or if a component of
  /// the mesh is left without a generator.
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
  CellPart part_;
  DiagramOptions options_;
  std::vector<GeneratorId> kept_;
};

}  // namespace gvd
