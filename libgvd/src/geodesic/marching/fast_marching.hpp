#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "geodesic/generator_table.hpp"
#include "geodesic/symbolic_offset.hpp"
#include "gvd/front.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

struct FastMarchingResult {
  GeneratorTable table;
  SymbolicOffset offset;    ///< contained in the table's distances
  std::int64_t events = 0;  ///< triangle events that propagated
};

/// Computes the distances from all generators at once. An event is a triangle and a generator; events are handled in
/// nearly ascending order of the sum of the three corner distances. Every triangle has a table of the generators that
/// may be nearest in a part of it. A generator does not propagate from a triangle in which another one dominates it.
///
/// Source: section 4.1 of the paper. Deviations: each distance is stored once per vertex and generator, so that
/// neighbouring triangles can't disagree; an improved distance queues the triangles round its vertex again; a ring of
/// buckets replaces the priority queue, so that an event may come before others that are nearer by a mean edge length.
/// Throws: gvd::Error (interrupted) where `progress` cancels. Cost: O(n) events on average.
FastMarchingResult march(const WorkingMesh& working, Front front, const Progress& progress);

/// The same with the paper's priority queue: the event with the least sum is always the next one. Which generators are
/// stopped, and where, may differ. Cost: O(n log n).
FastMarchingResult march_in_order(const WorkingMesh& working, Front front, const Progress& progress);

/// Distances from one point, propagated only as far as they are below a bound at each vertex.
///
/// Many runs share one work space. So the cost of a run depends on the vertices that it reaches, not on the size of the
/// mesh. Memory: 8 bytes a face.
class LocalMarch {
 public:
  /// The mesh has to outlive this.
  LocalMarch(const Mesh& mesh, Front front) : mesh_(mesh), front_(front), nodes_(mesh.vertex_count(), Node{0, 0, 0}) {}

  /// Marches from `start` over the vertices whose distance is below `limit`, and below (*upper)[v] where `upper` is
  /// given. The ring of vertices round these gets distances too, because they improve those inside.
  ///
  /// The march is label-correcting: the distances are a fixed point of the updates.
  /// If updates lower each other without end, it stops close to one. Cost: O(k log k) for k vertices reached.
  void run(const SurfacePoint& start, double limit, const IdVector<VertexId, double>* upper = nullptr);

  /// `watch` is called now and then during a run, with the number of vertices that it has reached. It may throw.
  void watch_runs(std::function<void(std::size_t reached)> watch) { watch_ = std::move(watch); }

  /// The vertices that the last run reached, each once, in the order in which it first reached them.
  const std::vector<VertexId>& reached() const { return reached_; }
  /// Mesh units; infinity at vertices that the last run did not reach.
  double distance(VertexId v) const { return nodes_[v].run == run_ ? nodes_[v].distance : kInfinity; }
  /// Distance at any point, from those at the corners of its face; along a straight line in the faces of the start.
  /// Infinity in faces that the last run did not reach. Cost: O(1).
  double distance(const SurfacePoint& point) const;

 private:
  struct Node {
    double distance;
    std::int32_t run;
    std::int32_t improvements;  // number of them in that run
  };
  struct Event {
    double distance;
    VertexId vertex;
    /// Least distance first in a standard heap, then least id.
    bool operator<(const Event& other) const {
      return distance > other.distance || (distance == other.distance && vertex > other.vertex);
    }
  };

  void place_start(const SurfacePoint& start);
  void reach(VertexId v, double distance);
  /// The corners of a face that v relaxes, and whether the other one was reached before.
  struct Beyond {
    VertexId v, other, apex;
    bool has_other;
  };

  bool is_below_bound(VertexId v) const;
  void relax(VertexId v);
  void reach_beyond(HalfedgeId base, HalfedgeId side, const Beyond& at, bool propagates);
  /// Distance at the corner opposite h, from those at the ends of h. Both must be reached.
  double update(HalfedgeId h) const;

  const Mesh& mesh_;
  Front front_;
  IdVector<VertexId, Node> nodes_;
  std::int32_t run_ = 0;
  double limit_ = 0;
  const IdVector<VertexId, double>* upper_ = nullptr;
  std::vector<FaceId> start_faces_;
  std::vector<VertexId> start_corners_;
  Vec3 start_position_ = Vec3::Zero();
  std::vector<VertexId> reached_;
  std::vector<Event> heap_;
  std::function<void(std::size_t)> watch_;
  std::size_t events_ = 0;
};

}  // namespace gvd
