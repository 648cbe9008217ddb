// The angle at an edge, at a scale: mean normals of the two sides of a disc around it.
//
// The idea of several scales is that of A. Hubeli and M. Gross, Multiresolution feature extraction for unstructured
// meshes, 2001. A mean over the whole disc would blur the crease itself; so the disc is parted at the edge, by two
// fronts that grow from its two faces.
#include "mesh/angle_at_scale.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "base/angles.hpp"

namespace gvd {
namespace {

/// A side has a voice if its weight is this share of the square of the radius. A strip that is as wide as this share of
/// the radius, along an edge, has about so much: a tenth of the spacing of samples that are two radii apart.
constexpr double kLeastVoice = 0.2;

/// At an edge, a quarter of the radius shows at least 1 / kFineFactor of the turn. A fillet of constant curvature does
/// so if it is narrower than the radius; a cylinder shows a quarter.
constexpr double kFineFactor = 5.0 / 3;

/// Faces in a disc. The radius of find_crease_chains is that of at most a hundred equal ones.
constexpr int kMostFaces = 400;

/// A wall lies beside an edge if their directions, and the way between them and the edge's normal, differ by less than
/// 45 degrees.
const double kHalfRight = std::sqrt(0.5);

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// The vector from a point to the nearest one of a segment.
Vec3 to_segment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  return a + std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0) * way - point;
}

}  // namespace

AngleAtScale::AngleAtScale(const Mesh& mesh, double radius, const IdVector<EdgeId, bool>& walls)
    : mesh_(mesh), radius_(radius), walls_(walls), seen_(mesh.face_count(), 0) {
  sizes_.reserve(mesh.face_count());
  for (const FaceId f : mesh.faces()) {
    const FaceShape& shape = mesh.shape(f);
    const auto& [a, b, c] = mesh.vertices(f);
    const double longest = *std::ranges::max_element(shape.length);
    FaceSize size{Vec3::Zero(), longest, shape.twice_area / longest};
    if (shape.twice_area > 0) {
      size.normal = (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).stableNormalized();
    }
    sizes_.push_back(size);
  }
  turns_.reserve(mesh.edge_count());
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    double turn = 0;
    if (twin.valid()) {
      const Vec3 &here = sizes_[Mesh::face(h)].normal, &there = sizes_[Mesh::face(twin)].normal;
      turn = here.isZero(0) || there.isZero(0) ? 180 : degrees(angle_between(here, there));
    }
    turns_.push_back(turn);
  }
}

/// The width of the faces of an inner edge: half of each one's height.
double AngleAtScale::width(EdgeId e) const {
  const HalfedgeId h = mesh_.halfedge(e);
  return (mesh_.area(Mesh::face(h)) + mesh_.area(Mesh::face(mesh_.twin(h)))) / mesh_.length(h);
}

bool AngleAtScale::bends(EdgeId e, double angle) const {
  return !mesh_.is_boundary(e) && turns_[e] >= angle * std::min(1.0, width(e) / (2 * radius_));
}

bool AngleAtScale::is_sharpest(EdgeId e) const {
  if (std::max(mesh_.length(e), width(e)) > radius_ / 2) return true;
  const HalfedgeId h = mesh_.halfedge(e);
  for (const HalfedgeId side : {h, mesh_.twin(h)}) {
    for (const HalfedgeId other : {Mesh::next(side), Mesh::previous(side)}) {
      if (turns_[mesh_.edge(other)] > turns_[e]) return false;
    }
  }
  return true;
}

ScaleAngle AngleAtScale::measure(EdgeId e, double least, double beside) {
  const HalfedgeId h = mesh_.halfedge(e);
  const Vec3 &from = mesh_.position(mesh_.from(h)), &to = mesh_.position(mesh_.to(h));
  const double reach = beside > 0 ? kShoulderReach * radius_ : radius_;
  Disc disc{e, (from + to) / 2, (to - from).normalized(), reach};
  if (!grow(least, disc)) return {};
  std::array<double, kLevels> angle{};
  int levels = 0;
  while (levels < kLevels && has_voice(disc.sides, levels, disc.faces == kMostFaces)) {
    angle[levels] = angle_of(disc.sides, levels);
    ++levels;
  }
  if (levels == 0) return {};
  double result = angle[0];
  if (levels == 2) result = std::min(result, 2 * angle[1] - angle[0]);
  if (levels == 3) {
    // At radius 0, by the line through the two larger or the two smaller scales: other creases may be in reach of the
    // largest, and a fillet is wider than the smallest.
    const double at_zero = std::max(2 * angle[1] - angle[0], 2 * angle[2] - angle[1]);
    result = std::min({result, at_zero, kFineFactor * angle[2]});
  }
  if (result < least && least > 0) return {};
  if (beside > 0 && disc.is_beside_wall && result < beside) return {};
  return {std::max(0.0, result), angle[0] > 0 ? std::min(1.0, angle[levels - 1] / angle[0]) : 1};
}

/// Shares out the faces of a disc, the nearest first. False, and the disc is not whole, if a quarter of the radius
/// shows that the angle is below the least.
bool AngleAtScale::grow(double least, Disc& disc) {
  const HalfedgeId h = mesh_.halfedge(disc.edge);
  ++measurement_;
  front_.clear();
  pushed_ = 0;
  push(0, Mesh::face(h), 0);
  push(0, Mesh::face(mesh_.twin(h)), 1);
  bool is_fine_known = false;
  while (!front_.empty() && disc.faces < kMostFaces) {
    const Entry entry = pop();
    if (seen_[entry.face] == measurement_) continue;
    if (entry.distance >= radius_ / 4 && !is_fine_known) {
      is_fine_known = true;
      const bool is_flat = kFineFactor * angle_of(disc.sides, kLevels - 1) < least;
      if (is_flat && has_voice(disc.sides, kLevels - 1, false)) return false;
    }
    seen_[entry.face] = measurement_;
    ++disc.faces;
    add(entry.face, entry.distance, disc.sides[entry.side]);
    push_neighbours(entry, disc);
  }
  return true;
}

void AngleAtScale::push_neighbours(const Entry& entry, Disc& disc) {
  for (const HalfedgeId side : Mesh::halfedges(entry.face)) {
    const EdgeId edge = mesh_.edge(side);
    const HalfedgeId across = mesh_.twin(side);
    if (edge == disc.edge || !across.valid()) continue;
    if (walls_[edge]) {
      disc.is_beside_wall = disc.is_beside_wall || is_beside(side, disc.middle, disc.along, disc.reach);
      continue;
    }
    if (seen_[Mesh::face(across)] == measurement_) continue;
    const Vec3 way = to_segment(disc.middle, mesh_.position(mesh_.from(side)), mesh_.position(mesh_.to(side)));
    const double distance = std::max(way.norm(), entry.distance);
    if (distance < disc.reach) push(distance, Mesh::face(across), entry.side);
  }
}

void AngleAtScale::push(double distance, FaceId face, int side) {
  const auto is_later = [](const Entry& a, const Entry& b) {
    return std::tie(a.distance, a.order) > std::tie(b.distance, b.order);
  };
  front_.push_back({distance, pushed_++, face, side});
  std::push_heap(front_.begin(), front_.end(), is_later);
}

AngleAtScale::Entry AngleAtScale::pop() {
  const auto is_later = [](const Entry& a, const Entry& b) {
    return std::tie(a.distance, a.order) > std::tie(b.distance, b.order);
  };
  std::pop_heap(front_.begin(), front_.end(), is_later);
  const Entry entry = front_.back();
  front_.pop_back();
  return entry;
}

/// Adds a face to the means of all radii that reach it. Long faces count as far as the disc may hold of them.
void AngleAtScale::add(FaceId f, double distance, Side& side) const {
  const FaceSize& size = sizes_[f];
  double radius = radius_;
  for (int level = 0; level < kLevels && distance < radius; ++level, radius /= 2) {
    const double area = std::min(size.longest, 2 * radius) * std::min(size.height, 2 * radius) / 2;
    const double weight = area * (1 - distance / radius);
    side.normal[level] += weight * size.normal;
    side.weight[level] += weight;
  }
}

/// Whether both sides have a voice at a level. A disc that is cut off holds too many faces for slivers alone.
bool AngleAtScale::has_voice(const std::array<Side, 2>& sides, int level, bool is_cut_off) const {
  const double radius = std::ldexp(radius_, -level), least = is_cut_off ? 0 : kLeastVoice * radius * radius;
  return std::ranges::all_of(sides, [&](const Side& side) { return side.weight[level] > least; });
}

double AngleAtScale::angle_of(const std::array<Side, 2>& sides, int level) {
  return degrees(angle_between(sides[0].normal[level], sides[1].normal[level]));
}

/// Whether a wall runs beside an edge, given by its midpoint and direction, within reach.
bool AngleAtScale::is_beside(HalfedgeId wall, const Vec3& middle, const Vec3& along, double reach) const {
  const Vec3 &a = mesh_.position(mesh_.from(wall)), &b = mesh_.position(mesh_.to(wall));
  const Vec3 way = to_segment(middle, a, b);
  const double distance = way.norm();
  return distance < reach && std::abs((b - a).normalized().dot(along)) > kHalfRight &&
         std::abs(way.dot(along)) < kHalfRight * distance;
}

}  // namespace gvd
