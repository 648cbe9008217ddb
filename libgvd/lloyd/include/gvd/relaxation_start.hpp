#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "gvd/coarse_copy.hpp"
#include "gvd/constrained_start.hpp"
#include "gvd/density.hpp"
#include "gvd/error.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The copy of a mesh on which generators are relaxed first.
struct CopyOptions {
  std::optional<std::int64_t> faces;  ///< of the copy, >= 0; 0: no copy; without a value, the fields below decide
  std::int64_t above = 50'000;        ///< only meshes with more faces have a copy
  CopySize size;                      ///< of this copy (see `default_copy_faces`)
};

/// Chooses the copy for a relaxation with these options. By default there is no copy without iterations, and none with
/// Acceleration::none, which serves to compare iterations on the mesh.
CopyOptions copy_options(const LloydOptions& relaxation, CopyOptions asked = {});

/// The initial generators of a relaxation, how they may move, and the density of the surface.
struct RelaxationStartOptions {
  std::vector<SurfacePoint> listed;  ///< the generators; empty: they are sampled
  SamplingOptions sampling;          ///< of sampled generators
  /// Called in place of `sample_generators`; there is then no copy. May be empty.
  std::function<std::vector<SurfacePoint>(const SamplingOptions&)> sample;
  StartOptions constraints;       ///< `are_listed` is ignored; only sampled generators follow preferred creases
  Density density;                ///< of the mesh's faces, or uniform
  bool weighs_curvature = false;  ///< use `make_curvature_density` in place of `density`
  double gradation = 0.3;         ///< of the curvature density
  CopyOptions copy;
  int threads = 0;    ///< >= 0; 0: as many as there are cores. The result does not depend on it
  Progress progress;  ///< of every step; may be empty
  /// Called at the beginning of every step with its name, so that the caller can time the steps; may be empty.
  std::function<void(std::string_view)> on_step;
};

/// A start with the density of the surface and, if there is one, the copy on which to relax first.
struct RelaxationStart : ConstrainedStart {
  Density density;
  std::optional<CoarseCopy> copy;
};

/// The least number of a copy's faces for each generator. With fewer faces, generators would coincide.
inline constexpr std::int64_t kCopyFacesPerGenerator = 2;

/// Samples the generators or takes the listed ones, and prepares their relaxation. gvd-lloyd and gvd-remesh share these
/// steps from options to points.
///
/// There is no copy if it would have fewer than kCopyFacesPerGenerator faces for each generator, or more than half of
/// the mesh's faces. Farthest points are sampled on the copy. By default, there is no copy for listed generators and
/// for a covering radius.
/// Throws Error{invalid_option} for a copy of fewer than 0 faces, and what `sample_generators`,
/// `make_curvature_density`, `make_coarse_copy` and `constrain_start` throw. Cost: the sum of the costs of these.
RelaxationStart start_relaxation(const Mesh& mesh, const RelaxationStartOptions& options);

/// The same, and an error about the number of generators is returned: more than the mesh has room for, or fewer than
/// are fixed or on features.
OrError<RelaxationStart> try_to_start_relaxation(const Mesh& mesh, const RelaxationStartOptions& options);

/// Relaxes the generators of a start, whose constraints, density and copy replace those of `options` and `stages`.
LloydResult relax_generators(const Mesh& mesh, const RelaxationStart& start, LloydOptions options = {},
                             LloydStages stages = {});

}  // namespace gvd
