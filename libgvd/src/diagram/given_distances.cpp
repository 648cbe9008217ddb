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

#include "base/union_find.hpp"
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

/// Lists of candidates for all faces in one array; freed items are used again.
class FaceCandidates {
 public:
  struct Candidate {
    GeneratorId generator;
    Corners distance{};
    std::int32_t next = -1;
  };

  explicit FaceCandidates(std::int32_t faces) : first_(faces, -1) {}

  /// Adds a generator with a higher id than all before, unless one of the face beats it; removes those that it beats.
  void merge(FaceId f, GeneratorId g, const Corners& distance) {
    for (std::int32_t i = first_[f]; i >= 0; i = items_[i].next) {
      if (beats(items_[i].distance, distance)) return;
    }
    std::int32_t last = -1;
    for (std::int32_t i = first_[f]; i >= 0;) {
      const std::int32_t next = items_[i].next;
      if (beats(distance, items_[i].distance)) {
        link(f, last) = next;
        items_[i].next = std::exchange(free_, i);
      } else {
        last = i;
      }
      i = next;
    }
    const std::int32_t added = take_free();
    items_[added] = {g, distance, -1};
    link(f, last) = added;
  }

  template <class Visit>
  void for_each(FaceId f, Visit visit) const {
    for (std::int32_t i = first_[f]; i >= 0; i = items_[i].next) visit(items_[i]);
  }

 private:
  std::int32_t& link(FaceId f, std::int32_t item) { return item < 0 ? first_[f] : items_[item].next; }

  std::int32_t take_free() {
    if (free_ < 0) {
      items_.emplace_back();
      return static_cast<std::int32_t>(items_.size()) - 1;
    }
    return std::exchange(free_, items_[free_].next);
  }

  IdVector<FaceId, std::int32_t> first_;
  std::vector<Candidate> items_;
  std::int32_t free_ = -1;
};

class Tabulator {
 public:
  Tabulator(const WorkingMesh& working, const std::vector<SurfacePoint>& generators)
      : working_(working),
        mesh_(working.mesh()),
        generators_(generators),
        candidates_(mesh_.face_count()),
        offset_(SymbolicOffset::of_marching(mesh_.mean_edge_length(), generators.size())) {
    UnionFind sets(std::size_t(mesh_.vertex_count()));
    for (const EdgeId e : mesh_.edges()) {
      sets.unite(mesh_.from(mesh_.halfedge(e)).value(), mesh_.to(mesh_.halfedge(e)).value());
    }
    for (const VertexId v : mesh_.vertices()) component_.push_back(sets.find(v.value()));
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
      candidates_.merge(f, g, {row_[a] + offset, row_[b] + offset, row_[c] + offset});
    }
  }

  GeneratorTable make_table() const {
    GeneratorTable table(mesh_.vertex_count(), mesh_.face_count());
    for (const FaceId f : mesh_.faces()) {
      candidates_.for_each(f, [&](const FaceCandidates::Candidate& c) {
        std::array<std::int32_t, 3> corner{};
        for (std::size_t i = 0; i < 3; ++i) corner[i] = table.lower(mesh_.vertices(f)[i], c.generator, c.distance[i]);
        table.add(f, c.generator, corner, 0);
      });
    }
    return table;
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const std::vector<SurfacePoint>& generators_;
  IdVector<VertexId, std::int32_t> component_;
  FaceCandidates candidates_;
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
