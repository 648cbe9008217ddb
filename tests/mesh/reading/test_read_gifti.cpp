// The reader of GIFTI's surfaces and values. tests/formats/read_with_nibabel.py has what nibabel writes.
#include <zlib.h>

#include "mesh/reading/readers.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_read_gifti {

using namespace test;

PolygonSoup parse_gii(const std::string& bytes) { return parse_soup(bytes, MeshFormat::gii, "file"); }

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string digits;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) digits += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return digits;
}

std::string deflate(const std::string& bytes) {
  std::string packed(compressBound(bytes.size()), '\0');
  uLongf size = packed.size();
  REQUIRE(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                   bytes.size()) == Z_OK);
  packed.resize(size);
  return packed;
}

template <class T>
std::string numbers(const std::vector<T>& values, bool big_endian = false) {
  std::string bytes;
  for (const T value : values) bytes += bytes_of(value, big_endian);
  return bytes;
}

// The sample with binary points.
std::string with_points(const std::string& type, const std::string& bytes, const std::string& encoding,
                        bool big_endian = false) {
  std::string text = replaced(kGifti, "NIFTI_TYPE_FLOAT32", "NIFTI_TYPE_" + type);
  text = replaced(text, "0 0 0 1 1 0\n1 0 1 0 1 1", base64(encoding == "GZipBase64Binary" ? deflate(bytes) : bytes));
  text = replaced(text, "\"ASCII\"", '"' + encoding + '"');
  return big_endian ? replaced(text, "LittleEndian", "BigEndian") : text;
}

const std::vector<float> kFloats{0, 0, 0, 1, 1, 0, 1, 0, 1, 0, 1, 1};

TEST_CASE("gifti: text, Base64 and packed Base64 give the same surface, in both orders of bytes") {
  require_tetrahedron(parse_gii(kGifti));
  for (const std::string encoding : {"Base64Binary", "GZipBase64Binary"}) {
    for (const bool big : {false, true}) {
      INFO(encoding << big);
      require_tetrahedron(parse_gii(with_points("FLOAT32", numbers(kFloats, big), encoding, big)));
      const std::vector<double> doubles(kFloats.begin(), kFloats.end());
      require_tetrahedron(parse_gii(with_points("FLOAT64", numbers(doubles, big), encoding, big)));
    }
  }
  std::string columns = replaced(kGifti, "0 0 0 1 1 0\n1 0 1 0 1 1", "0 1 1 0 0 1 0 1 0 0 1 1");
  require_tetrahedron(parse_gii(replaced(columns, "RowMajorOrder", "ColumnMajorOrder")));
}

TEST_CASE("gifti: a transform and further arrays are noted, the identity is not") {
  const auto with_matrix = [](const std::string& matrix) {
    return replaced(kGifti, "<Data>0 0 0",
                    "<CoordinateSystemTransformMatrix><DataSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></DataSpace>"
                    "<TransformedSpace>NIFTI_XFORM_TALAIRACH</TransformedSpace><MatrixData>" +
                        matrix + "</MatrixData></CoordinateSystemTransformMatrix><Data>0 0 0");
  };
  CHECK(parse_gii(with_matrix("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")).notes.empty());
  const PolygonSoup moved = parse_gii(with_matrix("1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1"));
  require_tetrahedron(moved);
  CHECK(moved.notes == std::vector<std::string>{"the transform of coordinates from 'NIFTI_XFORM_UNKNOWN' to "
                                                "'NIFTI_XFORM_TALAIRACH' is left out"});
  const std::string more = replaced(kGifti, "</GIFTI>", "<DataArray Intent=\"NIFTI_INTENT_SHAPE\"/></GIFTI>");
  CHECK(parse_gii(more).notes == std::vector<std::string>{"1 array is left out"});
  require_refused(with_matrix("1 0 x"), MeshFormat::gii, "'x' is not a number in an array of Coord");
}

TEST_CASE("gifti: what is wrong with a surface is refused in one line") {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    INFO(from << " -> " << to);
    require_refused(replaced(kGifti, from, to), MeshFormat::gii, part);
  };
  refused("</GIFTI>", "", "the XML is damaged");
  refused("NIFTI_INTENT_POINTSET", "NIFTI_INTENT_SHAPE", "no array NIFTI_INTENT_POINTSET; give a surface (.surf.gii)");
  refused("\"ASCII\"", "\"ExternalFileBinary\" ExternalFileName=\"a.dat\"", "the numbers are in another file, 'a.dat'");
  refused("\"ASCII\"", "\"Morse\"", "has the encoding 'Morse'");
  refused("Dim0=\"4\"", "Dim0=\"5\"",
          "an array 'NIFTI_INTENT_POINTSET' should have 15 numbers (Dim0 '5', Dim1 '3'), but its data hold 12 numbers; "
          "export the file again");
  refused("Dim0=\"4\"", "Dim0=\"4x\"",
          "an array 'NIFTI_INTENT_POINTSET' has Dim0 '4x', and should have a whole number from 0 there; export");
  refused("Dim0=\"4\"", "Dim0=\"-4\"", "has Dim0 '-4', and should");
  refused("Dim0=\"4\"", "", "should have 0 numbers (Dim1 '3'), but its data hold 12 numbers");
  require_tetrahedron(parse_gii(replaced(kGifti, "Dim0=\"4\"", "Dim0=\" 4 \"")));
  refused("Dim0=\"4\"", "Dim0=\"99999999999999\"", "99999999999999 in one dimension are more than the file can hold");
  refused("Dim1=\"3\"", "Dim1=\"4\"", "has 16 numbers in 4 rows; three in a row are needed");
  refused("Dimensionality=\"2\"", "Dimensionality=\"0\"", "has no dimensions");
  refused("1 3 2<", "1 3 4<", "cell 3 refers to point 4, and there are 4");
  require_refused(replaced(kGifti, "1 0 1 0 1 1", "1 0 nan 0 1 1"), MeshFormat::gii, "is not a finite number",
                  ErrorCode::precondition);
  require_refused("<?xml version=\"1.0\"?><VTKFile/>", MeshFormat::gii, "the XML has no element GIFTI");
  for (const std::string encoding : {"Base64Binary", "GZipBase64Binary"}) {
    INFO(encoding);
    const std::string hold = "should have 12 numbers (Dim0 '4', Dim1 '3'), but its data hold ";
    require_refused(with_points("FLOAT32", numbers(kFloats).substr(1), encoding), MeshFormat::gii,
                    hold + "11 numbers and 3 more bytes; export");
    require_refused(with_points("FLOAT32", numbers(kFloats) + "more", encoding), MeshFormat::gii, hold + "13 numbers;");
    require_refused(with_points("FLOAT32", numbers(kFloats) + numbers(kFloats), encoding), MeshFormat::gii,
                    hold + "24 numbers;");
    require_refused(with_points("FLOAT32", "", encoding), MeshFormat::gii, hold + "0 numbers;");
    // Far more than the file has, and fewer than it could unfold to.
    require_refused(replaced(with_points("FLOAT32", numbers(kFloats), encoding), "Dim0=\"4\"", "Dim0=\"3000000\""),
                    MeshFormat::gii, "should have 9000000 numbers (Dim0 '3000000', Dim1 '3'), but its data hold 12 ");
    require_refused(with_points("STRING", numbers(kFloats), encoding), MeshFormat::gii, "the type 'NIFTI_TYPE_STRING'");
  }
  const std::string packed = with_points("FLOAT32", numbers(kFloats), "GZipBase64Binary");
  const std::string once = deflate(numbers(kFloats));
  require_refused(replaced(packed, base64(once), base64(once + "\1")), MeshFormat::gii,
                  "file: the packed data of an array 'NIFTI_INTENT_POINTSET' end after its numbers, but 1 byte follows "
                  "them; export the file again");
  require_refused(replaced(packed, base64(once), base64(once + once)), MeshFormat::gii, "bytes follow them");
  std::string noise = with_points("FLOAT32", numbers(kFloats), "GZipBase64Binary");
  require_refused(replaced(noise, base64(deflate(numbers(kFloats))), "AAAAAAAAAAAAAAAA"), MeshFormat::gii,
                  "the packed data of an array 'NIFTI_INTENT_POINTSET' are damaged");
}

TEST_CASE("gifti: encodings, orders and indexing as nibabel spells them") {
  require_tetrahedron(parse_gii(replaced(kGifti, "\"ASCII\"", "\"GIFTI_ENCODING_ASCII\"")));
  for (const bool big : {false, true}) {
    for (const auto& [document, nibabel] :
         {std::pair("Base64Binary", "GIFTI_ENCODING_B64BIN"), {"GZipBase64Binary", "GIFTI_ENCODING_B64GZ"}}) {
      INFO(nibabel << big);
      std::string text = replaced(with_points("FLOAT32", numbers(kFloats, big), document, big), document, nibabel);
      text =
          big ? replaced(text, "BigEndian", "GIFTI_ENDIAN_BIG") : replaced(text, "LittleEndian", "GIFTI_ENDIAN_LITTLE");
      require_tetrahedron(parse_gii(replaced(text, "RowMajorOrder", "GIFTI_IND_ORD_ROW_MAJOR")));
    }
  }
  const std::string columns = replaced(replaced(kGifti, "RowMajorOrder", "GIFTI_IND_ORD_COL_MAJOR"),
                                       "0 0 0 1 1 0\n1 0 1 0 1 1", "0 1 1 0 0 1 0 1 0 0 1 1");
  require_tetrahedron(parse_gii(columns));
  require_refused(replaced(kGifti, "\"ASCII\"", "\"GIFTI_ENCODING_EXTBIN\" ExternalFileName=\"a.dat\""),
                  MeshFormat::gii, "the numbers are in another file, 'a.dat'");
}

std::string values_of(const std::string& intent, const std::string& dimensions, const std::string& data) {
  return "<GIFTI Version=\"1.0\"><LabelTable><Label Key=\"3\">three</Label></LabelTable>"
         "<DataArray Intent=\"NIFTI_INTENT_" +
         intent + "\" DataType=\"NIFTI_TYPE_INT32\" " + dimensions + " Encoding=\"ASCII\"><Data>" + data +
         "</Data></DataArray></GIFTI>";
}

std::string refused_values(const std::string& bytes) {
  return refusal([&] { parse_gifti_values(bytes, "file"); }, ErrorCode::unreadable_input);
}

TEST_CASE("gifti: values are those of the one array that is no surface") {
  const std::string labels = values_of("LABEL", "Dimensionality=\"1\" Dim0=\"4\"", "3 0 3 -1");
  CHECK(parse_gifti_values(labels, "file") == std::vector<double>{3, 0, 3, -1});
  CHECK(parse_gifti_values(values_of("SHAPE", "Dimensionality=\"2\" Dim0=\"2\" Dim1=\"1\"", "1.5 inf"), "file") ==
        std::vector<double>{1.5, std::numeric_limits<double>::infinity()});
  const std::string array =
      labels.substr(labels.find("<DataArray"), labels.find("</GIFTI>") - labels.find("<DataArray"));
  CHECK(parse_gifti_values(replaced(kGifti, "</GIFTI>", array + "</GIFTI>"), "file").size() == 4);
  CHECK(refused_values(kGifti) == "file: the GIFTI file has 0 arrays of values; give one with a single array");
  CHECK_THAT(refused_values(replaced(labels, "</GIFTI>", array + "</GIFTI>")), Catch::Matchers::Contains("2 arrays"));
  CHECK(refused_values(values_of("VECTOR", "Dimensionality=\"2\" Dim0=\"1\" Dim1=\"3\"", "1 2 3")) ==
        "file: the GIFTI file has 3 numbers for 1 vertex; give one for each");
  CHECK(refused_values(values_of("\x7f.", "Dimensionality=\"1\" Dim0=\"1\"", "one")) ==
        "file: 'one' is not a number in an array of 'NIFTI_INTENT_?.'");
  CHECK_THAT(refused_values(values_of("NODE_INDEX", "Dimensionality=\"1\" Dim0=\"1\"", "1")),
             Catch::Matchers::Contains("indices of vertices"));
}

TEST_CASE("gifti: a map of one region packs far, and is read") {
  constexpr std::size_t kVertices = 163842;
  std::string map =
      replaced(values_of("LABEL", "Dimensionality=\"1\" Dim0=\"163842\"", ""), "ASCII", "GZipBase64Binary");
  map = replaced(map, "<Data>", "<Data>" + base64(deflate(std::string(4 * kVertices, '\0'))));
  REQUIRE(map.size() < 1200);
  CHECK(parse_gifti_values(map, "file") == std::vector<double>(kVertices, 0));
  const std::string bomb = base64(deflate(std::string(std::size_t{4} << 22, '\0')));
  std::string large =
      replaced(values_of("LABEL", "Dimensionality=\"1\" Dim0=\"4194304\"", bomb), "ASCII", "GZipBase64Binary");
  CHECK_THAT(refused_values(large), Catch::Matchers::Contains("expands to more than 200 times its size"));
}

}  // namespace gvd::test_read_gifti
