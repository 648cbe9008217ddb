// What the kinds of options share. CLI11 converts by strtod and strtoll, which depend on the locale and take "010" for
// 8. So the commands' options keep their texts, and a validator turns them into values, which CLI11 allows
// (CLI::Option::each). Its messages then begin with the name of the option.

#include "common/options/typed_options.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "common/options/command_line.hpp"

namespace gvd::app {
namespace {

/// Beyond there is no such memory, and rounding begins.
constexpr double kMostBytes = 0x1p60;

/// The factor of a unit in small letters; nothing for a wrong one.
std::optional<double> unit_factor(std::string_view unit) {
  constexpr std::string_view kUnits = "kmgt";
  if (unit.ends_with('b')) unit.remove_suffix(1);
  const bool binary = unit.ends_with('i');
  if (binary) unit.remove_suffix(1);
  if (unit.empty()) return binary ? std::nullopt : std::optional(1.0);
  const std::size_t index = unit.size() == 1 ? kUnits.find(unit) : kUnits.npos;
  if (index == kUnits.npos) return std::nullopt;
  return std::ldexp(1.0, 10 * (static_cast<int>(index) + 1));
}

}  // namespace

std::string parse_size(std::string_view text, std::optional<std::int64_t>& bytes) {
  const std::string lower = to_lower(text);
  const char* const last = lower.data() + lower.size();
  double number = 0;
  const auto [end, error] = std::from_chars(lower.data(), last, number);
  const std::optional<double> factor = unit_factor({end, last});
  if (!factor || error == std::errc::invalid_argument || !std::isfinite(number)) {
    return fmt::format("'{}' is not a size; write a number with K, M, G or T, such as 500M or 2G", text);
  }
  const bool overflows = error != std::errc{} && lower.find("e-") == lower.npos;
  const double size = number * *factor;
  if (overflows || size > kMostBytes) return fmt::format("'{}' is too large; write at most 1048576T", text);
  if (size < 1) return fmt::format("'{}' is less than a byte; write a size such as 500M or 2G", text);
  bytes = static_cast<std::int64_t>(size);
  return "";
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

const std::vector<std::string>& side_extensions(const std::string& option) {
  static const std::map<std::string, std::vector<std::string>> kExtensions{
      {"--adjacency", {"graphml"}},
      {"--diagram", {"json"}},
      {"--face-labels", {"npy", "csv"}},
      {"--map", {"json"}},
      {"--points", {"ply", "xyz", "npy"}},
      {"--report", {"json"}},
      {"--stats", {"csv"}},
      {"--summary", {"csv"}},
      {"--trace", {"csv"}},
      {"--vertex-distances", {"npy", "csv", "shape.gii", "curv"}},
      {"--vertex-labels", {"npy", "csv", "label.gii", "annot"}},
      {"--view", {"html", "htm"}}};
  return kExtensions.at(option);
}

CLI::Validator has_side_extension(const std::string& option) {
  const auto check = [&extensions = side_extensions(option)](const std::string& file) {
    std::error_code ignored;
    const auto status = std::filesystem::status(file, ignored);
    const bool is_stream = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
    if (is_stream || file.starts_with("/dev/") || file.starts_with("/proc/") || file == "-" ||
        contains(extensions, file_extension(file)))
      return std::string();
    return fmt::format("'{}': the extension must be {}.{}", printable(file), extensions.size() > 1 ? "one of " : "",
                       fmt::join(extensions, ", ."));
  };
  return {check, ""};
}

std::string describe_unknown(const std::string& text, const std::vector<std::string>& names) {
  const auto meant = suggest_name(text, names);
  return fmt::format("'{}' is not one of {}{}", text, fmt::join(names, "|"),
                     meant ? fmt::format("; did you mean {}?", *meant) : "");
}

CLI::Option* add_file(CLI::App& app, const std::string& names, std::string& target, const std::string& description,
                      const std::string& type) {
  return app.add_option(names, target, description)->type_name(type)->check(not_empty("file"));
}

CLI::Option* add_side_output(CLI::App& app, const std::string& name, std::string& target,
                             const std::string& description) {
  const std::string type = fmt::format("FILE.{}", fmt::join(side_extensions(name), "|"));
  return add_file(app, name, target, description, type)->check(has_side_extension(name));
}

}  // namespace gvd::app
