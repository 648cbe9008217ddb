#pragma once

#include <array>
#include <string>
#include <vector>

#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"

namespace gvd::test {

inline constexpr std::array<Front, 2> kFronts{Front::circle, Front::planar};

/// Computes a diagram and requires that it passes its check.
inline Diagram compute_sound(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const DiagramOptions& options) {
  Diagram diagram = compute_diagram(mesh, generators, options);
  const DiagramCheck check = check_diagram(mesh, diagram);
  for (const std::string& violation : check.violations) UNSCOPED_INFO(violation);
  REQUIRE(check.ok());
  REQUIRE(diagram.report.unresolved_ends == 0);
  return diagram;
}

/// The same by the paper's method.
inline Diagram compute_sound(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             Front front = Front::circle) {
  DiagramOptions options;
  options.method = Method::gbgvd;
  options.front = front;
  return compute_sound(mesh, generators, options);
}

}  // namespace gvd::test
