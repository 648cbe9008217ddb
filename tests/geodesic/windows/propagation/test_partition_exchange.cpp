#include <cmath>
#include <vector>

#include "geodesic/windows/propagation/partition_exchange.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_partition_exchange {

TEST_CASE("messages come a round later, in the order of the senders") {
  Mailboxes mailboxes(3);
  mailboxes.to_send(PartitionId(2), PartitionId(0)).multi_label_faces = {FaceId(20), FaceId(21)};
  mailboxes.to_send(PartitionId(1), PartitionId(0)).multi_label_faces = {FaceId(10)};
  CHECK_FALSE(mailboxes.has_come());
  mailboxes.deliver();
  CHECK(mailboxes.has_come());
  CHECK(mailboxes.count_for(PartitionId(0)) == 3);
  CHECK(mailboxes.count_for(PartitionId(1)) == 0);
  std::vector<FaceId> received;
  mailboxes.for_each_received(PartitionId(0), [&](PartitionMessages& from) {
    received.insert(received.end(), from.multi_label_faces.begin(), from.multi_label_faces.end());
    from.clear();
  });
  CHECK(received == std::vector<FaceId>{FaceId(10), FaceId(20), FaceId(21)});
  mailboxes.deliver();
  CHECK_FALSE(mailboxes.has_come());
}

TEST_CASE("mailboxes know the least key of what has come") {
  Mailboxes mailboxes(2);
  PartitionMessages& messages = mailboxes.to_send(PartitionId(0), PartitionId(1));
  messages.paths.push_back({VertexCopyId(3), {2.5, GeneratorId(0), {}}});
  messages.least_key = 2.5;
  CHECK(std::isinf(mailboxes.least_key()));
  mailboxes.deliver();
  CHECK(mailboxes.least_key() == 2.5);
  mailboxes.for_each_received(PartitionId(1), [](PartitionMessages& received) { received.clear(); });
  mailboxes.deliver();
  CHECK(std::isinf(mailboxes.least_key()));
}

struct Received {
  std::vector<FaceId> faces;
  std::vector<VertexCopyId> vertices;
  std::vector<Window> windows;
  bool windows_came_last = true;

  void receive_multi_label_face(FaceId f) { note(faces, f); }
  void receive_path(VertexCopyId v, const VertexPath&) { note(vertices, v); }
  void receive_window(const PropagatedWindow& w) { windows.push_back(w.window); }
  template <class T>
  void note(std::vector<T>& list, const T& item) {
    windows_came_last = windows_came_last && windows.empty();
    list.push_back(item);
  }
};

/// A mesh in partitions, with their mailboxes.
struct Setup {
  Setup()
      : mesh(test::make_grid(8, 8)),
        frames(mesh, ParallelChunks(1, {})),
        partitions(mesh, 30, frames),
        mailboxes(partitions.count()),
        last_sent(partitions.shared_count()) {}

  PartitionExchange exchange(PartitionId own) { return {partitions, mailboxes, last_sent, own}; }
  Received receive(PartitionId own) {
    Received received;
    exchange(own).receive(received);
    return received;
  }
  /// A vertex that several partitions have.
  VertexCopyId shared_vertex() const {
    VertexCopyId v(0);
    while (!partitions.shared(v).valid()) v = VertexCopyId(v.value() + 1);
    return v;
  }

  Mesh mesh;
  FaceFrames frames;
  MeshPartitions partitions;
  Mailboxes mailboxes;
  IdVector<SharedCopyId, LastSent> last_sent;
};

TEST_CASE("a path to a shared vertex reaches all of its other copies") {
  Setup setup;
  const VertexCopyId v = setup.shared_vertex();
  const auto copies = setup.partitions.copies(setup.partitions.shared(v));
  REQUIRE(copies.size() > 1);
  const PartitionId sender = copies.front().partition;
  setup.exchange(sender).send_path(v, {1.5, GeneratorId(0), {}});
  setup.mailboxes.deliver();
  CHECK(setup.mailboxes.least_key() == 1.5);
  for (const auto& copy : copies) {
    const Received received = setup.receive(copy.partition);
    if (copy.partition == sender) {
      CHECK(received.vertices.empty());
    } else {
      CHECK(received.vertices == std::vector<VertexCopyId>{copy.vertex});
    }
  }
}

TEST_CASE("a path to a vertex of one partition alone is sent to no other") {
  Setup setup;
  VertexCopyId v(0);
  while (setup.partitions.shared(v).valid()) v = VertexCopyId(v.value() + 1);
  setup.exchange(PartitionId(0)).send_path(v, {1.5, GeneratorId(0), {}});
  setup.mailboxes.deliver();
  CHECK_FALSE(setup.mailboxes.has_come());
}

TEST_CASE("windows and faces go to their partition, paths before windows, and are received once") {
  Setup setup;
  HalfedgeId h(0);
  const PartitionId sender = setup.partitions.of_halfedge(h);
  while (setup.partitions.of_halfedge(h) == sender) h = HalfedgeId(h.value() + 1);
  const PartitionId receiver = setup.partitions.of_halfedge(h);
  PartitionExchange exchange = setup.exchange(sender);
  CHECK(exchange.is_own(HalfedgeId(0)));
  CHECK_FALSE(exchange.is_own(h));
  CHECK_FALSE(exchange.is_own(Mesh::face(h)));
  exchange.send_window({0, 1, 0, 1, 0, GeneratorId(4), h}, {1, 0, FaceId()}, 0.75);
  exchange.send_multi_label_face(Mesh::face(h));
  setup.mailboxes.deliver();
  CHECK(setup.mailboxes.least_key() == 0.75);
  const Received received = setup.receive(receiver);
  REQUIRE(received.windows.size() == 1);
  CHECK(received.windows[0].generator == GeneratorId(4));
  CHECK(received.faces == std::vector<FaceId>{Mesh::face(h)});
  CHECK(received.windows_came_last);
  const Received again = setup.receive(receiver);
  CHECK(again.windows.empty());
  CHECK(again.faces.empty());
}

TEST_CASE("a shared vertex sends again for a path that is shorter beyond rounding, or of another generator") {
  Setup setup;
  const VertexCopyId v = setup.shared_vertex();
  PartitionExchange exchange = setup.exchange(setup.partitions.copies(setup.partitions.shared(v)).front().partition);
  CHECK(exchange.record_sending(v, {1, GeneratorId(0), {}}));
  CHECK_FALSE(exchange.record_sending(v, {1 - 2e-16, GeneratorId(0), {}}));
  CHECK(exchange.record_sending(v, {1 - 1e-13, GeneratorId(0), {}}));
  CHECK(exchange.record_sending(v, {1, GeneratorId(1), {}}));
}

}  // namespace gvd::test_partition_exchange
