#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "gvd/coarse_copy.hpp"
#include "gvd/constrained_start.hpp"
#include "gvd/density.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The copy of a mesh that generators are relaxed on first.
struct CopyOptions {
  std::optional<std::int64_t> faces;  ///< of the copy, >= 0; 0: no copy; nothing: the three below decide
  std::int64_t above = 50'000;        ///< meshes of more faces have a copy
  CopySize size;                      ///< of that copy (default_copy_faces)
};

/// The copy for a relaxation with these options. By default there is none without iterations, and none with
/// Acceleration::none, which is for comparison, iteration by iteration, on the mesh.
CopyOptions copy_options(const LloydOptions& relaxation, CopyOptions asked = {});

/// Which generators a relaxation begins with, what they may do, and how the surface is weighed.
struct RelaxationStartOptions {
  std::vector<SurfacePoint> listed;  ///< the generators; empty: they are sampled
  SamplingOptions sampling;          ///< of sampled ones
  /// Samples them in place of sample_generators; there is no copy then. May be empty.
  std::function<std::vector<SurfacePoint>(const SamplingOptions&)> sample;
  StartOptions constraints;       ///< `are_listed` is set here; creases that are preferred are for sampled ones
  Density density;                ///< of the mesh's faces, or uniform
  bool weighs_curvature = false;  ///< take make_curvature_density in place of `density`
  double gradation = 0.3;         ///< of that density
  CopyOptions copy;
  int threads = 0;    ///< >= 0; 0: one a core. The result is the same for any number
  Progress progress;  ///< of every step; may be empty
  /// Called at the beginning of every step with its name, so that a caller can time them; may be empty.
  std::function<void(std::string_view)> on_step;
};

/// A start with the weight of the surface and the copy to relax on first, if any.
struct RelaxationStart : ConstrainedStart {
  Density density;
  std::optional<CoarseCopy> copy;
};

/// The least number of a copy's faces for each generator: with fewer, generators coincide.
inline constexpr std::int64_t kCopyFacesPerGenerator = 2;

/// Samples the generators or takes those listed, and prepares their relaxation: the way from options to points that
/// gvd-lloyd and gvd-remesh share.
///
/// There is no copy where it would have less than kCopyFacesPerGenerator faces for each generator, or more than half of
/// the mesh's. Farthest points are sampled on the copy. By default, neither listed generators nor those of a covering
/// radius have one: nothing moves relaxed generators to a copy.
/// Throws Error{invalid_option} for a copy of fewer than 0 faces, and what sample_generators, make_curvature_density,
/// make_coarse_copy and constrain_start throw. Cost: the sum of theirs.
RelaxationStart start_relaxation(const Mesh& mesh, const RelaxationStartOptions& options);

/// relax_generators from a start: its constraints, density and copy take the place of those given.
LloydResult relax_generators(const Mesh& mesh, const RelaxationStart& start, LloydOptions options = {},
                             LloydStages stages = {});

}  // namespace gvd
