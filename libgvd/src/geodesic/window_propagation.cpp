#include "geodesic/window_propagation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geodesic/bucket_queue.hpp"
#include "geodesic/saddle_fan.hpp"
#include "geodesic/window_filters.hpp"
#include "geodesic/window_lists.hpp"
#include "geodesic/window_retention.hpp"

namespace gvd {
namespace {

constexpr double kMaxBuckets = 1 << 16;
/// Windows whose images differ by less than this part of their distance, the same up to rounding, are one.
constexpr double kSameImage = 3e-13;

/// A distance must fall by this part of itself to be news.
constexpr double kNews = 4e-15;

class Propagation {
 public:
  Propagation(const Mesh& mesh, const PropagationOptions& options, const Progress& progress)
      : field_(mesh),
        frames_(field_.frames),
        fan_(frames_),
        options_(options),
        progress_(progress),
        queue_(options.bucket_width * mesh.mean_edge_length(), bucket_count(mesh, options)),
        bucket_width_(options.bucket_width * mesh.mean_edge_length()),
        waiting_(static_cast<std::size_t>(mesh.halfedge_count()), -1),
        retention_(options.keep, field_.frames, field_.distance, field_.label) {}

  WindowField run(const Mesh& mesh, const std::vector<VertexId>& generators) {
    for (std::size_t g = 0; g < generators.size(); ++g) {
      const auto v = static_cast<std::size_t>(generators[g].value());
      field_.distance.raw()[v] = 0;
      field_.label.raw()[v] = static_cast<std::int32_t>(g);
      events_.push_back({generators[g].value(), 0, {mesh.halfedge(generators[g]).value(), {}}, true});
      queue_.push(0, ~static_cast<std::int32_t>(events_.size() - 1));
    }
    while (!queue_.empty()) {
      fetch_ahead();
      const std::int32_t item = queue_.pop();
      if (item >= 0) {
        process_halfedge(item);
      } else {
        process_vertex(~item);
      }
    }
    field_.windows = retention_.finish();
    return std::move(field_);
  }

 private:
  void fetch_ahead() const {
    if (const std::int32_t* far = queue_.look_ahead(8); far && *far >= 0) {
      __builtin_prefetch(&waiting_[static_cast<std::size_t>(*far)]);
      const FaceFrame* f = &fan_.face(*far);
      __builtin_prefetch(f);
      __builtin_prefetch(reinterpret_cast<const char*>(f) + 64);
    }
    if (const std::int32_t* near = queue_.look_ahead(4); near && *near >= 0) {
      const std::int32_t place = waiting_[static_cast<std::size_t>(*near)];
      if (place >= 0) __builtin_prefetch(&pool_[place]);
    }
  }

  struct VertexEvent {
    std::int32_t vertex;
    double distance;
    FanRay back;  // towards where the path came from
    bool all_round;
  };

  static std::size_t bucket_count(const Mesh& mesh, const PropagationOptions& options) {
    double longest = 0;
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      for (const double length : mesh.shape(FaceId(f)).length) longest = std::max(longest, length);
    }
    return static_cast<std::size_t>(
        std::min(kMaxBuckets, 3 * longest / (options.bucket_width * mesh.mean_edge_length()) + 3));
  }

  double& distance(std::int32_t v) { return field_.distance.raw()[static_cast<std::size_t>(v)]; }
  std::int32_t label(std::int32_t v) const { return field_.label.raw()[static_cast<std::size_t>(v)]; }
  VertexKind kind(std::int32_t v) const { return frames_.kind.raw()[static_cast<std::size_t>(v)]; }
  bool is_flat(std::int32_t v) const { return kind(v) == VertexKind::flat; }

  /// A path to vertex v. Where it is news and v is a pseudo-source, v will send windows.
  void reach_vertex(std::int32_t v, double d, std::int32_t generator, const FanRay& back) {
    double& known = distance(v);
    if (!(d < known * (1 - kNews))) return;
    known = d;
    std::int32_t& label = field_.label.raw()[static_cast<std::size_t>(v)];
    if (label != generator) {
      if (label >= 0) mark_round(back.halfedge);
      label = generator;
    }
    if (kind(v) < VertexKind::saddle) return;
    std::int32_t place = 0;
    if (free_events_.empty()) {
      place = static_cast<std::int32_t>(events_.size());
      events_.push_back({v, d, back, false});
    } else {
      place = free_events_.back();
      free_events_.pop_back();
      events_[static_cast<std::size_t>(place)] = {v, d, back, false};
    }
    queue_.push(d, ~place);
  }

  void process_vertex(std::int32_t place) {
    const VertexEvent event = events_[static_cast<std::size_t>(place)];
    free_events_.push_back(place);
    if (event.distance > distance(event.vertex)) return;  // a shorter path came since
    if (event.all_round) {
      const std::int32_t start = event.back.halfedge;
      std::int32_t h = start;
      do {
        send(event, h, nullptr, nullptr);
        h = fan_.left_of(h);
      } while (h >= 0 && h != start);
      return;
    }
    const FanRay left = fan_.straight_left(event.back), right = fan_.straight_right(event.back);
    if (kind(event.vertex) == VertexKind::saddle) {
      send_between(event, left, right);
    } else {
      if (left.valid()) send_between(event, left, {});
      if (right.valid()) send_between(event, {}, right);
    }
  }

  /// Sends windows into the faces from `first` counter-clockwise to `last`; a ray that is not valid stands for the boundary.
  void send_between(const VertexEvent& event, const FanRay& first, const FanRay& last) {
    if (first.valid()) {
      for (std::int32_t h = first.halfedge; h >= 0; h = fan_.left_of(h)) {
        const bool is_first = h == first.halfedge, is_last = last.valid() && h == last.halfedge;
        send(event, h, is_first ? &first.angle : nullptr, is_last ? &last.angle : nullptr);
        if (is_last) return;
      }
    } else {
      for (std::int32_t h = last.halfedge; h >= 0; h = fan_.right_of(h)) {
        send(event, h, nullptr, h == last.halfedge ? &last.angle : nullptr);
      }
    }
  }

  /// Sends one window across the face of `outgoing`, between two rays; null for the face's own sides.
  void send(const VertexEvent& event, std::int32_t outgoing, const Rotation* first, const Rotation* last) {
    const FaceFrame& f = fan_.face(outgoing);
    const auto c = static_cast<std::size_t>(outgoing % 3), p = (c + 1) % 3, q = (c + 2) % 3;
    const std::int32_t generator = field_.label.raw()[static_cast<std::size_t>(event.vertex)];
    const std::int32_t base = outgoing - static_cast<std::int32_t>(c);
    if (!first || first->sine < kGrazingAngle) {
      reach_vertex(f.vertex[p], event.distance + f.length[c], generator,
                   {base + static_cast<std::int32_t>(p), {f.cosine[p], f.sine[p]}});
    }
    if (!last || (Rotation{f.cosine[c], f.sine[c]} - *last).sine < kGrazingAngle) {
      reach_vertex(f.vertex[q], event.distance + f.length[q], generator, {base + static_cast<std::int32_t>(q), {}});
    }
    const double length = f.length[p];
    const auto position = [&](const Rotation& ray) {
      const double from_p = f.length[c] * ray.sine / (ray.sine * f.cosine[p] + ray.cosine * f.sine[p]);
      return std::clamp(length - from_p, 0.0, length);
    };
    const Rays rays{last ? position(*last) : 0, first ? position(*first) : length, f.length[q] * f.cosine[q],
                    f.length[q] * f.sine[q]};
    const int joins = (!last && is_flat(f.vertex[q]) ? Window::kJoinsAtBegin : 0) |
                      (!first && is_flat(f.vertex[p]) ? Window::kJoinsAtEnd : 0);
    add_window(rays, {event.distance, generator, joins}, {base, &f, p, q});
  }

  /// Where the paths of a window come from, and whether others may join its two ends.
  struct Origin {
    double offset;
    std::int32_t generator;
    int joins;
  };
  /// Side i of a face, from corner `end` to corner `start` of a window that leaves by it.
  struct Side {
    std::int32_t base;  // the face's first halfedge
    const FaceFrame* face;
    std::size_t end, start;
  };

  /// Puts a window that leaves a face on the edge, unless it is beaten.
  void add_window(const Rays& w, const Origin& origin, const Side& side) {
    const FaceFrame& f = *side.face;
    const double length = f.length[side.end];
    const std::int32_t start = f.vertex[side.start], end = f.vertex[side.end];
    const bool empty = !(w.begin < w.end) | !(w.depth > 0);
    if (empty | is_beaten_by_start(w, origin.offset, distance(start)) |
        is_beaten_by_end(w, origin.offset, distance(end), length)) {
      return;
    }
    const std::int32_t twin = f.twin[side.end];
    ++field_.created_count;
    if (twin < 0) {
      keep(w, origin.offset, origin.generator, side.base + static_cast<std::int32_t>(side.end), start, end);
      return;
    }
    const double key = origin.offset + w.least_reach();
    std::int32_t& head = waiting_[static_cast<std::size_t>(twin)];
    if (head >= 0 && origin.joins != 0 && join(head, w, origin, length)) {
      requeue_if_earlier(head, key, twin);
      return;
    }
    const std::int32_t place = pool_.take();
    Window& added = pool_[place];
    added.rays.begin = w.begin;
    added.rays.end = w.end;
    added.rays.x = w.x;
    added.rays.depth = w.depth;
    added.offset = origin.offset;
    added.generator = origin.generator;
    added.key = static_cast<float>(key);
    added.joins = static_cast<std::uint8_t>(origin.joins);
    if (head < 0) {
      added.next = -1;
      head = place;
      queue_.push(key, twin);
    } else {
      Window& first = pool_[head];
      added.next = first.next;
      first.next = place;
      requeue_if_earlier(head, key, twin);
    }
  }

  /// The first window of a list holds the key with which the halfedge waits.
  void requeue_if_earlier(std::int32_t head, double key, std::int32_t h) {
    float& queued = pool_[head].key;
    if (!(key + bucket_width_ < static_cast<double>(queued))) return;
    queued = static_cast<float>(key);
    queue_.push(key, h);
  }

  bool join(std::int32_t head, const Rays& w, const Origin& origin, double length) {
    const double tolerance = kSameImage * (origin.offset + w.depth + std::abs(w.x));
    for (std::int32_t i = head; i >= 0; i = pool_[i].next) {
      Window& other = pool_[i];
      if (other.generator != origin.generator || other.offset != origin.offset) continue;
      if (std::abs(other.rays.x - w.x) > tolerance || std::abs(other.rays.depth - w.depth) > tolerance) continue;
      if ((origin.joins & Window::kJoinsAtBegin) && (other.joins & Window::kJoinsAtEnd) &&
          std::abs(other.rays.end - w.begin) <= 1e-9 * length) {
        other.rays.end = w.end;
        other.joins = static_cast<std::uint8_t>((other.joins & Window::kJoinsAtBegin) | (origin.joins & Window::kJoinsAtEnd));
        return true;
      }
      if ((origin.joins & Window::kJoinsAtEnd) && (other.joins & Window::kJoinsAtBegin) &&
          std::abs(other.rays.begin - w.end) <= 1e-9 * length) {
        other.rays.begin = w.begin;
        other.joins = static_cast<std::uint8_t>((other.joins & Window::kJoinsAtEnd) | (origin.joins & Window::kJoinsAtBegin));
        return true;
      }
    }
    return false;
  }

  /// A vertex that is not reached yet takes the label for the time being, so that reach_vertex sees another one coming.
  bool is_foreign(std::int32_t v, std::int32_t generator) {
    std::int32_t& known = field_.label.raw()[static_cast<std::size_t>(v)];
    if (known < 0) known = generator;
    return known != generator;
  }

  void keep(const Rays& w, double offset, std::int32_t generator, std::int32_t h, std::int32_t start, std::int32_t end) {
    if (is_foreign(start, generator) || is_foreign(end, generator)) retention_.mark_edge(h);
    retention_.add(w, offset, generator, h, queue_.front() - bucket_width_);
  }

  /// A vertex changes its label: windows on its edges may have had the old one.
  void mark_round(std::int32_t outgoing) {
    std::int32_t h = outgoing;
    do {
      retention_.mark_face(h / 3);
      h = fan_.left_of(h);
    } while (h >= 0 && h != outgoing);
    if (h == outgoing) return;
    for (h = outgoing; h >= 0; h = fan_.right_of(h)) retention_.mark_face(h / 3);
  }

  void process_halfedge(std::int32_t h) {
    std::int32_t place = waiting_[static_cast<std::size_t>(h)];
    if (place < 0) return;  // an earlier entry has done the work
    waiting_[static_cast<std::size_t>(h)] = -1;
    const FaceFrame& f = fan_.face(h);
    const auto i = static_cast<std::size_t>(h % 3);
    const std::int32_t start = f.vertex[i], end = f.vertex[(i + 1) % 3];
    while (place >= 0) {
      const Window& w = pool_[place];
      const std::int32_t next = w.next;
      pool_.free(place);  // what follows does not take it again before it has read it
      const Rays rays = w.rays;
      const Origin origin{w.offset, w.generator, w.joins};
      if (!(is_beaten_by_start(rays, origin.offset, distance(start)) |
            is_beaten_by_end(rays, origin.offset, distance(end), f.length[i]))) {
        keep(rays, origin.offset, origin.generator, h, start, end);
        cross_face(rays, origin, f, h, i);
      }
      place = next;
    }
  }

  void cross_face(const Rays& w, const Origin& origin, const FaceFrame& f, std::int32_t h, std::size_t i) {
    ++field_.window_count;
    const std::size_t right = (i + 1) % 3, left = (i + 2) % 3;
    const std::int32_t base = h - static_cast<std::int32_t>(i);
    const ApexView apex(w, f.length[left] * f.cosine[i], f.length[left] * f.sine[i]);
    if (apex.covered() || is_grazed(w, apex)) reach_apex(w, origin, f, base, i, apex);
    const bool flat = is_flat(f.vertex[left]);
    if (!apex.all_right()) {
      Origin from = origin;
      if (!apex.all_left()) from.joins = (origin.joins & Window::kJoinsAtBegin) | (flat ? Window::kJoinsAtEnd : 0);
      add_window(cross_left(w, f, i, apex), from, {base, &f, left, i});
    }
    if (!apex.all_left()) {
      Origin from = origin;
      if (!apex.all_right()) from.joins = (origin.joins & Window::kJoinsAtEnd) | (flat ? Window::kJoinsAtBegin : 0);
      add_window(cross_right(w, f, i, apex), from, {base, &f, right, left});
    }
  }

  void reach_apex(const Rays& w, const Origin& origin, const FaceFrame& f, std::int32_t base, std::size_t i, const ApexView& apex) {
    const std::size_t left = (i + 2) % 3;
    const double reach = std::sqrt(apex.squared_reach(w)), d = origin.offset + reach;
    if (!(d < distance(f.vertex[left]))) return;
    // The way back, turned from the side towards the edge's start.
    const double back_x = (w.x - apex.x) / reach, back_y = (-w.depth - apex.y) / reach;
    const double side_x = -f.cosine[i], side_y = -f.sine[i];
    const Rotation angle{side_x * back_x + side_y * back_y, side_x * back_y - side_y * back_x};
    reach_vertex(f.vertex[left], d, origin.generator, {base + static_cast<std::int32_t>(left), angle});
  }

  WindowField field_;
  const FaceFrames& frames_;
  VertexFan fan_;
  WindowPool pool_;
  PropagationOptions options_;
  const Progress& progress_;
  BucketQueue<std::int32_t> queue_;
  double bucket_width_;
  std::vector<std::int32_t> waiting_;  // [halfedge] windows that wait to cross it, the first in the queue's order ahead
  WindowRetention retention_;
  std::vector<VertexEvent> events_;
  std::vector<std::int32_t> free_events_;
};

}  // namespace

WindowField propagate_windows(const Mesh& mesh, const std::vector<VertexId>& generators,
                              const PropagationOptions& options, const Progress& progress) {
  return Propagation(mesh, options, progress).run(mesh, generators);
}

}  // namespace gvd
