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

/// A box round the points that two triangles have in common, if they have any. Near parallel ones get the common part
/// of their boxes. Rounded: for distances, not for decisions whether triangles meet.
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

/// The pairs of faces of a remesh that intersect because the surface does, ascending. All other ones are defects.
///
/// Two triangles of the surface itself (is_surface_triangle) are an inherited pair: they intersect there, too. Another
/// pair is one if (1) cells of its corners intersect (find_inherited), (2) the two faces meet within the length of
/// their longest side from where two faces of the surface meet, and (3) this pair of the surface is not spoken for. So
/// there are never more than the surface has. But a face of the surface may be large: where two of them meet along more
/// than the spacing of the vertices, they count as often as triangles of that size would meet there. Two faces of
/// decimated components need no (1): each collapse was asked what its faces meet.
///
/// `pairs`: of find_self_intersections of the remesh; `given`: of the surface. Deterministic: small triangles choose
/// first. Throws Error{interrupted} if `progress` cancels. Cost: O(p log q) and that of find_intersecting_cells.
std::vector<FacePair> find_inherited_pairs(const RemeshFaces& faces, const std::vector<FacePair>& pairs,
                                           const std::vector<FacePair>& given, const Progress& progress = {});

}  // namespace gvd
