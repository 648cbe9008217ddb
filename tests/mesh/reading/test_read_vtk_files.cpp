// The readers of VTK's files, .vtp, .vtu and .vtk. tests/formats/write_with_vtk.py has what VTK writes.
#include "mesh/reading/readers.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_read_vtk_files {

using namespace test;

PolygonSoup parse_vtp(const std::string& bytes) { return parse_soup(bytes, MeshFormat::vtp, "file"); }
PolygonSoup parse_vtk(const std::string& bytes) { return parse_soup(bytes, MeshFormat::vtk, "file"); }

// The sample with an array of points that refers to appended data.
std::string with_appended(const std::string& encoding, const std::string& data, const std::string& offset = "0") {
  std::string bytes =
      replaced(kVtp, "format=\"ascii\">0 0 0 1 1 0 1 0 1 0 1 1<", "format=\"appended\" offset=\"" + offset + "\"><");
  return replaced(bytes, "</VTKFile>",
                  "<AppendedData encoding=\"" + encoding + "\">_" + data + "</AppendedData></VTKFile>");
}

// Points of the tetrahedron behind the number of their bytes.
std::string point_bytes(std::uint32_t size = 96) {
  std::string bytes = bytes_of(size);
  for (const Vec3& p : parse_soup(kOff, MeshFormat::off, "off").positions) {
    for (const double x : p) bytes += bytes_of(x);
  }
  return bytes;
}

TEST_CASE("vtp: polygons, pieces, strips, and lines that are left out with their points") {
  CHECK(parse_vtp(kVtp).polygon_count() == 4);
  std::string piece = kVtp.substr(kVtp.find("<Piece"), kVtp.find("</PolyData>") - kVtp.find("<Piece"));
  const PolygonSoup two = parse_vtp(replaced(kVtp, piece, piece + piece));
  CHECK(two.positions.size() == 8);
  CHECK(two.polygon(7)[0] == 5);
  const PolygonSoup strip = parse_vtp(replaced(
      replaced(replaced(replaced(replaced(kVtp, "NumberOfPolys=\"4\"", "NumberOfStrips=\"1\""), "<Polys>", "<Strips>"),
                        "</Polys>", "</Strips>"),
               ">3 6 9 12<", ">4<"),
      ">0 1 2 0 3 1 0 2 3 1 3 2<", ">0 1 2 0<"));
  CHECK(strip.corners == std::vector<std::int32_t>{0, 1, 2, 2, 1, 0});
  std::string lines = replaced(kVtp, "NumberOfPoints=\"4\"", "NumberOfPoints=\"6\" NumberOfLines=\"1\"");
  lines = replaced(replaced(lines, ">0 0 0 1 1 0", ">9 9 9 0 0 0 1 1 0"), " 0 1 1<", " 0 1 1 8 8 8<");
  lines = replaced(lines, ">0 1 2 0 3 1 0 2 3 1 3 2<", ">1 2 3 1 4 2 1 3 4 2 4 3<");
  lines = replaced(lines, "<Polys>",
                   "<Lines><DataArray Name=\"connectivity\" type=\"Int8\" format=\"ascii\">0 5 1</DataArray>"
                   "<DataArray Name=\"offsets\" type=\"Int8\" format=\"ascii\">3</DataArray></Lines><Polys>");
  const PolygonSoup without = parse_vtp(lines);
  CHECK(without.positions.size() == 4);
  CHECK(without.corners == parse_vtp(kVtp).corners);
  REQUIRE(without.notes.size() == 1);
  CHECK(without.notes[0] == "1 line or vertex is left out");
}

TEST_CASE("vtp: appended data, raw and in Base64, may hold anything") {
  require_tetrahedron(parse_vtp(with_appended("raw", point_bytes())));
  require_tetrahedron(parse_vtp(with_appended("raw", "</VTKFile>" + point_bytes(), "10")));
  require_refused(with_appended("raw", point_bytes(4000)), MeshFormat::vtp,
                  "an array of Points ends before its last byte");
  require_refused(with_appended("raw", point_bytes(97) + "x"), MeshFormat::vtp,
                  "an array of Points has 97 bytes for numbers of 8 bytes; write the file again");
  require_refused(with_appended("raw", point_bytes(), "99999"), MeshFormat::vtp,
                  "an array of Points has the offset '99999', and ");
  require_refused(with_appended("base64", "YAAAAA==!"), MeshFormat::vtp, "ends before its last byte, or is not Base64");
}

TEST_CASE("vtu: cells of a surface are read, lines are left out, and other cells are refused") {
  const auto parse_vtu = [](const std::string& bytes) { return parse_soup(bytes, MeshFormat::vtu, "file"); };
  require_tetrahedron(parse_vtu(kVtu));
  require_tetrahedron(parse_soup(kVtu, MeshFormat::vtp, "file"));
  CHECK(detect_format(kVtu, "a.vtp") == MeshFormat::vtu);
  const std::string piece = kVtu.substr(kVtu.find("<Piece"), kVtu.find("</UnstructuredGrid>") - kVtu.find("<Piece"));
  CHECK(parse_vtu(replaced(kVtu, piece, piece + piece)).polygon(7)[0] == 5);
  // A line of two points that no face has.
  std::string lines =
      replaced(replaced(kVtu, "NumberOfPoints=\"4\"", "NumberOfPoints=\"6\""), " 0 1 1<", " 0 1 1 8 8 8 9 9 9<");
  lines = replaced(replaced(lines, "NumberOfCells=\"4\"", "NumberOfCells=\"5\""), "1 3 2<", "1 3 2 4 5<");
  lines = replaced(replaced(lines, "3 6 9 12<", "3 6 9 12 14<"), "5 5 7 5<", "5 5 7 5 3<");
  const PolygonSoup without = parse_vtu(lines);
  CHECK(without.positions.size() == 4);
  CHECK(without.notes == std::vector<std::string>{"1 line or vertex is left out"});
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    INFO(from << " -> " << to);
    require_refused(replaced(kVtu, from, to), MeshFormat::vtu, part);
  };
  refused("5 5 7 5<", "5 5 10 5<", "cell 2 has the VTK type 10, and only triangles");
  // The four triangles as one with four corners and others, and as a quad and a pixel with three.
  refused("3 6 9 12<", "4 6 9 12<",
          "cell 0 has 4 corners, and its VTK type 5 has 3; correct it, or write a polygon (type 7)");
  refused("5 5 7 5<", "5 9 7 5<",
          "cell 1 has 3 corners, and its VTK type 9 has 4; correct it, or write a polygon (type 7)");
  refused("5 5 7 5<", "5 5 7 8<",
          "cell 3 has 3 corners, and its VTK type 8 has 4; correct it, or write a polygon (type 7)");
  refused("1 3 2<", "1 3 2 0 1 2<",
          "the corners of the last cell end at 12, and the file has 15; write the file again");
  refused("NumberOfCells=\"4\"", "", "a piece has Cells and lacks NumberOfCells; write the file again");
  refused("NumberOfPoints=\"4\"", "", "a piece has Points and lacks NumberOfPoints; write the file again");
  refused("5 5 7 5<", "5 5 7<", "there are 4 cells and 3 types of cells");
  refused("NumberOfCells=\"4\"", "NumberOfCells=\"four\"", "a piece has NumberOfCells 'four', and should have");
  refused("NumberOfCells=\"4\"", "NumberOfCells=\"99999999999\"", "has 4 offsets");
  refused("5 5 7 5<", "3 3 3 3<", "4 vertices and no face; a surface is needed (4 lines and vertices are left out)");
  refused("1 3 2<", "1 3 4<", "cell 3 refers to point 4, and there are 4");
}

TEST_CASE("vtp, vtu: an array of cells or points gives numbers of the faces and vertices that were read") {
  const auto array = [](const std::string& name, const std::string& numbers) {
    return "<DataArray type=\"Int32\" Name=\"" + name + "\" format=\"ascii\">" + numbers + "</DataArray>";
  };
  const auto find = [](const std::string& bytes, const char* name, SoupElement preferred = SoupElement::polygon) {
    const auto found = parse_vtk_xml_property(bytes, name, "file", preferred);
    REQUIRE(found.has_value());
    return std::pair(found->of_vertices, found->values);
  };
  using Found = std::pair<bool, std::vector<double>>;
  // A line of two points that no face has, before the last cell.
  std::string grid = replaced(replaced(kVtu, "NumberOfPoints=\"4\"", "NumberOfPoints=\"6\""), ">0 0 0 1 1 0",
                              ">8 8 8 9 9 9 0 0 0 1 1 0");
  grid = replaced(replaced(grid, "NumberOfCells=\"4\"", "NumberOfCells=\"5\""), "0 1 2 0 3 1 0 2 3 1 3 2<",
                  "2 3 4 2 5 3 2 4 5 0 1 3 5 4<");
  grid = replaced(replaced(grid, "3 6 9 12<", "3 6 9 11 14<"), "5 5 7 5<", "5 5 7 3 5<");
  grid = replaced(grid, "<Points>",
                  "<PointData>" + array("Height", "1 2 3 4 5 6") + array("Label", "0 0 0 0 0 0") +
                      "</PointData><CellData>" + array("LABEL", "9 9 9 9 9") + array("Label", "5 6 7 -1 8") +
                      "</CellData><Points>");
  require_tetrahedron(parse_soup(grid, MeshFormat::vtu, "file"));
  CHECK(find(grid, "Label") == Found{false, {5, 6, 7, 8}});
  CHECK(find(grid, "label") == Found{false, {9, 9, 9, 9}});
  CHECK(find(grid, "Label", SoupElement::vertex) == Found{true, {0, 0, 0, 0}});
  CHECK(find(grid, "height") == Found{true, {3, 4, 5, 6}});
  CHECK_FALSE(parse_vtk_xml_property(grid, "none", "file", SoupElement::polygon).has_value());
  // VTK numbers a strip behind the polygons. It is read before them, as two triangles.
  std::string strip = replaced(kVtp, "NumberOfPolys=\"4\"", "NumberOfPolys=\"4\" NumberOfStrips=\"1\"");
  strip = replaced(strip, "<Polys>",
                   "<Strips>" + array("connectivity", "0 1 2 3") + array("offsets", "4") + "</Strips><CellData>" +
                       array("part", "1 2 3 4 5") + "</CellData><Polys>");
  CHECK(find(strip, "part") == Found{false, {5, 5, 1, 2, 3, 4}});
  const auto refused = [&](const std::string& from, const std::string& to) {
    return refusal([&] { parse_vtk_xml_property(replaced(grid, from, to), "Label", "file", SoupElement::polygon); },
                   ErrorCode::unreadable_input);
  };
  CHECK(refused("5 6 7 -1 8", "5 6 7") == "file: the array 'Label' has 3 numbers for 5 cells");
  CHECK(refused("5 6 7 -1 8", "5 six 7 -1 8") == "file: 'six' is not a number in an array of Label");
}

TEST_CASE("vtp: what is wrong is refused in one line") {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    INFO(from << " -> " << to);
    require_refused(replaced(kVtp, from, to), MeshFormat::vtp, part);
  };
  refused("\"PolyData\"", "\"ImageData\"", "the type 'ImageData', and only PolyData and UnstructuredGrid are read");
  refused("type=\"PolyData\"", "type=\"PolyData\" compressor=\"vtkLZ4DataCompressor\"", "'vtkLZ4DataCompressor'");
  refused("</PolyData>", "", "the XML is damaged");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"", "a piece of 5 points has 12 coordinates");
  refused("NumberOfPolys=\"4\"", "NumberOfPolys=\"99999999999\"", "has 4 offsets");
  for (const std::string wrong : {"abc", "-4", "4.5", ""}) {
    refused("NumberOfPolys=\"4\"", "NumberOfPolys=\"" + wrong + "\"",
            "a piece has NumberOfPolys '" + wrong +
                "', and should have a whole number from 0 there; export the file again");
  }
  require_tetrahedron(parse_soup(replaced(kVtp, "NumberOfPolys=\"4\"", "NumberOfPolys=\" 4 \""), MeshFormat::vtp, "a"));
  refused("format=\"ascii\"", "format=\"appended\" offset=\"begin\"",
          "an array of Points has the offset 'begin', and 0 bytes of data are appended; export the file again");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"1\"", "a piece of 1 point has 12 coordinates");
  refused("NumberOfPolys=\"4\"", "", "a piece has Polys and lacks NumberOfPolys; write the file again");
  refused("3 6 9 12", "3 6 9 13", "the corners of cell 3 end at 13");
  refused("3 6 9 12", "3 6 5 12", "the corners of cell 2 end at 5");
  refused("0 2 3 1 3 2", "0 2 3 1 3 4", "cell 3 refers to point 4, and there are 4");
  refused("0 2 3 1 3 2", "0 2 3 1 3 1.5", "cell 3 refers to point 1.5");
  refused("0 2 3 1 3 2", "0 2 3 1 3 x", "'x' is not a number in an array of Polys");
  refused("\"Float64\" NumberOfComponents=\"3\" format=\"ascii\"", "\"String\" format=\"binary\"", "the type 'String'");
  require_refused(replaced(kVtp, "1 0 1 0 1 1<", "1 0 nan 0 1 1<"), MeshFormat::vtp,
                  "a coordinate of point 2 is not a finite number", ErrorCode::precondition);
}

TEST_CASE("vtp: pieces that share one array are counted") {
  // The points of each piece are the same 100,000 bytes, which would be 30 million numbers.
  const std::string data = bytes_of(std::uint32_t{99984}) + std::string(99984, '\1');
  const std::string piece =
      "<Piece NumberOfPoints=\"33328\"><Points><DataArray type=\"Int8\" format=\"appended\" "
      "offset=\"0\"/></Points></Piece>";
  std::string pieces;
  for (int i = 0; i < 3000; ++i) pieces += piece;
  const std::string bytes = "<VTKFile type=\"PolyData\"><PolyData>" + pieces +
                            "</PolyData><AppendedData encoding=\"raw\">_" + data + "</AppendedData></VTKFile>";
  require_refused(bytes, MeshFormat::vtp, "expands to more than 200 times its size");
}

TEST_CASE("vtk: text with offsets, strips, fields, metadata and data behind the cells") {
  const std::string offsets =
      replaced(replaced(kVtk, "POLYGONS 4 16\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n",
                        "METADATA\nINFORMATION 1\nNAME a LOCATION b\nDATA 1 2\n\nPOLYGONS 5 12\nOFFSETS vtktypeint64\n"
                        "0 3 6 9 12\nCONNECTIVITY vtktypeint64\n0 1 2 0 3 1 0 2 3 1 3 2\nPOINT_DATA 4\nanything"),
               "Version 3.0", "Version 5.1");
  require_tetrahedron(parse_vtk(offsets));
  require_refused(replaced(offsets, "\n0 3 6 9 12\n", "\n3 3 6 9 12\n"), MeshFormat::vtk,
                  "the offsets begin with 3 and not with 0");
  require_tetrahedron(
      parse_vtk(replaced(kVtk, "POINTS", "FIELD FieldData 2\nTIME 1 1 double\n0.5\nb 2 2 int\n1 2 3 4\npoints")));
  CHECK(parse_vtk(replaced(kVtk, "POLYGONS", "TRIANGLE_STRIPS")).polygon_count() == 4);
  const std::string grid = replaced(replaced(kVtk, "POLYDATA", "UNSTRUCTURED_GRID"), "POLYGONS", "CELLS");
  require_tetrahedron(parse_vtk(grid + "CELL_TYPES 4\n5 5 7 5\n"));
  require_refused(grid + "CELL_TYPES 4\n5 5 10 5\n", MeshFormat::vtk, "cell 2 has the VTK type 10");
  require_refused(grid, MeshFormat::vtk, "there are 4 cells and 0 types of cells");
}

TEST_CASE("vtk: binary numbers are big-endian") {
  std::string bytes = replaced(kVtk, "ASCII", "BINARY").substr(0, kVtk.find("0 0 0 1 1 0") + 1);
  const PolygonSoup soup = parse_soup(kOff, MeshFormat::off, "off");
  for (const Vec3& p : soup.positions) {
    for (const double x : p) bytes += bytes_of(x, true);
  }
  bytes += "\nPOLYGONS 4 16\n";
  for (std::size_t f = 0; f < 4; ++f) {
    bytes += bytes_of(std::int32_t{3}, true);
    for (const std::int32_t v : soup.polygon(f)) bytes += bytes_of(v, true);
  }
  require_tetrahedron(parse_vtk(bytes));
  require_refused(bytes.substr(0, bytes.size() - 1), MeshFormat::vtk,
                  "16 numbers are promised, and the file has 63 more");
}

TEST_CASE("vtk: what is wrong is refused with its line") {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    INFO(from << " -> " << to);
    require_refused(replaced(kVtk, from, to), MeshFormat::vtk, part);
  };
  refused("Version 3.0", "Version", "the first line names no version");
  refused("ASCII", "TEXT", "file:3: the third line is 'text'");
  refused("POLYDATA", "STRUCTURED_GRID", "file:4: the data set is 'structured_grid'");
  refused("4 double", "99 double", "297 numbers are promised");
  refused("4 double", "99999999999999999999 double", "expected a count, found '99999999999999999999'");
  refused("4 double", "4 string", "file:5: 'string' is not a type of numbers that is read");
  refused("4 16", "5 16", "the list has 4 cells, and should have 5; export the file again");
  refused("3 0 1 2", "9 0 1 2", "file:12: cell 3 should have 2 corners, but 0 numbers follow; export");
  refused("3 0 1 2", "99 0 1 2", "cell 0 should have 99 corners, but 15 numbers follow; export");
  refused("3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2", "14 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 1",
          "cell 1 should have 1 corner, but");
  refused("1 0 1", "1 x 1", "file:7: expected a number, found 'x'");
  refused("POLYGONS", "POLYGON", "'polygon' is not a section of a surface");
}

}  // namespace gvd::test_read_vtk_files
