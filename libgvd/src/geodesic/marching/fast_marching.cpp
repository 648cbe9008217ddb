#include "geodesic/marching/fast_marching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bucket_queue.hpp"
#include "geodesic/marching/auxiliary_distance.hpp"
#include "geodesic/marching/local_update.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Largest symbolic offset, in mean edge lengths. Mirror-symmetric models put whole bisectors exactly on edges; offsets
/// that grow with the generator's id decide every tie the same way all along. Far above rounding (1e-16 times a
/// distance of up to 1e5 edges), far below any length that shows.
constexpr double kTieOffset = 1e-9;

/// Bucket width in mean edge lengths; a triangle's key is the sum of three distances.
constexpr double kBucketWidth = 1;

/// Bound on the number of buckets: beyond it keys share the last one, which costs repeated events, not exactness.
constexpr double kMaxBuckets = 1 << 16;

/// An improvement below this part of the distance is rounding: it is not propagated again.
constexpr double kImprovement = 1e-13;

/// The corners after and before corner i of a face.
constexpr std::array<std::size_t, 3> kNext{1, 2, 0}, kPrevious{2, 0, 1};

class Marcher {
 public:
  Marcher(const WorkingMesh& working, Front front, const Progress& progress)
      : mesh_(working.mesh()),
        front_(front),
        progress_(progress),
        table_(mesh_.vertex_count(), mesh_.face_count()),
        queue_(kBucketWidth * mesh_.mean_edge_length(), bucket_count(mesh_)),
        offset_step_(kTieOffset * mesh_.mean_edge_length() / static_cast<double>(working.generator_vertices().size())) {
    place_generators(working);
  }

  FastMarchingResult run() {
    while (!queue_.empty()) {
      if (++pops_ % kProgressStride == 0) report();
      process(queue_.pop());
    }
    return {std::move(table_), offset_step_, events_};
  }

 private:
  static constexpr std::int64_t kProgressStride = 1 << 15;

  static std::size_t bucket_count(const Mesh& mesh) {
    double longest = 0;
    for (std::int32_t e = 0; e < mesh.edge_count(); ++e) longest = std::max(longest, mesh.length(EdgeId(e)));
    // One event raises a key by at most three edges.
    return static_cast<std::size_t>(std::min(kMaxBuckets, 3 * longest / (kBucketWidth * mesh.mean_edge_length()) + 3));
  }

  /// Every generator reaches the faces round its vertex along their edges.
  void place_generators(const WorkingMesh& working) {
    for (std::size_t i = 0; i < working.generator_vertices().size(); ++i) {
      const GeneratorId g(static_cast<std::int64_t>(i));
      const double offset = static_cast<double>(i + 1) * offset_step_;
      table_.add(working.vertex(g), g, offset, HalfedgeId());
      for_each_outgoing(mesh_, working.vertex(g), [&](HalfedgeId h) {
        reach_along(mesh_.to(h), g, offset + mesh_.length(h));
        reach_along(mesh_.opposite(h), g, offset + mesh_.length(Mesh::previous(h)));
        add_entry(Mesh::face(h), g);
      });
    }
  }

  void reach_along(VertexId v, GeneratorId g, double distance) {
    const std::int32_t place = table_.find(v, g);
    if (place < 0) {
      table_.add(v, g, distance, HalfedgeId());
    } else {
      table_.distance(place).distance = std::min(table_.distance(place).distance, distance);
    }
  }

  void add_entry(FaceId f, GeneratorId g) {
    if (table_.find(f, g) >= 0) return;  // two halfedges of one face leave the generator on a closed fan of one face
    const auto& [a, b, c] = mesh_.vertices(f);
    const std::int32_t e = table_.add(f, g, {table_.find(a, g), table_.find(b, g), table_.find(c, g)}, kInfinity);
    queue_.push(key(table_.entry(e)), e);
  }

  double key(const TableEntry& e) const {
    const auto d = table_.corner_distances(e);
    return d[0] + d[1] + d[2];
  }

  /// A triangle event: the domination test, then the three neighbours.
  void process(std::int32_t place) {
    TableEntry& entry = table_.entry(place);
    const double now = key(entry);
    if (!(now < entry.processed_key)) return;  // an older event of an entry that has improved since
    entry.processed_key = now;
    entry.dominated = is_dominated(entry);
    if (entry.dominated) return;
    ++events_;
    const FaceId f = entry.face;
    const std::array<std::int32_t, 3> corner = entry.corner;  // by value: new entries move the table
    const GeneratorId g = entry.generator;
    for (std::size_t side = 0; side < 3; ++side) {
      const HalfedgeId twin = mesh_.twin(Mesh::halfedge(f, static_cast<int>(side)));
      if (twin.valid()) propagate(twin, g, corner[kNext[side]], corner[side]);  // it runs the other way
    }
  }

  /// Section 4.1: another generator of the table is nearer at the three corners, and at the three midpoints.
  bool is_dominated(const TableEntry& entry) const {
    const std::int32_t head = entry.face.value();
    if (table_.entry(head).next < 0) return false;
    const auto own = table_.corner_distances(entry);
    for (std::int32_t i = head; i >= 0; i = table_.entry(i).next) {
      const TableEntry& other = table_.entry(i);
      if (other.generator == entry.generator || other.dominated) continue;
      const auto theirs = table_.corner_distances(other);
      if (theirs[0] < own[0] && theirs[1] < own[1] && theirs[2] < own[2] && dominates_midpoints(other, entry))
        return true;
    }
    return false;
  }

  bool dominates_midpoints(const TableEntry& other, const TableEntry& entry) const {
    const auto own = table_.corner_distances(entry), theirs = table_.corner_distances(other);
    const FaceShape& shape = mesh_.shape(entry.face);
    for (std::size_t i = 0; i < 3; ++i) {
      // A distance changes by half a length at the most from a corner to the midpoint.
      const std::size_t j = kNext[i];
      if (std::min(theirs[i], theirs[j]) + shape.length[i] < std::max(own[i], own[j])) continue;
      const MedianHalves halves = make_median_halves(shape, i);
      if (!(auxiliary_distance(halves, theirs, i, front_) < auxiliary_distance(halves, own, i, front_))) return false;
    }
    return true;
  }

  /// Carries generator g, whose distances stand at place_a and place_b, across halfedge h from A to B into its face, to
  /// the corner D opposite.
  void propagate(HalfedgeId h, GeneratorId g, std::int32_t place_a, std::int32_t place_b) {
    const double distance_a = table_.distance(place_a).distance, distance_b = table_.distance(place_b).distance;
    const FaceId face = Mesh::face(h);
    const auto i = static_cast<std::size_t>(h.value() - 3 * face.value());
    const VertexId d = mesh_.vertices(face)[kPrevious[i]];
    const std::int32_t neighbour = table_.find(face, g);
    std::int32_t place_d = neighbour >= 0 ? table_.entry(neighbour).corner[kPrevious[i]] : table_.find(d, g);
    bool improved = false;
    // By the triangle inequality no point of the edge is nearer than this, and so is no corner beyond it.
    const double least = 0.5 * (distance_a + distance_b - mesh_.shape(face).length[i]);
    if (place_d < 0 || table_.distance(place_d).distance > least) {
      const double distance_d = update(face, i, distance_a, distance_b);
      if (place_d < 0) {
        place_d = table_.add(d, g, distance_d, h);
      } else if (distance_d < table_.distance(place_d).distance * (1 - kImprovement)) {
        table_.distance(place_d).distance = distance_d;
        table_.distance(place_d).via = h;
        improved = true;
      }
    }
    if (neighbour < 0) {
      std::array<std::int32_t, 3> corner{};
      corner[i] = place_a;
      corner[kNext[i]] = place_b;
      corner[kPrevious[i]] = place_d;
      const std::int32_t added = table_.add(face, g, corner, kInfinity);
      queue_.push(key(table_.entry(added)), added);
    }
    if (improved) requeue_round(Mesh::previous(h), g);
  }

  /// Distance at the corner opposite side i of a face.
  double update(FaceId f, std::size_t i, double distance_a, double distance_b) const {
    const FaceShape& s = mesh_.shape(f);
    const auto t = make_update_triangle(s.length[i], s.length[kPrevious[i]], s.length[kNext[i]], s.twice_area);
    return front_ == Front::circle ? update_circle(t, distance_a, distance_b)
                                   : update_planar(t, distance_a, distance_b);
  }

  /// The distance at the vertex that h leaves improved: its triangles have to go through the queue again.
  void requeue_round(HalfedgeId h, GeneratorId g) {
    for_each_outgoing(mesh_, mesh_.from(h), [&](HalfedgeId outgoing) {
      const std::int32_t e = table_.find(Mesh::face(outgoing), g);
      if (e >= 0) queue_.push(key(table_.entry(e)), e);
    });
  }

  void report() const {
    const double share = static_cast<double>(events_) / (1.3 * mesh_.face_count());
    report_progress(progress_, "distances", std::min(0.99, share));
  }

  const Mesh& mesh_;
  Front front_;
  const Progress& progress_;
  GeneratorTable table_;
  BucketQueue<std::int32_t> queue_;
  double offset_step_;
  std::int64_t pops_ = 0, events_ = 0;
};

}  // namespace

FastMarchingResult march(const WorkingMesh& working, Front front, const Progress& progress) {
  report_progress(progress, "distances", 0);
  return Marcher(working, front, progress).run();
}

}  // namespace gvd
