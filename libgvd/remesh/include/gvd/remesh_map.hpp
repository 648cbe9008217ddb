#pragma once

#include <cstdint>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Where the surface is on its remesh. The way back needs no map: vertex i of the remesh comes from generator i.
struct RemeshMap {
  IdVector<VertexId, SurfacePoint> points;  ///< per vertex of the surface: its point of the remesh
  std::int64_t kept_faces = 0;              ///< faces of the surface whose image is oriented as the remesh there is
  std::int64_t reversed_faces = 0;          ///< those whose image is turned round
  std::int64_t collapsed_faces = 0;         ///< those whose image has no area
  double largest_move = 0;                  ///< distance of a vertex from its image, mesh units
};

/// Maps every vertex of the surface to a point of its remesh.
///
/// A vertex in the cell of generator g goes to the nearest point of the triangles at vertex g and its neighbours.
/// Triangles whose normal is more than 90 degrees from the surface's there count only if there are no others. A vertex
/// on the boundary goes to the nearest point of their boundary edges instead if there are any. A vertex at which
/// generator g is goes to vertex g.
///
/// Properties: (1) every vertex has a point; (2) of two limbs, or two sheets, that are close in space, it is on the
/// right one: its triangle has a corner in the cell or in a neighbour of it; (3) a boundary vertex goes to the
/// boundary; (4) vertex i of the remesh and generator i are each other's points where the generator is at a vertex; (5)
/// deterministic, for every number of threads. Several vertices may have the same point, and the image of a face may be
/// reversed or without area: the counts say how many. Where all faces are kept and the vertices are dense, the map is
/// one-to-one up to the chords of the faces.
/// Throws Error{precondition} if `result` is no remesh of `surface`. Cost: O(n) for vertices of bounded valence.
RemeshMap map_to_remesh(const Mesh& surface, const RemeshResult& result, int threads = 0);

}  // namespace gvd
