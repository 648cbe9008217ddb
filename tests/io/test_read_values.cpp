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

std::string npy(const std::string& type, const std::string& shape, const std::string& data, int version = 1,
                const std::string& by_columns = "False") {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + by_columns + ", 'shape': " + shape + ", }\n";
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
  CHECK(refused(npy("<f8", "(1,)", std::string(8, ' '), 9)) ==
        "file: the file has version 9 of NumPy's format, and 1 to 3 are read");
}

TEST_CASE("values: the content decides on the format") {
  CHECK(parse_values("1 2,3 # four\n", "file") == Numbers{1, 2, 3});
  CHECK(parse_values("", "file").empty());
  CHECK_THAT(refused("one"), Contains("file:1: 'one' is not a number"));
  CHECK(refused(freesurfer_surface()) == "file: the file is a surface; give values of its vertices");
  CHECK_THAT(refused(kGifti), Contains("0 arrays of values"));
  CHECK_THAT(refused(std::string(4, '\0')), Contains("ends before the table of regions"));
  CHECK_THAT(refused(kObj), Contains("'v' is not a number"));
}

TEST_CASE("values: a table says which element each row is of, in any order") {
  CHECK(parse_values("face,label\r\n0,7\r\n1,-1\r\n", "file") == Numbers{7, -1});
  CHECK(parse_values("# c\n\"vertex\",\"label\"\n2,5\n0,3\n1,4\n", "file") == Numbers{3, 4, 5});
  CHECK(parse_values("source,vertex,distance\n0,0,0.5\n,1,inf\n", "file") == Numbers{0.5, HUGE_VAL});
  CHECK(parse_values(std::string("\xff\xfe"
                                 "1\0 \0"
                                 "2\0",
                                 8),
                     "file") == Numbers{1, 2});
}

TEST_CASE("values: a table that lacks an element, or has one twice, is refused with its line") {
  CHECK(refused("face,label\n0,1\n0,2\n") == "file:3: face 0 has a second row");
  CHECK(refused("face,label\n0,1\n2,2\n") == "file:3: face 2 in a table of 2 rows; each one from 0 on needs a row");
  CHECK(refused("vertex,label\n-1,1\n") ==
        "file:2: '-1' is not an index of a vertex; indices are whole numbers from 0");
  CHECK(refused("vertex,label\n0,one\n") == "file:2: 'one' is not a number");
  CHECK(refused("vertex,label\n0,1,2\n") == "file:2: 3 fields, but the header has 2; give as many as the header");
  CHECK(refused("source,vertex\n0,0\n") == "file:1: the header names no column of numbers");
  CHECK(refused("face,label_1,label_2\n0,1,2\n") == "file: the table has 2 columns of numbers, and one is needed");
  CHECK_THAT(refused("\n\xef\xbb\xbf\"face,l\n1,5\n"),
             Contains("file:2: the header has no column"));  // found by libFuzzer
  CHECK(parse_values("\xef\xbb\xbf"
                     "face,label\n0,5\n",
                     "file") == Numbers{5});
}

TEST_CASE("values: a table without a column of vertices or faces is refused with what to do") {
  for (const std::string table : {"# c\nlabel\n3\n", "\"id\",\"label\"\n0,1\n", "Vertex,label\n0,1\n",
                                  "vertex;label\n0;1\n", "vertex\tlabel\n0\t1\n", "my id,label\n"}) {
    INFO(table);
    CHECK_THAT(
        refused(table),
        Contains(": the header has no column vertex or face, with commas between columns; name the "
                 "column of indices 'vertex' or 'face', or give the numbers alone, in order and without a header"));
  }
  CHECK_THAT(refused("# c\nlabel\n3\n"), Contains("file:2: "));
  CHECK(refused("3,four\n") == "file:1: 'four' is not a number");
  CHECK(refused("label\nother\n") == "file:1: 'label' is not a number");
}

/// The numbers of a file for a mesh of a square of two triangles.
std::string values_for_square(const TemporaryFolder& folder, const std::string& bytes, ValueColumns columns) {
  PolygonSoup soup =
      make_soup(std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, std::vector<std::int64_t>{0, 1, 2, 0, 2, 3});
  write_bytes(folder / "values", bytes);
  const auto found =
      read_element_values(build_mesh(soup), (folder / "values").string(), {}, SoupElement::polygon, columns);
  REQUIRE(found.has_value());
  std::string text = found->soup.of_vertices ? "vertices" : "faces";
  for (const double value : found->soup.values) text += ' ' + std::to_string(int(value));
  return text;
}

TEST_CASE("values: of labels at several levels the last ones count, where they may") {
  const TemporaryFolder folder;
  const auto last = [&](const std::string& bytes) { return values_for_square(folder, bytes, ValueColumns::last); };
  const auto ints = [](std::initializer_list<std::int32_t> values) {
    std::string bytes;
    for (const std::int32_t value : values) bytes += bytes_of(value);
    return bytes;
  };
  const std::string rows = npy("<i4", "(2, 3)", ints({1, 2, 3, 4, 5, 6}));
  CHECK(last(rows) == "faces 3 6");
  CHECK(last(npy("<i4", "(2, 3)", ints({1, 2, 3, 4, 5, 6}), 1, "True")) == "faces 5 6");
  std::string tight = npy("<i4", "(2, 3)", ints({1, 2, 3, 4, 5, 6}), 1, "True");
  CHECK(last(replaced(tight, "'fortran_order': True,", "'fortran_order':True, ")) == "faces 5 6");
  CHECK(last("face,label_1,label_2\n1,10,11\n0,12,13\n") == "faces 13 11");
  CHECK_THAT(refusal([&] { values_for_square(folder, rows, ValueColumns::one); }, ErrorCode::unreadable_input),
             Contains("the array has the shape '2, 3', and one dimension is needed"));
  CHECK_THAT(refusal([&] { last(npy("<i4", "(1, 2, 3, 2)", ints({1}))); }, ErrorCode::unreadable_input),
             Contains("one dimension is needed"));
  CHECK_THAT(refusal([&] { last(npy("<i4", "(4294967296, 4294967296)", "")); }, ErrorCode::unreadable_input),
             Contains("one dimension is needed"));
}

TEST_CASE("values: numbers of what the repair made of the file count where their number is no other's") {
  const TemporaryFolder folder;
  // A square of one quadrilateral, with a vertex that no face has.
  const PolygonSoup soup = make_soup(std::vector<double>{9, 9, 9, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0},
                                     std::vector<std::int64_t>{1, 2, 3, 4}, 4);
  const CheckedMesh mesh = build_mesh(soup);
  const auto kind_of = [&](const std::string& bytes) {
    write_bytes(folder / "values", bytes);
    const auto found = read_element_values(mesh, (folder / "values").string(), {});
    REQUIRE(found.has_value());
    return std::string(found->of_mesh ? "mesh" : "file") + (found->soup.of_vertices ? " vertices" : " faces");
  };
  CHECK(kind_of("1 2 3 4 5") == "file vertices");
  CHECK(kind_of("1") == "file faces");
  CHECK(kind_of("1 2 3 4") == "mesh vertices");
  CHECK(kind_of("1 2") == "mesh faces");
  CHECK(kind_of("face,label\n0,1\n1,1\n") == "mesh faces");
  CHECK_THAT(refusal([&] { kind_of("1 2 3"); }, ErrorCode::unreadable_input),
             Contains("3 numbers; give one for each vertex (5) or each face (1)"));
}

TEST_CASE("values: a table of faces is none of vertices, and the other way round") {
  const TemporaryFolder folder;
  CHECK(values_for_square(folder, "vertex,label\n0,1\n1,1\n2,1\n3,1\n", ValueColumns::one) == "vertices 1 1 1 1");
  CHECK_THAT(refusal([&] { values_for_square(folder, "face,label\n0,1\n1,1\n2,1\n3,1\n", ValueColumns::one); },
                     ErrorCode::unreadable_input),
             Contains("4 numbers; give one for each vertex (4) or each face (2)"));
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
