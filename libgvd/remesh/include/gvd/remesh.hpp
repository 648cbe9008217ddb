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

/// The stages of a remesh. The first two make a round; where the dual has no defect, the third one follows.
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
  /// The largest number of generators to add, >= 0. Without a value: default_max_added, and three times as many where
  /// the numbers of defects so far let these be enough.
  std::optional<std::int64_t> max_added;
  /// The number of vertices that the mesh shall have, >= 1; without a value as many as it needs. For generators that
  /// are added, given ones are left out where the dual can do without them, but none of the first `kept` and
  /// none that `placement` fixes.
  std::optional<std::int64_t> vertex_count;
  std::size_t kept = 0;
  /// Number of diagrams that a relaxation has computed before. The work of searches is limited in proportion to that of
  /// the other diagrams, these included.
  std::int64_t earlier_diagrams = 0;
  /// Where more generators don't repair the dual of a component, or take too long, its own triangles, decimated, take
  /// its place: given generators there are no vertices then. Only with `refine`, and without `max_added` and
  /// `vertex_count`.
  bool may_decimate = false;
  /// Accept faces that intersect each other. Without it, generators are added near them as near other defects; faces
  /// that inherit their intersection from the input (find_inherited) are always accepted.
  bool allow_intersections = false;
  /// Curves that the dual's edges shall follow: creases, and the boundary (trace_creases). With `refine`,
  /// generators are added on them where cells of others come between, and where long edges would cut off bends of
  /// creases. `max_added` counts them, and at most one for each given generator and 100 more are added.
  std::vector<CreaseCurve> creases;
  /// Where the vertices are. `fixed`: ids of given generators. Its `threads` and `progress` are those of `diagram`.
  PlacementOptions placement;
  /// Called at the beginning of every stage, from the calling thread, so that a caller can time them; may be empty.
  std::function<void(RemeshStage)> on_stage;
};

/// The default of `max_added`: ten for each given generator, component, boundary loop and handle, and 100 more. Why
/// these: a sphere needs four vertices and a boundary loop three. A handle needs at most three on each of two loops,
/// and a thin limb three on each loop round it.
std::int64_t default_max_added(const MeshSummary& mesh, std::size_t generators);

/// After so many rounds no repair follows. Rounds that add generators on creases count; the diagrams of parts of the
/// mesh and those of a search do not. Measured on 850 remeshes of real meshes with 1 to 300 generators. Those
/// that succeeded took at most 50 rounds, and nine of ten of them at most 12.
inline constexpr std::int32_t kMaxRemeshRounds = 60;

/// Why a component of the surface is no dual.
enum class DecimationCause {
  growth,      ///< more defects from round to round: it is finer than the spacing of the generators nearly everywhere
  work,        ///< its repair takes too long
  generators,  ///< one of several components, and it would take too many generators
  narrow_tip,  ///< generators round a tip would be too close to each other
  no_room,     ///< every point for a new generator is too close to another one
};

/// Components of the surface without a proper dual: they are the input's own triangles, decimated.
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
  std::int64_t added_on_creases = 0;      ///< of these, those on creases, so that edges follow them
  double crease_length = 0;               ///< of the creases of the options, mesh units
  double crease_gap_length = 0;           ///< of their parts that edges do not follow: other cells come between
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
/// While the dual of the generators is not a proper mesh, generators are added near its defects, and the diagram is
/// computed again. check_dual, find_flipped_faces and find_self_intersections tell the defects; docs/guide/remesh.md
/// says where they go. The vertices are moved off their generators as `placement` says. A search follows where more
/// than a tenth of the given generators was added, those on creases not counted. Added generators that the mesh can do
/// without are left out again, but none on creases. One is put in the place of two where that will do. No given
/// generator is moved, and none is removed without `vertex_count` or `may_decimate`. At last, generators are added
/// where that leaves fewer slivers.
///
/// A bisector that ends on the boundary of the mesh becomes a boundary edge. The coarse boundary therefore passes
/// through the generators whose cells touch the boundary. It lies inside the surface unless these are on the boundary,
/// or the vertices are placed there.
///
/// Properties: (1) the certificate of a result is ok; (2) with Placement::generator vertex i is at generator i, bit by
/// bit; (3) deterministic.
/// Throws Error{no_valid_result} if no proper mesh is found with `max_added` generators, kMaxRemeshRounds, without
/// `refine`, or with `vertex_count`. It names the failing property and its position. Throws Error{invalid_option} for a
/// negative `max_added`, and what check_placement and compute_diagram throw. Cost: one diagram a round, and some tens
/// of rounds for the hardest surfaces.
RemeshResult remesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const RemeshOptions& options = {});

/// remesh where the diagram of the given generators is known, as after a relaxation: one diagram less. `diagram` must
/// be that of `mesh` with `options.diagram`. Throws Error{precondition} also where it has not the mesh's vertices and
/// faces.
RemeshResult remesh(const Mesh& mesh, Diagram diagram, const RemeshOptions& options = {});

/// Both, and the Error{no_valid_result} is returned.
OrError<RemeshResult> try_to_remesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const RemeshOptions& options = {});
OrError<RemeshResult> try_to_remesh(const Mesh& mesh, Diagram diagram, const RemeshOptions& options = {});

/// Writes the diagram of all generators as `gvd-diagram/1` with one more member, `"remesh"`:
/// `{"vertices":[[x,y,z]],"faces":[[a,b,c]],"face_points":[{"face","bary"}],"added"}`. Vertex i stands for
/// generator i, and is at it with Placement::generator. The point of a face is its branch point, on `mesh`. The stream
/// is flushed and checked. Throws Error{unwritable_output}. Cost: O(n).
void write_remesh_json(std::ostream& out, const Mesh& mesh, const RemeshResult& result);

}  // namespace gvd
