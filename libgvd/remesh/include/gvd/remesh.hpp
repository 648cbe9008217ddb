#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/quality.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The two kinds of work that a remesh alternates between.
enum class RemeshStage {
  diagram,  ///< computing the diagram
  dual,     ///< checking its dual, adding generators, and building and certifying the mesh
};

struct RemeshOptions {
  DiagramOptions diagram;  ///< its progress serves the whole run
  bool refine = true;      ///< add generators where the dual of the given ones is no proper mesh; otherwise refuse
  /// Most generators that may be added, >= 0. Not given: default_max_added.
  std::optional<std::int64_t> max_added;
  /// Called when a stage starts, so that a caller can time them; may be empty.
  std::function<void(RemeshStage)> on_stage;
};

/// Ten for each given generator, each component, each boundary loop and each handle, and 100 more: a sphere takes four
/// vertices, a boundary loop three, a handle at most three on each of two loops, and thin limbs three a loop.
std::int64_t default_max_added(const MeshSummary& mesh, std::size_t generators);

/// A run ends after this many diagrams, for where it has not converged by then it hardly will: of 850 runs on real
/// meshes, with 1 to 300 generators, none that succeeded took more than 50, and nine of ten took 12 at most.
inline constexpr std::int32_t kMostRounds = 60;

/// What holds for a remesh, measured on the mesh that is handed out and not on how it came about.
struct RemeshCertificate {
  MeshSummary input;
  MeshSummary output;
  bool manifold = false;         ///< OpenMesh takes every face, and finds one fan round every vertex
  bool closed_as_input = false;  ///< no boundary where the input has none, and a boundary where it has one
  bool same_euler_characteristic = false;
  bool same_components = false;  ///< as many, and each one holds exactly the generators of one input component
  bool same_boundary_loops = false;
  /// Euler characteristic and boundary loops agree in each component by itself, not only in sum.
  bool same_in_each_component = false;
  std::int64_t flipped_faces = 0;      ///< see find_flipped_faces
  std::int64_t unused_generators = 0;  ///< generators that are no vertex of any face

  bool ok() const;
  /// The first thing that does not hold, in words; empty where all do.
  std::string first_failure() const;
};

struct RemeshResult {
  Mesh mesh;                              ///< vertex i is generator i
  std::vector<SurfacePoint> generators;   ///< the given ones first and in their order, then those that were added
  std::int64_t added = 0;                 ///< how many of them were added
  std::int32_t rounds = 0;                ///< diagrams that were computed
  std::vector<SurfacePoint> face_points;  ///< the branch point of every face
  Diagram diagram;                        ///< of all generators
  RemeshCertificate certificate;
  TriangleQuality input_quality;
  TriangleQuality output_quality;
};

/// The coarse mesh whose vertices are the generators and whose triangles are the branch points of their diagram.
///
/// Where the dual of the given generators is no proper mesh (check_dual, find_flipped_faces), generators are added at
/// the places that fail, one for each place in a round, and the diagram is built again. docs/guide/remesh.md says where
/// they go. None is ever removed or moved.
///
/// At a boundary of the mesh, a bisector that ends there becomes a boundary edge: the coarse boundary runs through the
/// generators whose cells touch the boundary, so it lies inside of it unless these generators are on it.
///
/// Properties: (1) the certificate of a result is ok; (2) vertex i is generator i, bit by bit; (3) deterministic.
/// Throws Error{no_valid_result} that names the failing property and its place where no proper mesh comes about within
/// `max_added`, or without `refine`; and what compute_diagram throws. Cost: one diagram a round, and some tens of
/// rounds for the hardest surfaces.
RemeshResult remesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const RemeshOptions& options = {});

/// Compares a remesh with its surface. `generators` are the vertices in their order, `face_points` one point a face.
/// Never throws on a finding. Cost: O(n).
RemeshCertificate certify_remesh(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                                 const std::vector<SurfacePoint>& face_points);

}  // namespace gvd
