#include <cmath>

#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "tables.hpp"

namespace gvd::test_tables {

using namespace paper;

nlohmann::json measure_table(const std::string& key, double scale, int* reported = nullptr) {
  const auto count = [&](const std::string&) {
    if (reported != nullptr) ++*reported;
  };
  const Evaluation evaluation{Models({}, scale), 1, count};
  for (const Table& table : list_tables()) {
    if (table.key == key) return table.measure(evaluation);
  }
  return {};
}

TEST_CASE("there are tables 1 to 5, E at ten sets, and figure 10") {
  std::vector<std::string> keys;
  for (const Table& table : list_tables()) keys.push_back(table.key);
  CHECK(keys == std::vector<std::string>{"1", "2", "3", "4", "sets", "5", "fig10", "why"});
}

TEST_CASE("a row says which mesh it is of, and each method has finite figures") {
  int reported = 0;
  const nlohmann::json rows = measure_table("5", 0.05, &reported);
  REQUIRE(rows.size() == 5);
  CHECK(reported == 5);
  CHECK(rows[0]["mesh"] == "icosphere");
  CHECK(rows[0]["faces"] == 1280);
  CHECK(rows[1]["model"] == "Spot");
  CHECK(rows[1]["mesh"] == "figure.obj, resampled");
  CHECK(rows[4]["mesh"] == "plate.stl");
  for (const nlohmann::json& row : rows) {
    REQUIRE(row["methods"].size() >= 5);
    for (const nlohmann::json& method : row["methods"]) {
      CAPTURE(row["model"], method["method"]);
      CHECK(std::isfinite(method["e"]["mean"].get<double>()));
      CHECK(method["total_ms"].get<double>() > 0);
    }
  }
}

TEST_CASE("table 3 has a bad, a middling and a good mesh of each model") {
  const nlohmann::json rows = measure_table("3", 0.2);
  REQUIRE(rows.size() == 9);
  for (std::size_t i = 0; i < rows.size(); i += 3) {
    CHECK(rows[i]["quality"] == "low");
    CHECK(rows[i + 2]["quality"] == "high");
    CHECK(rows[i]["q_average"] < rows[i + 1]["q_average"]);
    CHECK(rows[i]["percent_below_30"] > rows[i + 2]["percent_below_30"]);
  }
}

TEST_CASE("what else could be taken for E is measured for each method") {
  const nlohmann::json rows = measure_table("why", 0.05);
  REQUIRE(rows.size() == 3);
  for (const nlohmann::json& row : rows) {
    REQUIRE(row["methods"].size() == 6);
    for (const nlohmann::json& method : row["methods"]) {
      CAPTURE(row["model"], method["method"]);
      CHECK(method["of_face"].get<double>() >= 0.9 * method["e"].get<double>());
      CHECK(method["distance"] > method["e"]);
      CHECK(method["by_marching"].get<double>() > 0);
    }
  }
}

TEST_CASE("table 2 has more and more generators on one mesh") {
  const nlohmann::json rows = measure_table("2", 0.05);
  REQUIRE(rows.size() == 7);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    CHECK(rows[i]["m"] >= rows[i - 1]["m"]);
    CHECK(rows[i]["faces"] == rows[0]["faces"]);
    CHECK(rows[i]["methods"][0]["memory_kb"].get<double>() > 0);
  }
}

TEST_CASE("a statistic has mean, deviation of the sample, least and most") {
  const Statistic found = summarize({1, 2, 6});
  CHECK(found.mean == Approx(3));
  CHECK(found.deviation == Approx(std::sqrt(7.0)));
  CHECK(found.least == 1);
  CHECK(found.most == 6);
}

TEST_CASE("a statistic of one value has no deviation, of none is zero") {
  CHECK(summarize({4}).mean == 4);
  CHECK(summarize({4}).deviation == 0);
  CHECK(summarize({}).mean == 0);
}

TEST_CASE("an experiment measures every method, with errors and memory where they are asked for") {
  const Mesh sphere = test::make_sphere(2);
  const std::vector<Comparator> methods = list_comparators({{}, false});
  const std::vector<Measurement> all = measure({sphere, 6, 2, true, true}, methods);
  REQUIRE(all.size() == methods.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(all[i].method);
    CHECK(all[i].method == methods[i].name);
    CHECK(all[i].field_ms[0] + all[i].diagram_ms[0] > 0);
    CHECK(all[i].memory_kb > 0);
    CHECK(summarize(all[i].errors).most >= summarize(all[i].errors).least);
    CHECK(summarize(all[i].turn_per_length).mean > 0);
  }
  CHECK(summarize(all[0].errors).mean < summarize(all[1].errors).mean);  // exact is better than growth
  const std::vector<Measurement> times = measure({sphere, 6, 1, false, false}, methods);
  CHECK(times[1].errors.empty());
  CHECK(times[1].memory_kb == 0);
}

TEST_CASE("runs draw generators of different seeds") {
  const Mesh sphere = test::make_sphere(2);
  const std::vector<Comparator> methods = list_comparators({{}, false});
  const Measurement found = measure({sphere, 6, 3, true, false}, methods)[1];
  CHECK(summarize(found.errors).deviation > 0);
  REQUIRE(found.errors.size() == 3);
  CHECK(summarize(found.errors).mean == Approx((found.errors[0] + found.errors[1] + found.errors[2]) / 3));
}

TEST_CASE("what else could be taken for E is the mean of all runs, with the same E") {
  const Mesh sphere = test::make_sphere(2);
  const std::vector<Comparator> methods = list_comparators({{}, false});
  const std::vector<Measurement> others = measure({sphere, 6, 2, true, false, true}, methods);
  const std::vector<Measurement> all = measure({sphere, 6, 2, true, false}, methods);
  REQUIRE(others.size() == methods.size());
  for (std::size_t i = 0; i < methods.size(); ++i) {
    CAPTURE(methods[i].name);
    CHECK(others[i].method == methods[i].name);
    CHECK(summarize(others[i].errors).mean == Approx(summarize(all[i].errors).mean));
    CHECK(summarize(others[i].distance).mean > summarize(others[i].errors).mean);
  }
}

}  // namespace gvd::test_tables
