#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Points of a surface on its remesh, and of the remesh on the surface.
struct RemeshMap {
  IdVector<VertexId, SurfacePoint> points;   ///< per vertex of the surface: its point of the remesh
  IdVector<VertexId, SurfacePoint> origins;  ///< per vertex of the remesh: its point of the surface
  bool one_to_one = false;                   ///< whether both come from a map that was checked to be one-to-one
  std::string obstacle;                      ///< why it is not one-to-one, as part of a sentence
  std::int64_t kept_faces = 0;               ///< faces of the surface whose image is oriented as the remesh there is
  std::int64_t reversed_faces = 0;           ///< faces whose image is turned over, as map_to_remesh says
  std::int64_t collapsed_faces = 0;          ///< faces whose image has no area
  double largest_move = 0;                   ///< distance of a vertex of the surface from its point, mesh units
  double mean_move = 0;                      ///< the mean of these distances, mesh units
};

/// Maps every vertex of the surface to a point of its remesh, and every vertex of the remesh to a point of the surface.
///
/// The surface is cut into the cells of the remesh's diagram. A convex combination map flattens each cell onto its
/// vertex's part of the dual, which is bounded by points near the branch points and by the points where bisectors cross
/// edges. Flips of edges are then followed as if the two faces were the halves of a square. A vertex of the remesh
/// comes from the nearest point of its cell or, if that point is near the cell's border, from its generator.
/// docs/developer/proofs.md proves that this map is one-to-one under two conditions, which are checked: the cells are
/// discs and join as the triangles of the dual do, and no triangle is turned over or loses its area in the plane.
/// `points` are values of the map, and `origins` values of its inverse, up to rounding.
///
/// If a check fails, `one_to_one` is false. Then a vertex goes to the nearest point of the triangles at its cell's
/// vertex and at the neighbours of that vertex, and a boundary vertex to the nearest of their boundary edges. Triangles
/// that face away from the surface are used only if there are no others. Several vertices may have the same point, and
/// a vertex of the remesh comes from its generator.
///
/// For the counts, the image of a face is the triangle of its corners' points. It is turned over if its normal is 90
/// degrees or more away from the sum of the remesh's normals at these points. A one-to-one map may bend a face that
/// much, but it reverses no part of it.
///
/// Properties: (1) every vertex has a point; (2) if two limbs or two sheets are close in space, the point is on the
/// right one; (3) a boundary vertex goes to the boundary, and a boundary vertex of the remesh comes from there; (4) if
/// a vertex of the remesh is at its generator, and the generator is at a vertex of the surface, then each of the two
/// vertices is the point of the other; (5) deterministic, for any number of `threads` (0: one for each core).
/// Throws Error{precondition} if `result` is not a remesh of `surface`, and Error{interrupted} if `progress` cancels.
/// Cost: O(n log n), and a sparse system for each cell.
RemeshMap map_to_remesh(const Mesh& surface, const RemeshResult& result, int threads = 0,
                        const Progress& progress = {});

/// Writes `gvd-remesh-map/1`: for each vertex of the output its point of the input, and for each vertex of the input
/// file its point of the output, or null if the vertex was dropped. docs/schema/README.md describes the format. The
/// stream is flushed and checked. Throws Error{unwritable_output}. Cost: O(n).
void write_map_json(std::ostream& out, const CheckedMesh& input, const RemeshMap& map);

}  // namespace gvd
