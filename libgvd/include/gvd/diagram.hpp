#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gvd/front.hpp"
#include "gvd/generator_curve.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The algorithm that computes distances.
enum class Solver {
  windows,        ///< exact distances on the polyhedron, by window propagation
  fast_marching,  ///< the paper's adapted fast marching (section 4.1)
};

/// The algorithm that turns distances into bisectors.
enum class Tracer {
  envelope,  ///< the lower envelope of the distances, on edges and in faces: as exact as the distances
  growth,    ///< the paper's refinement by unfolding, and growth (sections 4.2 and 4.3), improved
  paper,     ///< sections 4.2 and 4.3 exactly as in the paper, for comparisons
};

/// Any solver works with any tracer; three of the combinations have a name.
struct Method {
  Solver solver;
  Tracer tracer;

  bool operator==(const Method&) const = default;
  static const Method exact;  ///< windows and envelope: the diagram of the exact polyhedral metric
  static const Method gbgvd;  ///< fast marching and growth: the paper's method, improved
  static const Method paper;  ///< the paper's method step by step, with planar fronts unless the options name another
};
inline constexpr Method Method::exact{Solver::windows, Tracer::envelope};
inline constexpr Method Method::gbgvd{Solver::fast_marching, Tracer::growth};
inline constexpr Method Method::paper{Solver::fast_marching, Tracer::paper};
inline const Choices<Method> kMethodNames{{"exact", Method::exact}, {"gbgvd", Method::gbgvd}, {"paper", Method::paper}};

/// The least chord tolerance, in mean edge lengths. Distances have a relative error of about 1e-13, and a point can be
/// 10 to 100 times as far from the bisector as its two distances differ, so that below this limit rounding decides.
inline constexpr double kLeastChordTolerance = 1e-10;

struct DiagramOptions {
  Method method = Method::exact;
  std::optional<Front> front;  ///< the front of fast marching; if empty, the one of `chosen_front`
  /// Largest distance of a bisector's segments from the curve, in mean edge lengths, >= kLeastChordTolerance. Only the
  /// envelope tracer uses it. The number of points grows with the square root of its inverse.
  double chord_tolerance = 1e-4;
  /// Additive weight of each generator, mesh units, positive or negative. It is added to all distances from the
  /// generator, so that a larger weight makes the cell smaller. Only differences between weights matter. If empty, all
  /// weights are 0. Only Method::exact accepts weights.
  std::vector<double> weights = {};
  /// Number of threads, >= 1, or 0 for one per core. The result is bit-identical for any number.
  int threads = 0;
  Progress progress;  ///< may be empty

  /// `front` or, if it is empty, the front of the method: planar for Method::paper, circle for all others.
  Front chosen_front() const { return front.value_or(method == Method::paper ? Front::planar : Front::circle); }
};

/// A point that belongs to three or more cells.
struct BranchPoint {
  SurfacePoint point;
  Vec3 position;                        ///< mesh units
  std::vector<GeneratorId> generators;  ///< 3 or more, counter-clockwise around the point
  double distance = 0;                  ///< mean distance to the generators, their weights included; mesh units
};

/// A bisector: the polyline between two cells, from end to end.
struct Bisector {
  GeneratorId left;   ///< the cell on the left along `points`, seen from outside the surface
  GeneratorId right;  ///< the cell on the right
  bool closed = false;
  /// The branch points at its two ends; invalid for an end on the mesh's boundary, and for a closed bisector.
  std::array<BranchPointId, 2> ends;
  /// Points in order, both ends included; a closed bisector does not repeat its first point. Consecutive points share a
  /// face.
  std::vector<SurfacePoint> points;
};

/// The points of the surface that are nearest to one generator.
struct Cell {
  GeneratorId generator;
  double area = 0;                        ///< square mesh units
  std::int32_t euler_characteristic = 0;  ///< 1 for a disc, 0 for an annulus, 2 for a sphere
  std::int32_t components = 0;            ///< 1 if the cell is connected
  std::int32_t boundary_loops = 0;        ///< loops made of bisectors and of the mesh's boundary
  std::vector<GeneratorId> neighbours;    ///< cells with a bisector in common; ascending, each once, without itself

  bool is_disc() const { return components == 1 && euler_characteristic == 1; }
};

/// A polygon inside one face that belongs to one cell.
struct FacePiece {
  FaceId face;
  GeneratorId generator;
  /// Barycentric coordinates of its corners in `face`, counter-clockwise; simple, not always convex.
  std::vector<std::array<double, 3>> corners;
};

/// Counts the faces of the input by the number of different nearest generators of their corners (sections 3 and 4.4 of
/// the paper). Faces that no generator reaches are in none of the three classes.
struct FaceClassCounts {
  std::int64_t trivial = 0;    ///< n1: one generator
  std::int64_t ordinary = 0;   ///< n2: two
  std::int64_t branching = 0;  ///< n3: three
};

/// Figures of a run. `straightened_faces` and `unresolved_ends`, which count failures, are normally 0.
struct DiagramReport {
  std::int64_t propagation_events = 0;  ///< faces taken from fast marching's queue, or windows propagated across a face
  std::int64_t table_entries = 0;       ///< (face, generator) pairs in the generator tables; 0 without tables
  FaceClassCounts face_classes;
  std::int64_t relabelled_vertices = 0;  ///< vertices that got another label so that cells are connected
  std::int64_t gaps = 0;                 ///< connected sets of faces with three or more generators
  std::int64_t gaps_grown = 0;           ///< gaps that growth closed
  std::int64_t gaps_assembled = 0;       ///< gaps that assembly of the edge crossings closed
  /// Faces in which an exact arc would have intersected itself or another arc, so that its loops were cut off or it was
  /// made straight.
  std::int64_t straightened_faces = 0;
  /// Largest difference of the distances to the two generators of an arc in these faces, mesh units; 0 if there are
  /// none.
  double straightened_error = 0;
  std::int64_t unresolved_ends = 0;  ///< ends of bisectors neither at a branch point nor on the boundary
};

/// A geodesic Voronoi diagram. It owns its data and refers to the mesh by ids only. `check_diagram` (gvd/check.hpp)
/// lists its invariants, and tests them.
struct Diagram {
  std::vector<SurfacePoint> generators;          ///< indexed by GeneratorId; for a curve, its first point
  std::vector<GeneratorCurve> curves;            ///< the generators if they are curves; empty if they are points
  std::vector<double> weights;                   ///< DiagramOptions::weights, mesh units; empty if there were none
  IdVector<VertexId, GeneratorId> vertex_label;  ///< nearest generator; invalid if none reaches the vertex
  /// Distance to the nearest generator, even if the vertex was relabelled; mesh units, infinity if none reaches the
  /// vertex.
  IdVector<VertexId, double> vertex_distance;
  IdVector<BranchPointId, BranchPoint> branch_points;
  IdVector<BisectorId, Bisector> bisectors;
  IdVector<GeneratorId, Cell> cells;
  /// The generator of the whole face; invalid if the face is cut into pieces or no generator reaches it.
  IdVector<FaceId, GeneratorId> face_label;
  std::vector<FacePiece> pieces;  ///< the pieces of all faces that are cut, ascending by face
  double length = 0;              ///< total length of the bisectors, mesh units
  DiagramReport report;

  /// The weight of generator g; 0 without weights or without a generator.
  double weight(GeneratorId g) const { return weights.empty() || !g.valid() ? 0 : weights[g.index()]; }
};

/// Builds the geodesic Voronoi diagram of `generators` on `mesh`.
///
/// Properties: (1) `check_diagram` finds no violation, unless `report.unresolved_ends` is above 0; (2) the result is
/// bit-identical for any number of threads; (3) with Method::exact, the vertices' distances are exact up to rounding,
/// and a bisector's segments are at most the chord tolerance away from the exact curve, except in faces that
/// `report.straightened_faces` counts; (4) components of the mesh without a generator have no labels, pieces or
/// bisectors.
///
/// Throws Error{precondition} if there is no generator, a generator lies in no face of the mesh, two generators
/// coincide (the message names both), the weights give a generator's own position to another generator (`element` of
/// the error is the generator), or exact distances need more than 2^31 windows (100 GB).
/// Throws Error{invalid_option} if the chord tolerance is not a finite number of at least kLeastChordTolerance, the
/// number of threads is negative, the weights are not one finite number for each generator, or there are weights with
/// another method than Method::exact. Throws Error{interrupted} if the progress callback cancels.
/// `gvd/diagram_steps.hpp` lists the steps of progress. Several threads may call this at once.
/// Cost: O(n log n) time, O(n) memory for n faces.
Diagram compute_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                        const DiagramOptions& options = {});

/// The same for generators that are curves: a cell is the set of points that are nearest to one curve. It contains its
/// curve, so that it may be an annulus or have more holes. The bisector of two segments consists of straight lines and
/// parabolas, and is refined to the same chord tolerance.
///
/// Throws what the function above and `check_curves` throw; Error{precondition} if two curves touch or cross (the
/// message names both); Error{invalid_option} for another method than Method::exact, or if there are weights.
Diagram compute_diagram(const Mesh& mesh, const std::vector<GeneratorCurve>& curves,
                        const DiagramOptions& options = {});

}  // namespace gvd
