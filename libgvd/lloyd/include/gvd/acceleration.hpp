#pragma once

namespace gvd {

/// How the steps of an iteration are found.
enum class Acceleration {
  none,      ///< Lloyd's method: every generator goes to the centroid of its cell
  lbfgs,     ///< a quasi-Newton method (L-BFGS) with the Hessian of the centroidal Voronoi energy to begin with
  anderson,  ///< Anderson's mixing of the last steps
};

}  // namespace gvd
