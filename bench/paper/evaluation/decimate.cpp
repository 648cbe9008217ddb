#include "decimate.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <utility>
#include <vector>

#include "list_faces.hpp"

namespace gvd::paper {
namespace {

struct Traits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Traits>;

constexpr double kMostTurn = 60;  // degrees

Surface build(const Mesh& mesh) {
  Surface surface;
  std::vector<Surface::VertexHandle> handles;
  for (const Vec3& p : mesh.positions()) handles.push_back(surface.add_vertex({p.x(), p.y(), p.z()}));
  for (const auto& [a, b, c] : list_faces(mesh)) {
    surface.add_face(handles[a.index()], handles[b.index()], handles[c.index()]);
  }
  surface.update_face_normals();
  return surface;
}

Mesh extract(const Surface& surface) {
  std::vector<Vec3> positions;
  for (const auto v : surface.vertices()) {
    const Surface::Point& p = surface.point(v);
    positions.emplace_back(p[0], p[1], p[2]);
  }
  std::vector<Corners> faces;
  for (const auto f : surface.faces()) {
    std::size_t corner = 0;
    Corners& corners = faces.emplace_back();
    for (const auto v : f.vertices()) corners[corner++] = VertexId(v.idx());
  }
  return Mesh(std::move(positions), std::move(faces));
}

}  // namespace

Mesh decimate(const Mesh& mesh, int faces) {
  using Decimater = OpenMesh::Decimater::DecimaterT<Surface>;
  Surface surface = build(mesh);
  Decimater decimater(surface);
  OpenMesh::Decimater::ModQuadricT<Surface>::Handle error;
  decimater.add(error);
  decimater.module(error).unset_max_err();
  OpenMesh::Decimater::ModNormalFlippingT<Surface>::Handle turn;
  decimater.add(turn);
  decimater.module(turn).set_max_normal_deviation(kMostTurn);
  decimater.initialize();
  decimater.decimate_to_faces(0, static_cast<std::size_t>(faces));
  surface.garbage_collection();
  return extract(surface);
}

}  // namespace gvd::paper
