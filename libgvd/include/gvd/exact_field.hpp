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
  /// Number of threads, >= 1; 0: as many as there are cores. No bit of the result depends on it.
  int threads = 0;
  /// Points farther than this, the offset included, count as unreached; mesh units, >= 0. The work ends there, and the
  /// distances up to it are the same, except in their last bits.
  double max_distance = kInfinity;
};

/// A shortest path on the surface.
struct GeodesicPath {
  std::vector<SurfacePoint> points;  ///< from the point that was asked for to the generator; neighbours share a face
  GeneratorId generator;             ///< invalid, and no points, where no generator reaches
  double length = 0;                 ///< mesh units, the generator's offset apart; infinity where no generator reaches
  /// Whether the points lead all the way to the generator. Rounding can end them at a vertex before it, where thin
  /// faces leave no shorter way; `generator` and `length` are valid nevertheless. False where no generator reaches.
  bool complete = false;
};

struct IsolineOptions {
  /// Largest difference of the distance from the level on a straight piece, in mean edge lengths, > 0.
  double chord_tolerance = 1e-4;
  int threads = 0;         ///< as in ExactFieldOptions
  Progress progress = {};  ///< may be empty
};

/// A curve of equal distance: straight pieces between points that are on the level.
struct Isoline {
  double level;                      ///< mesh units
  bool closed;                       ///< otherwise it ends on the boundary; the first point is not repeated
  std::vector<SurfacePoint> points;  ///< the nearer side on the left; neighbours share a face
};

/// Exact distances on the surface of a mesh from the nearest of several generators.
///
/// The metric is that of the polyhedron itself, not of its edges, and not an approximation: straight lines over
/// unfolded faces, round saddles and round corners of the boundary. Source: window propagation after Mitchell, Mount
/// and Papadimitriou (1987), Chen and Han (1990), Xin and Wang (2009). Properties: (1) distances are right to 1e-13 of
/// themselves, and slightly less where many faces are thin; (2) what no generator reaches is infinitely far, and has no
/// label; (3) of generators that are equally near to a vertex, to 2e-14 of the distance, the first one is its label.
/// Memory: 50 bytes a window, about 10 windows a face on curved meshes and 2 on refined flat ones, and 10 bytes a face;
/// 130 a face while it is made.
class ExactField {
 public:
  /// The mesh has to outlive this. Throws Error{precondition} where there is no generator, a generator lies in no face
  /// of the mesh, two of them coincide (both are named), there is not one offset for each or there are more than 2^31
  /// windows (100 GB); Error{invalid_option} where an offset is negative or not finite, the largest distance is
  /// negative or no number, or the number of threads is negative; Error{interrupted} where the progress callback
  /// cancels.
  /// Cost: O(windows), about 5 to 10 times that of Dijkstra's algorithm on the edges. With a largest distance O(faces)
  /// for the tables, and the windows up to it.
  ExactField(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const ExactFieldOptions& options = {});
  /// The same for generators that are curves: distances are those from the nearest point of a curve, and a path ends
  /// there. Throws what the other one and `check_curves` throw; Error{precondition} if two curves touch or cross;
  /// Error{invalid_option} if there are offsets.
  ExactField(const Mesh& mesh, const std::vector<GeneratorCurve>& curves, const ExactFieldOptions& options = {});
  ~ExactField();
  ExactField(ExactField&&) noexcept;
  ExactField& operator=(ExactField&&) noexcept;

  /// Distance of a vertex from its nearest generator, its offset included; mesh units, infinity where none reaches.
  double distance(VertexId v) const;
  /// The nearest generator of a vertex; invalid where none reaches.
  GeneratorId label(VertexId v) const;

  struct Nearest {
    double distance;        ///< mesh units, the offset included; infinity where none reaches
    GeneratorId generator;  ///< invalid where none reaches
  };
  /// The same for any surface point. Cost: O(windows on its faces).
  Nearest nearest(const SurfacePoint& point) const;

  /// A shortest path from a point to its nearest generator; see GeodesicPath::complete. To the generator `only` where
  /// it is given: the shortest one for a point of the border of its cell, to which other generators are as near.
  /// Farther outside it may be longer, or none. Cost: O(faces crossed).
  GeodesicPath path(const SurfacePoint& point, GeneratorId only = {}) const;

  /// The curves on which the distance is one of `levels`: ascending, above 0, up to the largest distance.
  ///
  /// Properties: (1) each point is on the level to 1e-12 of it: the curves are those of the exact distance, not of one
  /// interpolated between vertices, and cross an edge as often as the distance does; (2) corners, where shortest paths
  /// of two directions meet, are points of the curve; (3) a curve closes or ends on the boundary, and curves do not
  /// cross each other on edges; (4) no bit depends on the number of threads. A curve round a farthest point inside one
  /// face is left out only if the distance inside of it rises by less than the tolerance.
  /// Throws Error{invalid_option} where the levels are not as said, the tolerance is not above 0, or the curves would
  /// cross edges more than 2e7 times, which would fill the memory; Error{interrupted}. Cost: O(windows + points).
  std::vector<Isoline> isolines(const std::vector<double>& levels, const IsolineOptions& options = {}) const;

  /// The tangent vector at the nearest generator (see geodesic_tracing.hpp) in whose direction the shortest path to
  /// `point` departs, as long as the path: the logarithm of the point. Zero for the generator itself, where none
  /// reaches, where the path is not complete, and for curves.
  Vec2 departure(const SurfacePoint& point) const { return departure(path(point)); }
  Vec2 departure(const GeodesicPath& path) const;  ///< the same for a path of this field

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct VertexDistances {
  IdVector<VertexId, double>
      distance;  ///< from the nearest generator, its offset included; infinity where none reaches
  IdVector<VertexId, GeneratorId> label;  ///< that generator; invalid where none reaches
};

/// The distances and labels of the vertices, with the same bits as ExactField's, in about half of its time. Throws the
/// same errors. Memory: 130 bytes a face, since no windows are kept.
VertexDistances compute_vertex_distances(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                         const ExactFieldOptions& options = {});

VertexDistances compute_vertex_distances(const Mesh& mesh, const std::vector<GeneratorCurve>& curves,
                                         const ExactFieldOptions& options = {});

/// Distances from each source alone. Row i of `rows`, row-major, gets those of all vertices from source i, or where
/// `at` is not null those of these points. Each thread computes whole rows, so all are busy where there are many.
/// Throws what ExactField throws, and Error{invalid_option} where `rows` has not sources x points numbers or there are
/// offsets. Cost: a field for each source. Memory: 130 bytes a face for each thread, or with `at` those of a field.
void compute_distance_rows(const Mesh& mesh, const std::vector<SurfacePoint>& sources,
                           const std::vector<SurfacePoint>* at, std::span<double> rows,
                           const ExactFieldOptions& options = {});

}  // namespace gvd
