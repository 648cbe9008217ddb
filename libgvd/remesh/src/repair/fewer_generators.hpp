#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "repair/local_dual.hpp"

namespace gvd {

/// Bounds on the search, in faces and generators of all its diagrams: so many times those of the whole diagram, or so
/// many in all. Beyond either, no more pairs are tried; beyond twice as many, the search ends. That is some seconds on
/// one core. With 400 times as many, two meshes of docs/notes/remesh-bench.md came out the same.
inline constexpr std::size_t kSearchedMeshes = 60, kSearchedElements = 1'000'000;

/// Looks for generators without which the dual has no defect either, among those that a repair has added. It tries to
/// leave one out, and to put a single one in the place of two that are near each other.
///
/// Whether a change leaves a defect is told by a part of the mesh (LocalDual); what passes there is decided on the
/// whole one. Candidates for the place of two are the points that would repair the defects that the two leave. In the
/// cells with these defects, branch points and some vertices are candidates, too. Every change leaves one generator
/// less, so the search ends. Deterministic.
class FewerGenerators {
 public:
  /// Whether the dual of these generators is right. If so, the diagram becomes theirs.
  using Accept = std::function<bool(const std::vector<SurfacePoint>&)>;

  /// `diagram`: without defects; it may change in `accept` only. Its first `given` generators stay. The mesh and the
  /// diagram must outlive the search.
  FewerGenerators(const Mesh& mesh, const Diagram& diagram, std::size_t given, const DiagramOptions& options,
                  Accept accept)
      : mesh_(mesh), diagram_(diagram), given_(given), options_(options), accept_(std::move(accept)) {}

  /// Afterwards no single added generator can be left out, as far as parts of the mesh tell, unless the search has
  /// become too long. Cost: of kSearchedMeshes diagrams at most twice.
  void search();

 private:
  bool pass_over_added();
  bool unite_with_nearest(GeneratorId g);
  bool leave_out(const std::vector<GeneratorId>& removed);
  bool replace(const std::vector<GeneratorId>& removed, const LocalDual& local, const LocalDual::Result& without);
  std::optional<LocalDual::Result> compute(const LocalDual& local, const std::vector<SurfacePoint>& added);
  bool accept(const std::vector<GeneratorId>& removed, const std::vector<SurfacePoint>& added);
  std::vector<SurfacePoint> list_candidates(const LocalDual& local, const LocalDual::Result& without) const;
  std::optional<GeneratorId> find_nearest_added(GeneratorId g) const;
  /// Faces and generators of the whole diagram.
  std::size_t whole_size() const { return mesh_.face_count() + diagram_.generators.size(); }
  /// Whether all diagrams so far exceed the bounds, or these bounds times `factor`.
  bool is_beyond_bounds(std::size_t factor = 1) const {
    return searched_ > factor * std::min(kSearchedElements, kSearchedMeshes * whole_size());
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::size_t given_;
  DiagramOptions options_;
  Accept accept_;
  std::size_t searched_ = 0;  // faces and generators in all diagrams so far
};

}  // namespace gvd
