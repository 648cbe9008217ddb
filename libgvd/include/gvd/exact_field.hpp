#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gvd/generator_curve.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

struct ExactFieldOptions {
  /// Distance at which each generator starts, in mesh units, >= 0: an additive weight. Empty: 0 for all.
  std::vector<double> offsets = {};
  Progress progress = {};  ///< may be empty
  /// Number of threads, >= 1, or 0 for one per core. The result is bit-identical for any number.
  int threads = 0;
  /// Points farther than this, offsets included, count as unreached; mesh units, >= 0. Propagation stops there. The
  /// distances up to it are the same as without this limit, except in their last bits.
  double max_distance = kInfinity;
};

/// A shortest path on the surface.
struct GeodesicPath {
  std::vector<SurfacePoint> points;  ///< from the given point to the generator; consecutive points share a face
  GeneratorId generator;             ///< invalid, and there are no points, if no generator reaches the given point
  double length = 0;                 ///< mesh units, without the generator's offset; infinity if no generator reaches
  /// Whether the points lead all the way to the generator. In thin faces, rounding can end them early, at a vertex from
  /// which no shorter way is found; `generator` and `length` are valid nevertheless. False if no generator reaches the
  /// given point.
  bool complete = false;
};

struct IsolineOptions {
  /// Largest difference between the distance of a point on a straight piece and the level, in mean edge lengths, > 0.
  double chord_tolerance = 1e-4;
  int threads = 0;         ///< as in ExactFieldOptions
  Progress progress = {};  ///< may be empty
};

/// A curve of equal distance, approximated by straight pieces between points that lie on it.
struct Isoline {
  double level;  ///< mesh units
  bool closed;   ///< if false, it ends on the boundary; a closed isoline does not repeat its first point
  std::vector<SurfacePoint> points;  ///< smaller distances are on the left; consecutive points share a face
};

/// Exact distances on the surface of a mesh from the nearest of several generators.
///
/// The metric is that of the polyhedron itself. It is not approximated, by paths along edges for instance: shortest
/// paths are straight lines over unfolded faces, which bend only at saddle vertices and at corners of the boundary.
/// Source: window propagation after Mitchell, Mount and Papadimitriou (1987), Chen and Han (1990), Xin and Wang (2009).
///
/// Properties: (1) distances have a relative error of at most 1e-13, or slightly more if many faces are thin; (2) a
/// point that no generator reaches has the distance infinity and no label; (3) if several generators are equally near
/// to a vertex, within 2e-14 of the distance, its label is the first of them; (4) the result is bit-identical for any
/// number of threads; (5) const functions may be called by several threads at once.
/// Memory: 50 bytes a window, with about 10 windows a face on curved meshes and 2 on refined flat ones, and 10 bytes a
/// face. Construction takes 130 bytes a face.
class ExactField {
 public:
  /// Computes the distances from points. The mesh must outlive the field.
  ///
  /// Throws Error{precondition} if there is no generator, a generator lies in no face of the mesh, two generators
  /// coincide (the message names both), the number of offsets is not the number of generators, or there are more than
  /// 2^31 windows (100 GB); Error{invalid_option} if an offset is negative or not finite, the largest distance is
  /// negative or not a number, or the number of threads is negative; Error{interrupted} if the progress callback
  /// cancels.
  /// Cost: O(windows), about 5 to 10 times that of Dijkstra's algorithm on the edges. With a largest distance, O(faces)
  /// for the tables, and the windows up to that distance.
  ExactField(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const ExactFieldOptions& options = {});
  /// Computes the distances from curves: those from the nearest point of a curve, where a path ends, too. Throws what
  /// the other constructor and `check_curves` throw; Error{precondition} if two curves touch or cross;
  /// Error{invalid_option} if there are offsets.
  ExactField(const Mesh& mesh, const std::vector<GeneratorCurve>& curves, const ExactFieldOptions& options = {});
  ~ExactField();
  ExactField(ExactField&&) noexcept;
  ExactField& operator=(ExactField&&) noexcept;

  /// The distance of a vertex from its nearest generator, the offset included; mesh units, infinity if none reaches it.
  double distance(VertexId v) const;
  /// The nearest generator of a vertex; invalid if none reaches it.
  GeneratorId label(VertexId v) const;

  struct Nearest {
    double distance;        ///< mesh units, the offset included; infinity if no generator reaches the point
    GeneratorId generator;  ///< invalid where none reaches
  };
  /// The distance and the nearest generator of any surface point. Cost: O(windows on its faces).
  Nearest nearest(const SurfacePoint& point) const;

  /// A shortest path from a point to its nearest generator; see GeodesicPath::complete. With `only`, the path leads to
  /// that generator instead. It is a shortest path if the point lies on the border of that generator's cell, where
  /// other generators are equally near; farther outside, it may be longer than the shortest path, or there is none.
  /// Cost: O(faces crossed).
  GeodesicPath path(const SurfacePoint& point, GeneratorId only = {}) const;

  /// The curves on which the distance is one of `levels`: ascending, above 0, up to the largest distance.
  ///
  /// Properties: (1) the distance of each point differs from the level by at most 1e-12 of it: the curves are level
  /// sets of the exact distance, not of values interpolated between vertices, and cross an edge as often as the
  /// distance takes the level on it; (2) corners, where shortest paths of two directions meet, are points of the curve;
  /// (3) a curve closes or ends on the boundary, and curves do not cross each other on edges; (4) the result is
  /// bit-identical for any number of threads; (5) a curve round a farthest point inside one face is left out only if
  /// the distance inside it rises by less than the tolerance.
  /// Throws Error{invalid_option} if the levels are out of order or out of range, the tolerance is not above 0, or the
  /// curves would cross edges more than 2e7 times, which would fill the memory; Error{interrupted} if the progress
  /// callback cancels. Cost: O(windows + points).
  std::vector<Isoline> isolines(const std::vector<double>& levels, const IsolineOptions& options = {}) const;

  /// The logarithm of a point: the tangent vector at its nearest generator (see geodesic_tracing.hpp) that has the
  /// direction in which the shortest path to the point departs, and the length of the path. It is zero for the
  /// generator itself, if no generator reaches the point, if the path is not complete, and if the generators are
  /// curves.
  Vec2 departure(const SurfacePoint& point) const { return departure(path(point)); }
  Vec2 departure(const GeodesicPath& path) const;  ///< the same for a path of this field

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct VertexDistances {
  IdVector<VertexId, double> distance;    ///< from the nearest generator, its offset included; infinity if none reaches
  IdVector<VertexId, GeneratorId> label;  ///< that generator; invalid if none reaches
};

/// Computes the distances and labels of the vertices alone.
///
/// Properties: (1) they have the same bits as those of an ExactField, and take about half of its time; (2) no windows
/// are kept, so that 130 bytes a face are enough. Throws what ExactField throws.
VertexDistances compute_vertex_distances(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                         const ExactFieldOptions& options = {});

/// The same for generators that are curves, as in ExactField.
VertexDistances compute_vertex_distances(const Mesh& mesh, const std::vector<GeneratorCurve>& curves,
                                         const ExactFieldOptions& options = {});

/// Computes the distances from each source separately. Row i of `rows`, which is row-major, receives the distances from
/// source i to all vertices or, if `at` is not null, to those points. Each thread computes whole rows, so that all
/// threads are busy if there are many sources.
/// Throws what ExactField throws, and Error{invalid_option} if the size of `rows` is not sources x points, or there are
/// offsets. Cost: that of one field per source. Memory: 130 bytes a face for each thread or, with `at`, the memory of a
/// field.
void compute_distance_rows(const Mesh& mesh, const std::vector<SurfacePoint>& sources,
                           const std::vector<SurfacePoint>* at, std::span<double> rows,
                           const ExactFieldOptions& options = {});

}  // namespace gvd
