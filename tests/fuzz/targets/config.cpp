// Feeds the reader of --config, and the search for the options that its keys name.
#include <fmt/format.h>

#include <deque>
#include <iterator>
#include <string>
#include <vector>

#include "common/options/config_file.hpp"
#include "common/options/config_options.hpp"
#include "fuzz/targets/require.hpp"

namespace {

using namespace gvd;
using namespace gvd::app;
using fuzz::attempt;
using fuzz::require;

/// An option of each kind, alone and as a list.
std::deque<DeclaredOption> make_options() {
  std::deque<DeclaredOption> declared;
  const auto add = [&](const char* names, ValueKind kind, bool is_list) {
    DeclaredOption option;
    option.text.names = names;
    option.text.kind = kind;
    option.is_list = is_list;
    declared.push_back(option);
  };
  add("INPUT", ValueKind::text, true);
  add("-n,--count", ValueKind::whole, false);
  add("--vertices", ValueKind::whole, true);
  add("--radius", ValueKind::number, false);
  add("--cut", ValueKind::flag, false);
  add("--sampling", ValueKind::text, false);
  return declared;
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

std::string toml_of(const ConfigValue& value) {
  switch (value.type) {
    case ConfigValue::Type::text:
      return quoted(value.text);
    case ConfigValue::Type::number:
      return value.text.find_first_of(".en") == std::string::npos ? value.text + ".0" : value.text;
    case ConfigValue::Type::other:
      return "{}";
    case ConfigValue::Type::whole:
    case ConfigValue::Type::flag:
      break;
  }
  return value.text;
}

std::string toml_of(const std::vector<ConfigEntry>& entries) {
  std::string content;
  for (const ConfigEntry& entry : entries) {
    content += quoted(entry.key) + (entry.is_array ? " = [" : " = ");
    for (const ConfigValue& value : entry.values) content += toml_of(value) + (entry.is_array ? ", " : "");
    content += entry.is_array ? "]\n" : "\n";
  }
  return content;
}

/// The entries, written as TOML, must come back: same keys, types and texts in the same order.
void check_written(const std::vector<ConfigEntry>& entries) {
  const std::string content = toml_of(entries);
  std::vector<ConfigEntry> again;
  attempt({}, [&] { again = parse_config(content, "written.toml"); });
  require(again.size() == entries.size(), "other entries come back from:\n" + content);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    require(again[i].key == entries[i].key && again[i].is_array == entries[i].is_array,
            "another entry comes back from:\n" + content);
    require(again[i].values.size() == entries[i].values.size(), "another array comes back from:\n" + content);
    for (std::size_t k = 0; k < entries[i].values.size(); ++k) {
      const ConfigValue &value = entries[i].values[k], &other = again[i].values[k];
      require(value.type == other.type && value.text == other.text, "another value comes back from:\n" + content);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::deque<DeclaredOption> declared = make_options();
  const std::string content(reinterpret_cast<const char*>(data), size);
  std::vector<ConfigEntry> entries;
  if (!attempt({ErrorCode::invalid_option}, [&] { entries = parse_config(content, "a.toml"); })) return 0;
  check_written(entries);
  std::vector<GivenOption> given;
  if (!attempt({ErrorCode::invalid_option}, [&] { given = find_config_options(entries, declared); })) return 0;
  require(given.size() == entries.size(), "a key is lost");
  for (const GivenOption& option : given) require(!option.values.empty(), "an option without a value");
  return 0;
}
