#pragma once

#include <cstdint>
#include <vector>

#include "dual/placed_faces.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/remesh_certificate.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A box around the points that two triangles have in common, if they have any. For nearly parallel triangles it is the
/// intersection of their boxes. It is rounded, so it serves for distances and not to decide whether triangles meet.
Box3 meeting_box(const Triangle& first, const Triangle& second);

/// A remesh and what its vertices and faces stand for. Refers to all of it.
struct RemeshFaces {
  const Mesh& surface;
  const Diagram& diagram;  ///< vertex i of the remesh stands for generator i
  const Mesh& remesh;
  const std::vector<SurfacePoint>& face_points;
  std::int64_t decimated_faces = 0;  ///< the last ones are those of decimated components

  bool is_decimated(FaceId f) const { return f.value() >= remesh.face_count() - decimated_faces; }
};

/// The pairs of faces of a remesh that intersect because the surface does, ascending. All other pairs are defects.
///
/// Two triangles of the surface itself (is_surface_triangle) are an inherited pair, because they intersect on the
/// surface as well. Any other pair is inherited if (1) cells of its corners intersect (find_inherited), (2) the two
/// faces meet within the length of their longest side from a place where two faces of the surface meet, and (3) that
/// pair of the surface has not been used for another pair. So there are never more inherited pairs than the surface
/// has. A large pair of the surface may be used several times: if the two faces meet along more than the spacing of the
/// vertices, as often as triangles of that size would meet there. Condition (1) is not needed for two faces of
/// decimated components, because each collapse was tested for what its faces meet.
///
/// `pairs` and `given` are the results of find_self_intersections for the remesh and for the surface. Deterministic:
/// small triangles choose first. Throws Error{interrupted} if `progress` cancels. Cost: O(p log q) and that of
/// find_intersecting_cells.
std::vector<FacePair> find_inherited_pairs(const RemeshFaces& faces, const std::vector<FacePair>& pairs,
                                           const std::vector<FacePair>& given, const Progress& progress = {});

}  // namespace gvd
