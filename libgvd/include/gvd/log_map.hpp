#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Where the corners of some faces lie in the tangent plane of a point.
struct LogMap {
  /// For every face asked for, the tangent vectors of its three corners (see geodesic_tracing.hpp): the direction in
  /// which the shortest path leaves the point, and its length, in mesh units. Infinite where nothing reaches.
  std::vector<std::array<Vec2, 3>> corners;
  bool complete = true;  ///< every corner is reached
};

/// Computes log maps round surface points of one mesh. It keeps its scratch memory between calls, so a map costs what
/// its faces cost, whatever the size of the mesh.
class LogMapSolver {
 public:
  /// The mesh must outlive the solver. Cost: O(n) memory.
  explicit LogMapSolver(const Mesh& mesh);

  /// The log map of `origin` over `faces` (each once). Paths may use these, the faces that touch them and the faces
  /// round the origin.
  ///
  /// Distances spread by unfolding a point source out of two known ones, and the direction at a new vertex divides that
  /// between the two in the ratio of the unfolded angles.
  /// Source: Melvaer and Reimers, "Geodesic polar coordinates on polygonal meshes" (2012). Where theirs keeps the
  /// smallest value ever met, the values here are computed again, in the order of distance, until they stand: a value
  /// that came out of a preliminary, too long distance may be too short. Properties: (1) exact on a flat patch where
  /// straight lines from the origin stay in it; (2) corners of the faces round the origin are exact unless a shorter
  /// way leads round; (3) deterministic. Throws Error{precondition} where the origin's face does not exist. Cost: O(k
  /// log k) for k faces.
  LogMap compute(const SurfacePoint& origin, const std::vector<FaceId>& faces);

 private:
  struct Polar {
    double distance;
    double angle;
  };
  struct VertexState {
    Polar value;
    Polar direct;  // straight through a face round the origin; infinite elsewhere
    bool accepted;
    bool stale;  // a value beside it has changed since its own was computed
  };

  void open_patch(const SurfacePoint& origin, const std::vector<FaceId>& faces);
  void open_round(VertexId v);
  void open_face(FaceId f);
  void start(const SurfacePoint& origin);
  void march();
  void spread(VertexId v);
  void offer(VertexId v, double distance);
  void settle();
  Polar best(VertexId v, bool accepted_only) const;
  template <class Visit>
  void for_each_halfedge(VertexId v, Visit visit) const;

  const Mesh& mesh_;
  std::int32_t turn_ = 0;  // stamp of the current call
  IdVector<FaceId, std::int32_t> face_stamp_;
  IdVector<VertexId, std::int32_t> vertex_stamp_;
  IdVector<VertexId, VertexState> state_;
  std::vector<std::pair<double, VertexId>> queue_;
  std::vector<VertexId> order_;  // accepted vertices
};

/// The log map of `origin` over the whole mesh, indexed by face. Cost: O(n log n).
LogMap compute_log_map(const Mesh& mesh, const SurfacePoint& origin);

}  // namespace gvd
