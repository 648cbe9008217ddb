#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "gvd/error.hpp"
#include "peer_figures.hpp"
#include "support/catch.hpp"

namespace gvd::test_peer_figures {

using namespace bench;

std::vector<PeerRun> all_runs() { return read_peer_runs(GVD_SOURCE_DIR "/bench/remesh/peers.tsv"); }

TEST_CASE("each program has a run of each model") {
  std::map<std::pair<std::string, int>, std::set<std::string>> models;
  for (const PeerRun& run : all_runs()) {
    CHECK(models[{run.program, run.vertices}].insert(run.model).second);
    CHECK(run.quality.rms <= run.quality.hausdorff);
    CHECK(run.quality.q > 0);
    CHECK(run.quality.q <= 1);
  }
  CHECK(models.size() == 11);  // three programs with three numbers of vertices, QEM with two
  for (const auto& [of, names] : models) CHECK(names.size() == 9);
}

TEST_CASE("a mesh has the runs of the model that its name begins with") {
  const auto runs = all_runs();
  CHECK(runs_on(runs, "bunny_69k_boundary", 100).size() == 3);
  CHECK(runs_on(runs, "spot.m30", 500).size() == 4);
  CHECK(runs_on(runs, "knot1", 2000).size() == 4);
  CHECK(runs_on(runs, "spotless", 500).empty());
  CHECK(runs_on(runs, "spot", 300).empty());
}

TEST_CASE("a line without all fields is refused") {
  const auto path = std::filesystem::temp_directory_path() / "gvd_test_peers.tsv";
  std::ofstream(path) << "head\n100\tspot\tACVD\tright\t1.0\n";
  CHECK_THROWS_AS(read_peer_runs(path.string()), Error);
  std::filesystem::remove(path);
  CHECK_THROWS_AS(read_peer_runs(path.string()), Error);
}

TEST_CASE("a figure is compared with the best of the peers") {
  const std::vector<PeerValues> peers{{"A", {3.0, 0.5}}, {"B", {2.0, 0.25}}, {"C", {std::nullopt, 0.75}}};
  const ComparedFigure distance{"distance", true, 1}, quality{"quality", false, 3};
  CHECK(compare_with_best(1.5, peers, 0, distance) == "ahead by 0.5");
  CHECK(compare_with_best(2, peers, 0, distance) == "level");
  CHECK(compare_with_best(2.5, peers, 0, distance) == "behind B by 0.5");
  CHECK(compare_with_best(0.875, peers, 1, quality) == "ahead by 0.125");
  CHECK(compare_with_best(0.5, peers, 1, quality) == "behind C by 0.250");
  CHECK(compare_with_best(1, {{"A", {std::nullopt}}}, 0, distance).empty());
  CHECK(compare_with_best(1, peers, 0, {"time", true, 1, false}).empty());
}

TEST_CASE("totals have worst figures, means, and the sum of the times") {
  RemeshQuality good{true, 1, 2, 1, 0.9, 30, 0, 0, 1, {}}, poor{false, 1.5, 4, 3, 0.7, 10, 5, 2, 3, 50};
  const FigureValues totals = totals_of({good, poor});
  CHECK(totals == FigureValues{1, 1.5, 3, 2, 0.8, 2.5, 10, 2, 4, 50});
  CHECK_FALSE(totals_of({good}).back());
  for (const auto& value : totals_of({})) CHECK_FALSE(value);
  CHECK(totals.size() == compared_totals().size());
  CHECK(values_of(good).size() == compared_figures().size());
}

}  // namespace gvd::test_peer_figures
