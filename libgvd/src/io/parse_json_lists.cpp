// Parses lists from JSON. The array `generators` of any object is a list, so that a diagram or a report serves as one.
//
// The documents of nlohmann/json do not know their lines. So JSON is read twice: first as events from a stream, whose
// position gives the lines of elements and of a syntax error, and then as a document. One parse with a callback would
// do both, but nlohmann/json 3.11 looks through all earlier elements after each object, which takes quadratic time.
// Source: RFC 8259, as nlohmann/json reads it. Cost: O(length).
#include "io/parse_json_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "gvd/text.hpp"

namespace gvd::detail {
namespace {

using nlohmann::json;

/// How many characters of the parser's reason a message repeats: enough for its own words and a token of moderate
/// length.
constexpr std::size_t kReasonLength = 200;

/// Handles the events of a parse, and records the line on which each object of the array "generators" begins.
class LineReader : public nlohmann::json_sax<json> {
 public:
  LineReader(std::string_view content, const std::string& name)
      : content_(content), name_(name), in_(std::string(content)) {}

  /// Throws Error{unreadable_input} with the line of a syntax error.
  std::vector<std::int32_t> read() {
    json::sax_parse(in_, this);
    return std::move(lines_);
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool number_float(double, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(json::binary_t&) override { return true; }

  bool key(std::string& text) override {
    if (depth_ == 1) inside_ = text == "generators";
    return true;
  }
  bool start_object(std::size_t) override {
    if (depth_ == 2 && inside_) lines_.push_back(current_line());
    return open();
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t, const std::string&, const json::exception& error) override {
    // The library's text begins with the name of the exception in brackets, "[json.exception.parse_error.101] parse
    // error at ...", and quotes everything that it has read since the last token.
    const std::string text = error.what();
    const std::size_t bracket = text.find("] ");
    const std::string reason = printable(text.substr(bracket == text.npos ? 0 : bracket + 2), kReasonLength);
    ListLocation{name_, current_line()}.refuse("not valid JSON: " + reason);
  }

 private:
  bool open() { return ++depth_ > 0; }
  bool close() { return --depth_ >= 0; }

  /// The line up to which the stream has been read. Counts each line only once, so all calls together take linear time.
  std::int32_t current_line() {
    const std::ptrdiff_t at = in_.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in);
    line_ += static_cast<std::int32_t>(std::count(content_.begin() + counted_to_, content_.begin() + at, '\n'));
    counted_to_ = at;
    return line_;
  }

  std::string_view content_;
  const std::string& name_;
  std::istringstream in_;
  std::vector<std::int32_t> lines_;
  std::int32_t line_ = 1;
  std::ptrdiff_t counted_to_ = 0;
  int depth_ = 0;  ///< number of open objects and arrays
  bool inside_ = false;
};

std::array<double, 3> read_three(const json& value, std::string_view key, const ListLocation& location) {
  std::array<double, 3> three{};
  const bool sized = value.is_array() && value.size() == 3;
  for (std::size_t i = 0; sized && i < 3; ++i) three[i] = value[i].is_number() ? value[i].get<double>() : NAN;
  if (!sized || !std::isfinite(three[0] + three[1] + three[2])) {
    location.refuse(fmt::format("\"{}\" must be an array of three finite numbers", key));
  }
  return three;
}

std::int64_t read_index(const json& value, std::string_view key, const ListLocation& location) {
  if (!value.is_number_integer() || value.get<std::int64_t>() < 0) {
    location.refuse(fmt::format("\"{}\" must be a whole number from 0", key));
  }
  return value.get<std::int64_t>();
}

}  // namespace

json parse_document(std::string_view content, const std::string& name) {
  LineReader(content, name).read();
  return json::parse(content);
}

GeneratorEntry read_object(const json& object, const ListLocation& location) {
  if (object.contains("face") && object.contains("bary")) {
    const std::int64_t face = read_index(object["face"], "face", location);
    return {GeneratorEntry::Kind::face, face, read_three(object["bary"], "bary", location), location.line};
  }
  if (object.contains("vertex")) {
    return {GeneratorEntry::Kind::vertex, read_index(object["vertex"], "vertex", location), {}, location.line};
  }
  if (object.contains("position")) {
    return {GeneratorEntry::Kind::position, 0, read_three(object["position"], "position", location), location.line};
  }
  location.refuse("a generator needs \"face\" and \"bary\", or \"vertex\", or \"position\"");
}

std::vector<GeneratorEntry> parse_json(std::string_view content, const std::string& name) {
  const std::vector<std::int32_t> lines = LineReader(content, name).read();
  const json document = json::parse(content);
  const ListLocation location{name, 1};
  if (!document.is_object() || !document.contains("generators")) {
    location.refuse("there is no array \"generators\"; write one");
  }
  const json& list = document["generators"];
  if (!list.is_array()) location.refuse("\"generators\" must be an array");
  std::vector<GeneratorEntry> entries;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const ListLocation at{name, i < lines.size() ? lines[i] : 1};
    if (!list[i].is_object()) at.refuse(fmt::format("element {} of \"generators\" must be an object", i));
    entries.push_back(read_object(list[i], at));
  }
  return entries;
}

}  // namespace gvd::detail
