#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "geodesic/windows/propagation/partition_propagator.hpp"
#include "support/catch.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_partition_propagator {

constexpr std::int32_t kOnePartition = 1000;

/// A convex mesh in the plane, so that every distance is Euclid's, and the propagators of its partitions.
struct Setup {
  explicit Setup(Mesh of_mesh, std::int32_t partition_faces = kOnePartition, KeepWindows keep = KeepWindows::all)
      : mesh(std::move(of_mesh)), parallel(1, silent), state(mesh, {keep, {}, 1, partition_faces}, parallel) {
    for (std::int32_t i = 0; i < state.partitions.count(); ++i) {
      partitions.push_back(std::make_unique<PartitionPropagator>(state, PartitionId(i)));
    }
  }

  PartitionPropagator& only() {
    REQUIRE(partitions.size() == 1);
    return *partitions.front();
  }
  PartitionPropagator& of(PartitionId i) { return *partitions[i.index()]; }
  double distance(VertexCopyId v) const { return state.labels.distance[v]; }
  GeneratorId label(VertexCopyId v) const { return state.labels.label[v]; }
  double straight(VertexId v, const Vec3& p) const { return (mesh.position(v) - p).norm(); }

  void start(VertexId v, GeneratorId g) {
    const SharedCopyId shared = state.partitions.shared(first_copy(v));
    if (!shared.valid()) {
      of(state.partitions.of_halfedge(mesh.halfedge(v))).start_vertex(first_copy(v), g, 0);
      return;
    }
    for (const auto& copy : state.partitions.copies(shared)) of(copy.partition).start_vertex(copy.vertex, g, 0);
  }

  /// Rounds, bucket after bucket, until nothing waits. The partitions of each round work in this order, or in reverse.
  void run(bool reversed = false) {
    std::vector<PartitionPropagator*> order;
    for (const auto& partition : partitions) order.push_back(partition.get());
    if (reversed) std::reverse(order.begin(), order.end());
    const auto waits = [](const PartitionPropagator* partition) { return partition->waits(); };
    while (state.mailboxes.has_come() || std::any_of(order.begin(), order.end(), waits)) {
      for (PartitionPropagator* partition : order) partition->run_round(0);
      state.mailboxes.deliver();
      if (state.mailboxes.least_key() < order.front()->front() + state.bucket_width) continue;
      for (PartitionPropagator* partition : order) partition->end_bucket(0, 1);
    }
  }

  Mesh mesh;
  Progress silent;
  ParallelChunks parallel;
  PropagationState state;
  std::vector<std::unique_ptr<PartitionPropagator>> partitions;
};

/// Two faces on both sides of the edge from (0, 0) to (1, 1). The vertices 1 and 2 lie in one face each.
Mesh make_square() { return test::make_jittered_grid(1, 1, 0, 1); }

Mesh make_plane() { return test::make_jittered_grid(6, 5, 0.2, 3); }

std::vector<Window> list_windows(const KeptWindows& kept) {
  std::vector<Window> windows;
  for (std::size_t i = 0; i < kept.windows.size(); ++i) windows.push_back(kept.windows[i]);
  return windows;
}

/// The point t of a window's frame: on the boundary the origin is the end of its halfedge (window.hpp).
Vec3 point_on_edge(const Mesh& mesh, const Window& w, double t) {
  const Vec3 from = mesh.position(mesh.from(w.halfedge)), to = mesh.position(mesh.to(w.halfedge));
  const double share = t / (to - from).norm();
  const bool is_boundary = !mesh.twin(w.halfedge).valid();
  return is_boundary ? Vec3(to + share * (from - to)) : Vec3(from + share * (to - from));
}

/// An edge between two partitions.
struct Border {
  HalfedgeId halfedge;  ///< of the receiver
  PartitionId sender, receiver;
  VertexCopyId sent, received;  ///< the copies of the vertex that `halfedge` leaves
};

VertexCopyId copy_in(const MeshPartitions& partitions, VertexId v, PartitionId partition) {
  for (const auto& copy : partitions.copies(partitions.shared(first_copy(v)))) {
    if (copy.partition == partition) return copy.vertex;
  }
  return VertexCopyId();
}

Border find_border(const Setup& setup) {
  const MeshPartitions& partitions = setup.state.partitions;
  for (std::int32_t i = 0; i < setup.mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i), twin = setup.mesh.twin(h);
    if (!twin.valid() || partitions.of_halfedge(h) == partitions.of_halfedge(twin)) continue;
    const PartitionId sender = partitions.of_halfedge(twin), receiver = partitions.of_halfedge(h);
    const VertexId v = setup.mesh.from(h);
    return {h, sender, receiver, copy_in(partitions, v, sender), copy_in(partitions, v, receiver)};
  }
  return {};
}

TEST_CASE("one partition finds Euclid's distances from a vertex of the plane, which sends windows once") {
  for (const int generator : {0, 10, 41}) {
    Setup setup(make_plane());
    const VertexId from(generator);
    setup.start(from, GeneratorId(7));
    setup.run();
    for (std::int32_t i = 0; i < setup.mesh.vertex_count(); ++i) {
      const VertexCopyId v = first_copy(VertexId(i));
      CHECK(setup.distance(v) == Approx(setup.straight(from, setup.mesh.position(VertexId(i)))).epsilon(1e-14));
      CHECK(setup.label(v) == GeneratorId(7));
    }
    CHECK(setup.only().events() == 1);
    CHECK_FALSE(setup.only().waits());
  }
}

TEST_CASE("the windows that one partition keeps hold Euclid's distances, and lie on every edge that paths cross") {
  Setup setup(make_plane());
  const VertexId from(10);
  setup.start(from, GeneratorId(0));
  setup.run();
  const std::vector<Window> windows = list_windows(setup.only().finish());
  for (const Window& w : windows) {
    for (const double t : {w.begin, (w.begin + w.end) / 2, w.end}) {
      CHECK(w.distance(t) == Approx(setup.straight(from, point_on_edge(setup.mesh, w, t))).epsilon(1e-13));
    }
  }
  // Only the edges at the generator have no windows: paths run along them and cross none.
  std::vector<char> crossed(static_cast<std::size_t>(setup.mesh.edge_count()), 0);
  for (const Window& w : windows) crossed[setup.mesh.edge(w.halfedge).index()] = 1;
  for (std::int32_t i = 0; i < setup.mesh.edge_count(); ++i) {
    const HalfedgeId h = setup.mesh.halfedge(EdgeId(i));
    if (setup.mesh.from(h) == from || setup.mesh.to(h) == from) CHECK_FALSE(crossed[EdgeId(i).index()]);
  }
  CHECK(std::count(crossed.begin(), crossed.end(), 1) > setup.mesh.edge_count() / 2);
}

TEST_CASE("a window is counted when it is carried across a face, and kept only if the options ask for it") {
  for (const KeepWindows keep : {KeepWindows::all, KeepWindows::none}) {
    Setup across(make_square(), kOnePartition, keep);
    across.start(VertexId(1), GeneratorId(0));  // its window on the diagonal crosses the other face
    across.run();
    CHECK(across.only().carried() == 1);
    // The window on the diagonal, and the two into which the far vertex splits it, on the boundary.
    CHECK(across.only().finish().windows.size() == (keep == KeepWindows::all ? 3 : 0));
    Setup beside(make_square(), kOnePartition, keep);
    beside.start(VertexId(0), GeneratorId(0));  // on the diagonal: its windows come to the boundary at once
    beside.run();
    CHECK(beside.only().carried() == 0);
    CHECK(beside.only().finish().windows.size() == (keep == KeepWindows::all ? 2 : 0));
  }
}

TEST_CASE("a generator at a vertex with a shorter path starts nothing, before the first round and after") {
  Setup setup(make_plane());
  PartitionPropagator& only = setup.only();
  only.start_vertex(VertexCopyId(10), GeneratorId(0), 0.5);
  only.start_vertex(VertexCopyId(10), GeneratorId(1), 0.75);
  only.start_vertex(VertexCopyId(12), GeneratorId(2), 100);  // waits until a path has come
  setup.run();
  CHECK(setup.label(VertexCopyId(10)) == GeneratorId(0));
  CHECK(setup.distance(VertexCopyId(10)) == 0.5);
  CHECK(setup.label(VertexCopyId(12)) == GeneratorId(0));
  CHECK(only.events() == 1);
}

TEST_CASE("a round takes the current bucket of the queue and nothing beyond it") {
  Setup setup(make_plane());
  PartitionPropagator& only = setup.only();
  only.run_round(0);  // nothing waits
  CHECK(only.events() == 0);
  CHECK(only.steps_to_next() == setup.state.bucket_count);

  const double width = setup.state.bucket_width;
  only.start_vertex(VertexCopyId(0), GeneratorId(0), 1.5 * width);
  only.start_vertex(VertexCopyId(41), GeneratorId(1), 3.5 * width);
  CHECK(only.waits());
  CHECK(only.waits_now() == 0);
  only.run_round(0);
  CHECK(only.events() == 0);
  REQUIRE(only.steps_to_next() == 1);
  only.end_bucket(0, 1);
  CHECK(only.front() == Approx(width));
  CHECK(only.waits_now() == 1);
  only.run_round(0);
  CHECK(only.events() == 1);
  CHECK(only.waits_now() == 0);
  CHECK(only.waits());  // the second generator, if no window
  CHECK(std::isinf(setup.distance(VertexCopyId(20))));
}

TEST_CASE("a partition that has done much work and has nothing left goes on with new messages") {
  Setup setup(test::make_jittered_grid(20, 20, 0.2, 3));
  PartitionPropagator& only = setup.only();
  setup.start(VertexId(0), GeneratorId(0));
  setup.run();
  REQUIRE(only.carried() > static_cast<std::int64_t>(setup.state.bucket_count));  // its memory was given back
  for (double& d : setup.state.labels.distance.raw()) d = std::numeric_limits<double>::infinity();
  setup.start(VertexId(440), GeneratorId(1));
  setup.run();
  for (std::int32_t i = 0; i < setup.mesh.vertex_count(); ++i) {
    const double expected = setup.straight(VertexId(440), setup.mesh.position(VertexId(i)));
    CHECK(setup.distance(VertexCopyId(i)) == Approx(expected).epsilon(1e-13));
  }
}

TEST_CASE("paths are received before windows, whichever was sent first, and each of them once") {
  for (const bool with_path : {true, false}) {
    Setup setup(make_plane(), 20);
    const Border border = find_border(setup);
    REQUIRE(border.halfedge.valid());
    PartitionExchange sender(setup.state.partitions, setup.state.mailboxes, setup.state.last_sent, border.sender);
    const double length = setup.mesh.length(setup.mesh.edge(border.halfedge));
    // Nearly straight down to the edge's start, for half an edge longer than the path there: that path beats it. One to
    // the edge's end would not.
    const double depth = length / 4;
    sender.send_window({0, length / 10, 0, depth, 1 + depth, GeneratorId(0), border.halfedge}, {1, 0, FaceId()}, 1);
    if (with_path) sender.send_path(border.sent, {1, GeneratorId(0), {}});
    setup.state.mailboxes.deliver();
    PartitionPropagator& receiver = setup.of(border.receiver);
    receiver.run_round(0);
    CHECK(receiver.waits() == !with_path);
    if (!with_path) continue;
    CHECK(setup.distance(border.received) == 1);
    CHECK(setup.label(border.received) == GeneratorId(0));
    setup.state.labels.distance[border.received] = 2;
    receiver.run_round(0);
    CHECK(setup.distance(border.received) == 2);
  }
}

TEST_CASE("a better path to a shared vertex is told to its other copies, and no other path is") {
  Setup setup(make_plane(), 20);
  const Border border = find_border(setup);
  REQUIRE(border.halfedge.valid());
  setup.of(border.sender).reach_vertex(border.sent, {1, GeneratorId(1), {}});
  setup.state.mailboxes.deliver();
  CHECK(setup.state.mailboxes.least_key() == 1);
  for (const auto& partition : setup.partitions) partition->run_round(0);
  CHECK(setup.distance(border.received) == 1);
  CHECK(setup.label(border.received) == GeneratorId(1));
  setup.state.mailboxes.deliver();
  CHECK_FALSE(setup.state.mailboxes.has_come());  // what was received is not told again
  setup.of(border.sender).reach_vertex(border.sent, {1, GeneratorId(2), {}});
  setup.of(border.sender).reach_vertex(border.sent, {1.5, GeneratorId(0), {}});
  setup.state.mailboxes.deliver();
  CHECK_FALSE(setup.state.mailboxes.has_come());
}

TEST_CASE("a vertex between partitions counts as one, and sends again only for a path that is really shorter") {
  Setup setup(make_plane(), 20);
  const Border border = find_border(setup);
  REQUIRE(border.halfedge.valid());
  setup.start(setup.mesh.from(border.halfedge), GeneratorId(0));
  setup.run();
  std::int64_t events = 0;
  for (const auto& partition : setup.partitions) events += partition->events();
  CHECK(events == 1);

  Setup again(make_plane(), 20);
  const VertexCopyId v = first_copy(again.mesh.from(border.halfedge));
  PartitionPropagator& first = again.of(again.state.partitions.copies(again.state.partitions.shared(v))[0].partition);
  for (const double d : {0.1, std::nextafter(0.1, 0.0), 0.1 - 1e-6}) {
    first.start_vertex(v, GeneratorId(0), d);
    first.run_round(0);
    CHECK(first.events() == (d < 0.1 - 1e-7 ? 2 : 1));
  }
}

TEST_CASE("the order of the received paths changes neither the label nor the distance of a vertex") {
  // Ties up to rounding: the first generator wins, with the shortest of its paths.
  const double below = std::nextafter(1.0, 0.0), above = std::nextafter(1.0, 2.0);
  std::vector<VertexPath> paths{{1, GeneratorId(1), {}},
                                {below, GeneratorId(1), {}},
                                {above, GeneratorId(0), {}},
                                {1, GeneratorId(0), {}},
                                {1.25, GeneratorId(0), {}}};
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  do {
    Setup setup(make_square());
    for (const std::size_t i : order) setup.only().receive_path(VertexCopyId(0), paths[i]);
    REQUIRE(setup.label(VertexCopyId(0)) == GeneratorId(0));
    REQUIRE(setup.distance(VertexCopyId(0)) == 1);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("the order in which the partitions work changes no label and no bit of a distance") {
  const auto run = [](bool reversed) {
    auto setup = std::make_unique<Setup>(test::make_jittered_grid(12, 12, 0, 1), 20);  // many vertices tie
    const std::array<int, 4> generators{0, 12, 84, 156};
    for (std::size_t g = 0; g < generators.size(); ++g) {
      setup->start(VertexId(generators[g]), GeneratorId(g));
    }
    setup->run(reversed);
    return setup;
  };
  const auto forward = run(false), backward = run(true);
  REQUIRE(forward->partitions.size() > 4);
  CHECK(forward->state.labels.distance == backward->state.labels.distance);
  CHECK(forward->state.labels.label == backward->state.labels.label);
  for (std::size_t i = 0; i < forward->partitions.size(); ++i) {
    CHECK(forward->partitions[i]->carried() == backward->partitions[i]->carried());
  }
  const MeshPartitions& partitions = forward->state.partitions;
  for (std::int32_t i = 0; i < forward->mesh.vertex_count(); ++i) {
    const SharedCopyId shared = partitions.shared(VertexCopyId(i));
    if (!shared.valid()) continue;
    for (const auto& copy : partitions.copies(shared)) {
      CHECK(forward->distance(copy.vertex) == forward->distance(VertexCopyId(i)));
      CHECK(forward->label(copy.vertex) == forward->label(VertexCopyId(i)));
    }
  }
}

TEST_CASE("vertex events are found by their ids, which are used again") {
  VertexEvents events;
  const auto event = [](int vertex) { return VertexEvent{VertexCopyId(vertex), false, {1.0 * vertex, {}, {}}}; };
  const VertexEventId a = events.add(event(10)), b = events.add(event(11));
  CHECK(a != b);
  CHECK(events.take(a).vertex == VertexCopyId(10));
  const VertexEventId c = events.add(event(12));
  CHECK(c == a);
  CHECK(events.take(b).path.distance == 11);
  CHECK(events.take(c).path.distance == 12);
  events.release();
  CHECK(events.take(events.add(event(13))).vertex == VertexCopyId(13));
}

TEST_CASE("a queue item is a halfedge or a vertex event") {
  for (const int i : {0, 1, 1 << 20}) {
    const QueueItem halfedge{HalfedgeId(i)}, event{VertexEventId(i)};
    CHECK(halfedge.is_halfedge());
    CHECK(halfedge.halfedge() == HalfedgeId(i));
    CHECK_FALSE(event.is_halfedge());
    CHECK(event.event() == VertexEventId(i));
  }
}

}  // namespace gvd::test_partition_propagator
