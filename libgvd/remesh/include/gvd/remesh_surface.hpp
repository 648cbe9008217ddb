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
/// relaxation, .902 after 10 iterations and .919 after 20; ten more add at most .01.
inline constexpr std::int32_t kRemeshRelaxation = 15;

/// A remesh from its generators to its mesh, as gvd-remesh makes it. Its progress and its threads are those of
/// `remesh.diagram`.
struct SurfaceRemeshOptions {
  /// The generators. Sampled ones follow the boundary, and creases sharper than kUsualCreaseAngle, as described for
  /// constrain_start. remesh_surface itself decides whether they leave room, and sets all of `copy` except its `faces`.
  RelaxationStartOptions start = default_start();
  std::optional<std::int32_t> relaxation;  ///< iterations, >= 0; kRemeshRelaxation for sampled ones, 0 for listed ones
  /// Where the vertices are. If it is not set, the vertices of sampled generators are fitted to the surface, and the
  /// vertices of listed ones stay at them.
  std::optional<Placement> placement;
  bool exact_count = false;  ///< as many vertices as generators, or Error{no_valid_result}
  /// remesh_surface sets its creases, its fixed and kept vertices, `may_decimate`, and what the members above say.
  RemeshOptions remesh;
  /// Called with the iterations and the energy (LloydOptions::on_iteration); may be empty.
  std::function<void(std::int64_t iterations, double energy)> on_iteration;
  /// Called at the beginning of every step with its name, so that a caller can time them; may be empty.
  std::function<void(std::string_view)> on_step;

  std::int32_t iterations() const { return relaxation.value_or(start.listed.empty() ? kRemeshRelaxation : 0); }
  Placement chosen_placement() const {
    return placement.value_or(start.listed.empty() ? Placement::fit : Placement::generator);
  }
  /// Whether generators may be added. If not, preferred creases are not followed.
  bool may_add() const { return remesh.refine && remesh.max_added != 0; }
  static RelaxationStartOptions default_start();
};

struct SurfaceRemesh {
  RelaxationStart start;                  ///< its points are the relaxed ones, with which the remesh began
  std::optional<LloydResult> relaxation;  ///< without its diagram; nothing if no iteration was asked for
  bool relaxation_ends_on_copy = false;   ///< no iteration on the mesh follows those on the copy, if there is one
  RemeshOptions options;                  ///< with which the remesh was made
  RemeshResult result;
};

/// Samples or takes generators, relaxes them and builds the coarse mesh of their diagram.
///
/// If no generator moves along a crease, the relaxation ends on a coarse copy of the mesh. With `exact_count`, given
/// generators are left out to make room for added ones; if that takes many, a start with fewer generators is tried as
/// well, and the nearer of the two remeshes is returned. Listed generators are never left out, so with `exact_count`
/// none is added to them.
///
/// Properties: (1) those of `remesh`; (2) with `exact_count`, the mesh has as many vertices as generators were asked
/// for.
/// Throws what start_relaxation, relax_generators and remesh throw, Error{precondition} for a mesh without area, and
/// Error{invalid_option} for a negative number of iterations. Cost: the sum of theirs, and up to twice that with
/// `exact_count`.
SurfaceRemesh remesh_surface(const Mesh& mesh, const SurfaceRemeshOptions& options);

/// Searches for the fewest sampled generators whose remesh is within `distance` of the mesh, in both directions; mesh
/// units, > 0.
///
/// A number for which no mesh is found counts as infinitely far. If that happens before any mesh was found, the search
/// ends with the error, because larger numbers would only take longer. The largest number tried is four for each vertex
/// of the mesh, or 2000 if that is more. `on_trial` is called after every trial and may be empty.
///
/// Properties: those of `find_fewest`, with the Hausdorff distance (its bound, the larger of both directions) as the
/// error.
/// Throws what remesh_surface and find_fewest throw, and Error{no_valid_result} if no number is enough. Cost: at most
/// 16 calls of remesh_surface.
Fewest find_remesh_count(const Mesh& mesh, const SurfaceRemeshOptions& options, double distance,
                         const std::function<void(const CountTrial&)>& on_trial = {});

}  // namespace gvd
