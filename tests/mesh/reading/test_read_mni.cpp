// MNI's surfaces. tests/formats/write_with_vtk.py has what VTK writes.
#include "mesh/reading/readers.hpp"
#include "mesh/reading/soup_files.hpp"

namespace gvd::test_read_mni {

using namespace test;

PolygonSoup parse(const std::string& bytes) { return parse_soup(bytes, MeshFormat::mni, "file"); }

TEST_CASE("MNI: a tetrahedron, whatever the name of the file and wherever lines end") {
  require_tetrahedron(parse(kMni));
  for (const char* name : {"a.obj", "a.off", "a"}) CHECK(detect_format(kMni, name) == MeshFormat::mni);
  std::string one_line = kMni;
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  require_tetrahedron(parse(one_line));
  CHECK_FALSE(is_mni("P 1 2 3 4 5"));
  CHECK_FALSE(is_mni("P a b c d e 4"));
  CHECK_FALSE(is_mni("p 0.3 0.3 0.4 10 1 4"));
  CHECK_FALSE(is_mni(""));
}

TEST_CASE("MNI: colours of all kinds are skipped") {
  const auto with_colors = [](const std::string& colors) { return parse(replaced(kMni, " 0 1 1 1 1\n", colors)); };
  require_tetrahedron(with_colors("1\n 1 0 0 1\n 1 0 0 1\n 1 0 0 1\n 1 0 0 1\n"));
  require_tetrahedron(with_colors("2\n 1 0 0 1\n 1 0 0 1\n 1 0 0 1\n 0 0 0 0\n"));
}

TEST_CASE("MNI: polygons of any size, several objects, and others that are noted") {
  const PolygonSoup quad =
      parse("P 0 0 0 0 0 4\n0 0 0 1 0 0 1 1 0 0 1 0\n0 0 1 0 0 1 0 0 1 0 0 1\n1\n0 1 1 1 1\n4\n0 1 2 3\n");
  CHECK(quad.corners == std::vector<std::int32_t>{0, 1, 2, 3});
  const PolygonSoup two = parse(kMni + kMni);
  CHECK(two.positions.size() == 8);
  CHECK(two.polygon(7)[0] == 5);
  const PolygonSoup noted = parse(kMni + "L 1 2\n");
  require_tetrahedron(noted);
  CHECK(noted.notes ==
        std::vector<std::string>{"line 19: 'L' is not an object of polygons; it and everything after it are skipped"});
}

TEST_CASE("MNI: what is wrong is refused with its line") {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    INFO(from << " -> " << to);
    require_refused(replaced(kMni, from, to), MeshFormat::mni, part);
  };
  refused("P ", "L ", "file:1: an object of MNI should begin with P, and not with 'L'");
  refused("10 1 4", "10 1 99999999999", "file:1: the number of points is 99999999999, and the file has only");
  refused("10 1 4", "10 1 -4", "the number of points is -4");
  refused("10 1 4", "ten 1 4", "a number of the surface is 'ten', and should be a number");
  refused("\n 4\n", "\n 4000000\n", "the number of polygons is 4000000, and the file has only");
  refused(" 0 1 1 1 1\n", " 3 1 1 1 1\n", "the kind of colours is 3, and should be 0, 1 or 2");
  refused("3 6 9 12", "3 6 5 12", "polygon 2 ends at corner 5, and the one before at 6");
  refused("3 6 9 12", "3 6 9 999999999999", "polygon 3 ends at corner 999999999999, and the one before at 9");
  refused(" 0 1 2 0", " 0 1 4 0", "polygon 0 refers to point 4, and there are 4");
  refused(" 3 1 3 2\n", " 3 1 3\n", "the file ends after line 18, and a corner of a polygon is missing");
  require_refused(replaced(kMni, " 1 1 0", " 1 nan 0"), MeshFormat::mni,
                  "coordinate y of vertex 1 is not a finite number", ErrorCode::precondition);
}

}  // namespace gvd::test_read_mni
