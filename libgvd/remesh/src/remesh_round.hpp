#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/placement.hpp"
#include "gvd/remesh.hpp"
#include "gvd/surface_point.hpp"
#include "repair/decimated_components.hpp"

namespace gvd {

/// The mesh that the generators of a diagram give, and the defects in the way.
struct RemeshRound {
  DualMesh dual;  ///< without decimated components
  Mesh mesh;      ///< none where the dual has defects; the faces of decimated components follow those of the dual
  std::vector<SurfacePoint> face_points;
  std::vector<EdgeFlip> flips;          ///< the flips of edges that turn the dual into the mesh
  std::vector<DualDefect> defects;      ///< of the dual
  std::string obstacle;                 ///< why a dual without defects is not a manifold mesh; usually empty
  std::vector<FaceId> decimated_wrong;  ///< faces of decimated components that intersect others
};

/// Makes the rounds of a remesh from diagrams.
class RoundMaker {
 public:
  /// `fixed` are the points of generators whose vertices stay, in their order. `decimated` is set once there are such
  /// components. All must outlive this.
  RoundMaker(const Mesh& mesh, const RemeshOptions& options, const std::vector<SurfacePoint>& fixed,
             const std::optional<DecimatedComponents>& decimated)
      : mesh_(mesh), options_(options), fixed_(fixed), decimated_(decimated) {}

  /// The round of a diagram, with the vertices at the generators, and with the defects of the dual and the flipped
  /// triangles. `number` counts rounds from 1.
  RemeshRound build(const Diagram& diagram, std::int32_t number) const;

  /// Moves the vertices of a round without defects as the options say; its defects are then triangles that intersect.
  void place(const Diagram& diagram, RemeshRound& round);

 private:
  /// Triangles with an edge of length 0. Generators on the two sides of a slit can have the same position although they
  /// are far apart on the surface.
  std::vector<DualDefect> find_coincident_corners(const Diagram& diagram, const DualMesh& dual) const;
  /// The generators on curves that edges follow.
  std::vector<GeneratorId> list_on_curves(const Diagram& diagram) const;
  /// Removes decimated components from the dual.
  void leave_out_decimated(const Diagram& diagram, RemeshRound& round) const;
  /// Adds vertices of decimated components to `fixed` that stay where the input has them: those of a face that is
  /// folded as the input's are, turned against the surface or intersecting another, and tips, because a needle has no
  /// area by which a fit would hold its end.
  void hold_folds_and_tips(const Diagram& diagram, const RemeshRound& round, std::vector<GeneratorId>& fixed) const;
  /// Places the vertices of a round; where those of a decimated component are farther from the surface than before,
  /// they stay as well. Its triangles were chosen by their distance, and thin sheets or sharp edges are lost in a fit.
  PlacedRemesh place_freely(const Diagram& diagram, const RemeshRound& round, PlacementOptions options) const;
  /// The vertices of decimated components that a placement has taken away from the surface.
  std::vector<GeneratorId> list_farther(const Diagram& diagram, const RemeshRound& round,
                                        const PlacedRemesh& placed) const;
  void append_decimated(const Diagram& diagram, std::vector<std::array<VertexId, 3>>& faces,
                        std::vector<SurfacePoint>& face_points) const;
  void build_mesh(const Diagram& diagram, RemeshRound& round) const;
  /// The pairs of faces of the placed mesh that intersect, without the inherited ones. The latter are found on the
  /// placed mesh, too, because its vertices may have left intersections that there were at the generators.
  std::vector<FacePair> find_intersections(const Diagram& diagram, const RemeshRound& round);

  const Mesh& mesh_;
  const RemeshOptions& options_;
  const std::vector<SurfacePoint>& fixed_;
  const std::optional<DecimatedComponents>& decimated_;
  std::optional<std::vector<FacePair>> of_input_;  // intersections of the input with itself, once they are needed
};

}  // namespace gvd
