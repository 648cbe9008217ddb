#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gvd/front.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// What computes the distances.
enum class Solver {
  windows,        ///< exact distances on the polyhedron, by propagation of windows
  fast_marching,  ///< the paper's adapted fast marching (section 4.1)
};

/// What turns distances into bisectors.
enum class Tracer {
  envelope,  ///< the lower envelope of the distances, on every edge and in every face: as exact as they are
  growth,    ///< the paper's refinement by unfolding, and growth (sections 4.2 and 4.3)
};

/// Any solver goes with any tracer; two of the combinations have a name.
struct Method {
  Solver solver;
  Tracer tracer;

  bool operator==(const Method&) const = default;
  static const Method exact;  ///< windows and envelope: the diagram of the exact polyhedral metric
  static const Method gbgvd;  ///< fast marching and growth: the paper's method
};
inline constexpr Method Method::exact{Solver::windows, Tracer::envelope};
inline constexpr Method Method::gbgvd{Solver::fast_marching, Tracer::growth};

/// Least chord tolerance, in mean edge lengths. The distances to two generators are right to 1e-13 of themselves or so,
/// and a point can be 10 to 100 times as far from the bisector as they differ: below this, rounding decides.
inline constexpr double kLeastChordTolerance = 1e-10;

struct DiagramOptions {
  Method method = Method::exact;
  Front front = Front::circle;  ///< of fast marching
  /// How far a bisector's straight pieces may be from it, in mean edge lengths, >= kLeastChordTolerance. Of the
  /// envelope tracer. Points grow with the square root of its inverse.
  double chord_tolerance = 1e-4;
  /// How many threads work at the same time, >= 1; 0: as many as there are cores. No bit of the result depends on it.
  int threads = 0;
  Progress progress;  ///< may be empty
};

/// A point where three or more cells meet.
struct BranchPoint {
  SurfacePoint point;
  Vec3 position;                        ///< mesh units
  std::vector<GeneratorId> generators;  ///< 3 or more, counter-clockwise round the point
  double distance = 0;                  ///< mean distance to the generators, mesh units
};

/// A bisector: the polyline between two cells, from end to end.
struct Bisector {
  GeneratorId left;   ///< the cell to the left when one walks along `points`, seen from outside the surface
  GeneratorId right;  ///< equal to `left` where a cell meets itself
  bool closed = false;
  /// The branch points at its two ends; invalid where the end lies on the mesh's boundary, or where it is closed.
  std::array<BranchPointId, 2> ends;
  /// Points in order, both ends included; a closed one does not repeat its first point. Consecutive points share a
  /// face.
  std::vector<SurfacePoint> points;
};

/// The part of the surface that is nearest to one generator.
struct Cell {
  GeneratorId generator;
  double area = 0;                        ///< square mesh units
  std::int32_t euler_characteristic = 0;  ///< 1 for a disc, 0 for an annulus, 2 for a sphere
  std::int32_t components = 0;            ///< 1 where the cell is connected
  std::int32_t boundary_loops = 0;        ///< loops made of bisectors and of the mesh's boundary
  std::vector<GeneratorId> neighbours;    ///< ascending, each once, without the cell itself
};

/// A polygon inside one face that belongs to one cell.
struct FacePiece {
  FaceId face;
  GeneratorId generator;
  /// Barycentric coordinates of its corners in `face`, counter-clockwise; simple, not always convex.
  std::vector<std::array<double, 3>> corners;
};

/// What a run did, and what it could not do (zero being the normal case).
struct DiagramReport {
  std::int64_t propagation_events = 0;   ///< triangles taken from fast marching's queue, or windows carried across one
  std::int64_t table_entries = 0;        ///< (triangle, generator) pairs in the generator tables; 0 without them
  std::int64_t relabelled_vertices = 0;  ///< vertices given to another generator to keep cells connected
  std::int64_t gaps = 0;                 ///< groups of faces with three or more generators
  std::int64_t gaps_grown = 0;           ///< of these, closed by growth
  std::int64_t gaps_assembled = 0;       ///< of these, closed by assembly of the edge crossings instead
  /// Faces with an exact arc that would have met itself or another one, and has lost its loops or is straight.
  std::int64_t straightened_faces = 0;
  std::int64_t unresolved_ends = 0;  ///< bisector ends that meet nothing; zero in a complete diagram
};

/// A geodesic Voronoi diagram. It owns its data and refers to the mesh by ids only.
struct Diagram {
  std::vector<SurfacePoint> generators;          ///< indexed by GeneratorId
  IdVector<VertexId, GeneratorId> vertex_label;  ///< nearest generator; invalid where none reaches
  IdVector<VertexId, double> vertex_distance;    ///< mesh units; infinity where none reaches
  IdVector<BranchPointId, BranchPoint> branch_points;
  IdVector<BisectorId, Bisector> bisectors;
  IdVector<GeneratorId, Cell> cells;
  /// The generator that owns the whole face; invalid where the face is cut or nothing reaches it.
  IdVector<FaceId, GeneratorId> face_label;
  std::vector<FacePiece> pieces;  ///< of the faces that are cut, ascending by face
  double length = 0;              ///< of all bisectors, mesh units
  DiagramReport report;
};

/// Builds the geodesic Voronoi diagram of `generators` on `mesh`.
///
/// Throws Error{precondition} where there is no generator, a generator lies in no face of the mesh, or two of them
/// coincide (both are named), or exact distances take more than 2^31 windows (100 GB), Error{invalid_option} where the
/// chord tolerance is not a finite number of at least kLeastChordTolerance or the number of threads is negative, and
/// Error{interrupted} where the progress callback cancels. May be called from several threads at once.
/// Cost: O(n log n) time, O(n) memory for n faces.
Diagram compute_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                        const DiagramOptions& options = {});

}  // namespace gvd
