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
  IdVector<VertexId, VertexId> whole_vertex;  ///< the vertex of the whole mesh for each vertex
};

/// Makes triangles of some faces of a mesh, in the order of `faces`, which must be ascending.
///
/// Corners share a vertex only if a fan of these faces joins them. If two fans of the faces meet at a vertex of the
/// mesh, each fan gets a vertex of its own, because a shared vertex would not be manifold. Vertices are numbered in the
/// order in which the faces first use them. Cost: O(k log k) for k faces.
FanFaces number_fans(const Mesh& mesh, const std::vector<FaceId>& faces);

/// Some faces of a mesh as a mesh of their own. Faces keep their order of corners, so that a point keeps its
/// barycentric coordinates in both directions.
struct Submesh {
  Mesh mesh;
  IdVector<FaceId, FaceId> whole_face;        ///< the whole mesh's face for each face, ascending
  IdVector<VertexId, VertexId> whole_vertex;  ///< the whole mesh's vertex for each vertex

  /// The same point in the submesh; nothing if the submesh does not have its face. Cost: O(log k) for k faces.
  std::optional<SurfacePoint> to_part(const SurfacePoint& point) const;
  SurfacePoint to_whole(const SurfacePoint& point) const { return {whole_face[point.face], point.bary}; }
};

/// Makes the submesh of `faces`, which must be ascending, with the vertices of `number_fans`.
///
/// `order`: if given, a key for each vertex of the whole mesh, by which the submesh's vertices are sorted. Equal keys
/// are sorted by the whole mesh's vertices, then as in `number_fans`. Cost: O(k log k) for k faces, whatever the size
/// of the mesh.
Submesh make_submesh(const Mesh& mesh, std::vector<FaceId> faces, const IdVector<VertexId, VertexId>& order = {});

/// The numbers of vertices before and after some were removed.
struct KeptVertices {
  IdVector<VertexId, VertexId> before;  ///< for each remaining vertex, ascending
  IdVector<VertexId, VertexId> after;   ///< for each original vertex; invalid if it was removed
};

/// Removes the vertices that no triangle uses, and renumbers the triangles' corners. Cost: O(n).
KeptVertices drop_unused_vertices(std::size_t vertices, std::vector<std::array<VertexId, 3>>& faces);

}  // namespace gvd
