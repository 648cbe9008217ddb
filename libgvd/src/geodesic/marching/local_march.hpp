#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/bucket_queue.hpp"
#include "geodesic/marching/march_fans.hpp"
#include "gvd/front.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Distances from one point, propagated only as far as they are below a bound at each vertex.
///
/// Many runs share one work space, so that the cost of a run depends on the vertices that it reaches, not on the size
/// of the mesh. Memory: about 130 bytes a face.
class LocalMarch {
 public:
  /// The mesh must outlive this object. `progress` is passed to MarchFans. Cost: O(n).
  LocalMarch(const Mesh& mesh, Front front, const Progress& progress = {});

  /// Marches from `start` over the vertices whose distance is below `limit`, and below (*upper)[p] if `upper` is given.
  /// The vertices round these get distances, too, because they improve the distances inside.
  ///
  /// The march is label-correcting: the distances are a fixed point of the updates.
  /// If updates lower each other without end, it stops close to one. Cost: O(k log k) for k vertices reached.
  void run(const SurfacePoint& start, double limit, const IdVector<PlaceId, double>* upper = nullptr);

  /// `watch` is called now and then during a run, with the number of vertices that it has reached. It may throw; then
  /// this march can't be used any more.
  void watch_runs(std::function<void(std::size_t reached)> watch) { watch_ = std::move(watch); }

  /// The fans, which map vertices to places.
  const MarchFans& fans() const { return fans_; }
  /// The vertices that the last run reached, each once, in the order in which it first reached them.
  const std::vector<PlaceId>& reached() const { return reached_; }
  /// Mesh units; infinity at vertices that the last run did not reach.
  double distance(PlaceId p) const { return nodes_[p].run == run_ ? nodes_[p].distance : kInfinity; }
  double distance(VertexId v) const { return distance(fans_.place(v)); }
  /// The distance at any point, computed from the distances at the corners of its face; in the faces of the start, it
  /// is the length of a straight line. Infinity in faces that the last run did not reach. Cost: O(1).
  double distance(const SurfacePoint& point) const;

 private:
  struct Node {
    double distance;
    std::int32_t run;
    std::int32_t improvements;  // number of improvements in that run
  };
  struct Event {
    double distance;
    PlaceId place;
    VertexId vertex;
    /// A standard heap with this order returns the least distance first, then the least id.
    bool operator<(const Event& other) const {
      return distance > other.distance || (distance == other.distance && vertex > other.vertex);
    }
  };

  void place_start(const SurfacePoint& start);
  void place_corner(VertexId v, double distance);
  void reach(PlaceId p, double distance);
  std::optional<Event> next_event();
  void open_bucket();
  bool is_outdated(const Event& event) const { return event.distance != nodes_[event.place].distance; }
  bool is_below_bound(PlaceId p, double distance) const {
    return distance < limit_ && (upper_ == nullptr || distance < (*upper_)[p]);
  }
  void relax(PlaceId p);

  const Mesh& mesh_;
  MarchFans fans_;
  Front front_;
  IdVector<PlaceId, Node> nodes_;
  std::int32_t run_ = 0;
  double limit_ = 0;
  const IdVector<PlaceId, double>* upper_ = nullptr;
  std::vector<FaceId> start_faces_;
  std::vector<PlaceId> start_corners_;
  Vec3 start_position_ = Vec3::Zero();
  std::vector<PlaceId> reached_;
  BucketQueue<Event> later_;
  std::vector<Event> soon_;  // a heap
  std::function<void(std::size_t)> watch_;
  std::size_t events_ = 0;
};

}  // namespace gvd
