#include <algorithm>
#include <memory>
#include <vector>

#include "geodesic/windows/propagation/propagation_rounds.hpp"
#include "support/catch.hpp"

namespace gvd::test_propagation_rounds {

constexpr double kWidth = 1;

/// A partition whose items are whole keys. An item at a key tells the next partition, which takes it as an item.
class Relay {
 public:
  Relay(Mailboxes& mailboxes, int own, int count, std::vector<double> items, double step)
      : mailboxes_(mailboxes), own_(own), next_((own + 1) % count), items_(std::move(items)), step_(step) {}

  void run_round(double settled) {
    settled_.push_back(settled);
    mailboxes_.for_each_received(PartitionId(own_), [&](PartitionMessages& messages) {
      for (const auto& sent : messages.paths) items_.push_back(sent.path.distance);
      messages.clear();
    });
    for (const double key : items_) {
      if (key >= front_ + kWidth) continue;
      taken.push_back(key);
      if (key + step_ > kLast) continue;
      PartitionMessages& messages = mailboxes_.to_send(PartitionId(own_), PartitionId(next_));
      messages.paths.push_back({VertexCopyId(0), {key + step_, GeneratorId(0), {}}});
      messages.least_key = std::min(messages.least_key, key + step_);
    }
    std::erase_if(items_, [&](double key) { return key < front_ + kWidth; });
  }
  void end_bucket(double, std::size_t steps) {
    CHECK(waits_now() == 0);
    front_ += kWidth * static_cast<double>(steps);
  }
  std::size_t waits_now() const {
    return static_cast<std::size_t>(
        std::count_if(items_.begin(), items_.end(), [&](double key) { return key < front_ + kWidth; }));
  }
  bool waits() const { return !items_.empty(); }
  std::size_t steps_to_next() const {
    if (items_.empty()) return 1000;
    return static_cast<std::size_t>(*std::min_element(items_.begin(), items_.end()) - front_);
  }
  double front() const { return front_; }

  std::vector<double> taken;
  static constexpr double kLast = 20;

 private:
  Mailboxes& mailboxes_;
  int own_, next_;
  std::vector<double> items_;
  double step_;
  double front_ = 0;
  std::vector<double> settled_;
};

TEST_CASE("rounds go on until no partition and no message waits, and skip empty buckets") {
  for (const double step : {0.25, 1.0, 3.0, 7.0}) {
    CAPTURE(step);
    const Progress silent;
    Mailboxes mailboxes(3);
    std::vector<std::unique_ptr<Relay>> partitions;
    for (int i = 0; i < 3; ++i) {
      partitions.push_back(
          std::make_unique<Relay>(mailboxes, i, 3, i == 0 ? std::vector<double>{0} : std::vector<double>{}, step));
    }
    int reports = 0;
    const ParallelChunks parallel(1, silent);
    PropagationRounds<Relay>(partitions, mailboxes, kWidth, parallel).run(kInfinity, [&] { ++reports; });
    // One item travels round the partitions, from key to key.
    std::vector<double> taken;
    for (const auto& partition : partitions) {
      CHECK(std::is_sorted(partition->taken.begin(), partition->taken.end()));
      taken.insert(taken.end(), partition->taken.begin(), partition->taken.end());
    }
    std::sort(taken.begin(), taken.end());
    REQUIRE(taken.size() == static_cast<std::size_t>(Relay::kLast / step) + 1);
    for (std::size_t i = 0; i < taken.size(); ++i) CHECK(taken[i] == static_cast<double>(i) * step);
    CHECK(reports >= static_cast<int>(taken.size()));
  }
}

TEST_CASE("an exception from the report ends the rounds") {
  const Progress silent;
  Mailboxes mailboxes(1);
  std::vector<std::unique_ptr<Relay>> partitions;
  partitions.push_back(std::make_unique<Relay>(mailboxes, 0, 1, std::vector<double>{0}, 1));
  const ParallelChunks parallel(1, silent);
  PropagationRounds<Relay> rounds(partitions, mailboxes, kWidth, parallel);
  CHECK_THROWS_AS(rounds.run(kInfinity, [] { throw 7; }), int);
  CHECK(partitions[0]->taken.size() == 1);
}

}  // namespace gvd::test_propagation_rounds
