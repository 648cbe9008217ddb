// Chooses colours of regions: few of them, and different ones for neighbours.
//
// The labels are coloured greedily in smallest-last order (Matula and Beck 1983), which needs few colours on surfaces
// of low genus. In a slider, each scene starts from the colours of the next scene; labels with the same colour as a
// neighbour then change their colour, one after the other, until no conflict is left.
// A result has the same colours in a file and in its page, because they are chosen from the labels of faces and the
// bisectors together: labels that meet along edges or along a bisector differ.
// Invariant: the choice depends on the labels and their neighbours alone, and ties go to the smaller label or colour.
#include "io/writers/region_colors.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <tuple>

#include "gvd/io/labelled_mesh.hpp"

namespace gvd::io {
namespace {

constexpr std::size_t kColors = kRegionPalette.size();
constexpr std::size_t kUncoloured = kColors;

void add_pair(std::vector<RegionPair>& pairs, GeneratorId a, GeneratorId b) {
  if (a.valid() && b.valid() && a != b) pairs.emplace_back(std::min(a, b), std::max(a, b));
}

using RegionNeighbours = std::vector<std::vector<std::size_t>>;

RegionNeighbours list_neighbours(std::size_t count, const std::vector<RegionPair>& adjacent) {
  RegionNeighbours neighbours(count);
  for (const auto& [a, b] : adjacent) {
    neighbours[a.index()].push_back(b.index());
    neighbours[b.index()].push_back(a.index());
  }
  return neighbours;
}

/// The number of labels with each colour; the last number counts the labels without a colour.
using Uses = std::array<std::size_t, kColors + 1>;

Uses count_colors(const std::vector<std::size_t>& choice, const std::vector<std::size_t>& labels) {
  Uses uses{};
  for (const std::size_t label : labels) ++uses[choice[label]];
  return uses;
}

/// The first colour of least cost among the first `count`.
template <class Cost>
std::size_t find_cheapest(std::size_t count, const Cost& cost) {
  std::size_t best = 0;
  for (std::size_t c = 1; c < count; ++c) {
    if (cost(c) < cost(best)) best = c;
  }
  return best;
}

/// Orders the labels smallest-last: removes the label of least degree from the graph again and again, and returns the
/// labels in the reverse order of their removal.
std::vector<std::size_t> order_smallest_last(const RegionNeighbours& neighbours) {
  std::vector<std::size_t> degree(neighbours.size()), order;
  std::set<std::pair<std::size_t, std::size_t>> left;
  for (std::size_t i = 0; i < neighbours.size(); ++i) left.emplace(degree[i] = neighbours[i].size(), i);
  while (!left.empty()) {
    const std::size_t least = left.begin()->second;
    left.erase(left.begin());
    order.push_back(least);
    for (const std::size_t other : neighbours[least]) {
      if (left.erase({degree[other], other}) > 0) left.emplace(--degree[other], other);
    }
  }
  std::reverse(order.begin(), order.end());
  return order;
}

std::vector<Rgb> to_colors(const std::vector<std::size_t>& choice) {
  std::vector<Rgb> colors;
  for (const std::size_t c : choice) colors.push_back(kRegionPalette[c]);
  return colors;
}

/// If labels change their colour more often than this on average, all colours are chosen from scratch.
constexpr std::size_t kMostChanges = 20;

/// The pairs of adjacent labels of a mesh: labels of faces or, without these, labels of vertices.
std::vector<RegionPair> list_pairs(const LabelledMesh& labelled) {
  std::vector<RegionPair> pairs;
  const Mesh& mesh = labelled.mesh;
  if (labelled.face_label != nullptr) {
    add_face_neighbours(mesh, *labelled.face_label, pairs);
  } else if (labelled.vertex_label != nullptr) {
    for (const EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      add_pair(pairs, (*labelled.vertex_label)[mesh.from(h)], (*labelled.vertex_label)[mesh.to(h)]);
    }
  }
  sort_pairs(pairs);
  return pairs;
}

}  // namespace

void add_face_neighbours(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::vector<RegionPair>& pairs) {
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (mesh.twin(h).valid()) add_pair(pairs, label[Mesh::face(h)], label[Mesh::face(mesh.twin(h))]);
  }
}

void add_cell_neighbours(const IdVector<GeneratorId, Cell>& cells, std::vector<RegionPair>& pairs) {
  for (const GeneratorId cell : cells.ids()) {
    for (const GeneratorId other : cells[cell].neighbours) add_pair(pairs, cell, other);
  }
}

void sort_pairs(std::vector<RegionPair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

std::vector<Rgb> choose_region_colors(std::size_t count, const std::vector<RegionPair>& adjacent) {
  const RegionNeighbours neighbours = list_neighbours(count, adjacent);
  std::vector<std::size_t> choice(count, kUncoloured);
  Uses uses{};
  for (const std::size_t label : order_smallest_last(neighbours)) {
    const Uses around = count_colors(choice, neighbours[label]);
    choice[label] =
        find_cheapest(kColors, [&](std::size_t c) { return std::tuple(around[c], c >= kUsualColors, uses[c]); });
    ++uses[choice[label]];
  }
  return to_colors(choice);
}

std::vector<Rgb> adapt_region_colors(const std::vector<Rgb>& before, std::size_t count,
                                     const std::vector<RegionPair>& adjacent) {
  const RegionNeighbours neighbours = list_neighbours(count, adjacent);
  std::vector<std::size_t> choice(count, kUncoloured);
  std::vector<std::array<std::size_t, kUsualColors>> tries(count);  // how often each label has taken each colour
  Uses uses{};
  for (std::size_t label = 0; label < std::min(before.size(), count); ++label) {
    const auto found = std::find(kRegionPalette.begin(), kRegionPalette.end(), before[label]);
    choice[label] = std::size_t(found - kRegionPalette.begin());
    ++uses[choice[label]];
  }
  const auto count_around = [&](std::size_t label) { return count_colors(choice, neighbours[label]); };
  const auto clashes = [&](std::size_t label) {
    return choice[label] == kUncoloured || count_around(label)[choice[label]] > 0;
  };
  // The usual colour that the fewest neighbours have. A colour that the label had before counts as if a neighbour had
  // it; otherwise neighbours could pass colours around for ever.
  const auto choose = [&](std::size_t label) {
    const Uses around = count_around(label);
    return find_cheapest(kUsualColors, [&](std::size_t c) { return std::tuple(around[c] + tries[label][c], uses[c]); });
  };
  const auto take = [&](std::size_t label, std::size_t c) {
    if (choice[label] != kUncoloured) --uses[choice[label]];
    choice[label] = c;
    ++uses[c];
    ++tries[label][c];
  };
  std::deque<std::size_t> open;
  for (std::size_t label = 0; label < count; ++label) {
    const std::size_t c = choose(label);
    const bool is_free = count_around(label)[c] == 0;
    if (is_free && (clashes(label) || choice[label] >= kUsualColors)) take(label, c);
    if (clashes(label)) open.push_back(label);
  }
  for (std::size_t left = kMostChanges * count; !open.empty(); --left) {
    if (left == 0) return choose_region_colors(count, adjacent);
    const std::size_t label = open.front();
    open.pop_front();
    if (!clashes(label)) continue;
    take(label, choose(label));
    for (const std::size_t other : neighbours[label]) {
      if (choice[other] == choice[label]) open.push_back(other);
    }
  }
  return to_colors(choice);
}

}  // namespace gvd::io

namespace gvd {

std::vector<Rgb> region_colors(const LabelledMesh& labelled) {
  std::int64_t count = labelled.diagram != nullptr ? std::ssize(labelled.diagram->cells) : 0;
  const auto count_labels = [&count](const auto* labels) {
    if (labels == nullptr) return;
    for (const GeneratorId label : *labels) count = std::max<std::int64_t>(count, label.value() + 1);
  };
  count_labels(labelled.face_label);
  count_labels(labelled.vertex_label);
  const std::vector<io::RegionPair> borders = io::list_pairs(labelled);
  std::vector<io::RegionPair> all = borders;
  if (labelled.diagram != nullptr) io::add_cell_neighbours(labelled.diagram->cells, all);
  io::sort_pairs(all);
  std::vector<Rgb> colors = io::choose_region_colors(static_cast<std::size_t>(count), all);
  // The graph with both kinds of pairs can be impossible to draw on the surface, so its neighbours may need more
  // colours than the palette has.
  const auto is_same = [&](const io::RegionPair& pair) {
    return colors[pair.first.index()] == colors[pair.second.index()];
  };
  if (std::any_of(borders.begin(), borders.end(), is_same)) colors = io::choose_region_colors(colors.size(), borders);
  return colors;
}

}  // namespace gvd
