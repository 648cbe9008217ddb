// Feeds the file of --config: its entries, and the options that its keys name.
#include <fmt/format.h>

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "common/options/config_file.hpp"
#include "fuzz/targets/require.hpp"
#include "gvd/option_text.hpp"
#include "options/toy_options.hpp"

namespace {

using namespace gvd;
using namespace gvd::app;
using fuzz::attempt;
using fuzz::require;

std::vector<GivenTexts> read(const OptionList& list, const std::string& content) {
  std::istringstream stream(content);
  return read_config_file(list, stream, "a.toml");
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if ((c >= 0 && c < ' ') || c == '"' || c == '\\' || c == 127) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<int>(c));
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string toml_of(const GivenTexts& given, const std::string& text) {
  if (const auto* const number = std::get_if<Number>(&given.option->field)) {
    const bool is_word = !number->words.empty();
    const bool is_plain = number->implied && (text == "true" || text == "false");
    const bool real = is_real(*number);
    if (is_word) return quoted(text);
    return is_plain || !real || text.find_first_of(".en") != std::string::npos ? text : text + ".0";
  }
  if (std::holds_alternative<Flag>(given.option->field)) {
    return given.option->is_on ? (text == "true" ? "false" : "true") : text;  // no-refine
  }
  return quoted(text);
}

/// The entries, written as TOML, must come back: same options and texts in the same order.
void check_written(const OptionList& list, const std::vector<GivenTexts>& all) {
  std::string content;
  for (const GivenTexts& given : all) {
    const bool is_list = is_repeatable(given.option->field) && takes_value(given.option->field);
    content += given.source.spelling + (is_list ? " = [" : " = ");
    for (const std::string& text : given.texts) content += toml_of(given, text) + (is_list ? ", " : "");
    content += is_list ? "]\n" : "\n";
  }
  std::vector<GivenTexts> again;
  attempt({}, [&] { again = read(list, content); });
  require(again.size() == all.size(), "other entries come back from:\n" + content);
  for (std::size_t i = 0; i < all.size(); ++i) {
    require(again[i].option == all[i].option && again[i].texts == all[i].texts,
            "another entry comes back from:\n" + content);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::Toy toy;
  const std::string content(reinterpret_cast<const char*>(data), size);
  std::vector<GivenTexts> given;
  if (!attempt({ErrorCode::invalid_option}, [&] { given = read(toy.list, content); })) return 0;
  for (const GivenTexts& each : given) {
    require(!each.texts.empty(), "an option without a value");
    read_option(*each.option, each.texts);
  }
  check_written(toy.list, given);
  return 0;
}
