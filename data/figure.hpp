#pragma once

#include "gvd/vec.hpp"

namespace gvd::data {

/// A four-legged figure whose tail curls back into its back: one component, genus 1, thin limbs. About 3.5 long (x),
/// 2.6 high (y) and 1 wide (z, its plane of symmetry being z = 0).
///
/// Returns: negative inside, positive outside; near the surface about the distance to it, in mesh units.
/// Only +, -, *, / and the square root are used, all of them exactly rounded, so that every machine gets the same
/// value.
double figure_value(const Vec3& p);

/// Gradient of figure_value by central differences.
Vec3 figure_gradient(const Vec3& p);

/// Point of the surface that a few Newton steps along the gradient reach from a point near it.
Vec3 project_to_figure(Vec3 p);

}  // namespace gvd::data
