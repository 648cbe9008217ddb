#include <string>
#include <vector>

#include "diagram/evaluation/violations.hpp"
#include "support/catch.hpp"

namespace gvd::test_violations {

TEST_CASE("no violation: empty") {
  Violations violations;
  CHECK(violations.empty());
  CHECK(violations.take().empty());
}

TEST_CASE("a violation begins with its property, and then names the element") {
  Violations violations;
  violations.add(7, "a sum is wrong");
  violations.add(3, "bisector", 12, "separates nothing");
  CHECK_FALSE(violations.empty());
  CHECK(violations.take() == std::vector<std::string>{"(7) a sum is wrong", "(3) bisector 12: separates nothing"});
}

}  // namespace gvd::test_violations
