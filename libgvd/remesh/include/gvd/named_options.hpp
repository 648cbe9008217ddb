#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gvd/balance.hpp"
#include "gvd/density.hpp"
#include "gvd/features.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/names.hpp"
#include "gvd/placement.hpp"
#include "gvd/relaxation_start.hpp"
#include "gvd/remesh_surface.hpp"

// The options of relaxations and remeshes by the names that they have in Python and JavaScript.
//
// `Given` holds those that were given, in the language's own way: has(name); read(name, value) and read(name, value,
// choices), which keep the value where nothing was given; is_text(name), points(name), sampling(name), numbers(name).
namespace gvd {

/// A number for each vertex, or else for each face, above 0.
inline Density make_density(const Mesh& mesh, const std::vector<double>& values) {
  return std::ssize(values) == mesh.vertex_count() ? make_vertex_density(mesh, values)
                                                   : make_face_density(mesh, values);
}

/// What both commands take: generators, constraints, weight and copy.
template <class Given>
void read_start(const Given& given, const Mesh& mesh, RelaxationStartOptions& start) {
  if (given.has("generators")) start.listed = given.points("generators");
  if (given.has("sampler")) start.sampling = given.sampling("sampler");
  if (given.has("fixed")) start.constraints.fixed = given.points("fixed");
  given.read("keep_boundary", start.constraints.keep_boundary);
  if (given.has("features")) {
    bool& prefers = start.constraints.prefers_creases;
    start.constraints.crease_angle.reset();
    prefers = false;
    if (given.is_text("features")) {
      given.read("features", prefers, Choices<bool>{{"auto", true}, {"none", false}});
    } else {
      given.read("features", start.constraints.crease_angle);
    }
    if (prefers) start.constraints.crease_angle = kUsualCreaseAngle;
  }
  given.read("weighs_curvature", start.weighs_curvature);
  if (given.has("density")) start.density = make_density(mesh, given.numbers("density"));
  given.read("gradation", start.gradation);
  given.read("coarse", start.copy.faces);
}

template <class Given>
LloydOptions make_lloyd_options(const Given& given) {
  LloydOptions options;
  given.read("accelerate", options.acceleration, kAccelerationNames);
  given.read("relocate", options.relocate);
  given.read("iterations", options.max_iterations);
  given.read("tolerance", options.energy_tolerance);
  given.read("move_tolerance", options.move_tolerance);
  given.read("step", options.step);
  return options;
}

template <class Given>
SurfaceRemeshOptions make_remesh_options(const Given& given, const Mesh& mesh, const DiagramOptions& diagram) {
  SurfaceRemeshOptions options;
  read_start(given, mesh, options.start);
  options.start.threads = diagram.threads;
  given.read("prefers_boundary", options.start.constraints.prefers_boundary);
  given.read("relax", options.relaxation);
  given.read("place", options.placement, kPlacementNames);
  given.read("shape", options.remesh.placement.shape);
  given.read("exact_count", options.exact_count);
  given.read("max_added", options.remesh.max_added);
  given.read("refine", options.remesh.refine);
  given.read("allow_intersections", options.remesh.allow_intersections);
  options.remesh.diagram = diagram;
  return options;
}

template <class Given>
BalanceOptions make_balance_options(const Given& given, const Mesh& mesh, const DiagramOptions& diagram) {
  BalanceOptions options;
  options.diagram = diagram;
  if (given.has("shares")) options.shares = given.numbers("shares");
  if (given.has("weights")) options.diagram.weights = given.numbers("weights");
  if (given.has("density")) options.density = make_density(mesh, given.numbers("density"));
  return options;
}

}  // namespace gvd
