#include "list_comparators.hpp"

#include "library_methods.hpp"
#include "rvd/lrvd.hpp"
#include "rvd/rvd.hpp"
#include "windows/window_voronoi.hpp"

namespace gvd::paper {
namespace {

using Points = std::vector<SurfacePoint>;

Comparator library_method(const std::string& name, const Method& method, Front front = Front::circle) {
  DiagramOptions options;
  options.method = method;
  options.front = front;
  return {name, [options](const Mesh& mesh, const Points& generators) {
            return run_library_method(mesh, generators, options);
          }};
}

Comparator window_voronoi(const std::string& name, bool unpruned) {
  return {name, [unpruned](const Mesh& mesh, const Points& generators) {
            return compute_window_voronoi(mesh, generators, {unpruned});
          }};
}

}  // namespace

std::vector<Comparator> list_comparators(const ComparatorOptions& options) {
  std::vector<Comparator> all{library_method("exact", Method::exact), library_method("gbgvd circle", Method::gbgvd),
                              library_method("gbgvd planar", Method::gbgvd, Front::planar),
                              library_method("paper's steps", Method::paper, Front::planar),
                              window_voronoi("windows [27]", false)};
  if (options.unpruned_windows) all.push_back(window_voronoi("unpruned [27]", true));
  all.push_back({"diffusion [8]", [diffusion = options.diffusion](const Mesh& mesh, const Points& generators) {
                   return compute_diffusion(mesh, generators, diffusion);
                 }});
  all.push_back({"RVD [29]", compute_rvd});
  all.push_back(
      {"LRVD [28]", [](const Mesh& mesh, const Points& generators) { return compute_lrvd(mesh, generators); }});
  return all;
}

}  // namespace gvd::paper
