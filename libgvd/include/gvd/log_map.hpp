#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The positions of the corners of some faces in the tangent plane of a point.
struct LogMap {
  /// For every face requested, the tangent vectors of its three corners (see geodesic_tracing.hpp): the direction in
  /// which the shortest path leaves the point, times its length in mesh units. Infinite without a path.
  std::vector<std::array<Vec2, 3>> corners;
  bool complete = true;  ///< there is a path to every corner
};

/// Computes log maps round surface points of one mesh. It keeps its work space between calls, so the cost of a map
/// depends on its faces only, not on the size of the mesh.
class LogMapSolver {
 public:
  /// The mesh must outlive the solver. Cost: O(n) memory.
  explicit LogMapSolver(const Mesh& mesh);

  /// The log map of `origin` over `faces`, which are all different. Paths may use the patch: these faces, those that
  /// touch them, and the faces round the origin.
  ///
  /// The distance at a vertex follows from those at two others of a face by unfolding a point source. Its direction
  /// divides the angle between theirs in the ratio of the unfolded angles.
  /// Source: Melvaer and Reimers, "Geodesic polar coordinates on polygonal meshes" (2012). Deviation: they keep the
  /// smallest value found for a vertex; here all values are updated, in the order of distance, until they converge. A
  /// value that follows from a preliminary, too long distance may be too short.
  /// Properties: (1) exact on a flat patch that contains the straight lines from the origin; (2) exact at the corners of
  /// the faces round the origin, unless a path outside of these faces is shorter; (3) deterministic.
  /// Throws Error{precondition} if the origin's face does not exist. Cost: O(k log k) for k faces.
  LogMap compute(const SurfacePoint& origin, const std::vector<FaceId>& faces);

 private:
  struct Polar {
    double distance;
    double angle;
  };
  struct VertexState {
    Polar value;
    Polar direct;  // along the segment in a face round the origin; infinite at other vertices
    bool accepted;
    bool stale;  // a neighbour's value has changed since this one was computed
  };

  void check_origin(const SurfacePoint& origin) const;
  void open_patch(const SurfacePoint& origin, const std::vector<FaceId>& faces);
  void open_faces_round(VertexId v);
  void open_face(FaceId f);
  void start(const SurfacePoint& origin);
  void march();
  void offer_to_neighbours(VertexId v);
  void offer_through(HalfedgeId base);
  void offer(VertexId v, double distance);
  void converge();
  Polar compute_value(VertexId v, bool accepted_only) const;
  LogMap collect(const std::vector<FaceId>& faces) const;
  bool is_in_patch(FaceId f) const { return face_stamp_[f] == call_; }

  const Mesh& mesh_;
  std::int32_t call_ = 0;  // number of the current call; the stamps of what belongs to its patch
  IdVector<FaceId, std::int32_t> face_stamp_;
  IdVector<VertexId, std::int32_t> vertex_stamp_;
  IdVector<VertexId, VertexState> state_;
  std::vector<std::pair<double, VertexId>> queue_;
  std::vector<VertexId> order_;  // accepted vertices, in order; while the patch is opened: its vertices
};

/// The log map of `origin` over the whole mesh; `corners` is indexed by face. Cost: O(n log n).
LogMap compute_log_map(const Mesh& mesh, const SurfacePoint& origin);

}  // namespace gvd
