// Reads a window field for tracers and users: sources on edges and in faces, tables of generators, shortest paths, and
// the logarithm of any point: the distance to its nearest generator, and the direction in which the path leaves it.
//
// Idea: a kept window is an image with an interval, so it is a source of its edge, and of the face that it enters. The
// ends of an edge and the corners of a face are sources too: shortest paths can come through them. A path is traced
// back: the best source of the point's faces shows where the path enters the face, and its image. The line towards the
// image crosses face after face until it meets the vertex that the image is of. From a pseudo-source it goes on in the
// same way, so only the windows at the bends are read.
// Windows also carry the angle at which their paths leave the generator. In the plane of a face, a ray from an image
// differs from the window's side by an angle that the tangent plane shares. So a logarithm needs no tracing back.
// Source: the windows and paths of Mitchell, Mount and Papadimitriou (1987); the tables of section 4.1 of the paper;
// docs/developer/lloyd.md, "Departures", whose tangent planes are scaled as Polthier and Schmies (1998) do.
// Invariant: where windows were kept, the least of the sources' distances is exact, and each one is a path's length.
// Each vertex of a path is nearer to the generator than the one before, so that the path ends. `images_` are those that
// reach the face entered last, corners first, windows in their order.
#include "geodesic/windows/window_queries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "gvd/diagram_steps.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Progress is reported once every so many faces.
constexpr std::int32_t kTableStride = 1 << 12;

/// The length of generator g's shortest path to p among these sources.
double least_distance(const std::vector<FaceSource>& sources, GeneratorId g, const Vec2& p) {
  double least = kInfinity;
  for (const FaceSource& s : sources) {
    if (s.generator == g) least = std::min(least, s.distance(p));
  }
  return least;
}

/// A line that passes a corner at no more than this angle, in radians, ends there. The path continues with the
/// corner's own shortest path. Otherwise rounding could lead the line past the wrong side of the corner at which its
/// window ends. Far above the rounding error of an image (1e-13), far below the angle to another corner.
constexpr double kAtCorner = 1e-9;

/// Vertices with more faces keep the way on from them. Few meshes have any, so that the memo is mostly empty.
constexpr int kManyFaces = 64;

/// A straight line towards an image, at the point where it crosses a halfedge into the halfedge's face.
struct Step {
  HalfedgeId halfedge;
  double t;    // from the halfedge's start, mesh units
  Vec2 image;  // in the frame of the halfedge, its face above
};

class PathTracer {
 public:
  PathTracer(const Mesh& mesh, const WindowField& field, PathMemo& memo) : mesh_(mesh), field_(field), memo_(memo) {}

  GeodesicPath trace(const SurfacePoint& start, GeneratorId only) {
    path_.points.push_back(start);
    path_.generator = only;
    for (const FaceId f : faces_around(mesh_, start)) look_from(f, start);
    path_.length = best_distance_;
    path_.generator = std::isinf(best_distance_) ? GeneratorId() : best_.generator;
    if (!path_.generator.valid()) return std::move(path_);
    for (VertexId v = follow_best(); v.valid() && !is_on_generator(v);) {
      look_from(v);
      if (std::isinf(best_distance_)) return std::move(path_);  // rounding hides the continuation
      const VertexId nearer = follow_best();
      if (!nearer.valid()) break;  // on a segment of a curve
      // Rounding again: the path would never end.
      if (!(field_.distance[nearer] < field_.distance[v])) return std::move(path_);
      v = nearer;
    }
    path_.complete = true;
    return std::move(path_);
  }

 private:
  /// Whether a path ends at a vertex: the generator, or a vertex of it if it is a curve.
  bool is_on_generator(VertexId v) const { return v == memo_.end(path_.generator) || field_.distance[v] == 0; }

  /// Looks for a shorter path to p through face f. If p is the vertex `reached`, the path must continue from there: it
  /// must come from a vertex nearer to the generator, and across the opposite edge or along a side.
  void look_from(FaceId f, const SurfacePoint& p, VertexId reached = VertexId()) {
    collect_face_sources(mesh_, field_, f, sources_);
    const Vec2 at = *locate_in_face(mesh_, f, p);
    for (const FaceSource& s : sources_) {
      if (reached.valid() && !(s.offset < field_.distance[reached])) continue;
      if (reached.valid() && !s.is_corner && mesh_.opposite(s.halfedge) != reached) continue;
      if (path_.generator.valid() && s.generator != path_.generator) continue;
      const double d = s.distance(at);
      if (!(d < best_distance_)) continue;
      best_ = s;
      best_distance_ = d;
      best_point_ = at;
    }
  }

  /// Looks for the way on from a vertex.
  void look_from(VertexId v) {
    const PathMemo::Key key(v, path_.generator);
    if (const auto known = memo_.find(key)) {
      best_ = known->source;
      best_distance_ = known->distance;
      best_point_ = known->at;
      return;
    }
    best_distance_ = kInfinity;
    int faces = 0;
    for_each_outgoing(mesh_, v, [&](HalfedgeId h) {
      ++faces;
      look_from(Mesh::face(h), edge_point(h, 0), v);
    });
    if (faces > kManyFaces) memo_.add(key, {best_, best_distance_, best_point_});
  }

  /// Follows the best path to the vertex from which it comes; to none if it comes from a segment of a curve, where it
  /// ends.
  VertexId follow_best() {
    if (best_.is_corner) return go_to(best_.halfedge);
    const FaceLayout layout(mesh_, Mesh::face(best_.halfedge));
    const int i = Mesh::corner(best_.halfedge);
    const Vec2 origin = layout.corner[i], along = layout.side(i);
    const Vec2 entry = best_.entry(best_point_), image = best_.origin(entry) - origin;
    const double length = mesh_.length(best_.halfedge), t = along.dot(entry - origin);
    if (best_.is_parallel() && begins_at(best_.halfedge, std::abs(cross(along, image)))) {
      return end_on_segment(best_.halfedge, t);
    }
    // In the frame of the opposite halfedge, the edge runs the other way.
    Step step{mesh_.twin(best_.halfedge), length - t, {length - along.dot(image), std::abs(cross(along, image))}};
    for (;;) {
      const double fraction = step.t / mesh_.length(step.halfedge);
      if (fraction <= kAtCorner) return go_to(step.halfedge);
      if (fraction >= 1 - kAtCorner) return go_to(Mesh::next(step.halfedge));
      const SurfacePoint crossing = edge_point(step.halfedge, fraction);
      path_.points.push_back(make_surface_point(crossing.face, crossing.bary));
      const VertexId v = advance(step);
      if (v.valid() || !step.halfedge.valid()) return v;
    }
  }

  /// Whether parallel paths begin on the edge of a halfedge, so far from which their beginning lies. Rounding of a
  /// path's direction over its faces leaves the beginning beside the edge.
  bool begins_at(HalfedgeId h, double outside) const {
    if (outside > kAtCorner * mesh_.length(h)) return false;
    bool begins = false;
    field_.windows.for_each(h, [&](const Window& w) { begins |= w.begins_here(); });
    return begins;
  }
  VertexId end_on_segment(HalfedgeId h, double t) {
    const SurfacePoint end = edge_point(h, std::clamp(t / mesh_.length(h), 0.0, 1.0));
    path_.points.push_back(make_surface_point(end.face, end.bary));
    return VertexId();
  }

  /// Ends a line at the vertex that `outgoing` leaves.
  VertexId go_to(HalfedgeId outgoing) {
    const VertexId v = mesh_.from(outgoing);
    const SurfacePoint& last = path_.points.back();
    if (last.kind() != SurfacePoint::Kind::vertex || vertex(mesh_, last) != v) {
      path_.points.push_back(edge_point(outgoing, 0));
    }
    return v;
  }

  /// Crosses one face. Returns the vertex at which the line ends, or advances the step to the next face.
  VertexId advance(Step& step) {
    const HalfedgeId k = step.halfedge;
    const FaceFrame f = make_face_frame(mesh_, Mesh::face(k));
    const int i = Mesh::corner(k);
    const double left = f.length[(i + 2) % 3], base = f.length[i];
    const Vec2 apex(left * f.cosine[i], left * f.sine[i]), at(step.t, 0);
    const double beside = cross(step.image - at, apex - at);
    if (std::abs(beside) <= kAtCorner * (step.image - at).norm() * (apex - at).norm()) return go_to(Mesh::previous(k));
    const bool to_right = beside > 0;
    const HalfedgeId side = to_right ? Mesh::next(k) : Mesh::previous(k);
    const Vec2 origin = to_right ? Vec2(base, 0) : apex, target = to_right ? apex : Vec2(0, 0);
    const double length = mesh_.length(side);
    const Vec2 along = (target - origin) / length;
    const double inside = cross(along, at - origin), outside = -cross(along, step.image - origin);
    if (best_.is_parallel() && begins_at(side, std::abs(outside))) {
      step.halfedge = HalfedgeId();
      return end_on_segment(side, along.dot(step.image - origin));
    }
    if (!mesh_.twin(side).valid()) return go_to(Mesh::previous(k));  // it grazes a boundary corner
    // The vertex lies in this face and rounding led past it: the line would never end.
    if (outside < -kAtCorner * length) return go_to(nearest_corner(k, step.image, base, apex));
    const double from_x = along.dot(at - origin), image_x = along.dot(step.image - origin);
    const double fraction = inside + outside > 0 ? inside / (inside + outside) : 0;
    const double t = std::clamp(from_x + fraction * (image_x - from_x), 0.0, length);
    step = {mesh_.twin(side), length - t, {length - image_x, outside}};
    return VertexId();
  }

  /// The halfedge that leaves the corner nearest to p, in the frame of halfedge k.
  static HalfedgeId nearest_corner(HalfedgeId k, const Vec2& p, double base, const Vec2& apex) {
    const double to_start = p.squaredNorm(), to_end = (p - Vec2(base, 0)).squaredNorm();
    const double to_apex = (p - apex).squaredNorm();
    if (to_apex <= std::min(to_start, to_end)) return Mesh::previous(k);
    return to_start <= to_end ? k : Mesh::next(k);
  }

  const Mesh& mesh_;
  const WindowField& field_;
  PathMemo& memo_;
  GeodesicPath path_;
  std::vector<FaceSource> sources_;
  FaceSource best_{};
  double best_distance_ = kInfinity;
  Vec2 best_point_ = Vec2::Zero();
};

/// The tangent angle of a halfedge of the working mesh that leaves the fan's generator.
double tangent_angle(const WorkingMesh& working, const TangentFan& fan, HalfedgeId h) {
  const FaceId face = Mesh::face(h), parent = working.parent(face);
  const FaceLayout layout(working.input(), parent);
  const std::array<Bary, 3>& corners = working.corners(face);
  const int from = Mesh::corner(h);
  return fan.angle(parent, layout.at(corners[(from + 1) % 3]) - layout.at(corners[from]));
}

/// The number of windows by which the cache is filled ahead: those of one or two faces.
constexpr std::size_t kAhead = 16;

}  // namespace

void collect_edge_sources(const Mesh& mesh, const WindowField& field, HalfedgeId h, std::vector<EdgeSource>& sources) {
  sources.clear();
  const double length = mesh.length(h);
  const VertexId from = mesh.from(h), to = mesh.to(h);
  if (field.label[from].valid()) sources.push_back({0, length, 0, 0, field.distance[from], field.label[from]});
  if (field.label[to].valid()) sources.push_back({0, length, length, 0, field.distance[to], field.label[to]});
  const HalfedgeId twin = mesh.twin(h);
  if (twin.valid()) {
    field.windows.for_each(h, [&](const Window& w) {
      if (w.is_parallel()) {
        sources.push_back(EdgeSource::parallel(w.begin, w.end, w.x, w.offset, w.generator));
      } else {
        sources.push_back({w.begin, w.end, w.x, w.depth, w.offset, w.generator});
      }
    });
  }
  field.windows.for_each(twin.valid() ? twin : h, [&](const Window& w) {
    if (w.is_parallel()) {
      sources.push_back(EdgeSource::parallel(length - w.end, length - w.begin, -w.x, w.distance(length), w.generator));
    } else {
      sources.push_back({length - w.end, length - w.begin, length - w.x, w.depth, w.offset, w.generator});
    }
  });
}

void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f, const FaceLayout& layout,
                          std::vector<FaceSource>& sources) {
  sources.clear();
  const std::array<Vec2, 3> side{layout.side(0), layout.side(1), layout.side(2)};
  field.windows.for_each(f, [&](const Window& w) {
    const HalfedgeId h = w.halfedge;
    if (!mesh.twin(h).valid() && !w.begins_here()) return;  // the boundary: the paths leave the face
    const int i = Mesh::corner(h);
    const Vec2 &origin = layout.corner[i], &along = side[i];
    const Vec2 inwards = turned_left(along), to_image = w.x * along - w.depth * inwards;
    const bool is_parallel = w.is_parallel();
    sources.push_back({is_parallel ? to_image : origin + to_image, origin + w.begin * along, origin + w.end * along,
                       is_parallel ? -kInfinity : w.offset, w.generator, h, false, w.distance(w.begin),
                       w.distance(w.end)});
  });
  for (int i = 0; i < 3; ++i) {
    const VertexId v = mesh.vertices(f)[i];
    if (!field.label[v].valid()) continue;
    const Vec2 at = layout.corner[i];
    const double d = field.distance[v];
    sources.push_back({at, at, at, d, field.label[v], Mesh::halfedge(f, i), true, d, d});
  }
}

// Visits faces, so that each window is read once: most faces have none.
std::vector<EdgeId> WindowDistances::contested_edges(const ParallelChunks& parallel) const {
  const auto faces = cut_into_chunks(mesh_.face_count(), kScanChunk);
  std::vector<EdgeId> edges = parallel.collect(faces, steps::kLabels, [&](const Chunk& chunk) {
    std::vector<EdgeId> found;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceId f(i);
      const auto& [a, b, c] = mesh_.vertices(f);
      const std::array<GeneratorId, 3> label{field_.label[a], field_.label[b], field_.label[c]};
      std::array<bool, 3> is_contested{label[0] != label[1], label[1] != label[2], label[2] != label[0]};
      field_.windows.for_each(f, [&](const Window& w) {
        const int side = Mesh::corner(w.halfedge);
        is_contested[side] |= w.generator != label[side];
      });
      for (int side = 0; side < 3; ++side) {
        if (is_contested[side]) found.push_back(mesh_.edge(Mesh::halfedge(f, side)));
      }
    }
    return found;
  });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

GeneratorTable make_generator_table(const Mesh& mesh, const WindowField& field, const Progress& progress) {
  GeneratorTable table(mesh.vertex_count(), mesh.face_count());
  for (const VertexId v : mesh.vertices()) {
    if (field.label[v].valid()) table.add(v, field.label[v], field.distance[v], HalfedgeId());
  }
  std::vector<FaceSource> sources;
  for (const FaceId f : mesh.faces()) {
    if (f.value() % kTableStride == 0) report_progress(progress, steps::kTables, double(f.value()) / mesh.face_count());
    const FaceLayout layout(mesh, f);
    collect_face_sources(mesh, field, f, layout, sources);
    while (!sources.empty()) {
      const GeneratorId g = sources.front().generator;
      std::array<std::int32_t, 3> corner{};
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = table.lower(mesh.vertices(f)[k], g, least_distance(sources, g, layout.corner[k]));
      }
      table.add(f, g, corner, 0);
      std::erase_if(sources, [g](const FaceSource& s) { return s.generator == g; });
    }
  }
  return table;
}

GeodesicPath trace_shortest_path(const Mesh& mesh, const WindowField& field, PathMemo& memo, const SurfacePoint& start,
                                 GeneratorId only) {
  return PathTracer(mesh, field, memo).trace(start, only);
}

Departures::Departures(const WorkingMesh& working, const std::vector<SurfacePoint>& generators) {
  for (const GeneratorId g : IdRange<GeneratorId>(generators.size())) {
    const TangentFan fan(working.input(), generators[g.index()]);
    planes_.push_back({tangent_angle(working, fan, working.mesh().halfedge(working.vertex(g))), fan.scale()});
  }
}

void NearestPaths::enter(FaceId f) {
  face_ = f;
  const FaceFrame& frame = field_.frame[f];
  corner_ = {Vec2(0, 0), Vec2(frame.length[0], 0), frame.length[2] * Vec2(frame.cosine[0], frame.sine[0])};
  side_ = {Vec2(1, 0), Vec2(-frame.cosine[1], frame.sine[1]), Vec2(-frame.cosine[0], -frame.sine[0])};
  images_.clear();
  // The corners first: they bound the distance, so that most windows need no square root.
  for (int i = 0; i < 3; ++i) {
    const VertexId v = mesh_.vertices(f)[i];
    if (!field_.label[v].valid()) continue;
    images_.push_back(
        {corner_[i], Vec2::Zero(), Vec2::Zero(), field_.distance[v], field_.label[v], i, kCorner, false, Vec2::Zero()});
  }
  const Chunk windows = field_.windows.of_face(f);
  for (std::size_t number = windows.begin; number < windows.end; ++number) {
    field_.windows.prefetch_window(number + kAhead);  // of faces that probably come next
    add_window(number);
  }
}

void NearestPaths::add_window(std::size_t number) {
  const Window& w = field_.windows[number];
  const int i = Mesh::corner(w.halfedge);
  if (!field_.frame[face_].twin[i].valid()) return;  // the boundary: the paths leave the face
  const Vec2 along = side_[i], inwards = turned_left(along);
  images_.push_back({corner_[i] + w.x * along - w.depth * inwards, (w.begin - w.x) * along + w.depth * inwards,
                     (w.end - w.x) * along + w.depth * inwards, w.offset, w.generator, i, number, false, Vec2::Zero()});
}

std::size_t NearestPaths::search(const Vec2& p, GeneratorId only, double& distance) const {
  std::size_t best = kNoImage;
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const Image& image = images_[i];
    const double rest = distance - image.offset;
    const Vec2 ray = p - image.at;
    const double squared = ray.squaredNorm();
    if (!(rest > 0) || squared >= rest * rest) continue;
    if (only.valid() && image.generator != only) continue;
    if (!passes(image, ray)) continue;
    distance = image.offset + std::sqrt(squared);
    best = i;
  }
  return best;
}

NearestPath NearestPaths::at(const Vec2& p, GeneratorId only) {
  NearestPath nearest{GeneratorId(), kInfinity, Vec2::Zero()};
  const std::size_t best = search(p, only, nearest.distance);
  if (best == kNoImage) return find_round_ends(p, only);
  nearest.generator = images_[best].generator;
  nearest.distance -= field_.starts[nearest.generator];
  nearest.log = log(images_[best], p - images_[best].at, nearest.distance);
  return nearest;
}

NearestPath NearestPaths::from(std::size_t image, const Vec2& p) {
  Image& source = images_[image];
  const Vec2 ray = p - source.at;
  if (!passes(source, ray)) return at(p, source.generator);
  const double distance = source.offset - field_.starts[source.generator] + ray.norm();
  return {source.generator, distance, log(source, ray, distance)};
}

/// No straight path of a generator reaches the point, only paths round the end of an opening. Happens beside a cell
/// without a corner of the face.
NearestPath NearestPaths::find_round_ends(const Vec2& p, GeneratorId only) const {
  NearestPath nearest{GeneratorId(), kInfinity, Vec2::Zero()};
  for (const Image& image : images_) {
    if (image.generator != only) continue;
    for (const Vec2& end : {image.begin, image.end}) {
      const double to_end = image.offset - field_.starts[only] + end.norm();
      const double distance = to_end + (p - image.at - end).norm();
      if (!(distance < nearest.distance)) continue;
      Image along = image;
      nearest = {only, distance, log(along, end, to_end)};
      nearest.log *= distance / nearest.log.norm();
    }
  }
  return nearest;
}

Vec2 NearestPaths::log(Image& image, const Vec2& ray, double distance) const {
  if (is_direct(image) && !departures_.is_flat(image.generator)) {
    return distance * departures_.direction(image.generator, from_side(image, ray));
  }
  if (!image.has_direction) {
    image.direction = direction(image);
    image.has_direction = true;
  }
  if (!is_direct(image)) return distance * image.direction;
  // The ray is turned from the face into the tangent plane, as the side is.
  const Vec2& side = side_[image.side];
  return side.dot(ray) * image.direction + cross(side, ray) * turned_left(image.direction);
}

Vec2 NearestPaths::direction(const Image& image) const {
  Departure departure;
  if (image.window != kCorner) {
    departure = field_.windows.departure(image.window);
  } else if (!is_direct(image)) {
    departure = field_.departure[mesh_.vertices(face_)[image.side]];
  } else {
    departure = from_side(image, side_[image.side]);
  }
  return departures_.direction(image.generator, departure);
}

/// The departure of a ray of a direct window, or from a generator in a corner of the face.
Departure NearestPaths::from_side(const Image& image, const Vec2& ray) const {
  const Vec2& side = side_[image.side];
  const Departure of_side = image.window != kCorner ? field_.windows.departure(image.window)
                                                    : field_.angles.side(Mesh::halfedge(face_, image.side));
  return of_side + Departure::of_angle(std::atan2(cross(side, ray), side.dot(ray)));
}

}  // namespace gvd
