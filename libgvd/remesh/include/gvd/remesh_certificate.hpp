#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Two faces of a mesh, first < second.
struct FacePair {
  FaceId first, second;
  auto operator<=>(const FacePair&) const = default;
};

/// The properties of a remesh, measured on the returned mesh itself.
struct RemeshCertificate {
  MeshSummary input;
  MeshSummary output;
  bool manifold = false;         ///< OpenMesh accepts every face, and finds one fan round every vertex
  bool closed_as_input = false;  ///< no boundary where the input has none, and a boundary where it has one
  bool same_euler_characteristic = false;
  bool same_components = false;  ///< the same number, and each has exactly the generators of one input component
  bool same_boundary_loops = false;
  /// Euler characteristic and boundary loops agree for each component, not only in sum.
  bool same_in_each_component = false;
  std::int64_t flipped_faces = 0;      ///< see find_flipped_faces
  std::int64_t unused_generators = 0;  ///< generators that are a vertex of no face

  std::vector<FacePair> self_intersections;  ///< of the remesh: they have a common point outside of what they share
  /// How many of these pairs are inherited: the parts of the input under the two faces intersect each other. They are
  /// accepted.
  std::int64_t inherited_intersections = 0;
  bool intersections_allowed = false;  ///< whether all other pairs are accepted, too

  /// Whether all properties hold.
  bool ok() const;
  /// The first property that does not hold, as part of a sentence; empty if all hold.
  std::string first_failure() const;
};

/// Compares a remesh with its surface. Vertex i stands for generator i of the diagram, and `face_points` are the branch
/// points of the faces. Cells and bisectors of the diagram matter only if faces of the remesh intersect. The last
/// `decimated_faces` faces belong to decimated components (RemeshResult::decimated), for whose pairs fewer conditions
/// hold.
///
/// Properties: (1) every figure is measured on the returned mesh, and none is taken from the algorithm that made it;
/// (2) the result does not depend on `threads` (0: one for each core); (3) a property that fails never causes an
/// exception. Cost: O(n log n), and as much again for the pairs of the surface if the remesh intersects itself.
RemeshCertificate certify_remesh(const Mesh& surface, const Diagram& diagram, const Mesh& remesh,
                                 const std::vector<SurfacePoint>& face_points, int threads = 0,
                                 std::int64_t decimated_faces = 0);

}  // namespace gvd
