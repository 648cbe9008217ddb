// VTK PolyData in XML: text, Base64 and appended arrays, with or without zlib's compression.
//
// Appended data need not be XML. So the document is cut at their beginning and closed again before it is parsed, and
// arrays find their bytes by their offset. The numbers of every array become doubles; a piece's points and polygons
// are the only arrays that are read.
// Source: VTK File Formats, version 4.2; vtkXMLDataParser for the layout of compressed arrays.
// Invariant: no count of the file takes memory that its bytes could not fill; deflate's limit goes for blocks.
#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/array_bytes.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/unpack.hpp"
#include "mesh/reading/vtk_soup.hpp"

namespace gvd {
namespace {

class VtpParser {
 public:
  VtpParser(std::string_view bytes, std::string_view name)
      : name_(name), soup_(name), limit_(bytes.size(), name), bytes_(bytes), text_(bytes) {}

  PolygonSoup parse() {
    load_document();
    const pugi::xml_node root = document_.child("VTKFile");
    read_header(root);
    for (const pugi::xml_node piece : root.child("PolyData").children("Piece")) read_piece(piece);
    return soup_.take();
  }

 private:
  void load_document() {
    const std::size_t appended = bytes_.find("<AppendedData");
    if (appended != bytes_.npos) {
      const std::size_t open = std::min(bytes_.find('>', appended), bytes_.size() - 1) + 1;
      const std::size_t data = bytes_.find('_', open);
      if (data != bytes_.npos) appended_ = bytes_.substr(data + 1);
      text_ = std::string(bytes_.substr(0, open)) + "</AppendedData></VTKFile>";
    }
    const pugi::xml_parse_result result = document_.load_buffer_inplace(text_.data(), text_.size());
    if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
    if (!result) soup_.refuse(fmt::format("byte {}: the XML is damaged: {}", result.offset, result.description()));
  }

  void read_header(pugi::xml_node root) {
    const std::string_view type = root.attribute("type").value();
    if (type != "PolyData") {
      soup_.refuse(fmt::format("the VTK file has the type {}, and only PolyData is read; extract the surface first",
                               quoted(type)));
    }
    const std::string_view compressor = root.attribute("compressor").value();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
      soup_.refuse(fmt::format("the arrays are compressed by {}; write the file with vtkZLibDataCompressor or without",
                               quoted(compressor)));
    }
    is_compressed_ = !compressor.empty();
    big_endian_ = std::string_view(root.attribute("byte_order").value()) == "BigEndian";
    const bool long_header = std::string_view(root.attribute("header_type").value()) == "UInt64";
    header_ = {StoredNumber::Kind::unsigned_integer, long_header ? 8U : 4U, big_endian_};
    is_base64_appended_ = std::string_view(root.child("AppendedData").attribute("encoding").value()) == "base64";
  }

  void read_piece(pugi::xml_node piece) {
    const auto count = [&](const char* name) { return piece.attribute(name).as_ullong(); };
    const std::uint64_t points = count("NumberOfPoints");
    if (points == 0) return;
    const std::vector<double> coordinates = read_array(piece.child("Points").child("DataArray"), "Points");
    if (coordinates.size() % 3 != 0 || coordinates.size() / 3 != points) {
      soup_.refuse(fmt::format("a piece of {} points has {} coordinates", points, coordinates.size()));
    }
    soup_.add_points(coordinates);
    if (piece.child("PointData").attribute("TCoords")) soup_.leave_out_texture();
    if (count("NumberOfVerts") > 0) soup_.leave_out(read_cells(piece, "Verts", count("NumberOfVerts")));
    if (count("NumberOfLines") > 0) soup_.leave_out(read_cells(piece, "Lines", count("NumberOfLines")));
    if (count("NumberOfStrips") > 0) soup_.add_strips(read_cells(piece, "Strips", count("NumberOfStrips")));
    if (count("NumberOfPolys") > 0) soup_.add_polygons(read_cells(piece, "Polys", count("NumberOfPolys")));
  }

  VtkCells read_cells(pugi::xml_node piece, const char* kind, std::uint64_t count) {
    const auto read = [&](const char* array) {
      return read_array(piece.child(kind).find_child_by_attribute("DataArray", "Name", array), kind);
    };
    VtkCells cells{read("offsets"), read("connectivity")};
    if (cells.ends.size() != count) {
      soup_.refuse(fmt::format("a piece with {} of the cells {} has {} offsets", count, kind, cells.ends.size()));
    }
    return cells;
  }

  std::vector<double> read_array(pugi::xml_node array, std::string_view what) {
    const std::string_view format = array.attribute("format").value();
    if (format.empty() || format == "ascii") return parse_array_text(array.child_value(), what, name_);
    auto type = find_vtk_type(array.attribute("type").value());
    if (!type || (format != "binary" && format != "appended")) {
      soup_.refuse(fmt::format("an array of {} has the format {} and the type {}", what, quoted(format),
                               quoted(array.attribute("type").value())));
    }
    type->big_endian = big_endian_;
    if (format == "binary") return to_numbers(*type, read_bytes({array.child_value(), true}, what));
    const std::uint64_t offset = array.attribute("offset").as_ullong();
    if (offset >= appended_.size()) {
      soup_.refuse(fmt::format("an array of {} begins {} bytes into the appended data, which have {}", what, offset,
                               appended_.size()));
    }
    return to_numbers(*type, read_bytes({appended_.substr(offset), is_base64_appended_}, what));
  }

  std::vector<double> to_numbers(const StoredNumber& type, const std::string& bytes) {
    limit_.spend(bytes.size() / type.size * sizeof(double));
    return type.read_all(bytes);
  }

  /// The bytes of an array behind its header, unpacked.
  std::string read_bytes(ArrayBytes data, std::string_view what) {
    const std::uint64_t first = read_word(data, what);
    if (is_compressed_) return unpack_blocks(data, first, what);
    limit_.spend(std::min(first, data.most()));
    std::string bytes = data.take(first);
    if (bytes.size() != first) refuse_short(what);
    return bytes;
  }

  std::uint64_t read_word(ArrayBytes& data, std::string_view what) const {
    const std::string bytes = data.take(header_.size);
    if (bytes.size() != header_.size) refuse_short(what);
    return header_.read_bits(bytes.data());
  }

  /// Header: the number of blocks, the size of each, that of the last one or 0 where it is as large; then the packed
  /// size of each.
  std::string unpack_blocks(ArrayBytes& data, std::uint64_t blocks, std::string_view what) {
    if (blocks == 0) return "";
    const std::uint64_t size = read_word(data, what), last = read_word(data, what);
    if (blocks > data.most() / header_.size) refuse_short(what);
    std::vector<std::uint64_t> packed(blocks);
    for (std::uint64_t& bytes : packed) bytes = read_word(data, what);
    std::string content;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t made = b + 1 == blocks && last != 0 ? last : size;
      if (!append_inflated(content, data.take(packed[b]), made, limit_)) {
        soup_.refuse(fmt::format("a compressed array of {} is damaged", what));
      }
    }
    return content;
  }

  [[noreturn]] void refuse_short(std::string_view what) const {
    soup_.refuse(fmt::format("an array of {} ends before its last byte, or is no Base64", what));
  }

  std::string name_;
  VtkSoup soup_;
  ExpansionLimit limit_;
  std::string_view bytes_;
  std::string_view appended_;  // behind the underscore
  std::string text_;           // which the document refers to
  pugi::xml_document document_;
  bool is_compressed_ = false, big_endian_ = false, is_base64_appended_ = false;
  StoredNumber header_;
};

}  // namespace

PolygonSoup parse_vtp(std::string_view bytes, std::string_view name) { return VtpParser(bytes, name).parse(); }

}  // namespace gvd
