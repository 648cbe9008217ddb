// Reads lines, tokens and numbers of a text, with line numbers for messages.
//
// Numbers are read by std::from_chars, which does not depend on the locale. It does not distinguish overflow from
// underflow, but the decimal exponent does. Only texts with lone CR as line ends are copied; all others are read in
// place. The readers of all formats share this code, so messages about a wrong token, a missing number and an early end
// are the same in all formats.
// Invariant: an element that lacks a number is refused with its own line, before numbers of the next element are taken
// for it.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::string_view without_plus(std::string_view token) {
  const bool has_plus = token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+';
  return has_plus ? token.substr(1) : token;
}

/// Returns 0 or infinity for a number beyond the range of a double. The decimal exponent of the first nonzero digit is
/// above 300 for an overflow and below -300 for an underflow.
double out_of_range_value(std::string_view token) {
  const double sign = token[0] == '-' ? -1 : 1;
  const std::size_t e = std::min(token.find_first_of("eE"), token.size());
  const std::string_view mantissa = token.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t leading = mantissa.find_first_of("123456789");
  if (leading == std::string_view::npos) return 0;
  double exponent = double(point) - double(leading);
  if (e < token.size()) {
    std::string_view digits = without_plus(token.substr(e + 1));
    std::int64_t value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ec != std::errc()) value = digits[0] == '-' ? -1'000'000'000'000 : 1'000'000'000'000;
    exponent += double(value);
  }
  return exponent < 0 ? sign * 0.0 : sign * kInfinity;
}

/// Whether there is a CR without an LF after it, so that CR alone ends lines.
bool has_lone_return(std::string_view bytes) {
  for (std::size_t at = bytes.find('\r'); at != std::string_view::npos; at = bytes.find('\r', at + 1)) {
    if (at + 1 < bytes.size() && bytes[at + 1] != '\n') return true;
  }
  return false;
}

std::string with_unix_lines(std::string_view bytes) {
  std::string text(bytes);
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] == '\r' && text[i + 1] != '\n') text[i] = '\n';
  }
  return text;
}

}  // namespace

std::optional<double> parse_double(std::string_view token) {
  token = without_plus(token);
  double value = 0;
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (stop != end || token.empty() || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc::result_out_of_range ? out_of_range_value(token) : value;
}

// Inlined completely, because calls of the conversion would take 4 % of the instructions of reading an OBJ.
[[gnu::flatten]] std::optional<std::int64_t> parse_integer(std::string_view token) {
  return parse_number<std::int64_t>(without_plus(token));
}

TextReader::TextReader(std::string_view bytes, std::string_view name, bool comments)
    : text_(bytes), name_(name), comments_(comments) {
  if (has_lone_return(bytes)) {
    unix_text_ = with_unix_lines(bytes);
    text_ = unix_text_;
  }
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
}

bool TextReader::next_line() {
  if (text_.empty()) return false;
  const std::size_t end = std::min(text_.find('\n'), text_.size());
  line_ = text_.substr(0, end);
  text_.remove_prefix(std::min(end + 1, text_.size()));
  ++line_number_;
  return true;
}

bool TextReader::next_content_line() {
  while (next_line()) {
    const auto first = std::find_if_not(line_.begin(), line_.end(), is_blank);
    if (first != line_.end() && !(comments_ && *first == '#')) return true;
  }
  return false;
}

bool TextReader::begin_element() {
  if (!next_content_line()) return false;
  element_line_ = line_number_;
  return true;
}

void TextReader::end_element(std::string_view kind, std::int64_t element) const {
  if (line_number_ == element_line_) return;
  const auto extra = std::find_if_not(line_.begin(), line_.end(), is_blank);
  if (extra == line_.end() || (comments_ && *extra == '#')) return;
  throw Error(ErrorCode::unreadable_input,
              fmt::format("{}:{}: {} {} has too few numbers, or continues on line {} and does not end there", name_,
                          element_line_, kind, element, line_number_),
              element);
}

std::string_view TextReader::token() {
  const char* const end = line_.data() + line_.size();
  const char* begin = line_.data();
  while (begin != end && is_blank(*begin)) ++begin;
  const char* stop = begin;
  while (stop != end && !is_blank(*stop) && !(comments_ && *stop == '#')) ++stop;
  const bool at_comment = stop == begin;
  line_ = at_comment ? std::string_view() : std::string_view(stop, std::size_t(end - stop));
  return {begin, std::size_t(stop - begin)};
}

std::string_view TextReader::next_number(std::string_view what) {
  std::string_view text = token();
  while (text.empty() && element_line_ > 0) {
    if (!next_content_line()) refuse_end(fmt::format("and {} is missing", what));
    text = token();
  }
  if (text.empty()) refuse(fmt::format("{} is missing", what));
  return text;
}

double TextReader::number(std::string_view what) {
  const std::string_view text = next_number(what);
  const std::optional<double> value = parse_double(text);
  if (!value) refuse(fmt::format("{} is {}, and should be a number", what, quoted(text)));
  return *value;
}

std::int64_t TextReader::integer(std::string_view what) {
  const std::string_view text = next_number(what);
  const std::optional<std::int64_t> value = parse_integer(text);
  if (!value) refuse(fmt::format("{} is {}, and should be a whole number", what, quoted(text)));
  return *value;
}

Vec3 TextReader::position(std::int64_t vertex) {
  constexpr std::string_view kCoordinates[] = {"coordinate x", "coordinate y", "coordinate z"};
  Vec3 p;
  for (int i = 0; i < 3; ++i) {
    p[i] = number(kCoordinates[i]);
    if (!std::isfinite(p[i])) {
      throw Error(
          ErrorCode::precondition,
          fmt::format("{}:{}: {} of vertex {} is not a finite number", name_, line_number_, kCoordinates[i], vertex),
          vertex);
    }
  }
  return p;
}

void TextReader::refuse(const std::string& message, std::int64_t element) const {
  throw Error(ErrorCode::unreadable_input, fmt::format("{}:{}: {}", name_, line_number_, message), element);
}

void TextReader::refuse_end(const std::string& message, std::int64_t element) const {
  throw Error(ErrorCode::unreadable_input,
              fmt::format("{}: the file ends after line {}, {}", name_, line_number_, message), element);
}

std::string first_word(std::string_view bytes) {
  TextReader text(bytes.substr(0, 1 << 20), "", true);
  return text.next_content_line() ? std::string(text.token()) : std::string();
}

bool is_xml_of(std::string_view bytes, std::string_view element) {
  constexpr std::size_t kSearched = 4096;
  bytes = bytes.substr(0, kSearched);
  const std::size_t first = bytes.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  return first != bytes.npos && bytes[first] == '<' && bytes.find(element) != bytes.npos;
}

bool is_json(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  return first != bytes.npos && bytes[first] == '{';
}

}  // namespace gvd
