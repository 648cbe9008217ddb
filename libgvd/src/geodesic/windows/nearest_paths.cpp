// The logarithm of any point: the distance to its nearest generator, and the direction in which the path leaves it.
//
// Idea: windows carry the angle at which their paths leave the generator. In the plane of a face, a ray from an image
// forms an angle with the window's side that is the same in the tangent plane. A logarithm therefore needs no tracing
// back.
// Source: docs/developer/lloyd.md, "Departures", whose tangent planes are scaled as Polthier and Schmies (1998) do.
// Invariant: `images_` has the images that reach the face entered last, first the corners, then the windows in their
// order.
#include "geodesic/windows/nearest_paths.hpp"

#include <cmath>

#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"

namespace gvd {
namespace {

/// The tangent angle of a halfedge of the working mesh that leaves the fan's generator.
double tangent_angle(const WorkingMesh& working, const TangentFan& fan, HalfedgeId h) {
  const FaceId face = Mesh::face(h), parent = working.parent(face);
  const FaceLayout layout(working.input(), parent);
  const std::array<Bary, 3>& corners = working.corners(face);
  const int from = Mesh::corner(h);
  return fan.angle(parent, layout.at(corners[(from + 1) % 3]) - layout.at(corners[from]));
}

/// Windows are prefetched this many ahead, which is about the number of windows of one or two faces.
constexpr std::size_t kAhead = 16;

}  // namespace

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
    field_.windows.prefetch_window(number + kAhead);  // windows of faces that probably come next
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

/// Finds the shortest path round the end of an opening, if no straight path of a generator reaches the point. This
/// happens beside a cell that contains no corner of the face.
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
  // The ray is rotated from the face into the tangent plane by the same angle as the side.
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
