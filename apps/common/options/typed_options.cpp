// What the kinds of options share. CLI11 converts by strtod and strtoll, which depend on the locale and take "010" for
// 8. So the commands' options keep their texts, and a validator turns them into values, which CLI11 allows
// (CLI::Option::each). Its messages then begin with the name of the option.

#include "common/options/typed_options.hpp"

#include <cmath>
#include <memory>

namespace gvd::app {
namespace {

/// Beyond there is no such memory, and rounding begins.
constexpr double kMostBytes = 0x1p60;

/// The number that `text` spells; infinity or 0 where a double can't hold it. Nothing where it spells none.
std::optional<double> parse_any_number(const std::string& text) {
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (end != last || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc{}) return value;
  return text.find("e-") == text.npos ? std::numeric_limits<double>::infinity() : 0;
}

/// Takes the unit off the end of `text`, which is in small letters. Returns its factor, or nothing for a wrong one.
std::optional<double> take_unit(std::string& text) {
  constexpr std::string_view kUnits = "kmgt";
  if (text.ends_with('b')) text.pop_back();
  const bool binary = text.ends_with('i');
  if (binary) text.pop_back();
  const std::size_t unit = text.empty() ? kUnits.npos : kUnits.find(text.back());
  if (unit == kUnits.npos) return binary ? std::nullopt : std::optional(1.0);
  text.pop_back();
  return std::ldexp(1.0, 10 * (static_cast<int>(unit) + 1));
}

}  // namespace

ParsedSize parse_size(std::string_view text) {
  std::string lower = to_lower(std::string(text));
  const std::optional<double> factor = take_unit(lower);
  const std::optional<double> number = parse_any_number(lower);
  if (!factor || !number || std::isnan(*number) || lower.find("inf") != lower.npos) {
    return {0, fmt::format("'{}' is no size; write a number with K, M, G or T, as 500M or 2G", text)};
  }
  const double bytes = *number * *factor;
  if (bytes < 1) return {0, fmt::format("'{}' is less than a byte; write a size such as 500M or 2G", text)};
  if (bytes > kMostBytes) return {0, fmt::format("'{}' is too large; write at most 1048576T", text)};
  return {static_cast<std::int64_t>(bytes), ""};
}

CLI::Option* add_parsed(CLI::App& app, const std::string& names, const std::string& type, const StoreText& store,
                        const std::string& description) {
  return app.add_option(names, CLI::callback_t(), description)->type_name(type)->check(store);
}

CLI::Option* add_flag(CLI::App& app, const std::string& names, bool& target, const std::string& description) {
  const auto self = std::make_shared<CLI::Option*>();
  const auto store = [&target, self](std::int64_t on) {
    target = on > 0;
    if (!target) (*self)->clear();
  };
  *self = app.add_flag_function(names, store, description)->take_last();
  return (*self)->check([](const std::string& text) -> std::string {
    bool value = false;
    return CLI::detail::lexical_cast(text, value) ? "" : fmt::format("'{}' is neither true nor false", text);
  });
}

CLI::Validator not_empty(const std::string& kind) {
  return {[kind](std::string& name) { return name.empty() ? "the name is empty; name a " + kind : ""; }, ""};
}

CLI::Option* add_file(CLI::App& app, const std::string& names, std::string& target, const std::string& description,
                      const std::string& type) {
  return app.add_option(names, target, description)->type_name(type)->check(not_empty("file"));
}

}  // namespace gvd::app
