// CGAL's geodesic distances and its remesher, to compare with. Only in builds with CGAL's GPL-licensed packages.
//
// Xin and Wang's exact paths (Surface_mesh_shortest_path) and the heat method (Crane, Weischedel, Wardetzky 2013) give
// distances at the vertices, without labels or bisectors: their times are lower bounds of what a diagram by them would
// cost. Each method has the kernel that CGAL's manual recommends. The conversion of the mesh is not timed.
// The remesher is that of Botsch and Kobbelt (A remeshing approach to multiresolution modeling, 2004), as CGAL's
// package Polygon_mesh_processing implements it. It has the target of our own, so that no table depends on one of them.
#include "peers.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <array>
#include <utility>
#include <vector>

#include "clocks.hpp"
#include "gvd/error.hpp"

namespace gvd::bench {
namespace {

template <class Kernel>
using Surface = CGAL::Surface_mesh<typename Kernel::Point_3>;

template <class Kernel>
typename Surface<Kernel>::Vertex_index vertex_of(VertexId v) {
  return typename Surface<Kernel>::Vertex_index(static_cast<typename Surface<Kernel>::size_type>(v.value()));
}

template <class Kernel>
Surface<Kernel> build_surface(const Mesh& mesh) {
  Surface<Kernel> surface;
  for (const Vec3& p : mesh.positions()) surface.add_vertex({p.x(), p.y(), p.z()});
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
    if (surface.add_face(vertex_of<Kernel>(a), vertex_of<Kernel>(b), vertex_of<Kernel>(c)) ==
        Surface<Kernel>::null_face()) {
      throw Error(ErrorCode::no_valid_result, "CGAL refuses the surface");
    }
  }
  return surface;
}

/// Keeps the compiler from leaving out what computes `value`.
void keep(double value) {
  static volatile double kept;
  kept = value;
  (void)kept;
}

double time_shortest_paths(const Mesh& mesh, const std::vector<VertexId>& generators) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Paths = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Surface<Kernel>>>;
  const Surface<Kernel> surface = build_surface<Kernel>(mesh);
  return cpu_milliseconds([&] {
    Paths paths(surface);
    for (const VertexId v : generators) paths.add_source_point(vertex_of<Kernel>(v));
    paths.build_sequence_tree();
    double sum = 0;
    for (const auto v : surface.vertices()) sum += paths.shortest_distance_to_source_points(v).first;
    keep(sum);
  });
}

void time_heat(const Mesh& mesh, const std::vector<VertexId>& generators, PeerTimes& times) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Heat = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Surface<Kernel>>;
  Surface<Kernel> surface = build_surface<Kernel>(mesh);
  auto distance = surface.add_property_map<Surface<Kernel>::Vertex_index, double>("v:distance", 0).first;
  const double start = cpu_milliseconds();
  Heat heat(surface);
  for (const VertexId v : generators) heat.add_source(vertex_of<Kernel>(v));
  heat.estimate_geodesic_distances(distance);
  const double solved = cpu_milliseconds();
  // Sources set anew: it solves once for each set.
  heat.clear_sources();
  for (const VertexId v : generators) heat.add_source(vertex_of<Kernel>(v));
  heat.estimate_geodesic_distances(distance);
  times.heat = solved - start;
  times.heat_again = cpu_milliseconds() - solved;
}

}  // namespace

PeerTimes time_peers(const Mesh& mesh, const std::vector<VertexId>& generators) {
  PeerTimes times;
  times.shortest_paths = time_shortest_paths(mesh, generators);
  time_heat(mesh, generators, times);
  return times;
}

std::vector<std::vector<double>> compute_heat_distances(const Mesh& mesh, const std::vector<VertexId>& generators) {
  using Kernel = CGAL::Simple_cartesian<double>;
  Surface<Kernel> surface = build_surface<Kernel>(mesh);
  auto distance = surface.add_property_map<Surface<Kernel>::Vertex_index, double>("v:distance", 0).first;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Surface<Kernel>> heat(surface);
  std::vector<std::vector<double>> distances;
  for (const VertexId generator : generators) {
    heat.clear_sources();
    heat.add_source(vertex_of<Kernel>(generator));
    heat.estimate_geodesic_distances(distance);
    std::vector<double>& row = distances.emplace_back();
    for (const auto v : surface.vertices()) row.push_back(distance[v]);
  }
  return distances;
}

Mesh remesh_isotropically(const Mesh& mesh, double edge_length, unsigned rounds) {
  namespace processing = CGAL::Polygon_mesh_processing;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  Surface<Kernel> surface = build_surface<Kernel>(mesh);
  processing::isotropic_remeshing(surface.faces(), edge_length, surface,
                                  processing::parameters::number_of_iterations(rounds));
  surface.collect_garbage();
  std::vector<Vec3> positions;
  for (const auto v : surface.vertices()) {
    positions.emplace_back(surface.point(v).x(), surface.point(v).y(), surface.point(v).z());
  }
  std::vector<std::array<VertexId, 3>> faces;
  for (const auto f : surface.faces()) {
    auto corner = faces.emplace_back().begin();
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) *corner++ = VertexId(v.idx());
  }
  return Mesh(std::move(positions), std::move(faces));
}

}  // namespace gvd::bench
