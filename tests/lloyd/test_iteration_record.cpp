// The energies of a relaxation, measured anew and merged.
#include "iteration_record.hpp"
#include "support/catch.hpp"

namespace gvd::test_iteration_record {

const Precision kWithoutDiagram{{}, true};

/// A record with the energies 10, 9, 8.5, 8.4, where the only generator moved by 1 each time.
IterationRecord make_record() {
  IterationRecord record;
  record.initial_energy = 10;
  GeneratorMove move;
  move.length = {1};
  move.scale = 0.5;
  move.held = 3;
  move.by = Acceleration::lbfgs;
  record.add(move, 10, 9, kWithoutDiagram);
  record.add(move, 9, 8.5, kWithoutDiagram);
  record.add(move, 8.5, 8.4, kWithoutDiagram);
  return record;
}

TEST_CASE("iteration record: an iteration has what its move has") {
  const IterationRecord record = make_record();
  REQUIRE(record.iterations.size() == 3);
  CHECK(record.iterations[1].energy == 8.5);
  CHECK(record.iterations[1].largest_move == 1);
  CHECK(record.iterations[1].scale == 0.5);
  CHECK(record.iterations[1].held == 3);
  CHECK(record.iterations[1].by == Acceleration::lbfgs);
  CHECK(record.iterations[1].is_sampled);
}

TEST_CASE("iteration record: the sum of the last falls is known once there are as many") {
  const IterationRecord record = make_record();  // falls of 0.1, 0.056 and 0.012
  CHECK(record.sum_falls(3) == Approx(0.1 + 0.5 / 9 + 0.1 / 8.5));
  CHECK(record.sum_falls(1) == Approx(0.1 / 8.5));
  CHECK(!record.sum_falls(4));
}

TEST_CASE("iteration record: energies fall after one is measured anew, too") {
  for (const double energy : {8.3, 8.45, 8.5, 8.7, 9.5}) {
    CAPTURE(energy);
    IterationRecord record = make_record();
    record.restate(energy, Precision());
    CHECK(record.iterations.back().energy == energy);
    CHECK_FALSE(record.iterations.back().is_sampled);
    double before = record.initial_energy, path = 0;
    for (const LloydIteration& i : record.iterations) {
      CHECK(i.energy < before);
      before = i.energy;
      path += i.largest_move;
    }
    CHECK(path == 3);
  }
  IterationRecord empty;
  empty.restate(5, Precision());
  CHECK(empty.initial_energy == 5);
  CHECK(empty.iterations.empty());
}

TEST_CASE("iteration record: all iterations become one") {
  IterationRecord record = make_record();
  record.merge_all();
  REQUIRE(record.iterations.size() == 1);
  CHECK(record.iterations[0].mean_move == 3);
}

}  // namespace gvd::test_iteration_record
