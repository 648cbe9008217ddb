// Creases of a surface as it looks at a scale: chains that begin where the surface turns most, and grow by hysteresis.
//
// The thresholds are those of J. Canny, A computational approach to edge detection, 1986: an edge with the whole angle
// begins a chain, and half of it suffices to go on. Where the mesh around a crease is folded or fine, many edges beside
// each other see the whole turn. So edges are taken one by one, the sharpest first, and each chain grows to its ends
// before the next one begins: the edges of chains are walls for the measurements that follow, and explain the turn to
// their neighbours. What a wall leaves on its side is a strip without a voice, or a flat one.
#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include "gvd/creases.hpp"
#include "gvd/error.hpp"
#include "mesh/angle_at_scale.hpp"
#include "mesh/creases.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Radius of the discs in which the surface is looked at, in spacings.
constexpr double kScale = 0.5;

/// Most radius of these discs, in square roots of a mean face: a hundred faces. That many make a mean of any noise.
constexpr double kMostScale = 6;

/// Factor of the angle below which a chain that begins beside another one is its shoulder. The two edges of a rounded
/// crease of 90 degrees have 45 each.
constexpr double kShoulder = 1.25;

/// Cosine of the largest turn from one edge of a chain to the next: 75 degrees. Behind a corner another chain begins.
constexpr double kLeastForwards = 0.25;

/// Cosine of the largest turn towards a chain that a gap parts from an end: 66 degrees.
constexpr double kLeastAhead = 0.4;

/// Factor of the length of edges in a gap at which the surface does not turn.
constexpr double kFlatLength = 3;

class ChainFinder {
 public:
  ChainFinder(const Mesh& mesh, double angle, double radius)
      : mesh_(mesh),
        strong_(angle),
        weak_(angle / 2),
        radius_(radius),
        is_crease_(mesh.edge_count(), false),
        degree_(mesh.vertex_count(), 0),
        angle_(mesh, radius, is_crease_) {}

  void grow_chains() {
    std::vector<std::pair<double, EdgeId>> seeds;  // by their negative angles
    for (const EdgeId e : mesh_.edges()) {
      if (!angle_.bends(e, weak_) || !angle_.is_sharpest(e)) continue;
      const double angle = angle_.measure(e, strong_, 0).degrees;
      if (angle > strong_) seeds.emplace_back(-angle, e);
    }
    std::ranges::sort(seeds);
    for (const auto& [order, e] : seeds) {
      if (is_crease_[e] || !(angle_.measure(e, strong_, kShoulder * strong_).degrees > strong_)) continue;
      take(e);
      const HalfedgeId h = mesh_.halfedge(e);
      grow(mesh_.from(h), mesh_.to(h));
      grow(mesh_.to(h), mesh_.from(h));
    }
  }

  /// Joins ends inside the surface to a chain ahead of them.
  void close_gaps() {
    for (const VertexId v : mesh_.vertices()) {
      if (is_end(v)) close_gap(v);
    }
  }

  /// All chains, with their crispness as it is now that each one hides what is behind it from the others.
  CreaseChains chains() {
    CreaseChains chains;
    for (const EdgeId e : mesh_.edges()) {
      if (!is_crease_[e]) continue;
      chains.edges.push_back(e);
      chains.crispness.push_back(angle_.measure(e, 0, 0).crispness);
    }
    return chains;
  }

 private:
  bool is_end(VertexId v) const { return degree_[v] == 1 && !mesh_.is_boundary(v); }

  void take(EdgeId e) {
    is_crease_[e] = true;
    const HalfedgeId h = mesh_.halfedge(e);
    ++degree_[mesh_.from(h)], ++degree_[mesh_.to(h)];
  }

  /// Lengthens a chain beyond its last edge, to where it meets another one or ends. Edges that go straight on are
  /// preferred; the direction is that of the last radius.
  void grow(VertexId tail, VertexId tip) {
    Vec3 ahead = (mesh_.position(tip) - mesh_.position(tail)).normalized();
    while (is_end(tip)) {
      double best = 0;
      HalfedgeId next;
      for_each_outgoing(mesh_, tip, [&](HalfedgeId h) {  // all, since the tip is inside the surface
        const double cosine = (mesh_.position(mesh_.to(h)) - mesh_.position(tip)).normalized().dot(ahead);
        const EdgeId e = mesh_.edge(h);
        if (is_crease_[e] || !(cosine > kLeastForwards) || !angle_.bends(e, weak_)) return;
        const double angle = angle_.measure(e, weak_, strong_).degrees;
        if (!(angle >= weak_ && angle * cosine > best)) return;
        best = angle * cosine;
        next = h;
      });
      if (!next.valid()) return;
      take(mesh_.edge(next));
      const Vec3 step = mesh_.position(mesh_.to(next)) - mesh_.position(tip);
      const double share = std::min(1.0, step.norm() / radius_);
      ahead = ((1 - share) * ahead + share * step.normalized()).normalized();
      tip = mesh_.to(next);
    }
  }

  /// The last part of a chain, which is twice the radius long if the chain is: its vertices from the end on, and the
  /// direction in which it ends.
  struct LastPart {
    std::vector<VertexId> vertices;
    Vec3 ahead = Vec3::Zero();
  };

  LastPart last_part(VertexId end) const {
    LastPart part{{end}};
    EdgeId last;
    double length = 0;
    while (length < 2 * radius_) {
      const VertexId v = part.vertices.back();
      HalfedgeId next;
      for_each_neighbour(mesh_, v, [&](VertexId, HalfedgeId h) {
        if (is_crease_[mesh_.edge(h)] && mesh_.edge(h) != last) next = h;
      });
      last = mesh_.edge(next);
      part.vertices.push_back(mesh_.from(next) == v ? mesh_.to(next) : mesh_.from(next));
      length += mesh_.length(next);
      if (length <= radius_ || part.vertices.size() == 2) {
        part.ahead = (mesh_.position(end) - mesh_.position(part.vertices.back())).normalized();
      }
      if (degree_[part.vertices.back()] != 2) break;
    }
    return part;
  }

  /// Takes the shortest way along edges from an end to another chain, or to the boundary, if there is one ahead.
  void close_gap(VertexId end) {
    const LastPart own = last_part(end);
    const double reach = AngleAtScale::kShoulderReach * radius_;
    std::map<VertexId, std::pair<double, HalfedgeId>> ways;  // their lengths, and their last edges
    std::priority_queue<std::pair<double, VertexId>, std::vector<std::pair<double, VertexId>>, std::greater<>> front;
    ways[end] = {0, HalfedgeId()};
    front.emplace(0, end);
    while (!front.empty()) {
      const auto [length, v] = front.top();
      front.pop();
      if (length > ways[v].first) continue;
      const bool is_own = std::ranges::find(own.vertices, v) != own.vertices.end();
      if (!is_own && (degree_[v] > 0 || mesh_.is_boundary(v))) {
        for (VertexId w = v; w != end; w = mesh_.from(ways[w].second)) take(mesh_.edge(ways[w].second));
        return;
      }
      if (is_own && v != end) continue;
      for_each_outgoing(mesh_, v, [&, length = length](HalfedgeId h) {  // v is inside the surface
        const EdgeId e = mesh_.edge(h);
        const VertexId to = mesh_.to(h);
        const double there = length + mesh_.length(h) * (angle_.bends(e, weak_) ? 1 : kFlatLength);
        const Vec3 way = mesh_.position(to) - mesh_.position(end);
        if (is_crease_[e] || there > reach || way.dot(own.ahead) < kLeastAhead * way.norm()) return;
        const auto [known, is_new] = ways.try_emplace(to, there, h);
        if (!is_new && known->second.first <= there) return;
        known->second = {there, h};
        front.emplace(there, to);
      });
    }
  }

  const Mesh& mesh_;
  double strong_, weak_;  // degrees
  double radius_;
  IdVector<EdgeId, bool> is_crease_;
  IdVector<VertexId, std::int32_t> degree_;  // creases
  AngleAtScale angle_;
};

/// Takes out edges of chains, by a list that need not be sorted.
void take_out(const Mesh& mesh, const std::vector<EdgeId>& edges, CreaseChains& chains) {
  IdVector<EdgeId, bool> is_out(mesh.edge_count(), false);
  for (const EdgeId e : edges) is_out[e] = true;
  CreaseChains kept;
  for (std::size_t i = 0; i < chains.edges.size(); ++i) {
    if (is_out[chains.edges[i]]) continue;
    kept.edges.push_back(chains.edges[i]);
    kept.crispness.push_back(chains.crispness[i]);
  }
  chains = std::move(kept);
}

/// The branches that end inside the surface after less than the least length.
std::vector<EdgeId> short_branches(const Mesh& mesh, const CreaseChains& chains, double least) {
  const CreaseNetwork network(mesh, chains.edges);
  std::vector<EdgeId> all;
  for (const VertexId v : mesh.vertices()) {
    if (network.leaving(v).size() != 1 || mesh.is_boundary(v)) continue;
    std::vector<EdgeId> branch;
    CreaseNetwork::Step step = network.leaving(v).front();
    double length = 0;
    while (true) {
      branch.push_back(step.edge);
      length += mesh.length(step.edge);
      const auto& onward = network.leaving(network.end(step));
      if (onward.size() != 2 || length >= least) break;
      step = onward[onward[0].edge == step.edge ? 1 : 0];
    }
    if (length < least) all.insert(all.end(), branch.begin(), branch.end());
  }
  return all;
}

/// Takes out branches and groups that are too short. A branch may be one only when others are gone.
void take_out_short(const Mesh& mesh, double least, CreaseChains& chains) {
  while (true) {
    const std::vector<EdgeId> branches = short_branches(mesh, chains, least);
    if (branches.empty()) break;
    take_out(mesh, branches, chains);
  }
  std::vector<EdgeId> groups;
  for (const CreaseGroup& group : group_creases(mesh, chains.edges)) {
    if (group.length < least) groups.insert(groups.end(), group.edges.begin(), group.edges.end());
  }
  if (!groups.empty()) take_out(mesh, groups, chains);
}

}  // namespace

CreaseChains find_crease_chains(const Mesh& mesh, double angle, double spacing) {
  check_crease_angle(angle);
  if (!(spacing > 0)) throw Error(ErrorCode::invalid_option, "the spacing of samples must be above 0");
  const double mean_area = compute_area(mesh) / std::max(1, mesh.face_count());
  const double radius = std::min(kScale * spacing, kMostScale * std::sqrt(mean_area));
  if (!(radius > 0) || angle == 180) return {};
  ChainFinder finder(mesh, angle, radius);
  finder.grow_chains();
  finder.close_gaps();
  CreaseChains chains = finder.chains();
  take_out_short(mesh, spacing, chains);
  return chains;
}

}  // namespace gvd
