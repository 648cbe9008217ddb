#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Asks for the distances from one generator to several points, which one run of a single-source solver answers.
struct DistanceQuery {
  SurfacePoint generator;
  std::vector<SurfacePoint> points;
};

/// A function that computes exact geodesic distances, in mesh units: for each query one distance per point, infinity if
/// there is no path. `compute_exact_distances` of gvd::verify is such a function; any other exact solver can be used.
using ExactDistances = std::function<std::vector<std::vector<double>>(const std::vector<DistanceQuery>&)>;

struct ErrorMeasureOptions {
  /// Number of equal parts of every segment of a bisector, each with a quadrature of its own; 1 or more.
  int panels = 1;
};

/// The difference of the two distances along the bisectors of a diagram (section 5.2 of the paper).
struct ErrorMeasure {
  double error_integral = 0;   ///< E: the integral of |d_left - d_right| along the bisectors, square mesh units
  double error_mean = 0;       ///< error_integral / length, mesh units; 0 without bisectors
  double error_max = 0;        ///< largest |d_left - d_right| among the samples, mesh units
  double length = 0;           ///< total length of the integrated bisectors, mesh units
  std::int64_t distances = 0;  ///< that were asked for; 0 where `exact` was not `verify_diagram`'s
  std::int64_t corrected = 0;  ///< of these, longer than a path on the surface, whose length was taken (verify.hpp)
};

/// The error measure E: the sum over the bisectors of the integral of |d_left(p) - d_right(p)| dp, where d_left and
/// d_right are the exact geodesic distances from p to the two generators of the bisector.
///
/// Source:  section 5.2 of the paper
/// Quadrature: every panel is sampled at the four Gauss-Lobatto points, which include its ends. If the samples do not
/// change sign, the rule is exact to degree 5. If they do, the cubic through them is split at its roots and integrated
/// piece by piece, so the kink of |.| costs no accuracy. At a kink of the distance itself, where its path changes sides
/// of a vertex, the error decreases with the square of the number of panels.
/// Properties: (1) 0 for bisectors on which the two distances agree; (2) a bisector between a cell and itself is left
/// out of all four figures, since its two distances are the same; (3) infinite, and never NaN, if a sample can't be
/// reached from both of its generators; (4) `exact` is called once, with one query for each generator that has a
/// bisector, ascending.
/// Throws Error{invalid_option} for panels < 1, Error{precondition} if the diagram does not match the mesh (element:
/// the bisector) or `exact` returns a wrong number of distances, and whatever `exact` throws.
/// Cost: 3 x panels samples a segment, each in two queries; memory linear in them.
ErrorMeasure compute_error_measure(const Mesh& mesh, const Diagram& diagram, const ExactDistances& exact,
                                   const ErrorMeasureOptions& options = {});

}  // namespace gvd
