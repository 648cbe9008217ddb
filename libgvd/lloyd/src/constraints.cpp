// Where generators may go: anywhere, along a crease, or nowhere.
#include "constraints.hpp"

#include <fmt/format.h>

#include <iterator>

#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd {

void GeneratorConstraints::check(const std::vector<SurfacePoint>& generators) const {
  if (freedom_.empty()) return;
  if (freedom_.size() != generators.size()) {
    throw Error(ErrorCode::precondition,
                fmt::format("{} given for {}", counted(std::ssize(freedom_), "freedom is", "freedoms are"),
                            counted(std::ssize(generators), "generator", "generators")));
  }
  for (int i = 0; i < std::ssize(generators); ++i) {
    if (freedom_[i] != Freedom::on_crease || network_->contains(generators[i])) continue;
    throw Error(ErrorCode::precondition, fmt::format("generator {} has to stay on a crease and lies on none", i), i);
  }
}

Vec2 GeneratorConstraints::project(const Mesh& mesh, std::size_t generator, const SurfacePoint& point,
                                   const Vec2& tangent) const {
  if (of(generator) == Freedom::on_crease) return network_->project(point, tangent);
  return is_free(generator) ? project_to_surface(mesh, point, tangent) : Vec2(0, 0);
}

GeodesicTrace GeneratorConstraints::move(const Mesh& mesh, std::size_t generator, const SurfacePoint& point,
                                         const Vec2& step) const {
  if (of(generator) == Freedom::on_crease) return network_->follow(point, network_->project(point, step));
  return trace_geodesic(mesh, point, is_free(generator) ? step : Vec2(0, 0));
}

}  // namespace gvd
