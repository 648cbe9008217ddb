#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/mesh.hpp"

// Header only, so that libgvd itself does not link OpenMesh. A program that includes this header links OpenMeshCore.

namespace gvd {

/// Traits with double precision, so that a mesh comes back bit by bit.
struct OpenMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using OpenMeshTriMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits>;

/// Converts a mesh for OpenMesh's algorithms, as `to_openmesh` does, and returns the error.
template <class TriMesh = OpenMeshTriMesh>
OrError<TriMesh> try_to_openmesh(const Mesh& mesh) {
  using Point = typename TriMesh::Point;
  using Scalar = typename TriMesh::Scalar;
  TriMesh result;
  result.reserve(static_cast<std::size_t>(mesh.vertex_count()), static_cast<std::size_t>(mesh.edge_count()),
                 static_cast<std::size_t>(mesh.face_count()));
  for (const Vec3& p : mesh.positions()) {
    result.add_vertex(Point(static_cast<Scalar>(p.x()), static_cast<Scalar>(p.y()), static_cast<Scalar>(p.z())));
  }
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    const auto added = result.add_face(OpenMesh::VertexHandle(a.value()), OpenMesh::VertexHandle(b.value()),
                                       OpenMesh::VertexHandle(c.value()));
    if (!added.is_valid()) return Error(ErrorCode::precondition, "OpenMesh refuses a face of the mesh", f);
  }
  return result;
}

/// Converts a mesh for OpenMesh's algorithms. Vertices, faces and corners keep their order.
///
/// `TriMesh` is any triangle mesh of OpenMesh with points of three numbers. Coordinates are rounded if its numbers have
/// less precision than a double. Throws Error{precondition} if OpenMesh refuses a face, which happens for no valid
/// mesh. Cost: O(n).
template <class TriMesh = OpenMeshTriMesh>
TriMesh to_openmesh(const Mesh& mesh) {
  return value_or_throw(try_to_openmesh<TriMesh>(mesh));
}

/// Converts a triangle mesh of OpenMesh. Deleted elements and vertices without a face are left out; the remaining
/// elements keep their order. Throws what the constructor of Mesh throws. Cost: O(n).
template <class TriMesh>
Mesh from_openmesh(const TriMesh& source) {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  std::vector<VertexId> renamed(source.n_vertices());
  for (const auto v : source.vertices()) {  // the range skips deleted vertices
    const OpenMesh::VertexHandle handle = v;
    if (source.is_isolated(handle)) continue;
    renamed[handle.idx()] = VertexId(positions.size());
    const auto& p = source.point(handle);
    positions.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto f : source.faces()) {
    const OpenMesh::FaceHandle handle = f;
    std::array<VertexId, 3> corners;
    std::size_t i = 0;
    for (auto v = source.cfv_ccwbegin(handle); v != source.cfv_ccwend(handle) && i < 3; ++v) {
      corners[i++] = renamed[v->idx()];
    }
    faces.push_back(corners);
  }
  return Mesh(std::move(positions), std::move(faces));
}

}  // namespace gvd
