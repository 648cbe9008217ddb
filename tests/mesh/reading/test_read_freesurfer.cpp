// The readers of FreeSurfer's own files. tests/formats/read_with_nibabel.py has what nibabel writes.
#include "mesh/reading/readers.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_read_freesurfer {

using namespace test;
using Catch::Matchers::Contains;

std::string big(std::int32_t value) { return bytes_of(value, true); }
std::string text(const std::string& text) { return big(std::int32_t(text.size())) + text; }

TEST_CASE("freesurfer: a surface of triangles, and what may follow it") {
  require_tetrahedron(parse_soup(freesurfer_surface(), MeshFormat::fs, "lh.white"));
  require_tetrahedron(parse_soup(freesurfer_surface() + big(20) + "valid = 1\n", MeshFormat::fs, "lh.white"));
  CHECK(detect_format(freesurfer_surface(), "lh.white") == MeshFormat::fs);
}

TEST_CASE("freesurfer: what is wrong with a surface is refused in one line") {
  const std::string bytes = freesurfer_surface();
  const std::size_t counts = bytes.find("\n\n") + 2;
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    INFO(size);
    require_refused(bytes.substr(0, size), MeshFormat::fs, size < 3 ? "does not begin as" : "the file");
  }
  require_refused(std::string(bytes).replace(counts, 4, big(-1)), MeshFormat::fs, "the number of vertices is -1");
  require_refused(std::string(bytes).replace(counts, 4, big(2000000000)), MeshFormat::fs,
                  "the number of vertices is 2000000000, and the file has only");
  require_refused(std::string(bytes).replace(counts + 4, 4, big(5)), MeshFormat::fs, "ends before the last corner");
  require_refused(std::string(bytes).replace(bytes.size() - 4, 4, big(4)), MeshFormat::fs,
                  "cell 3 refers to point 4, and there are 4");
  require_refused("\xff\xff\xfd" + bytes.substr(3), MeshFormat::fs, "with quads or with values; give a surface of");
  require_refused(std::string(bytes).replace(counts + 8, 4, "\x7f\xc0\0\0", 4), MeshFormat::fs,
                  "a coordinate of point 0 is not a finite number", ErrorCode::precondition);
}

TEST_CASE("freesurfer: values of vertices") {
  const std::string head = "\xff\xff\xff" + big(3) + big(1);
  const std::string bytes = head + big(1) + bytes_of(0.5F, true) + bytes_of(-2.0F, true) + bytes_of(1e9F, true);
  CHECK(parse_morphometry(bytes, "lh.curv") == std::vector<double>{0.5, -2, 1e9});
  const auto refused = [](const std::string& wrong) {
    return refusal([&] { parse_morphometry(wrong, "lh.curv"); }, ErrorCode::unreadable_input);
  };
  CHECK_THAT(refused(bytes.substr(0, bytes.size() - 1)), Contains("lh.curv: the file ends before the last value"));
  CHECK_THAT(refused(head + big(2) + std::string(24, '\0')), Contains("2 values for each vertex"));
  CHECK_THAT(refused("\xff\xff\xff" + big(1 << 30)), Contains("number of vertices is 1073741824"));
}

// Three vertices; those of the colours 1 and 256 are in the table, that of 7 is not.
const std::string kColors = big(3) + big(2) + big(1) + big(0) + big(256) + big(1) + big(7);
const std::string kNumbered = big(1) + big(-2) + big(12) + text("colours.txt") + big(2) + big(0) + text("???") +
                              big(1) + big(0) + big(0) + big(0) + big(11) + text("cuneus") + big(0) + big(1) + big(0) +
                              big(0);
const std::string kPlain = big(1) + big(2) + text("colours.txt") + text("???") + big(1) + big(0) + big(0) + big(0) +
                           text("cuneus") + big(0) + big(1) + big(0) + big(0);

TEST_CASE("freesurfer: an annotation's labels are the numbers of its table") {
  CHECK(parse_annotation(kColors + kNumbered, "lh.annot") == std::vector<double>{11, -1, 0});
  CHECK(parse_annotation(kColors + kPlain, "lh.annot") == std::vector<double>{1, -1, 0});
}

TEST_CASE("freesurfer: what is wrong with an annotation is refused in one line") {
  const auto refused = [](const std::string& wrong) {
    return refusal([&] { parse_annotation(wrong, "lh.annot"); }, ErrorCode::unreadable_input);
  };
  const std::string bytes = kColors + kNumbered;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK_THAT(refused(bytes.substr(0, size)), Contains("lh.annot: "));
  }
  CHECK_THAT(refused(kColors), Contains("ends before the table of regions"));
  CHECK_THAT(refused(kColors + big(0)), Contains("has no table of regions"));
  CHECK_THAT(refused(kColors + big(1) + big(-3)), Contains("has the version 3, and only 2 is read"));
  CHECK_THAT(refused(kColors + big(1) + "\x80" + std::string(3, '\0')), Contains("has the version 2147483648"));
  CHECK_THAT(refused(std::string(bytes).replace(4, 4, big(3))), Contains("a colour for vertex 3, and there are 3"));
  CHECK_THAT(refused(std::string(bytes).replace(bytes.size() - 16, 4, big(256))),
             Contains("a colour of region 11 is 256"));
}

}  // namespace gvd::test_read_freesurfer
