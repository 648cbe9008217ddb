#include "rvd/delaunay_neighbours.hpp"

#include <algorithm>

#ifdef GVD_HAS_PEERS
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <utility>
#endif

namespace gvd::paper {

#ifdef GVD_HAS_PEERS
std::vector<std::vector<GeneratorId>> find_delaunay_neighbours(const std::vector<Vec3>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<GeneratorId, Kernel>;
  using Structure = CGAL::Triangulation_data_structure_3<VertexBase>;
  using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
  std::vector<std::pair<Kernel::Point_3, GeneratorId>> sites;
  for (const Vec3& p : points) sites.push_back({{p.x(), p.y(), p.z()}, GeneratorId(static_cast<int>(sites.size()))});
  const Delaunay delaunay(sites.begin(), sites.end());
  std::vector<std::vector<GeneratorId>> neighbours(points.size());
  for (auto v = delaunay.finite_vertices_begin(); v != delaunay.finite_vertices_end(); ++v) {
    std::vector<Delaunay::Vertex_handle> around;
    delaunay.finite_adjacent_vertices(v, std::back_inserter(around));
    for (const Delaunay::Vertex_handle& other : around) neighbours[v->info().index()].push_back(other->info());
  }
  for (auto& list : neighbours) std::sort(list.begin(), list.end());
  return neighbours;
}
#else
std::vector<std::vector<GeneratorId>> find_delaunay_neighbours(const std::vector<Vec3>& points) {
  std::vector<std::vector<GeneratorId>> neighbours(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j != i) neighbours[i].push_back(GeneratorId(static_cast<int>(j)));
    }
  }
  return neighbours;
}
#endif

}  // namespace gvd::paper
