// Feeds the file of --config: its entries, and the options that its keys name.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "common/options/config_file.hpp"
#include "fuzz/targets/require.hpp"

namespace {

using namespace gvd;
using namespace gvd::app;
using fuzz::attempt;
using fuzz::require;
using Items = std::vector<CLI::ConfigItem>;

/// An app with an option of each kind, alone and as a list.
class OneOfEach {
 public:
  OneOfEach() {
    app_.set_help_flag();
    app_.add_option("INPUT", texts_)->type_name("");
    app_.add_option("-n,--count", text_)->type_name("N");
    app_.add_option("--vertices", texts_)->type_name("LIST");
    app_.add_option("--radius", text_)->type_name("NUMBER");
    app_.add_option("--max-memory", text_)->type_name("SIZE");
    app_.add_option("--sampling", text_)->type_name("NAME");
    app_.add_flag("--cut", flag_);
    app_.set_config("--config")->add_result("a.toml");
  }

  Items read(const std::string& content) const {
    std::istringstream stream(content);
    return ConfigFile(app_).from_config(stream);
  }

 private:
  CLI::App app_{"", "gvd-fuzz"};
  std::string text_;
  std::vector<std::string> texts_;
  bool flag_ = false;
};

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

std::string toml_of(const CLI::ConfigItem& item, const std::string& text) {
  if (item.name == "count" || item.name == "cut") return text;
  if (item.name != "radius") return quoted(text);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

/// The items, written as TOML, must come back: same names and texts in the same order.
void check_written(const OneOfEach& options, const Items& items) {
  std::string content;
  for (const CLI::ConfigItem& item : items) {
    const bool is_list = item.name == "INPUT" || item.name == "vertices";
    content += (item.name == "INPUT" ? "input" : item.name) + (is_list ? " = [" : " = ");
    for (const std::string& text : item.inputs) content += toml_of(item, text) + (is_list ? ", " : "");
    content += is_list ? "]\n" : "\n";
  }
  Items again;
  attempt({}, [&] { again = options.read(content); });
  require(again.size() == items.size(), "other entries come back from:\n" + content);
  for (std::size_t i = 0; i < items.size(); ++i) {
    require(again[i].name == items[i].name && again[i].inputs == items[i].inputs,
            "another entry comes back from:\n" + content);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const OneOfEach options;
  const std::string content(reinterpret_cast<const char*>(data), size);
  Items items;
  if (!attempt({ErrorCode::invalid_option}, [&] { items = options.read(content); })) return 0;
  for (const CLI::ConfigItem& item : items) require(!item.inputs.empty(), "an option without a value");
  check_written(options, items);
  return 0;
}
