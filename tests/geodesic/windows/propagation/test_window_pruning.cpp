#include <limits>
#include <set>

#include "geodesic/windows/propagation/window_pruning.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_window_pruning {

constexpr double kNever = 0, kSettled = std::numeric_limits<double>::infinity();

/// A grid of one partition. Every vertex has the distance 1, and the label 0 left of x = 2.5, else 1.
struct Setup {
  explicit Setup(KeepWindows keep)
      : mesh(test::make_grid(4, 4)),
        parallel(1, silent),
        state(mesh, {keep, {}, 1, 1000}, parallel),
        exchange(state.partitions, state.mailboxes, state.last_sent, PartitionId(0)),
        pruning(state, exchange) {
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      state.labels.distance[VertexCopyId(v)] = 1;
      state.labels.label[VertexCopyId(v)] = GeneratorId(mesh.position(VertexId(v)).x() < 2.5 ? 0 : 1);
    }
  }
  void add(HalfedgeId h, double settled = kNever) {
    pruning.add({0, 1, 0, 1, 0, GeneratorId(0), h}, {}, pruning.place(h), settled);
  }
  void add_to_all(double settled = kNever) {
    for (std::int32_t h = 0; h < mesh.halfedge_count(); ++h) add(HalfedgeId(h), settled);
  }
  std::multiset<HalfedgeId> finish() {
    std::multiset<HalfedgeId> kept;
    const BlockList<Window> windows = pruning.finish().windows;
    for (std::size_t i = 0; i < windows.size(); ++i) kept.insert(windows[i].halfedge);
    return kept;
  }
  bool has_one_label(FaceId f) const {
    const auto& [a, b, c] = mesh.vertices(f);
    const auto label = [&](VertexId v) { return state.labels.label[first_copy(v)]; };
    return label(a) == label(b) && label(b) == label(c);
  }
  /// A halfedge between two faces that have the label 0 alone.
  HalfedgeId inner_halfedge() const {
    for (std::int32_t i = 0; i < mesh.halfedge_count(); ++i) {
      const HalfedgeId h(i), twin = mesh.twin(h);
      if (twin.valid() && has_one_label(Mesh::face(h)) && has_one_label(Mesh::face(twin))) return h;
    }
    return HalfedgeId();
  }

  Mesh mesh;
  Progress silent;
  ParallelChunks parallel;
  PropagationState state;
  PartitionExchange exchange;
  WindowPruning pruning;
};

TEST_CASE("no window is kept, or all are, if the options say so") {
  Setup none(KeepWindows::none), all(KeepWindows::all);
  none.add_to_all();
  all.add_to_all();
  CHECK(none.finish().empty());
  CHECK(all.finish().size() == static_cast<std::size_t>(all.mesh.halfedge_count()));
}

TEST_CASE("at the end, the windows on the edges of faces with several labels are kept") {
  Setup setup(KeepWindows::near_bisectors);
  setup.add_to_all();
  const std::multiset<HalfedgeId> kept = setup.finish();
  for (std::int32_t i = 0; i < setup.mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i), twin = setup.mesh.twin(h);
    const bool needed = !setup.has_one_label(Mesh::face(h)) || (twin.valid() && !setup.has_one_label(Mesh::face(twin)));
    CHECK(kept.count(h) == (needed ? 1 : 0));
  }
}

TEST_CASE("a window with another label than its edge's ends keeps the windows of both faces") {
  Setup setup(KeepWindows::near_bisectors);
  const HalfedgeId h = setup.inner_halfedge();
  setup.add(h);
  setup.pruning.mark_edge(h, 0);
  CHECK(setup.finish().count(h) == 1);

  Setup unmarked(KeepWindows::near_bisectors);
  unmarked.add(h);
  CHECK(unmarked.finish().empty());
}

TEST_CASE("a vertex that changes its label keeps the windows of all its faces") {
  Setup setup(KeepWindows::near_bisectors);
  const HalfedgeId outgoing = setup.inner_halfedge();
  setup.pruning.mark_vertex(outgoing, 0);
  setup.add_to_all();
  const std::multiset<HalfedgeId> kept = setup.finish();
  const VertexId v = setup.mesh.from(outgoing);
  for (std::int32_t i = 0; i < setup.mesh.halfedge_count(); ++i) {
    if (setup.mesh.from(HalfedgeId(i)) == v) CHECK(kept.count(HalfedgeId(i)) == 1);
  }
}

TEST_CASE("a face that is settled with one label stays so") {
  Setup setup(KeepWindows::near_bisectors);
  const HalfedgeId h = setup.inner_halfedge();
  for (int i = 0; i < 2000; ++i) setup.add(h, kSettled);  // enough to be reviewed
  setup.pruning.mark_edge(h, 0);
  CHECK(setup.finish().size() == 0);
}

TEST_CASE("a face is settled only when no window to come can hold a shorter path to it") {
  Setup setup(KeepWindows::near_bisectors);
  const HalfedgeId h = setup.inner_halfedge();
  // The longest side is sqrt(2): at 1 + sqrt(2) / sqrt(3), the paths through the corners beat all that comes.
  for (int i = 0; i < 2000; ++i) setup.add(h, 1.8);
  setup.pruning.mark_edge(h, 0);
  CHECK(setup.finish().size() == 2000);
}

}  // namespace gvd::test_window_pruning
