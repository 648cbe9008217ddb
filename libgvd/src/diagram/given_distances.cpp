// Makes the tables that tracers read from distances that the caller gives row by row.
//
// A row is checked, completed on the vertices of the working mesh, and merged into the candidates of every face: the
// generators that no other generator beats at all three corners (equation (3) of the paper). No update of a front
// decreases when its distances grow, so that a beaten generator is nowhere the nearest in the face. After the last row,
// the candidates become the tables. Memory therefore holds only one row and the candidates, whatever the number of
// generators.
// Source: section 4.1 of the paper for the tables and the test.
// Invariant: the result depends on the rows alone. Candidates of a face are ascending by generator, and the offsets
// that decide ties are those of marching.
#include "diagram/given_distances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

using CornerDistances = std::array<double, 3>;

/// The least distance of a generator from another generator's vertex, in lengths of the shortest edge there. A nearer
/// generator would win the vertex that the other one owns. The bisector moves by half of this.
constexpr double kLeastSeparation = 1e-3;

/// Whether the first generator is nearer at all corners of a face.
bool beats(const CornerDistances& a, const CornerDistances& b) { return a[0] < b[0] && a[1] < b[1] && a[2] < b[2]; }

/// A generator that may be the nearest one for some points of a face, with its distances at the corners.
struct Contender {
  GeneratorId generator;
  CornerDistances distance{};
};

/// Adds a generator to the candidates of a face, unless one of them beats it, and removes the candidates that it beats.
void merge(std::vector<Contender>& candidates, const Contender& added) {
  const auto beats_added = [&](const Contender& c) { return beats(c.distance, added.distance); };
  if (std::ranges::any_of(candidates, beats_added)) return;
  std::erase_if(candidates, [&](const Contender& c) { return beats(added.distance, c.distance); });
  candidates.push_back(added);
}

/// The distances of one generator to the vertices of the working mesh.
using DistanceRow = IdVector<VertexId, double>;

/// Fills in unknown distances along the edges from the vertices whose distances are known.
void extend_row(const Mesh& mesh, DistanceRow& row) {
  using Offer = std::pair<double, VertexId>;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
  for (const VertexId v : mesh.vertices()) {
    if (row[v] != kInfinity) continue;
    for_each_neighbour(mesh, v, [&](VertexId u, HalfedgeId h) {
      if (row[u] != kInfinity) offers.emplace(row[u] + mesh.length(h), v);
    });
  }
  while (!offers.empty()) {
    const auto [distance, v] = offers.top();
    offers.pop();
    if (row[v] != kInfinity) continue;
    row[v] = distance;
    for_each_neighbour(mesh, v, [&, from = distance](VertexId u, HalfedgeId h) {
      if (row[u] == kInfinity) offers.emplace(from + mesh.length(h), u);
    });
  }
}

/// The distance at a point of the input, interpolated linearly in its face.
double interpolate_row(const Mesh& input, const SurfacePoint& point, const DistanceRow& row) {
  double distance = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.bary[i] > 0) distance += point.bary[i] * row[input.vertices(point.face)[i]];
  }
  return distance;
}

void check_distance(GeneratorId g, VertexId v, double d) {
  if (d >= 0 && (d <= kLongestDistance || d == kInfinity)) return;
  throw Error(ErrorCode::precondition,
              fmt::format("the distance of generator {} at vertex {} is {}; give a number from 0 to {:g}, or "
                          "infinity where it is unknown",
                          g.value(), v.value(), d, kLongestDistance),
              v.value());
}

GeneratorTable make_table(const Mesh& mesh, const IdVector<FaceId, std::vector<Contender>>& candidates) {
  GeneratorTable table(mesh.vertex_count(), mesh.face_count());
  for (const FaceId f : mesh.faces()) {
    for (const auto& [generator, distance] : candidates[f]) {
      std::array<std::int32_t, 3> corner{};
      for (std::size_t i = 0; i < 3; ++i) corner[i] = table.lower(mesh.vertices(f)[i], generator, distance[i]);
      table.add(f, generator, corner, 0);
    }
  }
  return table;
}

}  // namespace

FastMarchingResult tabulate_distances(const WorkingMesh& working, const std::vector<SurfacePoint>& generators,
                                      const DistanceSolver& solver, const Progress& progress) {
  const Mesh &mesh = working.mesh(), &input = working.input();
  const auto offset = SymbolicOffset::of_marching(mesh.mean_edge_length(), generators.size());
  const IdVector<FaceId, std::int32_t> component = compute_face_components(mesh);
  const auto component_of = [&](VertexId v) { return component[Mesh::face(mesh.halfedge(v))]; };
  IdVector<GeneratorId, double> separation;  // least distance of other generators from its vertex
  for (const VertexId v : working.generator_vertices()) {
    double shortest = kInfinity;
    for_each_neighbour(mesh, v, [&](VertexId, HalfedgeId h) { shortest = std::min(shortest, mesh.length(h)); });
    separation.push_back(kLeastSeparation * shortest);
  }
  IdVector<FaceId, std::vector<Contender>> candidates(mesh.face_count());
  DistanceRow row;
  for (const GeneratorId g : working.generator_vertices().ids()) {
    report_progress(progress, steps::kDistances, double(g.value()) / double(generators.size()));
    const std::int32_t own_component = component_of(working.vertex(g));
    row.assign(mesh.vertex_count(), kInfinity);
    solver(g, std::span(row.raw()).first(input.vertex_count()));
    for (const VertexId v : input.vertices()) {
      if (component_of(v) == own_component) {
        check_distance(g, v, row[v]);
      } else {
        row[v] = kInfinity;
      }
    }
    // The solver does not know vertices that only the working mesh has.
    for (const GeneratorId other : working.generator_vertices().ids()) {
      const VertexId v = working.vertex(other);
      if (component_of(v) != own_component) continue;
      if (v.value() >= input.vertex_count()) row[v] = interpolate_row(input, generators[other.index()], row);
      row[v] = std::max(row[v], separation[other]);
    }
    row[working.vertex(g)] = 0;
    extend_row(mesh, row);
    const double longer = offset.of(g);
    for (const FaceId f : mesh.faces()) {
      const auto& [a, b, c] = mesh.vertices(f);
      if (row[a] == kInfinity) continue;  // a component without the generator
      merge(candidates[f], {g, {row[a] + longer, row[b] + longer, row[c] + longer}});
    }
  }
  return {make_table(mesh, candidates), offset, 0};
}

}  // namespace gvd
