#include <cmath>
#include <vector>

#include "geodesic/windows/propagation/partition_messages.hpp"
#include "support/catch.hpp"

namespace gvd::test_partition_messages {

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

}  // namespace gvd::test_partition_messages
