#include <type_traits>

#include "gvd/error.hpp"
#include "gvd/ids.hpp"
#include "support/catch.hpp"

namespace gvd::test_ids {

static_assert(!std::is_convertible_v<int, VertexId>, "a plain number is no id");
static_assert(!std::is_constructible_v<FaceId, VertexId>, "an id of one kind is none of another");

TEST_CASE("ids: invalid by default, ordered by value") {
  CHECK_FALSE(VertexId().valid());
  CHECK(VertexId().value() == -1);
  CHECK(VertexId(0).valid());
  CHECK(VertexId(3).index() == 3);
  CHECK(VertexId(2) < VertexId(5));
  CHECK(VertexId() < VertexId(0));
  CHECK(VertexId(7) == VertexId(7));
}

TEST_CASE("id vector: elements by id, and the id of an appended one") {
  IdVector<FaceId, double> values(2, 0.5);
  CHECK(values.size() == 2);
  CHECK(values.push_back(1.5) == FaceId(2));
  CHECK(values[FaceId(0)] == 0.5);
  CHECK(values[FaceId(2)] == 1.5);
  values[FaceId(1)] = -1;
  CHECK(values == IdVector<FaceId, double>(std::vector<double>{0.5, -1, 1.5}));
  values.resize(4, 9);
  CHECK(values[FaceId(3)] == 9);
  values.assign(1, 2);
  CHECK(values.raw() == std::vector<double>{2});
  CHECK(IdVector<FaceId, double>().empty());
}

TEST_CASE("error: code, message and element") {
  const Error error(ErrorCode::precondition, "face 3 is flat", 3);
  CHECK(error.code() == ErrorCode::precondition);
  CHECK(error.element() == 3);
  CHECK(std::string(error.what()) == "face 3 is flat");
  CHECK(Error(ErrorCode::invalid_option, "x").element() == -1);
}

}  // namespace gvd::test_ids
