#include <cmath>

#include "geodesic/windows/window.hpp"
#include "support/catch.hpp"

namespace gvd::test_window {

TEST_CASE("the distances of a window are those from its image, and from its generator") {
  const Window w{1, 3, 0, 1, 10, GeneratorId(0), HalfedgeId(0)};
  CHECK(w.squared_image_distance(2) == 5);
  CHECK(w.image_distance(2) == std::sqrt(5.0));
  CHECK(w.distance(2) == 10 + std::sqrt(5.0));
}

TEST_CASE("the least distance to a window's interval is at the image's foot, or at the end next to it") {
  const auto least = [](double x) {
    return Window{1, 3, x, 2, 10, GeneratorId(0), HalfedgeId(0)}.least_image_distance();
  };
  CHECK(least(2) == 2);
  CHECK(least(0) == std::sqrt(5.0));
  CHECK(least(4) == std::sqrt(5.0));
}

}  // namespace gvd::test_window
