// Isotropic remeshing by CGAL, beside our own: two remeshers with the same target, so that a table does not depend on
// one of them.
//
// Source: Botsch and Kobbelt, A remeshing approach to multiresolution modeling, 2004, as CGAL's package
// Polygon_mesh_processing implements it. CGAL's package is under the GPL; builds without it have no such meshes.
#include "gvd/error.hpp"
#include "models.hpp"

#ifdef GVD_HAS_PEERS
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <utility>
#include <vector>

#endif

namespace gvd::paper {

#ifdef GVD_HAS_PEERS
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// Of splits, collapses, flips and a relaxation each: as many as `resample` makes.
constexpr unsigned kRounds = 6;

Surface build(const Mesh& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> handles;
  for (const Vec3& p : mesh.positions()) handles.push_back(surface.add_vertex({p.x(), p.y(), p.z()}));
  for (const auto& [a, b, c] : list_faces(mesh)) {
    surface.add_face(handles[a.index()], handles[b.index()], handles[c.index()]);
  }
  return surface;
}

Mesh extract(const Surface& surface) {
  std::vector<Vec3> positions;
  for (const auto v : surface.vertices()) {
    const Kernel::Point_3& p = surface.point(v);
    positions.emplace_back(p.x(), p.y(), p.z());
  }
  std::vector<Corners> faces;
  for (const auto f : surface.faces()) {
    std::size_t corner = 0;
    Corners& corners = faces.emplace_back();
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) corners[corner++] = VertexId(v.idx());
  }
  return Mesh(std::move(positions), std::move(faces));
}

}  // namespace

bool has_cgal_remeshing() { return true; }

Mesh remesh_with_cgal(const Mesh& mesh, int faces) {
  const MeshSummary summary = compute_mesh_summary(mesh);
  if (summary.boundary_loops > 0) throw Error(ErrorCode::precondition, "only closed meshes are remeshed");
  const Surface input = build(mesh);
  const auto remesh = [&](double edge_length) {
    namespace processing = CGAL::Polygon_mesh_processing;
    Surface surface = input;
    processing::isotropic_remeshing(surface.faces(), edge_length, surface,
                                    processing::parameters::number_of_iterations(kRounds));
    surface.collect_garbage();
    return extract(surface);
  };
  return search_edge_length(remesh, summary.area, faces);
}
#else
bool has_cgal_remeshing() { return false; }

Mesh remesh_with_cgal(const Mesh&, int) {
  throw Error(ErrorCode::precondition, "this build has no CGAL: configure with -DGVD_WITH_CGAL_GPL=ON");
}
#endif

}  // namespace gvd::paper
