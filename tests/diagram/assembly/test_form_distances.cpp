#include <cmath>
#include <type_traits>

#include "diagram/assembly/form_distances.hpp"
#include "support/assembled_face.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_form_distances {

const GeneratorId kA(0), kB(1), kC(2);

TEST_CASE("forms that are equal everywhere, or nowhere, have no equidistant point") {
  const std::vector<DistanceForm> same{test::form(0, 1, 1, 1), test::form(1, 1, 1, 1), test::form(2, 1, 1, 1)};
  CHECK_FALSE(FormDistances(same).equidistant(kA, kB, kC, {}));
  const std::vector<DistanceForm> parallel{test::form(0, 0, 0, 0), test::form(1, 1, 1, 1), test::form(2, 2, 2, 2)};
  CHECK_FALSE(FormDistances(parallel).equidistant(kA, kB, kC, {}));
}

TEST_CASE("a form finds its generator among those that are given, which need not be all") {
  const std::vector<DistanceForm> forms{test::form(3, 1, 2, 3), test::form(7, 4, 5, 6)};
  const FormDistances distances(forms);
  CHECK(distances.at(GeneratorId(3), {1, 0, 0}) == 1);
  CHECK(distances.at(GeneratorId(7), {0, 0.5, 0.5}) == 5.5);
}

static_assert(!std::is_base_of_v<FacePaths, FormDistances>, "forms confirm nothing and know no paths");

TEST_CASE("at the equidistant point of random forms the three values are equal") {
  test::Random random(1);
  const auto any = [&](int g) { return test::form(g, random.real(0, 1), random.real(0, 1), random.real(0, 1)); };
  for (int i = 0; i < 2000; ++i) {
    const std::vector<DistanceForm> forms{any(0), any(1), any(2)};
    const FormDistances distances(forms);
    const auto p = distances.equidistant(kA, kB, kC, {});
    if (!p || std::abs((*p)[0]) + std::abs((*p)[1]) > 100) continue;
    REQUIRE(distances.at(kA, *p) == Approx(distances.at(kB, *p)).margin(1e-9));
    REQUIRE(distances.at(kA, *p) == Approx(distances.at(kC, *p)).margin(1e-9));
    REQUIRE((*p)[0] + (*p)[1] + (*p)[2] == Approx(1));
  }
}

TEST_CASE("with circles the difference of two forms is that of the squared distances to two point sources") {
  const std::array<Vec2, 3> corner{Vec2(0, 0), Vec2(2, 0), Vec2(0.5, 1.5)};
  const auto form_of = [&](int g, const Vec2& source) {
    return test::form(g, form_value(Front::circle, (source - corner[0]).norm()),
                      form_value(Front::circle, (source - corner[1]).norm()),
                      form_value(Front::circle, (source - corner[2]).norm()));
  };
  const Vec2 a(-1, 0.3), b(2, 2);
  const DistanceForm first = form_of(0, a), second = form_of(1, b);
  const Bary bary{0.2, 0.5, 0.3};
  const Vec2 p = interpolate(bary, corner[0], corner[1], corner[2]);
  CHECK(first.at(bary) - second.at(bary) == Approx((p - a).squaredNorm() - (p - b).squaredNorm()).epsilon(1e-13));
  CHECK(form_value(Front::planar, 3) == 3);
  CHECK(form_value(Front::circle, 3) == 9);
  CHECK(form_value(Front::circle, -3) == -9);
}

}  // namespace gvd::test_form_distances
