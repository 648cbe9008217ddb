// VTK PolyData in XML: text, Base64 and appended arrays, with or without zlib's compression.
//
// Appended data need not be XML. So the document is cut at their beginning and closed again before it is parsed, and
// arrays find their bytes by their offset. The numbers of every array become doubles; a piece's points and polygons
// are the only arrays that are read.
// Base64 comes in runs that end in padding: a compressed array has one for its header and one for its blocks. So the
// decoder goes on behind a padding.
// Source: VTK File Formats, version 4.2; vtkXMLDataParser for the layout of compressed arrays.
// Invariant: no count of the file takes memory that its bytes could not fill; deflate's limit goes for blocks.
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <pugixml.hpp>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/unpack.hpp"
#include "mesh/reading/vtk_soup.hpp"

namespace gvd {
namespace {

/// A byte of deflate's output needs at least 1 / 1032 of its input (zlib, Technical Details).
constexpr std::uint64_t kMostDeflated = 1032;

/// The value of a Base64 digit, or -1.
int base64_value(char digit) {
  if (digit >= 'A' && digit <= 'Z') return digit - 'A';
  if (digit >= 'a' && digit <= 'z') return digit - 'a' + 26;
  if (digit >= '0' && digit <= '9') return digit - '0' + 52;
  if (digit == '+') return 62;
  return digit == '/' ? 63 : -1;
}

/// The bytes of an array, as they are or in Base64.
class ArrayBytes {
 public:
  ArrayBytes(std::string_view data, bool is_base64) : data_(data), is_base64_(is_base64) {}

  /// Upper bound on the bytes that are left.
  std::uint64_t most() const { return pending_.size() + data_.size(); }

  /// The next bytes; fewer where the data end or hold anything but Base64.
  std::string take(std::uint64_t count) {
    if (!is_base64_) {
      const std::string taken(data_.substr(0, count));
      data_.remove_prefix(taken.size());
      return taken;
    }
    std::string taken = std::move(pending_);
    taken.reserve(std::min(count, most()) + 2);
    while (taken.size() < count && decode_four(taken)) continue;
    pending_ = taken.size() > count ? taken.substr(count) : "";
    taken.resize(std::min<std::uint64_t>(count, taken.size()));
    return taken;
  }

 private:
  /// Appends what the next four digits stand for: three bytes, or fewer where padding follows.
  bool decode_four(std::string& bytes) {
    std::uint32_t bits = 0;
    int digits = 0, padding = 0;
    while (digits + padding < 4 && !data_.empty()) {
      const char c = data_.front();
      data_.remove_prefix(1);
      if (c == ' ' || (c >= '\t' && c <= '\r')) continue;
      const int value = c == '=' ? 0 : base64_value(c);
      if (value < 0 || (c != '=' && padding > 0)) return false;
      (c == '=' ? padding : digits)++;
      bits = bits << 6 | std::uint32_t(value);
    }
    if (digits + padding < 4 || padding > 2) return false;
    for (int i = 0; i < 3 - padding; ++i) bytes += static_cast<char>(bits >> (16 - 8 * i));
    return true;
  }

  std::string_view data_;  // what is left
  bool is_base64_;
  std::string pending_;  // decoded and not taken
};

class VtpParser {
 public:
  VtpParser(std::string_view bytes, std::string_view name)
      : soup_(name), limit_(bytes.size(), name), bytes_(bytes), text_(bytes) {}

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
    if (format.empty() || format == "ascii") return parse_text(array.child_value(), what);
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

  std::vector<double> parse_text(std::string_view text, std::string_view what) {
    constexpr std::string_view kBlank = " \t\r\n\v\f";
    std::vector<double> numbers;
    for (std::size_t at = text.find_first_not_of(kBlank); at < text.size(); at = text.find_first_not_of(kBlank, at)) {
      const std::string_view token = text.substr(at, text.find_first_of(kBlank, at) - at);
      const auto number = parse_double(token);
      if (!number) soup_.refuse(fmt::format("{} is no number in an array of {}", quoted(token), what));
      numbers.push_back(*number);
      at += token.size();
    }
    return numbers;
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
      append_block(content, data.take(packed[b]), b + 1 == blocks && last != 0 ? last : size, what);
    }
    return content;
  }

  void append_block(std::string& content, const std::string& packed, std::uint64_t size, std::string_view what) {
    const std::size_t begin = content.size();
    uLongf made = 0;
    int status = Z_DATA_ERROR;
    if (size <= kMostDeflated * packed.size()) {
      limit_.spend(size + packed.size());
      content.resize(begin + size);
      made = size;
      status = uncompress(reinterpret_cast<Bytef*>(content.data() + begin), &made,
                          reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    }
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status != Z_OK || made != size) soup_.refuse(fmt::format("a compressed array of {} is damaged", what));
  }

  [[noreturn]] void refuse_short(std::string_view what) const {
    soup_.refuse(fmt::format("an array of {} ends before its last byte, or is no Base64", what));
  }

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
