// The search for generators that were added in vain, and the exchange that keeps a number of generators.
//
// Both leave out generators without which the dual has no defect either (LocalChanges). The search looks among the
// added ones, pair by pair, since the successes of single ones are rare. The exchange makes room for the added
// generators: it looks among all that may go, and first where the surface is flattest for the distance between
// generators. Every change leaves one generator less, so both end; each also ends where its diagrams exceed a limit.

#include <algorithm>
#include <cmath>

#include "base/least.hpp"
#include "repair/local_changes.hpp"
#include "repair/repair_steps.hpp"

namespace gvd {
namespace {

/// The generator from `first` on that is nearest in space: along the surface it would cost a propagation.
std::optional<GeneratorId> find_nearest(const Mesh& mesh, const Diagram& diagram, GeneratorId g, std::size_t first) {
  Least<std::optional<GeneratorId>> nearest;
  const Vec3 at = position(mesh, diagram.generators[g.index()]);
  for (std::size_t i = first; i < diagram.generators.size(); ++i) {
    const double distance = (position(mesh, diagram.generators[i]) - at).norm();
    if (i != g.index()) nearest.offer(distance, GeneratorId(i));
  }
  return nearest.value;
}

/// Ids from `first` on, the last one first.
std::vector<GeneratorId> list_backwards(const Diagram& diagram, std::size_t first) {
  std::vector<GeneratorId> ids;
  for (std::size_t i = diagram.generators.size(); i-- > first;) ids.emplace_back(i);
  return ids;
}

/// For each generator, how far its cell and its neighbours are from the surface's plane at it, at most; mesh units.
/// About the distance from the surface that a mesh without the generator would have there.
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

/// Ids from `first` on, the one with the least bend first.
std::vector<GeneratorId> list_by_bend(const Mesh& mesh, const Diagram& diagram, std::size_t first) {
  const std::vector<double> bends = measure_bends(mesh, diagram);
  std::vector<GeneratorId> ids = list_backwards(diagram, first);
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

bool search_fewer_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search) {
  LocalChanges changes(mesh, diagram, search);
  const auto list = [&] { return list_backwards(diagram, search.kept); };
  repeat(changes, std::max(search.kept, search.least), list, [&](GeneratorId g) {
    const auto other = find_nearest(mesh, diagram, g, search.kept);
    if (!other) return changes.leave_out(g);
    if (!changes.is_near_change(*other)) changes.unite(g, *other);
  });
  changes.forget_trials();
  repeat(changes, std::max(search.kept, search.least), list, [&](GeneratorId g) { changes.leave_out(g); });
  return !changes.is_over();
}

bool exchange_generators(const Mesh& mesh, const Diagram& diagram, const GeneratorSearch& search) {
  LocalChanges changes(mesh, diagram, search);
  const auto list = [&] { return list_by_bend(mesh, diagram, search.kept); };
  repeat(changes, search.least, list, [&](GeneratorId g) { changes.leave_out(g); });
  return diagram.generators.size() == search.least;
}

}  // namespace gvd
