#include <cmath>

#include "comparators.hpp"
#include "measure.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_measure {

using namespace paper;

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
    CHECK(all[i].field_ms + all[i].diagram_ms > 0);
    CHECK(all[i].memory_kb > 0);
    CHECK(all[i].error.most >= all[i].error.least);
    CHECK(all[i].turn_per_length > 0);
  }
  CHECK(all[0].error.mean < all[1].error.mean);  // exact is better than growth
  const std::vector<Measurement> times = measure({sphere, 6, 1, false, false}, methods);
  CHECK(times[1].error.most == 0);
  CHECK(times[1].memory_kb == 0);
}

TEST_CASE("runs draw generators of different seeds") {
  const Mesh sphere = test::make_sphere(2);
  const std::vector<Comparator> methods = list_comparators({{}, false});
  const Measurement found = measure({sphere, 6, 3, true, false}, methods)[1];
  CHECK(found.error.deviation > 0);
  REQUIRE(found.errors.size() == 3);
  CHECK(found.error.mean == Approx((found.errors[0] + found.errors[1] + found.errors[2]) / 3));
}

TEST_CASE("what else could be taken for E is the mean of all runs, with the same E") {
  const Mesh sphere = test::make_sphere(2);
  const std::vector<Comparator> methods = list_comparators({{}, false});
  const std::vector<OtherMeasurement> others = measure_others({sphere, 6, 2}, methods);
  const std::vector<Measurement> all = measure({sphere, 6, 2, true, false}, methods);
  REQUIRE(others.size() == methods.size());
  for (std::size_t i = 0; i < methods.size(); ++i) {
    CAPTURE(methods[i].name);
    CHECK(others[i].method == methods[i].name);
    CHECK(others[i].error == Approx(all[i].error.mean));
    CHECK(others[i].others.distance > others[i].error);
  }
}

}  // namespace gvd::test_measure
