// Lists as JSON: the array `generators` of any object, so that a diagram or a report serves as a list.
//
// The parser tells the line of a syntax error only by what it has read so far, and no line of an element. So it reads a
// stream whose position gives the line, and a callback notes where each generator begins.
// An element is a face with coordinates, or else a vertex, or else a position, as in a row of comma-separated values.
// Source: RFC 8259, as the library nlohmann/json reads it. Cost: O(length), counting each line once.
// Invariant: every message names list and line, and is printable whatever the file holds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gvd/text.hpp"
#include "io/parse_lists.hpp"

namespace gvd::detail {
namespace {

using nlohmann::json;

/// Characters of the parser's reason that a message repeats: its own words, and a token of moderate length.
constexpr std::size_t kReasonLength = 200;

struct Document {
  json root;
  std::vector<std::int32_t> lines;  ///< of the start of each object in the array "generators"
};

Document parse_document(std::string_view content, const std::string& name) {
  Document document;
  std::istringstream in{std::string(content)};
  std::int32_t line = 1;
  std::ptrdiff_t counted_to = 0;
  const auto current_line = [&] {
    const std::ptrdiff_t at = in.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in);
    line += static_cast<std::int32_t>(std::count(content.begin() + counted_to, content.begin() + at, '\n'));
    counted_to = at;
    return line;
  };
  bool inside = false;
  const auto note = [&](int depth, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::key && depth == 1) inside = parsed == "generators";
    if (event == json::parse_event_t::object_start && depth == 2 && inside) document.lines.push_back(current_line());
    return true;
  };
  try {
    document.root = json::parse(in, note);
  } catch (const json::exception& error) {
    // The library's text begins with its own name in brackets: "[json.exception.parse_error.101] parse error at ...",
    // and quotes what it has read since the last token, whatever that is.
    const std::string text = error.what();
    const std::size_t bracket = text.find("] ");
    const std::string reason = printable(text.substr(bracket == text.npos ? 0 : bracket + 2), kReasonLength);
    ListLocation{name, current_line()}.refuse("not valid JSON: " + reason);
  }
  return document;
}

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

}  // namespace

std::vector<GeneratorEntry> parse_json(std::string_view content, const std::string& name) {
  const Document document = parse_document(content, name);
  const ListLocation location{name, 1};
  if (!document.root.is_object() || !document.root.contains("generators")) {
    location.refuse("there is no array \"generators\"; write one");
  }
  const json& list = document.root["generators"];
  if (!list.is_array()) location.refuse("\"generators\" must be an array");
  std::vector<GeneratorEntry> entries;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::int32_t line = i < document.lines.size() ? document.lines[i] : 1;
    const ListLocation at{name, line};
    if (!list[i].is_object()) at.refuse(fmt::format("element {} of \"generators\" must be an object", i));
    entries.push_back(read_object(list[i], at));
  }
  return entries;
}

}  // namespace gvd::detail
