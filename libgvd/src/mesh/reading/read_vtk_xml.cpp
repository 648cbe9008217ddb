// Reads VTK's PolyData and UnstructuredGrid in XML: text, Base64 and appended arrays, with or without zlib's
// compression.
//
// Appended data need not be XML. So the document is cut where they begin and closed again before it is parsed, and
// arrays find their bytes by their offset. The numbers of every array become doubles. Only the points and polygons of a
// piece are read, and one array of their data on request.
// Source: VTK File Formats, version 4.2; vtkXMLDataParser for the layout of compressed arrays.
// Invariant: memory is never allocated for a count in the file that the file's bytes could not fill; for compressed
// blocks, deflate's limit applies.
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

constexpr const char* kGrid = "UnstructuredGrid";

class VtkXmlParser {
 public:
  VtkXmlParser(std::string_view bytes, std::string_view name)
      : name_(name), soup_(name), limit_(bytes.size(), name), bytes_(bytes), text_(bytes) {}

  PolygonSoup parse() {
    load_document();
    read_header(document_.child("VTKFile"));
    visit_pieces([](pugi::xml_node) {});
    return soup_.take();
  }

  std::optional<SoupProperty> parse_property(std::string_view property, SoupElement preferred) {
    load_document();
    read_header(document_.child("VTKFile"));
    const SoupElement other = preferred == SoupElement::vertex ? SoupElement::polygon : SoupElement::vertex;
    for (const SoupElement element : {preferred, other}) {
      if (has_array(element, property)) return read_property(element, property);
    }
    return std::nullopt;
  }

 private:
  /// Reads every piece into the soup, and calls done(piece) after each.
  template <class Done>
  void visit_pieces(const Done& done) {
    const pugi::xml_node root = document_.child("VTKFile");
    for (const pugi::xml_node piece : root.child("PolyData").children("Piece")) {
      read_piece(piece);
      done(piece);
    }
    for (const pugi::xml_node piece : root.child(kGrid).children("Piece")) {
      read_grid_piece(piece);
      done(piece);
    }
  }

  static pugi::xml_node find_array(pugi::xml_node piece, SoupElement element, std::string_view property) {
    pugi::xml_node similar;
    for (const pugi::xml_node array :
         piece.child(element == SoupElement::vertex ? "PointData" : "CellData").children("DataArray")) {
      const std::string_view name = array.attribute("Name").value();
      if (name == property) return array;
      if (!similar && to_lower(name) == to_lower(property)) similar = array;
    }
    return similar;
  }

  bool has_array(SoupElement element, std::string_view property) const {
    bool is_everywhere = false;
    const pugi::xml_node root = document_.child("VTKFile");
    for (const char* kind : {"PolyData", kGrid}) {
      for (const pugi::xml_node piece : root.child(kind).children("Piece")) {
        if (count_in(piece, "NumberOfPoints") == 0) continue;
        if (!find_array(piece, element, property)) return false;
        is_everywhere = true;
      }
    }
    return is_everywhere;
  }

  SoupProperty read_property(SoupElement element, std::string_view property) {
    soup_.keep_cells();
    std::vector<double> of_file;  // for all points, or for all cells in the order in which they are read
    visit_pieces([&](pugi::xml_node piece) {
      if (count_in(piece, "NumberOfPoints") == 0) return;
      const bool of_points = element == SoupElement::vertex;
      const std::uint64_t wanted =
          of_points ? count_in(piece, "NumberOfPoints") : std::uint64_t(soup_.cell_count()) - of_file.size();
      std::vector<double> numbers = read_array(find_array(piece, element, property), property);
      if (numbers.size() != wanted) {
        soup_.refuse(fmt::format(
            "the array {} has {} for {}", quoted(property), counted(std::ssize(numbers), "number", "numbers"),
            counted(std::int64_t(wanted), of_points ? "point" : "cell", of_points ? "points" : "cells")));
      }
      if (!of_points && std::string_view(piece.parent().name()) == "PolyData") {
        // VTK numbers strips after polygons, but this reader reads strips first.
        const auto strips = std::ptrdiff_t(count_in(piece, "NumberOfStrips"));
        const auto polygons = std::ptrdiff_t(count_in(piece, "NumberOfPolys"));
        std::rotate(numbers.end() - strips - polygons, numbers.end() - strips, numbers.end());
      }
      of_file.insert(of_file.end(), numbers.begin(), numbers.end());
    });
    soup_.take();
    SoupProperty found{element == SoupElement::vertex, {}};
    if (!found.of_vertices) {
      for (const std::int64_t cell : soup_.polygon_cells()) found.values.push_back(of_file[std::size_t(cell)]);
      return found;
    }
    const std::vector<char>& is_kept = soup_.kept_points();
    for (std::size_t p = 0; p < of_file.size(); ++p) {
      if (is_kept.empty() || is_kept[p] != 0) found.values.push_back(of_file[p]);
    }
    return found;
  }

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
    if (type != "PolyData" && type != kGrid) {
      soup_.refuse(
          fmt::format("the VTK file has the type {}, and only PolyData and UnstructuredGrid are read; extract "
                      "the surface first",
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

  /// The number of elements that a piece declares; 0 if it declares none.
  std::uint64_t count_in(pugi::xml_node piece, const char* name) const {
    const pugi::xml_attribute given = piece.attribute(name);
    if (!given) return 0;
    if (const auto count = parse_count(given.value())) return *count;
    soup_.refuse(fmt::format("a piece has {} {}, and should have a whole number from 0 there; {}", name,
                             quoted(given.value()), kExportAgain));
  }

  /// Refuses a piece that has arrays of a kind but does not declare the number of elements, which would count as 0.
  void require_count(pugi::xml_node piece, const char* number, const char* kind) const {
    if (piece.attribute(number)) return;
    for (const pugi::xml_node array : piece.child(kind).children("DataArray")) {
      const bool is_empty = *array.child_value() == '\0' && !array.attribute("offset");
      if (!is_empty) soup_.refuse(fmt::format("a piece has {} and lacks {}; write the file again", kind, number));
    }
  }

  /// Returns false if the piece is empty.
  bool read_points(pugi::xml_node piece) {
    require_count(piece, "NumberOfPoints", "Points");
    const std::uint64_t points = count_in(piece, "NumberOfPoints");
    if (points == 0) return false;
    const std::vector<double> coordinates = read_array(piece.child("Points").child("DataArray"), "Points");
    if (coordinates.size() % 3 != 0 || coordinates.size() / 3 != points) {
      soup_.refuse(fmt::format("a piece of {} has {}", counted(std::int64_t(points), "point", "points"),
                               counted(std::ssize(coordinates), "coordinate", "coordinates")));
    }
    soup_.add_points(coordinates);
    if (piece.child("PointData").attribute("TCoords")) soup_.leave_out_texture();
    return true;
  }

  void read_piece(pugi::xml_node piece) {
    const auto count = [&](const char* name) { return count_in(piece, name); };
    if (!read_points(piece)) return;
    for (const auto& [number, kind] : {std::pair("NumberOfStrips", "Strips"), {"NumberOfPolys", "Polys"}}) {
      require_count(piece, number, kind);
    }
    if (count("NumberOfVerts") > 0) soup_.leave_out(read_cells(piece, "Verts", count("NumberOfVerts")));
    if (count("NumberOfLines") > 0) soup_.leave_out(read_cells(piece, "Lines", count("NumberOfLines")));
    if (count("NumberOfStrips") > 0) soup_.add_strips(read_cells(piece, "Strips", count("NumberOfStrips")));
    if (count("NumberOfPolys") > 0) soup_.add_polygons(read_cells(piece, "Polys", count("NumberOfPolys")));
  }

  void read_grid_piece(pugi::xml_node piece) {
    require_count(piece, "NumberOfCells", "Cells");
    const std::uint64_t count = count_in(piece, "NumberOfCells");
    if (!read_points(piece) || count == 0) return;
    const VtkCells cells = read_cells(piece, "Cells", count);
    soup_.add_cells(cells, read_named(piece, "Cells", "types"));
  }

  std::vector<double> read_named(pugi::xml_node piece, const char* kind, const char* array) {
    return read_array(piece.child(kind).find_child_by_attribute("DataArray", "Name", array), kind);
  }

  VtkCells read_cells(pugi::xml_node piece, const char* kind, std::uint64_t count) {
    VtkCells cells{read_named(piece, kind, "offsets"), read_named(piece, kind, "connectivity")};
    if (cells.ends.size() != count) {
      soup_.refuse(fmt::format("a piece with {} of the cells {} has {}", count, kind,
                               counted(std::ssize(cells.ends), "offset", "offsets")));
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
    if (format == "binary") return to_numbers(*type, read_bytes({array.child_value(), true}, what), what);
    const std::string_view offset = array.attribute("offset").value();
    const std::uint64_t begin = parse_count(offset).value_or(appended_.size());
    if (begin >= appended_.size()) {
      soup_.refuse(fmt::format("an array of {} has the offset {}, and {} of data are appended; {}", what,
                               quoted(offset), counted(std::ssize(appended_), "byte", "bytes"), kExportAgain));
    }
    return to_numbers(*type, read_bytes({appended_.substr(begin), is_base64_appended_}, what), what);
  }

  std::vector<double> to_numbers(const StoredNumber& type, const std::string& bytes, std::string_view what) {
    if (bytes.size() % type.size != 0) {
      soup_.refuse(fmt::format("an array of {} has {} for numbers of {} bytes; write the file again", what,
                               counted(std::ssize(bytes), "byte", "bytes"), type.size));
    }
    limit_.spend(bytes.size() / type.size * sizeof(double));
    return type.read_all(bytes);
  }

  /// Reads the bytes of an array after its header, unpacked.
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

  /// Unpacks the blocks of a compressed array. Its header has the number of blocks, the size of a block, the size of
  /// the last block or 0 if it is a full one, and then the packed size of each block.
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
    soup_.refuse(fmt::format("an array of {} ends before its last byte, or is not Base64", what));
  }

  std::string name_;
  VtkSoup soup_;
  ExpansionLimit limit_;
  std::string_view bytes_;
  std::string_view appended_;  // the data after the underscore
  std::string text_;           // the document refers to this text
  pugi::xml_document document_;
  bool is_compressed_ = false, big_endian_ = false, is_base64_appended_ = false;
  StoredNumber header_;
};

}  // namespace

PolygonSoup parse_vtk_xml(std::string_view bytes, std::string_view name) { return VtkXmlParser(bytes, name).parse(); }

std::optional<SoupProperty> parse_vtk_xml_property(std::string_view bytes, std::string_view property,
                                                   std::string_view name, SoupElement preferred) {
  return VtkXmlParser(bytes, name).parse_property(property, preferred);
}

}  // namespace gvd
