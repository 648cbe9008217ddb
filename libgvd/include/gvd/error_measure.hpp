#pragma once

#include <functional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Distances wanted from one generator: one single-source run answers them all.
struct DistanceQuery {
  SurfacePoint generator;
  std::vector<SurfacePoint> points;
};

/// Exact geodesic distances, in mesh units: for each query one distance for each of its points, infinity where no
/// path leads. gvd::verify has one (`compute_exact_distances`); any other exact solver serves as well.
using ExactDistances = std::function<std::vector<std::vector<double>>(const std::vector<DistanceQuery>&)>;

struct ErrorMeasureOptions {
  /// Equal parts that every segment of a bisector is divided into, each one with a quadrature of its own; 1 or more.
  int panels = 1;
};

/// How far a diagram's bisectors are from where the two distances agree (section 5.2 of the paper).
struct ErrorMeasure {
  double error_integral = 0;  ///< E: the integral of |d_left - d_right| along the bisectors, square mesh units
  double error_mean = 0;      ///< error_integral / length, mesh units; 0 where there is no bisector
  double error_max = 0;       ///< largest |d_left - d_right| among the samples, mesh units
  double length = 0;          ///< of the bisectors that were integrated, mesh units
};

/// The error measure E: the sum over the bisectors of the integral of |d_left(p) - d_right(p)| dp, where d_left and
/// d_right are the exact geodesic distances from p to the bisector's two generators.
///
/// Source:  section 5.2 of the paper
/// Quadrature: every panel is sampled at the four Gauss-Lobatto points, its two ends among them. Where the samples
/// keep their sign the rule is exact to degree 5. Where the sign changes, |.| has a kink: the cubic through the four
/// samples is cut at its roots and integrated piece by piece, so the kink costs nothing. Where the distance itself has
/// a kink (its path changes sides of a vertex) the error falls with the square of the panels.
/// Properties: (1) 0 for bisectors on which the two distances agree; (2) a bisector between a cell and itself is left
/// out of all four figures, for its two distances are one; (3) infinite, and never NaN, where a sample can't be reached
/// from both of its generators; (4) `exact` is called once, with one query for each generator that owns a bisector,
/// ascending.
/// Throws Error{invalid_option} for panels < 1, Error{precondition} where the diagram does not fit the mesh (element:
/// the bisector) or `exact` returns another number of distances than was asked, and whatever `exact` throws.
/// Cost: 3 x panels samples a segment, each one in two queries; memory linear in them.
ErrorMeasure compute_error_measure(const Mesh& mesh, const Diagram& diagram, const ExactDistances& exact,
                                   const ErrorMeasureOptions& options = {});

}  // namespace gvd
