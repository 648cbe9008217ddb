#include "geodesic/window_propagation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geodesic/bucket_queue.hpp"
#include "geodesic/saddle_fan.hpp"
#include "geodesic/waiting_windows.hpp"
#include "geodesic/window_filters.hpp"

namespace gvd {
namespace {

/// Bucket width in mean edge lengths. Between 0.5 and 2 the time is the same.
constexpr double kBucketWidth = 0.8;

/// The same where there are needles: they bring many vertices within one edge's length of each other, and each one that
/// is taken out of its turn sends windows that are in vain. With a hundredth of the width they are an eighth.
constexpr double kFineBucketWidth = 0.01;

/// Bound on the number of buckets: beyond it keys share the last one, which costs repeated events, not exactness.
constexpr double kMaxBuckets = 1 << 16;

class Propagation {
 public:
  Propagation(const Mesh& mesh, const PropagationOptions& options, const Progress& progress)
      : mesh_(mesh),
        progress_(progress),
        field_(mesh),
        fan_(field_.frames),
        has_needles_(field_.frames.has_needles),
        bucket_width_((has_needles_ ? kFineBucketWidth : kBucketWidth) * mesh.mean_edge_length()),
        queue_(bucket_width_, bucket_count(mesh, bucket_width_)),
        waiting_(static_cast<std::size_t>(mesh.halfedge_count()), bucket_width_),
        apex_path_(has_needles_ ? static_cast<std::size_t>(mesh.halfedge_count()) : 0),
        retention_(options.keep, field_) {}

  WindowField run(const std::vector<VertexId>& generators, const std::vector<double>& offsets) {
    for (std::size_t g = 0; g < generators.size(); ++g) {
      start_vertex(generators[g], GeneratorId(static_cast<std::int64_t>(g)), offsets.empty() ? 0 : offsets[g]);
    }
    for (std::int64_t pops = 1; !queue_.empty(); ++pops) {
      if (pops % kProgressStride == 0) report();
      const std::int32_t item = queue_.pop();
      if (item >= 0) {
        cross_halfedge(item);
      } else {
        send_from_vertex(~item);
      }
    }
    forget_unreached_labels();
    field_.windows = retention_.finish();
    return std::move(field_);
  }

 private:
  static constexpr std::int64_t kProgressStride = 1 << 14;

  /// A pseudo-source that was reached, or a generator: it will send windows.
  struct VertexEvent {
    std::int32_t vertex;
    bool all_round;  // a generator, or a blurred vertex
    double distance;
    FanRay back;  // towards where the path came from
  };

  /// Side `end` of a face: from corner `end` to corner `start` of a window that leaves by it.
  struct Side {
    std::int32_t base;  // the face's first halfedge
    const FaceFrame* face;
    std::size_t end, start;
  };

  static std::size_t bucket_count(const Mesh& mesh, double width) {
    double longest = 0;
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      for (const double length : mesh.shape(FaceId(f)).length) longest = std::max(longest, length);
    }
    // From a window to the one that it becomes, or to a vertex and its windows, the key rises by two edges at the most.
    return static_cast<std::size_t>(std::min(kMaxBuckets, 3 * longest / width + 3));
  }

  double& distance(std::int32_t v) { return field_.distance[VertexId(v)]; }
  std::int32_t label(std::int32_t v) const { return field_.label[VertexId(v)].value(); }
  VertexKind kind(std::int32_t v) const { return field_.frames.kind[VertexId(v)]; }
  bool is_flat(std::int32_t v) const { return kind(v) == VertexKind::flat; }

  /// Windows will start from v in all directions.
  void start_vertex(VertexId v, GeneratorId g, double d) {
    if (!(d < field_.distance[v])) return;
    field_.distance[v] = d;
    field_.label[v] = g;
    push_event({v.value(), true, d, {}});
  }

  void push_event(const VertexEvent& event) {
    if (free_events_.empty()) {
      free_events_.push_back(static_cast<std::int32_t>(events_.size()));
      events_.emplace_back();
    }
    const std::int32_t place = free_events_.back();
    free_events_.pop_back();
    events_[static_cast<std::size_t>(place)] = event;
    queue_.push(event.distance, ~place);
  }

  /// A path to vertex v. Where it is news and paths can bend at v, v will send windows.
  void reach_vertex(std::int32_t v, double d, std::int32_t generator, const FanRay& back) {
    if (!is_news(d, distance(v))) return;
    distance(v) = d;
    if (label(v) != generator) {
      if (label(v) >= 0) retention_.mark_vertex(fan_, back.halfedge);
      field_.label[VertexId(v)] = GeneratorId(generator);
    }
    if (kind(v) >= VertexKind::saddle) push_event({v, kind(v) == VertexKind::blurred, d, back});
  }

  void send_from_vertex(std::int32_t place) {
    const VertexEvent event = events_[static_cast<std::size_t>(place)];
    free_events_.push_back(place);
    if (event.distance > distance(event.vertex)) return;  // a shorter path came since
    ++field_.events;
    if (event.all_round) {
      send_all_round(event);
      return;
    }
    const FanRay left = fan_.straight_left(event.back), right = fan_.straight_right(event.back);
    if (kind(event.vertex) == VertexKind::saddle) {
      if (left.valid() && right.valid()) {
        send_between(event, left, right);
      } else {
        send_all_round(event);  // rounding hides where straight on is
      }
    } else {
      if (left.valid()) send_between(event, left, {});
      if (right.valid()) send_between(event, {}, right);
    }
  }

  void send_all_round(const VertexEvent& event) {
    const std::int32_t start = mesh_.halfedge(VertexId(event.vertex)).value();
    std::int32_t h = start;
    do {
      send(event, h, nullptr, nullptr);
      h = fan_.left_of(h);
    } while (h >= 0 && h != start);
  }

  /// Sends windows from `first` counter-clockwise to `last`; an invalid ray stands for the boundary.
  void send_between(const VertexEvent& event, const FanRay& first, const FanRay& last) {
    if (first.valid()) {
      for (std::int32_t h = first.halfedge; h >= 0; h = fan_.left_of(h)) {
        const bool ends = last.valid() && h == last.halfedge;
        send(event, h, h == first.halfedge ? &first.angle : nullptr, ends ? &last.angle : nullptr);
        if (ends) return;
      }
    } else {
      for (std::int32_t h = last.halfedge; h >= 0; h = fan_.right_of(h)) {
        send(event, h, nullptr, h == last.halfedge ? &last.angle : nullptr);
      }
    }
  }

  /// Sends a window across the face of `outgoing`, and distances along those of its sides that lie between the rays.
  void send(const VertexEvent& event, std::int32_t outgoing, const Rotation* first, const Rotation* last) {
    const FaceFrame& f = fan_.face(outgoing);
    const auto c = static_cast<std::size_t>(outgoing % 3), p = (c + 1) % 3, q = (c + 2) % 3;
    const std::int32_t generator = label(event.vertex), base = outgoing - static_cast<std::int32_t>(c);
    if (!first || first->is_grazing()) {
      reach_vertex(f.vertex[p], event.distance + f.length[c], generator,
                   {base + static_cast<std::int32_t>(p), {f.cosine[p], f.sine[p]}});
    }
    if (!last || (fan_.corner(outgoing) - *last).is_grazing()) {
      reach_vertex(f.vertex[q], event.distance + f.length[q], generator, {base + static_cast<std::int32_t>(q), {}});
    }
    const int joins =
        (!last && is_flat(f.vertex[q]) ? Origin::kAtBegin : 0) | (!first && is_flat(f.vertex[p]) ? Origin::kAtEnd : 0);
    add_window(send_rays(f, c, first, last), {event.distance, generator, 1, base / 3, static_cast<std::uint8_t>(joins)},
               {base, &f, p, q});
  }

  /// Puts a window that leaves a face on the edge, unless it can hold no shortest path.
  void add_window(const Rays& w, const Origin& origin, const Side& side) {
    const FaceFrame& f = *side.face;
    const double length = f.length[side.end];
    const std::int32_t start = f.vertex[side.start], end = f.vertex[side.end];
    const bool by_start = is_beaten_by_start(w, origin.offset, distance(start));
    const bool by_end = is_beaten_by_end(w, origin.offset, distance(end), length);
    if (is_empty(w) | by_start | by_end) return;  // no shortcuts: branches that can't be foretold cost more
    if (has_needles_ && is_left_to_ends(w, origin, start, end, length)) return;
    const std::int32_t twin = f.twin[side.end];
    if (twin < 0) {
      keep(w, origin, side.base + static_cast<std::int32_t>(side.end), start, end);
      return;
    }
    const double key = origin.offset + w.least_reach();
    if (waiting_.add(twin, w, origin, length, key)) queue_.push(key, twin);
  }

  bool is_left_to_ends(const Rays& w, const Origin& origin, std::int32_t start, std::int32_t end, double length) {
    return (kind(start) == VertexKind::blurred &&
            is_left_to_vertex(origin.offset, distance(start), w.end, w.squared_reach(w.end))) ||
           (kind(end) == VertexKind::blurred &&
            is_left_to_vertex(origin.offset, distance(end), length - w.begin, w.squared_reach(w.begin)));
  }

  void keep(const Rays& w, const Origin& origin, std::int32_t h, std::int32_t start, std::int32_t end) {
    const bool foreign_start = is_foreign(start, origin.generator), foreign_end = is_foreign(end, origin.generator);
    if (foreign_start || foreign_end) retention_.mark_edge(h);
    retention_.add(w, origin, h, queue_.front() - bucket_width_);
  }

  /// A vertex that is not reached yet takes the label for the time being, so that reach_vertex sees when another one
  /// comes.
  bool is_foreign(std::int32_t v, std::int32_t generator) {
    GeneratorId& known = field_.label[VertexId(v)];
    if (!known.valid()) known = GeneratorId(generator);
    return known.value() != generator;
  }

  void cross_halfedge(std::int32_t h) {
    const FaceFrame& f = fan_.face(h);
    const auto i = static_cast<std::size_t>(h % 3);
    waiting_.take(h, [&](const Rays& rays, const Origin& origin) {
      if (has_needles_ && is_crossed_twice(origin, h / 3, mesh_.face_count())) return;
      keep(rays, origin, h, f.vertex[i], f.vertex[(i + 1) % 3]);
      cross_face(rays, origin, f, h - static_cast<std::int32_t>(i), i);
    });
  }

  void cross_face(const Rays& w, const Origin& origin, const FaceFrame& f, std::int32_t base, std::size_t i) {
    ++field_.carried;
    const std::size_t right = (i + 1) % 3, top = (i + 2) % 3;
    const ApexView apex(w, f.length[top] * f.cosine[i], f.length[top] * f.sine[i]);
    Exits exits{!apex.all_right(), !apex.all_left()};
    if (apex.covered() || is_grazed(w, apex, f.length[i])) {
      const double reach = std::sqrt(apex.squared_reach(w));
      reach_apex(w, origin, f, base, i, apex, reach);
      if (has_needles_ && apex.covered())
        exits = split_at_apex(w, origin, f, base + static_cast<std::int32_t>(i), apex, reach);
    }
    if (std::isinf(distance(f.vertex[top]))) reach_apex_along_sides(f, base, i);
    // Where the apex splits the window, the two parts may join again behind it.
    const int split = is_flat(f.vertex[top]) ? Origin::kAtBegin | Origin::kAtEnd : 0;
    Origin next = origin;
    if (has_needles_ && is_milestone(++next.crossed)) next.milestone = base / 3;
    if (exits.left) {
      const int at_end = apex.all_left() ? origin.joins : split;
      next.joins = static_cast<std::uint8_t>((origin.joins & Origin::kAtBegin) | (at_end & Origin::kAtEnd));
      add_window(cross_left(w, f, i, apex), next, {base, &f, top, i});
    }
    if (exits.right) {
      const int at_begin = apex.all_right() ? origin.joins : split;
      next.joins = static_cast<std::uint8_t>((at_begin & Origin::kAtBegin) | (origin.joins & Origin::kAtEnd));
      add_window(cross_right(w, f, i, apex), next, {base, &f, right, top});
    }
  }

  /// The sides of the face that a window which covers the apex goes on to.
  Exits split_at_apex(const Rays& w, const Origin& origin, const FaceFrame& f, std::int32_t h, const ApexView& apex,
                      double reach) {
    const ApexPath own{origin.offset + reach, w.x + (apex.x - w.x) * w.depth / (w.depth + apex.y)};
    const double tolerance = kSameRay * reach + kRounding * f.length[static_cast<std::size_t>(h % 3)];
    return exits_beside(apex_path_[static_cast<std::size_t>(h)], own, tolerance);
  }

  void reach_apex(const Rays& w, const Origin& origin, const FaceFrame& f, std::int32_t base, std::size_t i,
                  const ApexView& apex, double reach) {
    const std::size_t top = (i + 2) % 3;
    const double d = origin.offset + reach;
    if (!(d < distance(f.vertex[top]))) return;
    // The way back, turned from the side towards the edge's start.
    const double back_x = (w.x - apex.x) / reach, back_y = (-w.depth - apex.y) / reach;
    const Rotation angle{-f.cosine[i] * back_x - f.sine[i] * back_y, -f.cosine[i] * back_y + f.sine[i] * back_x};
    reach_vertex(f.vertex[top], d, origin.generator, {base + static_cast<std::int32_t>(top), angle});
  }

  /// Paths along the sides, so that no window ever stands on an edge with an end that is not reached: it would have
  /// nothing to be beaten by. What the propagation does ends for that reason, whatever rounding does.
  void reach_apex_along_sides(const FaceFrame& f, std::int32_t base, std::size_t i) {
    const std::size_t right = (i + 1) % 3, top = (i + 2) % 3;
    const std::int32_t start = f.vertex[i], end = f.vertex[right], outgoing = base + static_cast<std::int32_t>(top);
    reach_vertex(f.vertex[top], distance(start) + f.length[top], label(start), {outgoing, {}});
    reach_vertex(f.vertex[top], distance(end) + f.length[right], label(end), {outgoing, {f.cosine[top], f.sine[top]}});
  }

  void forget_unreached_labels() {
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (std::isinf(distance(v))) field_.label[VertexId(v)] = GeneratorId();
    }
  }

  void report() const {
    const double share = static_cast<double>(field_.carried) / (10.0 * mesh_.face_count());
    report_progress(progress_, "distances", share / (1 + share));
  }

  const Mesh& mesh_;
  const Progress& progress_;
  WindowField field_;
  VertexFan fan_;
  bool has_needles_;
  double bucket_width_;
  BucketQueue<std::int32_t> queue_;  // halfedges where windows wait, and ~places of vertex events
  WaitingWindows waiting_;
  std::vector<ApexPath> apex_path_;  // [halfedge into the face]; empty without needles
  WindowRetention retention_;
  std::vector<VertexEvent> events_;
  std::vector<std::int32_t> free_events_;
};

}  // namespace

WindowField propagate_windows(const Mesh& mesh, const std::vector<VertexId>& generators,
                              const PropagationOptions& options, const Progress& progress) {
  report_progress(progress, "distances", 0);
  return Propagation(mesh, options, progress).run(generators, options.offsets);
}

}  // namespace gvd
