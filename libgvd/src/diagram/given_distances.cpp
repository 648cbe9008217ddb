// Distances that the caller gives, row by row, as the tables that tracers read.
//
// A row is checked, completed on the vertices of the working mesh, and merged into the candidates of every face: those
// generators that no other one beats at all three corners (equation (3) of the paper). No update of a front decreases
// when its distances grow, so a beaten generator is nowhere the nearest in the face. After the last row the candidates
// become the tables. So memory holds one row and the candidates, whatever the number of generators.
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

using Corners = std::array<double, 3>;

/// The least distance of a generator at another one's vertex, in lengths of the shortest edge there. What is nearer
/// would win the vertex that the other one owns; the bisector moves by half of this.
constexpr double kLeastSeparation = 1e-3;

/// Whether the first generator is nearer at all corners of a face.
bool beats(const Corners& a, const Corners& b) { return a[0] < b[0] && a[1] < b[1] && a[2] < b[2]; }

/// A generator that may be the nearest one of points of a face, with its distances at the corners.
struct Candidate {
  GeneratorId generator;
  Corners distance{};
};

/// Adds a generator to those of a face, unless one of them beats it; removes those that it beats.
void merge(std::vector<Candidate>& candidates, const Candidate& added) {
  const auto beats_added = [&](const Candidate& c) { return beats(c.distance, added.distance); };
  if (std::ranges::any_of(candidates, beats_added)) return;
  std::erase_if(candidates, [&](const Candidate& c) { return beats(added.distance, c.distance); });
  candidates.push_back(added);
}

class Tabulator {
 public:
  Tabulator(const WorkingMesh& working, const std::vector<SurfacePoint>& generators)
      : working_(working),
        mesh_(working.mesh()),
        generators_(generators),
        candidates_(mesh_.face_count()),
        offset_(SymbolicOffset::of_marching(mesh_.mean_edge_length(), generators.size())) {
    const auto component = compute_face_components(mesh_);
    for (const VertexId v : mesh_.vertices()) component_.push_back(component[Mesh::face(mesh_.halfedge(v))]);
    for (const VertexId v : working.generator_vertices()) {
      double shortest = kInfinity;
      for_each_neighbour(mesh_, v, [&](VertexId, HalfedgeId h) { shortest = std::min(shortest, mesh_.length(h)); });
      separation_.push_back(kLeastSeparation * shortest);
    }
  }

  FastMarchingResult run(const DistanceSolver& solver, const Progress& progress) {
    for (const GeneratorId g : working_.generator_vertices().ids()) {
      report_progress(progress, steps::kDistances, double(g.value()) / double(generators_.size()));
      row_.assign(mesh_.vertex_count(), kInfinity);
      solver(g, std::span(row_.raw()).first(working_.input().vertex_count()));
      check_row(g);
      complete_row(g);
      merge_row(g);
    }
    return {make_table(), offset_, 0};
  }

 private:
  bool reaches(GeneratorId g, VertexId v) const { return component_[v] == component_[working_.vertex(g)]; }

  void check_row(GeneratorId g) {
    for (const VertexId v : working_.input().vertices()) {
      const double d = row_[v];
      if (!reaches(g, v)) {
        row_[v] = kInfinity;
        continue;
      }
      if (!(d >= 0) || (d > kLongestDistance && d != kInfinity)) {
        throw Error(ErrorCode::precondition,
                    fmt::format("the distance of generator {} at vertex {} is {}; give a number from 0 to {:g}, or "
                                "infinity where it is unknown",
                                g.value(), v.value(), d, kLongestDistance),
                    v.value());
      }
    }
  }

  /// Fills in the generators that are vertices of the working mesh alone, and what the solver does not know.
  void complete_row(GeneratorId g) {
    for (const GeneratorId other : working_.generator_vertices().ids()) {
      const VertexId v = working_.vertex(other);
      if (!reaches(g, v)) continue;
      if (v.value() >= working_.input().vertex_count()) row_[v] = interpolate(generators_[other.index()]);
      row_[v] = std::max(row_[v], separation_[other]);
    }
    row_[working_.vertex(g)] = 0;
    extend_row();
  }

  /// Linear in the face of the input.
  double interpolate(const SurfacePoint& point) const {
    double distance = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (point.bary[i] > 0) distance += point.bary[i] * row_[working_.input().vertices(point.face)[i]];
    }
    return distance;
  }

  /// Goes on along the edges from the vertices whose distance is known.
  void extend_row() {
    using Offer = std::pair<double, VertexId>;
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
    for (const VertexId v : mesh_.vertices()) {
      if (row_[v] != kInfinity) continue;
      for_each_neighbour(mesh_, v, [&](VertexId u, HalfedgeId h) {
        if (row_[u] != kInfinity) offers.emplace(row_[u] + mesh_.length(h), v);
      });
    }
    while (!offers.empty()) {
      const auto [distance, v] = offers.top();
      offers.pop();
      if (row_[v] != kInfinity) continue;
      row_[v] = distance;
      for_each_neighbour(mesh_, v, [&, from = distance](VertexId u, HalfedgeId h) {
        if (row_[u] == kInfinity) offers.emplace(from + mesh_.length(h), u);
      });
    }
  }

  void merge_row(GeneratorId g) {
    const double offset = offset_.of(g);
    for (const FaceId f : mesh_.faces()) {
      const auto& [a, b, c] = mesh_.vertices(f);
      if (row_[a] == kInfinity) continue;  // a component without the generator
      merge(candidates_[f], {g, {row_[a] + offset, row_[b] + offset, row_[c] + offset}});
    }
  }

  GeneratorTable make_table() const {
    GeneratorTable table(mesh_.vertex_count(), mesh_.face_count());
    for (const FaceId f : mesh_.faces()) {
      for (const auto& [generator, distance] : candidates_[f]) {
        std::array<std::int32_t, 3> corner{};
        for (std::size_t i = 0; i < 3; ++i) corner[i] = table.lower(mesh_.vertices(f)[i], generator, distance[i]);
        table.add(f, generator, corner, 0);
      }
    }
    return table;
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const std::vector<SurfacePoint>& generators_;
  IdVector<VertexId, std::int32_t> component_;
  IdVector<FaceId, std::vector<Candidate>> candidates_;
  SymbolicOffset offset_;
  IdVector<GeneratorId, double> separation_;  // least distance of the others at its vertex
  IdVector<VertexId, double> row_;            // of the current generator
};

}  // namespace

FastMarchingResult tabulate_distances(const WorkingMesh& working, const std::vector<SurfacePoint>& generators,
                                      const DistanceSolver& solver, const Progress& progress) {
  return Tabulator(working, generators).run(solver, progress);
}

}  // namespace gvd
