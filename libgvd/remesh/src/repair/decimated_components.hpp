#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/decimate_part.hpp"
#include "mesh/submesh.hpp"

namespace gvd {

/// A triangle of a decimated component, by vertices of the surface.
struct DecimatedFace {
  std::array<VertexId, 3> corners;
  /// The face of the surface from which this one was made. Each corner of that face is one of `corners`, or has
  /// collapsed to one of them.
  FaceId origin;

  /// The middle of its origin. It stands for the face on the surface, as a branch point does for a triangle of a dual.
  SurfacePoint point() const { return {origin, {1.0 / 3, 1.0 / 3, 1.0 / 3}}; }
};

/// Components of a surface that are remeshed by their own triangles, decimated, and not by the dual of a diagram.
///
/// If no generators are found whose dual is a proper mesh, the surface itself is one. Halfedges of it collapse as long
/// as topology and orientation stay the same, no face meets a face that it has not met before, and edges on curved
/// parts stay within two spacings. If the result meets faces of other components, fewer halfedges collapse, in the end
/// none.
///
/// Properties: (1) each vertex is one of the surface; (2) the faces of each component have its topology; (3) a face is
/// a triangle of the surface, or is not flipped (find_flipped_faces); (4) no more pairs of faces intersect than on the
/// surface; (5) deterministic.
class DecimatedComponents {
 public:
  /// The surface must outlive this. `spacing`: of the generators on the whole surface, mesh units. Cost: O(n).
  DecimatedComponents(const Mesh& surface, double spacing);

  std::int32_t count() const { return std::int32_t(parts_.size()); }
  bool has(std::int32_t component) const { return parts_.contains(component); }
  bool has(const SurfacePoint& point) const { return has(component_[point.face]); }
  /// The component of each face of the surface, as compute_face_components numbers them.
  const IdVector<FaceId, std::int32_t>& component() const { return component_; }

  /// Adds components, each for so many vertices, or as many more as the conditions above ask for. Nothing happens to
  /// them before `decimate`. Cost: O(n).
  void add(const std::map<std::int32_t, std::int64_t>& vertices_of_component);

  /// Lets fewer vertices of the surface collapse to the corners of a face: some that are far from it stay. The face is
  /// one of `remesh`; `corners` are its corners on the surface. Cost: O(k) for k such vertices.
  void refine(const Mesh& remesh, FaceId face, const std::array<VertexId, 3>& corners);

  /// Decimates the components that are new or have been refined. Throws Error{interrupted} if `progress` cancels. Cost:
  /// O(n log n) for the n faces of all these components, if the box of a face overlaps a bounded number of others.
  void decimate(const Progress& progress);

  /// The faces of all these components, by component.
  std::vector<DecimatedFace> faces() const;
  /// Their vertices, ascending.
  std::vector<VertexId> vertices() const;

 private:
  struct Part {
    std::int64_t vertices = 0;    // the number asked for
    std::vector<FaceId> surface;  // its faces there
    std::vector<DecimatedFace> faces;
    int refinements = 0;
    bool is_stale = true;  // new, or refined
  };

  /// Decimates one component. `own`: its faces.
  void decimate(const Submesh& own, CollapseGuard& guard, Part& part, const std::function<void(double)>& report);
  /// Stores the faces that are left, and which vertices have collapsed to which.
  void take(const Submesh& own, const PartDecimator& decimator, Part& part);

  const Mesh& surface_;
  double spacing_;  // of the generators
  IdVector<FaceId, std::int32_t> component_;
  std::map<std::int32_t, Part> parts_;
  IdVector<VertexId, char> is_kept_;
  IdVector<VertexId, std::vector<VertexId>> members_;  // that have collapsed to each vertex
};

}  // namespace gvd
