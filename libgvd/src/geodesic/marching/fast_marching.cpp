// Adapted fast marching: the distances of all generators at once, each near its own cell; and marched distances as a
// DistanceField, for the envelope tracer.
//
// All generators: an event is a triangle and a generator. It carries the generator's distances across the triangle's
// edges to the corners opposite. A generator that another one dominates in a triangle does not propagate from there, so
// that the work is O(n) for any number of generators. The order matters: a generator may cross a triangle before the
// arrival of another one that would have stopped it. The tables therefore depend on the order, and so do the distances
// outside the cells. The order of each queue is the same on every machine.
// Field: if the distances of a generator at the two ends of a side come from a point source, they determine its image
// beyond that side. The table of each face thus becomes three images for each generator.
// Source: section 4.1 of the paper, with the test of section 3 for a defeated generator. The local update is that of
// Kimmel and Sethian (1998), or the one by a circle.
// Invariant: a vertex has one distance for each generator, which all faces round it share and which only falls. An
// image has the two distances from which it was unfolded, and its paths enter through the side between them.
#include "geodesic/marching/fast_marching.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/bucket_queue.hpp"
#include "geodesic/marching/local_update.hpp"
#include "geodesic/marching/marched_distances.hpp"
#include "geodesic/marching/unfold.hpp"
#include "gvd/diagram_steps.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Width of a bucket in mean edge lengths. A triangle's key is the sum of three distances. If all triangles shared one
/// bucket, which is first in first out, there would be 8 % more table entries (spot, 30 generators).
constexpr double kMarchBucketWidth = 1;

/// Largest number of buckets. Larger keys share the last bucket, which costs repeated events but no exactness.
constexpr double kMostMarchBuckets = 1 << 16;

/// Least improvement of a distance that is propagated, relative to the distance. With buckets, smaller improvements are
/// rounding. In the paper's order, the faces round a vertex where thousands of needles meet would improve each other by
/// less and less without end, and each improvement would queue all of them again. A millionth is far below the error of
/// a linear front, and limits the number of improvements of a distance from a to b to 1e6 ln(a / b).
constexpr double kImprovement = 1e-13, kImprovementInOrder = 1e-6;

/// The corners after and before corner i of a face.
constexpr std::array<std::size_t, 3> kNext{1, 2, 0}, kPrevious{2, 0, 1};

/// The paper's priority queue: the least key first, and of equal keys the least item.
class PriorityQueue {
 public:
  bool empty() const { return heap_.empty(); }
  void push(double key, std::int32_t item) { heap_.emplace(key, item); }
  std::int32_t pop() {
    const std::int32_t item = heap_.top().second;
    heap_.pop();
    return item;
  }

 private:
  using Waiting = std::pair<double, std::int32_t>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> heap_;
};

BucketQueue<std::int32_t> make_buckets(const Mesh& mesh) {
  const double width = kMarchBucketWidth * mesh.mean_edge_length();
  // One event raises a key by at most three edges.
  return {width, static_cast<std::size_t>(std::min(kMostMarchBuckets, 3 * longest_edge(mesh) / width + 3))};
}

template <class Queue>
class Marcher {
 public:
  Marcher(const WorkingMesh& working, Front front, const Progress& progress, Queue queue)
      : working_(working),
        mesh_(working.mesh()),
        front_(front),
        progress_(progress),
        table_(mesh_.vertex_count(), mesh_.face_count()),
        queue_(std::move(queue)),
        offset_(SymbolicOffset::of_marching(mesh_.mean_edge_length(), working.generator_vertices().size())) {
    place_generators();
  }

  FastMarchingResult run() {
    while (!queue_.empty()) {
      if (++pops_ % kProgressStride == 0) report();
      process(queue_.pop());
    }
    return {std::move(table_), offset_, events_};
  }

 private:
  static constexpr std::int64_t kProgressStride = 1 << 15;

  /// Gives every generator its distances on the faces round its vertex, along their edges.
  void place_generators() {
    for (const GeneratorId g : working_.generator_vertices().ids()) {
      const double offset = offset_.of(g);
      table_.add(working_.vertex(g), g, offset, HalfedgeId());
      for_each_outgoing(mesh_, working_.vertex(g), [&](HalfedgeId h) {
        table_.lower(mesh_.to(h), g, offset + mesh_.length(h));
        table_.lower(mesh_.opposite(h), g, offset + mesh_.length(Mesh::previous(h)));
        add_entry(Mesh::face(h), g);
      });
    }
  }

  void add_entry(FaceId f, GeneratorId g) {
    if (table_.find(f, g) >= 0) return;  // two halfedges of the face leave g if its closed fan has one face
    const auto& [a, b, c] = mesh_.vertices(f);
    const std::int32_t e = table_.add(f, g, {table_.find(a, g), table_.find(b, g), table_.find(c, g)}, kInfinity);
    queue_.push(key(table_.entry(e)), e);
  }

  /// The key of a table entry: equation (5) of the paper.
  double key(const TableEntry& e) const {
    const auto d = table_.corner_distances(e);
    return d[0] + d[1] + d[2];
  }

  /// Handles the event of one triangle and generator: the domination test, then the three neighbours.
  void process(std::int32_t index) {
    TableEntry& entry = table_.entry(index);
    const double current = key(entry);
    if (!(current < entry.processed_key)) return;  // the entry has improved since this event was queued
    entry.processed_key = current;
    entry.dominated = is_dominated(entry);
    if (entry.dominated) return;
    ++events_;
    const FaceId f = entry.face;
    const std::array<std::int32_t, 3> corner = entry.corner;  // a copy: adding entries moves the table
    const GeneratorId g = entry.generator;
    for (int side = 0; side < 3; ++side) {
      const HalfedgeId twin = mesh_.twin(Mesh::halfedge(f, side));
      if (twin.valid()) propagate(twin, g, corner[kNext[side]], corner[side]);  // the twin has the other direction
    }
  }

  /// Whether another generator of the face is nearer at all corners: equation (3). Then it is nearer at the midpoints
  /// of the edges, too, because no update decreases when its distances grow (property (4) in local_update.hpp).
  bool is_dominated(const TableEntry& entry) const {
    const std::int32_t head = entry.face.value();
    if (table_.entry(head).next < 0) return false;
    const auto own = table_.corner_distances(entry);
    for (std::int32_t i = head; i >= 0; i = table_.entry(i).next) {
      const TableEntry& other = table_.entry(i);
      if (other.generator == entry.generator || other.dominated) continue;
      const auto others = table_.corner_distances(other);
      if (others[0] < own[0] && others[1] < own[1] && others[2] < own[2]) return true;
    }
    return false;
  }

  /// Carries generator g across halfedge h, which runs from A to B, into h's face, to its opposite corner D. `index_a`
  /// and `index_b` are the table's indices of g's distances at A and B.
  void propagate(HalfedgeId h, GeneratorId g, std::int32_t index_a, std::int32_t index_b) {
    const double distance_a = table_.distance(index_a).distance, distance_b = table_.distance(index_b).distance;
    const FaceId face = Mesh::face(h);
    const std::size_t i = Mesh::corner(h);
    const VertexId d = mesh_.vertices(face)[kPrevious[i]];
    const std::int32_t neighbour = table_.find(face, g);
    std::int32_t index_d = neighbour >= 0 ? table_.entry(neighbour).corner[kPrevious[i]] : table_.find(d, g);
    const auto update = [&] {
      return update_by(front_over(g, index_a, index_b), make_update_triangle(mesh_.shape(face), i), distance_a,
                       distance_b);
    };
    bool improved = false;
    // By the triangle inequality no point of the edge is nearer than this, and no corner beyond the edge.
    const double least = 0.5 * (distance_a + distance_b - mesh_.shape(face).length[i]);
    if (index_d < 0) {
      index_d = table_.add(d, g, update(), h);
    } else if (table_.distance(index_d).distance > least) {
      improved = improve(table_.distance(index_d), update(), h);
    }
    if (neighbour < 0) {
      std::array<std::int32_t, 3> corner{};
      corner[i] = index_a;
      corner[kNext[i]] = index_b;
      corner[kPrevious[i]] = index_d;
      const std::int32_t added = table_.add(face, g, corner, kInfinity);
      queue_.push(key(table_.entry(added)), added);
    }
    if (improved) requeue_around(Mesh::previous(h), g);
  }

  /// Replaces a vertex's distance by a shorter one. Returns false, and changes nothing, if it is not shorter by more
  /// than the least improvement.
  static bool improve(VertexDistance& at_vertex, double distance, HalfedgeId via) {
    constexpr double kLeast = std::is_same_v<Queue, PriorityQueue> ? kImprovementInOrder : kImprovement;
    if (!(distance < at_vertex.distance * (1 - kLeast))) return false;
    at_vertex.distance = distance;
    at_vertex.via = via;
    return true;
  }

  /// The front that carries generator g over an edge, whose ends have the distances at these indices. A generator
  /// inside a face has only three neighbours (four on an edge), and a planar front is least accurate next to its
  /// source. Over the edges of the generator's face, a circle front is therefore used even with planar fronts: it is
  /// exact there, so that the generator has six exact distances around it, as a generator at a vertex has.
  Front front_over(GeneratorId g, std::int32_t index_a, std::int32_t index_b) const {
    const bool next_to_source = !table_.distance(index_a).via.valid() && !table_.distance(index_b).via.valid();
    return next_to_source && working_.vertex(g).value() >= working_.input().vertex_count() ? Front::circle : front_;
  }

  /// Queues the faces round the vertex that h leaves, after its distance has improved.
  void requeue_around(HalfedgeId h, GeneratorId g) {
    for_each_outgoing(mesh_, mesh_.from(h), [&](HalfedgeId outgoing) {
      const std::int32_t e = table_.find(Mesh::face(outgoing), g);
      if (e >= 0) queue_.push(key(table_.entry(e)), e);
    });
  }

  void report() const {
    const double share = double(events_) / (1.3 * mesh_.face_count());
    report_progress(progress_, steps::kDistances, std::min(0.99, share));
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  Front front_;
  const Progress& progress_;
  GeneratorTable table_;
  Queue queue_;
  SymbolicOffset offset_;
  std::int64_t pops_ = 0, events_ = 0;
};

}  // namespace

FastMarchingResult march(const WorkingMesh& working, Front front, const Progress& progress) {
  report_progress(progress, steps::kDistances, 0);
  return Marcher(working, front, progress, make_buckets(working.mesh())).run();
}

FastMarchingResult march_in_order(const WorkingMesh& working, Front front, const Progress& progress) {
  report_progress(progress, steps::kDistances, 0);
  return Marcher(working, front, progress, PriorityQueue()).run();
}

const VertexDistance& MarchedDistances::nearest(VertexId v) const {
  const VertexDistance* best = &table_.distance(v.value());
  table_.for_each(v, [&](const VertexDistance& d) {
    if (std::tie(d.distance, d.generator) < std::tie(best->distance, best->generator)) best = &d;
  });
  return *best;
}

std::vector<EdgeId> MarchedDistances::contested_edges(const ParallelChunks& parallel) const {
  const auto has_several = [&](HalfedgeId h) {
    const FaceId f = Mesh::face(h);
    return table_.reached(f) && table_.entry(f.value()).next >= 0;
  };
  return find_edges(mesh_, parallel, [&](EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
    return has_several(h) || (twin.valid() && has_several(twin));
  });
}

void MarchedDistances::collect(EdgeId e, std::vector<EdgeSource>& sources) const {
  sources.clear();
  const HalfedgeId h = mesh_.halfedge(e);
  const double length = mesh_.length(h);
  const VertexDistance &from = nearest(mesh_.from(h)), &to = nearest(mesh_.to(h));
  sources.push_back({0, length, 0, 0, from.distance, from.generator});
  sources.push_back({0, length, length, 0, to.distance, to.generator});
  for (const HalfedgeId side : {h, mesh_.twin(h)}) {
    if (!side.valid()) continue;
    table_.for_each(Mesh::face(side), [&](const TableEntry& entry) {
      if (entry.dominated) return;
      const auto d = table_.corner_distances(entry);
      const int i = Mesh::corner(side), j = (i + 1) % 3;
      const double a = side == h ? d[i] : d[j], b = side == h ? d[j] : d[i];
      const double x = apex_foot(length, a, b);
      // Distances that break the triangle inequality have no image: only the paths along the edge remain.
      if (std::abs(x) <= a) sources.push_back({0, length, x, std::sqrt((a - x) * (a + x)), 0, entry.generator});
    });
  }
}

void MarchedDistances::collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const {
  sources.clear();
  const auto& corner = layout.corner;
  for (int i = 0; i < 3; ++i) {
    const VertexDistance& v = nearest(mesh_.vertices(f)[i]);
    sources.push_back(FaceSource::corner(corner[i], v.distance, v.generator, Mesh::halfedge(f, i)));
  }
  table_.for_each(f, [&](const TableEntry& entry) {
    const auto d = table_.corner_distances(entry);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Vec2 image = unfold_source(corner[i], corner[j], d[i], d[j]);
      sources.push_back({image, corner[i], corner[j], 0, entry.generator, Mesh::halfedge(f, i),
                         FaceSource::Kind::window, d[i], d[j]});
    }
  });
}

}  // namespace gvd
