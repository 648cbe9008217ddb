// Advice of the library in the words of the commands. libgvd knows no command line: where a message of its errors ends
// with advice, it names a field of an options struct, and the user of a command needs the option that sets it.

#include "common/name_options.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace gvd::app {
namespace {

/// This ends a message behind other advice.
constexpr std::string_view kAllow = ", or set allow_intersections";
constexpr std::string_view kAllowOption = ", or add --allow-intersections";

struct Advice {
  std::string_view of_library;
  std::string_view of_command;
};

constexpr std::array<Advice, 8> kAdvice{{
    {"name the format", "name the format with --input-format obj, ply, off or stl"},
    {"allow its repair", "allow its repair with --on-defect repair"},
    {"give the list as CSV", "give the list as CSV with --generators-format csv"},
    {"raise max_snap", "raise --max-snap"},
    {"set merge_coincident", "add --merge-coincident"},
    {"set refine", "leave --no-refine or --exact-count out"},
    {"raise max_added", "raise --max-added"},
    {"choose PLY, OBJ, OFF or VTP",
     "choose PLY, OBJ, OFF or VTP by the extension of -o, or for -o - by --output-format"},
}};

}  // namespace

std::string name_options(std::string message) {
  if (message.ends_with(kAllow)) {
    message.resize(message.size() - kAllow.size());
    return name_options(std::move(message)).append(kAllowOption);
  }
  for (const Advice& advice : kAdvice) {
    if (!message.ends_with(advice.of_library)) continue;
    message.replace(message.size() - advice.of_library.size(), advice.of_library.size(), advice.of_command);
    break;
  }
  return message;
}

}  // namespace gvd::app
