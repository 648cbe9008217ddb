#include <fstream>

#include "gvd/read_values.hpp"
#include "io/fixture.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_read_values {

using namespace test;
using Catch::Matchers::Contains;
using Numbers = std::vector<double>;

std::string npy(const std::string& type, const std::string& shape, const std::string& data, int version = 1) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
  const std::string length =
      version == 1 ? bytes_of(std::uint16_t(header.size())) : bytes_of(std::uint32_t(header.size()));
  return "\x93NUMPY" + std::string{char(version), '\0'} + length + header + data;
}

std::string refused(const std::string& bytes) {
  return refusal([&] { parse_values(bytes, "file"); }, ErrorCode::unreadable_input);
}

TEST_CASE("values: NumPy's arrays of every type, order of bytes and version") {
  CHECK(parse_values(npy("<f8", "(2,)", bytes_of(0.5) + bytes_of(-3.0)), "file") == Numbers{0.5, -3});
  CHECK(parse_values(npy(">f4", "(2, 1)", bytes_of(0.5F, true) + bytes_of(-3.0F, true), 2), "file") ==
        Numbers{0.5, -3});
  CHECK(parse_values(npy("<i8", "(1, 2)", bytes_of(std::int64_t{-7}) + bytes_of(std::int64_t{9}), 3), "file") ==
        Numbers{-7, 9});
  CHECK(parse_values(npy("|u1", "(2,)", "\xff\x01"), "file") == Numbers{255, 1});
  CHECK(parse_values(npy("|b1", "(2,)", std::string("\1\0", 2)), "file") == Numbers{1, 0});
  CHECK(parse_values(npy("<f8", "(0,)", ""), "file").empty());
}

TEST_CASE("values: other arrays of NumPy are refused in one line") {
  const std::string good = npy("<f8", "(2,)", bytes_of(0.5) + bytes_of(1.0));
  for (std::size_t size = 6; size < good.size(); ++size)
    CHECK_THAT(refused(good.substr(0, size)), Contains("file: the "));
  CHECK(refused(npy("<f2", "(2,)", "1234")) == "file: the array has the type '<f2', and numbers are needed");
  CHECK_THAT(refused(npy("<U1", "(2,)", "12345678")), Contains("the type '<U1'"));
  CHECK_THAT(refused(npy("|i7", "(2,)", std::string(14, ' '))), Contains("the type '|i7'"));
  CHECK(refused(npy("<f8", "(2, 3)", std::string(48, ' '))) ==
        "file: the array has the shape '2, 3', and one dimension is needed");
  CHECK_THAT(refused(npy("<f8", "(99999999999999999999,)", "")), Contains("one dimension is needed"));
  CHECK(refused(npy("<f8", "(3,)", std::string(17, ' '))) ==
        "file: the array has 3 numbers, and the file 17 bytes for them");
  CHECK_THAT(refused("\x93NUMPY"), Contains("ends within NumPy's header"));
}

TEST_CASE("values: the content decides on the format") {
  CHECK(parse_values("1 2,3 # four\n", "file") == Numbers{1, 2, 3});
  CHECK(parse_values("", "file").empty());
  CHECK_THAT(refused("one"), Contains("file:1: 'one' is no number"));
  CHECK(refused(freesurfer_surface()) == "file: the file is a surface; give values of its vertices");
  CHECK_THAT(refused(kGifti), Contains("0 arrays of values"));
  CHECK_THAT(refused(std::string(4, '\0')), Contains("ends before the table of regions"));
  CHECK_THAT(refused(kObj), Contains("'v' is no number"));
}

TEST_CASE("values: what this library writes comes back, also packed by gzip") {
  const Labelled labelled;
  const TemporaryFolder folder;
  Numbers labels, distances;
  for (const GeneratorId label : labelled.diagram.vertex_label) labels.push_back(label.value() + 1);
  for (const double d : labelled.diagram.vertex_distance) distances.push_back(static_cast<float>(d));
  for (const char* file : {"a.label.gii", "lh.annot"}) {
    write_mesh(folder / file, labelled.view());
    CHECK(read_values(folder / file) == labels);
  }
  for (const char* file : {"a.shape.gii", "a.func.gii", "lh.curv"}) {
    write_mesh(folder / file, labelled.view());
    CHECK(read_values(folder / file) == distances);
  }
  const std::string packed = "gzip -k '" + (folder / "lh.curv").string() + "'";
  REQUIRE(std::system(packed.c_str()) == 0);  // NOLINT(concurrency-mt-unsafe)
  CHECK(read_values(folder / "lh.curv.gz") == distances);
}

TEST_CASE("values: a file that is not there is refused with its name") {
  CHECK(refusal([] { read_values("missing/numbers.txt"); }, ErrorCode::unreadable_input) ==
        "missing/numbers.txt: there is no such file");
}

}  // namespace gvd::test_read_values
