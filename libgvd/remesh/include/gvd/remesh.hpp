#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gvd/creases.hpp"
#include "gvd/diagram.hpp"
#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "gvd/placement.hpp"
#include "gvd/quality.hpp"
#include "gvd/remesh_certificate.hpp"
#include "gvd/surface_distance.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The stages of a remesh. The first two make up a round; if the dual has no defect, the third one follows.
enum class RemeshStage {
  diagram,    ///< computes the diagram
  dual,       ///< checks its dual, and adds generators or builds the mesh
  placement,  ///< moves the vertices; then triangles that intersect may lead to another round
  search,     ///< looks for fewer generators, where many were added
  distance,   ///< certifies the mesh and measures its distances from the input, at the end
};

struct RemeshOptions {
  DiagramOptions diagram;  ///< its progress callback serves the whole run
  bool refine = true;      ///< add generators if the dual of the given ones is not a proper mesh; otherwise throw
  /// The largest number of generators to add, >= 0. If it is not set, the limit is default_max_added, and is raised to
  /// three times as many if the defects so far suggest that this will be enough.
  std::optional<std::int64_t> max_added;
  /// The exact number of vertices of the mesh, >= 1. If it is not set, the mesh has as many as it needs. To make room
  /// for added generators, given ones that the dual does not need are left out, but none of the first `kept` and none
  /// that `placement` fixes.
  std::optional<std::int64_t> vertex_count;
  std::size_t kept = 0;
  /// The number of diagrams that a relaxation has computed before. The work of searches is limited in proportion to the
  /// work of all other diagrams, including these.
  std::int64_t earlier_diagrams = 0;
  /// Whether a component becomes its own triangles, decimated, if more generators don't repair its dual or take too
  /// long. The given generators there are then no vertices. Has an effect only with `refine`, and without `max_added`
  /// and `vertex_count`.
  bool may_decimate = false;
  /// Whether faces may intersect each other. If not, generators are added near intersecting faces as near other
  /// defects. Faces that inherit their intersection from the input (find_inherited) are always accepted.
  bool allow_intersections = false;
  /// Curves that the dual's edges should follow: creases, and the boundary (trace_creases). With `refine`, generators
  /// are added on a curve where other cells interrupt it, and where a long edge would cut off a bend of a crease. They
  /// count towards `max_added`, and there are at most 100 more of them than given generators.
  std::vector<CreaseCurve> creases;
  /// Where the vertices are. `fixed` has ids of given generators. The `threads` and `progress` of `diagram` apply here
  /// as well; those of the placement are ignored.
  PlacementOptions placement;
  /// Called at the beginning of every stage, from the calling thread, so that a caller can time them; may be empty.
  std::function<void(RemeshStage)> on_stage;
};

/// The default of `max_added`: ten for each given generator, component, boundary loop and handle, and 100 more. A
/// sphere needs four vertices, a boundary loop three, a handle at most three on each of two loops, and a thin limb
/// three on each loop around it.
std::int64_t default_max_added(const MeshSummary& mesh, std::size_t generators);

/// The largest number of rounds. Rounds that add generators on creases count; diagrams of parts of the mesh and
/// diagrams of a search do not. In 850 remeshes of real meshes, the successful ones took at most 50 rounds, and nine of
/// ten at most 12.
inline constexpr std::int32_t kMaxRemeshRounds = 60;

/// Why a component of the remesh is not a dual.
enum class DecimationCause {
  growth,      ///< more defects from round to round: it is finer than the spacing of the generators nearly everywhere
  work,        ///< its repair takes too long
  generators,  ///< one of several components, and it would take too many generators
  narrow_tip,  ///< generators round a tip would be too close to each other
  no_room,     ///< every point for a new generator is too close to another one
};

/// The components of the surface that have no proper dual. They consist of the input's own triangles, decimated.
struct DecimatedParts {
  std::int64_t components = 0;
  std::map<DecimationCause, std::int64_t> causes;  ///< how many components have each
  std::int64_t generators = 0;  ///< given ones, in these components: they are no vertices of the remesh
  std::int64_t vertices = 0;    ///< of the remesh, in these components; each stands for a vertex of the input
  std::string reason;           ///< the first defect that no generators removed; empty without such components
};

struct RemeshResult {
  Mesh mesh;                              ///< vertex i stands for generator i
  std::vector<SurfacePoint> generators;   ///< the given ones in their order, then the added ones
  std::int64_t added = 0;                 ///< number of generators added
  DecimatedParts decimated;               ///< `generators` has their vertices between the given and the added ones
  std::int64_t left_out = 0;              ///< number of given generators left out (`vertex_count`)
  std::int64_t max_added = 0;             ///< the largest number that might be added
  bool search_cut_short = false;          ///< the search for fewer generators ended at its limit
  std::vector<DualDefect> given_defects;  ///< of the dual of the given generators: why others were added
  std::int64_t added_on_creases = 0;      ///< how many of the added ones are on creases
  double crease_length = 0;               ///< of the creases of the options, mesh units
  double crease_gap_length = 0;           ///< of their parts that no edges follow, because other cells lie between
  bool creases_lack_added = false;        ///< only `max_added` kept generators from being added on those parts
  std::int32_t rounds = 0;                ///< number of diagrams, before a search for fewer
  std::vector<SurfacePoint> face_points;  ///< the branch point of every face; flipped faces keep theirs
  std::vector<EdgeFlip> flips;            ///< of edges, one after another: without them, `mesh` is the dual
  std::vector<FaceId> slivers;            ///< faces with a Q (gvd/quality.hpp) below kSliverQ, ascending
  Diagram diagram;                        ///< of all generators
  RemeshCertificate certificate;
  TriangleQuality input_quality;
  TriangleQuality output_quality;
  SurfaceDistance input_to_output;  ///< distances of the input's points from the remesh
  SurfaceDistance output_to_input;
};

/// The coarse mesh whose vertices are the generators and whose triangles are the branch points of their diagram.
///
/// As long as the dual of the generators is not a proper mesh, generators are added near its defects, and the diagram
/// is computed again. check_dual, find_flipped_faces and find_self_intersections find the defects, and
/// propose_generators says where the new generators go. Then the vertices move off their generators as `placement`
/// says. If more than a tenth as many generators were added as given, not counting those on creases, a search removes
/// added generators that the mesh does not need, and replaces two by one where one is enough. Finally, generators are
/// added where that leaves fewer slivers.
///
/// A bisector that ends on the boundary of the mesh becomes a boundary edge. The coarse boundary therefore passes
/// through the generators whose cells touch the boundary, and lies inside the surface unless these generators are on
/// the boundary or their vertices are placed there.
///
/// Properties: (1) the certificate of a result is ok; (2) with Placement::generator, vertex i is at generator i, bit by
/// bit; (3) no given generator is moved, and none is removed without `vertex_count` or `may_decimate`; (4)
/// deterministic, for any number of threads.
/// Throws Error{no_valid_result} if no proper mesh is found within the limits of `max_added`, kMaxRemeshRounds,
/// `refine` and `vertex_count`; the message names the property that fails and where. Throws Error{invalid_option} for a
/// negative `max_added`, and what check_placement and compute_diagram throw.
/// Cost: one diagram for each round; the hardest surfaces take some tens of rounds.
/// Source: the dual of geodesic cells as a remesh is that of Peyré and Cohen, Geodesic remeshing using front
/// propagation, 2006.
RemeshResult remesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const RemeshOptions& options = {});

/// The same for a known diagram of the given generators, such as the last one of a relaxation, which saves a diagram.
/// `diagram` must be the diagram of `mesh` with `options.diagram`. Throws Error{precondition} if its numbers of
/// vertices and faces are not the mesh's.
RemeshResult remesh(const Mesh& mesh, Diagram diagram, const RemeshOptions& options = {});

/// The two functions above, except that Error{no_valid_result} is returned instead of thrown.
OrError<RemeshResult> try_to_remesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const RemeshOptions& options = {});
OrError<RemeshResult> try_to_remesh(const Mesh& mesh, Diagram diagram, const RemeshOptions& options = {});

/// Writes the diagram of all generators as `gvd-diagram/1` with one more member, `"remesh"`:
/// `{"vertices":[[x,y,z]],"faces":[[a,b,c]],"face_points":[{"face","bary"}],"added"}`. Vertex i stands for
/// generator i, and is at it with Placement::generator. The point of a face is its branch point, on `mesh`. The stream
/// is flushed and checked. Throws Error{unwritable_output}. Cost: O(n).
void write_remesh_json(std::ostream& out, const Mesh& mesh, const RemeshResult& result);

}  // namespace gvd
