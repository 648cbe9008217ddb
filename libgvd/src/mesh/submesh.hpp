#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

// Some of the faces of a mesh as a mesh of their own.

namespace gvd {

/// Triangles with vertices of their own.
struct FanFaces {
  std::vector<std::array<VertexId, 3>> faces;
  IdVector<VertexId, VertexId> whole_vertex;  ///< the vertex of the whole mesh where each vertex is
};

/// The triangles of some faces of a mesh, in the order of `faces`, which ascend.
///
/// Corners have a vertex in common where a fan of these faces joins them: a vertex at which two fans meet would be no
/// manifold. Vertices are numbered in the order in which the faces come to them. Cost: O(k log k) for k faces.
FanFaces number_fans(const Mesh& mesh, const std::vector<FaceId>& faces);

/// Some faces of a mesh as a mesh of their own. Faces keep their corners, so a point goes there and back by its face.
struct Submesh {
  Mesh mesh;
  IdVector<FaceId, FaceId> whole_face;        ///< of each face, ascending
  IdVector<VertexId, VertexId> whole_vertex;  ///< of each vertex

  /// Nothing for a point of a face that the submesh does not have. Cost: O(log k) for k faces.
  std::optional<SurfacePoint> to_part(const SurfacePoint& point) const;
  SurfacePoint to_whole(const SurfacePoint& point) const { return {whole_face[point.face], point.bary}; }
};

/// The submesh of `faces`, which ascend, with the vertices of `number_fans`.
///
/// `order`: one for each vertex of the whole mesh. With it, vertices ascend by their orders; those of equal ones by the
/// whole mesh's vertices, then as `number_fans` has them. Cost: O(k log k) for k faces, whatever the size of the mesh.
Submesh make_submesh(const Mesh& mesh, std::vector<FaceId> faces, const IdVector<VertexId, VertexId>& order = {});

/// The numbers of vertices before and after some were left out.
struct KeptVertices {
  IdVector<VertexId, VertexId> before;  ///< of each vertex that is left, ascending
  IdVector<VertexId, VertexId> after;   ///< of each vertex that there was; invalid where it was left out
};

/// Leaves out the vertices in none of the triangles, and gives the triangles the new numbers. Cost: O(n).
KeptVertices drop_unused_vertices(std::size_t vertices, std::vector<std::array<VertexId, 3>>& faces);

}  // namespace gvd
