#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "gvd/find_fewest.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/relaxation_start.hpp"
#include "gvd/remesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Iterations of the relaxation of sampled generators. On nine models with 2000 generators, the mean Q is .762 without
/// any, .902 after 10 and .919 after 20. After 30 it is at most .01 more.
inline constexpr std::int32_t kRemeshRelaxation = 15;

/// A remesh from its generators to its mesh, as gvd-remesh makes it. Its progress and its threads are those of
/// `remesh.diagram`.
struct SurfaceRemeshOptions {
  /// The generators. Sampled ones follow the boundary, and creases sharper than kUsualCreaseAngle, as far as
  /// constrain_start says. Whether they leave room, and the rules of `copy` but its `faces`, are set by remesh_surface.
  RelaxationStartOptions start = default_start();
  std::optional<std::int32_t> relaxation;  ///< iterations, >= 0; kRemeshRelaxation for sampled ones, 0 for listed ones
  /// Where the vertices are; nothing: fitted to the surface for sampled generators, at the generators for listed ones.
  std::optional<Placement> placement;
  bool exact_count = false;  ///< as many vertices as generators, or Error{no_valid_result}
  /// Its creases, its fixed and kept vertices, `may_decimate` and the above are set by remesh_surface.
  RemeshOptions remesh;
  /// Called with the iterations and the energy (LloydOptions::on_iteration); may be empty.
  std::function<void(std::int64_t iterations, double energy)> on_iteration;
  /// Called at the beginning of every step with its name, so that a caller can time them; may be empty.
  std::function<void(std::string_view)> on_step;

  std::int32_t iterations() const { return relaxation.value_or(start.listed.empty() ? kRemeshRelaxation : 0); }
  Placement chosen_placement() const {
    return placement.value_or(start.listed.empty() ? Placement::fit : Placement::generator);
  }
  /// Whether generators may be added. Where none may, creases that are preferred are not followed.
  bool may_add() const { return remesh.refine && remesh.max_added != 0; }
  static RelaxationStartOptions default_start();
};

struct SurfaceRemesh {
  RelaxationStart start;                  ///< its points are those that the remesh began with: relaxed
  std::optional<LloydResult> relaxation;  ///< without its diagram; nothing where no iteration was asked for
  bool relaxation_ends_on_copy = false;   ///< no iteration on the mesh follows those on the copy, if there is one
  RemeshOptions options;                  ///< those that the remesh was made with
  RemeshResult result;
};

/// Samples or takes generators, relaxes them and builds the coarse mesh of their diagram.
///
/// The relaxation ends on a copy of the mesh where no generator moves along creases. With `exact_count`, given
/// generators are left out for those that are added. Where these are many, a start with fewer is tried too, and the
/// nearer remesh is taken. Listed generators are never left out: none is added to them then.
/// Properties: those of `remesh`, and vertex_count = the number of generators with `exact_count`.
/// Throws what start_relaxation, relax_generators and remesh throw; Error{precondition} for a mesh without area;
/// Error{invalid_option} for a negative number of iterations. Cost: theirs; twice that at most with `exact_count`.
SurfaceRemesh remesh_surface(const Mesh& mesh, const SurfaceRemeshOptions& options);

/// Searches for the fewest sampled generators whose remesh is within `distance` of the mesh, both ways; mesh units, >
/// 0.
///
/// A number that gives no mesh counts as infinitely far, unless none before has given one: then larger ones would take
/// long. At most four generators for each vertex of the mesh are tried, or 2000 where it has few. `on_trial` is called
/// after every trial; may be empty. Throws what remesh_surface throws; Error{no_valid_result} where no number does.
/// Cost: up to 17 remeshes.
Fewest find_remesh_count(const Mesh& mesh, const SurfaceRemeshOptions& options, double distance,
                         const std::function<void(const CountTrial&)>& on_trial = {});

}  // namespace gvd
