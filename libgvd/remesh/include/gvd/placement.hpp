#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Where the vertices of a remesh are.
enum class Placement {
  generator,  ///< at the generators, on the surface
  quadric,    ///< at the points nearest to the planes of their cells' faces, in the sense of least squares
  fit,        ///< so that the remesh is near the surface in the sense of least squares, with good triangles
};
inline const Choices<Placement> kPlacementNames{
    {"generator", Placement::generator}, {"quadric", Placement::quadric}, {"fit", Placement::fit}};

/// An edge that was replaced by the other diagonal of its two faces. The faces keep their ids, and the points of the
/// surface that they stand for.
struct EdgeFlip {
  using Face = std::array<VertexId, 3>;

  FaceId left, right;              ///< the faces on the two sides of the edge from `from` to `to`
  VertexId from, to;               ///< the ends of the edge before
  VertexId left_apex, right_apex;  ///< those of the edge after

  /// The corners of `left` and `right`, counter-clockwise.
  std::pair<Face, Face> before() const { return {{from, to, left_apex}, {to, from, right_apex}}; }
  std::pair<Face, Face> after() const { return {{from, right_apex, left_apex}, {right_apex, to, left_apex}}; }
};

/// The faces after a sequence of flips, and the faces before it, with their corners in the order of EdgeFlip. Cost:
/// O(n).
std::vector<EdgeFlip::Face> apply_flips(std::vector<EdgeFlip::Face> faces, const std::vector<EdgeFlip>& flips);
std::vector<EdgeFlip::Face> undo_flips(std::vector<EdgeFlip::Face> faces, const std::vector<EdgeFlip>& flips);

struct PlacementOptions {
  Placement method = Placement::fit;
  std::vector<GeneratorId> fixed;  ///< generators whose vertices stay at them
  /// Generators on curves that edges follow. An edge between two of them, or between two on the boundary, is not
  /// flipped.
  std::vector<GeneratorId> on_curves;
  /// The weight of good triangles against the distance with Placement::fit, in [0, 1]. At 0 the distance counts most,
  /// at 1 the triangles do. Below 1/2 the two bounds on angles below approach kLeastPlacedAngle, which they reach at 0.
  double shape = 0.5;
  /// No move makes an angle of a triangle smaller than this; degrees, in [0, 60]. An angle that is smaller already does
  /// not shrink.
  double least_angle = 33;
  /// The least angle of triangles at creases with Placement::fit; degrees, in [0, 60].
  double least_crease_angle = 20;
  int threads = 0;    ///< 0: one for each core; the result does not depend on it
  Progress progress;  ///< of the step "placement"
};

/// The least angle of all triangles with Placement::quadric, and with Placement::fit where `shape` is 0; degrees.
inline constexpr double kLeastPlacedAngle = 10;

/// Throws Error{invalid_option} for a shape or an angle out of its range, and for a fixed generator that does not exist
/// among `generators` ones. Cost: O(k) for k fixed generators.
void check_placement(const PlacementOptions& options, std::size_t generators);

/// A remesh with its vertices near the surface.
struct PlacedRemesh {
  std::vector<Vec3> positions;  ///< of the vertices, mesh units
  std::vector<EdgeFlip> flips;  ///< of edges, one after another
};

/// Computes positions near the surface for the vertices of a remesh, in mesh units, by the chosen method.
///
/// The vertices of `remesh` must be at the generators of `diagram`; `face_points` are the branch points of its faces. A
/// vertex moves towards its target as far as three rules allow: no triangle is flipped (find_flipped_faces), no angle
/// drops below the bound, and no two triangles intersect that did not intersect at the generators. If a triangle breaks
/// a rule, the steps of its vertices are halved up to kMaxHalvings times, and then left out.
///
/// Quadric: a vertex minimises the sum of square distances from the planes of its cell's faces and from the lines of
/// the cell's boundary edges. A plane has the weight of its area in the cell. Source: Garland and Heckbert, Surface
/// simplification using quadric error metrics, 1997. In directions in which the sum hardly changes, the vertex keeps
/// the generator's position.
///
/// Fit: vertices at creases and on the boundary go to their quadric's minimum first. Then kFitRounds rounds minimise a
/// sum of square distances over all vertices at once: the distances of samples of the surface from the planes of their
/// nearest triangles, and the distances of samples of the remesh from the surface. Springs pull the vertices along the
/// surface to positions of better triangles. After each round, the vertices of thin triangles, and after the last round
/// all vertices, move to where their triangles are better while the distances hardly grow. Before the last round, an
/// edge is flipped if that improves triangles and distances together.
///
/// Properties: (1) with `generator`, every vertex is at its generator, bit by bit; (2) the vertices of `fixed` stay at
/// theirs; (3) after the flips, the mesh has the topology of `remesh`; (4) deterministic, for any number of threads.
/// Throws what check_placement throws, and Error{precondition} if the arguments do not belong together. Cost: O(n log
/// n), and one sparse system for each round.
PlacedRemesh place_vertices(const Mesh& surface, const Diagram& diagram, const Mesh& remesh,
                            const std::vector<SurfacePoint>& face_points, const PlacementOptions& options = {});

/// The steps of a vertex are halved at most this many times.
inline constexpr int kMaxHalvings = 4;

/// Rounds of the fit. A remesh of few vertices has one more.
inline constexpr int kFitRounds = 4;

}  // namespace gvd
