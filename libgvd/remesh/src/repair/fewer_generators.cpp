// The search for generators that were added in vain, and the exchange that keeps a number of generators.
//
// Both leave out generators without which the dual has no defect either (LocalChanges). The search looks among the
// added ones, pair by pair, because single ones rarely succeed. The exchange makes room for the added generators: it
// looks among all that may go, and first where the surface is flattest for the distance between generators. Every
// change leaves one generator less, so both end; each also ends where its diagrams exceed a limit.

#include "repair/fewer_generators.hpp"

#include <algorithm>
#include <cmath>

#include "base/least.hpp"
#include "repair/local_changes.hpp"
#include "repair/local_dual.hpp"

namespace gvd {
namespace {

/// The nearest other generator in space, out of some; the nearest along the surface would cost a propagation. Cost:
/// O(n), like that of the part for its trial.
std::optional<GeneratorId> find_nearest(const Mesh& mesh, const Diagram& diagram, GeneratorId g,
                                        const std::vector<GeneratorId>& among) {
  Least<std::optional<GeneratorId>> nearest;
  const Vec3 at = position(mesh, diagram.generators[g.index()]);
  for (const GeneratorId other : among) {
    const double distance = (position(mesh, diagram.generators[other.index()]) - at).norm();
    if (other != g) nearest.offer(distance, other);
  }
  return nearest.value;
}

/// The generators that may go, the last one first.
std::vector<GeneratorId> list_free(const Diagram& diagram, const GeneratorSearch& search) {
  CellFlags stays(diagram.generators.size(), 0);
  for (const GeneratorId g : find_in_order(search.fixed, diagram.generators)) stays[g] = 1;
  std::vector<GeneratorId> ids;
  for (std::size_t i = diagram.generators.size(); i-- > search.kept;) {
    if (!stays[GeneratorId(i)]) ids.emplace_back(i);
  }
  return ids;
}

/// For each generator, the largest distance of its cell and its neighbours from the tangent plane at the generator;
/// mesh units. A mesh without the generator would be about this far from the surface there.
std::vector<double> measure_bends(const Mesh& mesh, const Diagram& diagram) {
  std::vector<Vec3> at, normal;
  for (const SurfacePoint& point : diagram.generators) {
    at.push_back(position(mesh, point));
    normal.push_back(surface_normal(mesh, point));
  }
  std::vector<double> bends(at.size(), 0);
  const auto offer = [&](GeneratorId g, const Vec3& p) {
    bends[g.index()] = std::max(bends[g.index()], std::abs((p - at[g.index()]).dot(normal[g.index()])));
  };
  for (const VertexId v : mesh.vertices()) {
    if (diagram.vertex_label[v].valid()) offer(diagram.vertex_label[v], mesh.position(v));
  }
  for (const Cell& cell : diagram.cells) {
    for (const GeneratorId n : cell.neighbours) offer(cell.generator, at[n.index()]);
  }
  return bends;
}

/// The generators that may go, the one with the least bend first.
std::vector<GeneratorId> list_by_bend(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search) {
  const std::vector<double> bends = measure_bends(mesh, diagram);
  std::vector<GeneratorId> ids = list_free(diagram, search);
  std::stable_sort(ids.begin(), ids.end(),
                   [&](GeneratorId g, GeneratorId h) { return bends[g.index()] < bends[h.index()]; });
  return ids;
}

/// Tries the listed generators, and lists and tries again as long as changes leave any to be tried. Ends at the limit,
/// or with `least` generators.
template <class List, class Try>
void repeat(LocalChanges& changes, std::size_t least, List list, Try try_generator) {
  for (bool tries = true; tries && !changes.is_over() && changes.count() > least;) {
    tries = false;
    for (const GeneratorId g : list()) {
      if (changes.is_over() || changes.count() <= least) break;
      if (changes.is_idle(g)) continue;
      try_generator(g);
      tries = true;
    }
    changes.apply();
  }
}

}  // namespace

std::vector<GeneratorId> find_in_order(const std::vector<SurfacePoint>& points,
                                       const std::vector<SurfacePoint>& generators) {
  std::vector<GeneratorId> ids;
  for (std::size_t i = 0; i < generators.size() && ids.size() < points.size(); ++i) {
    if (generators[i] == points[ids.size()]) ids.emplace_back(i);
  }
  return ids;
}

bool search_fewer_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search) {
  LocalChanges changes(mesh, diagram, search);
  std::vector<GeneratorId> free;
  const auto list = [&]() -> const std::vector<GeneratorId>& { return free = list_free(diagram, search); };
  const std::size_t least = std::max(search.kept, search.least);
  const auto leave_out = [&] {
    changes.forget_trials();
    repeat(changes, least, list, [&](GeneratorId g) { changes.leave_out(g); });
  };
  // Some generators that were added by forecasts are not needed: they go first, at a single trial each.
  if (search.only) leave_out();
  changes.forget_trials();
  repeat(changes, least, list, [&](GeneratorId g) {
    const auto other = find_nearest(mesh, diagram, g, free);
    if (!other) return changes.leave_out(g);
    if (!changes.is_near_change(*other)) changes.unite(g, *other);
  });
  leave_out();
  return !changes.is_over();
}

bool exchange_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search) {
  LocalChanges changes(mesh, diagram, search);
  const auto list = [&] { return list_by_bend(mesh, diagram, search); };
  repeat(changes, search.least, list, [&](GeneratorId g) { changes.leave_out(g); });
  return diagram.generators.size() == search.least;
}

}  // namespace gvd
