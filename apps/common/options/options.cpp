// Computes what follows from several options, and handles names of files. Nothing here depends on the locale.

#include "common/options/options.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "gvd/io/mesh_writer.hpp"

namespace gvd::app {

std::uint64_t seed_of(const Options& options) {
  const Option* const option = options.list->find("seed");
  const auto* const number = option == nullptr ? nullptr : std::get_if<Number>(&option->field);
  const auto* const seed = number == nullptr ? nullptr : std::get_if<std::uint64_t*>(&number->value);
  return seed == nullptr ? 0 : **seed;
}

std::string format_of(const OutputOptions& output, const std::string& file) {
  const std::string asked = output.formats.empty() ? "" : output.formats.front();
  if (file == "-") return asked;
  const std::string extension = file_extension(file);
  return asked == kFreeSurfer && find_output(extension) == nullptr ? asked : extension;
}

std::vector<std::string> written_formats(const OutputOptions& output) {
  std::vector<std::string> written;
  if (!output.folder.empty()) written = output.formats;
  for (const std::string& file : output.files) written.push_back(format_of(output, file));
  return written;
}

bool writes(const OutputOptions& output, Content any) {
  const std::vector<std::string> written = written_formats(output);
  return std::ranges::any_of(written, [&](const std::string& format) {
    const Format* const row = find_output(format);
    return row != nullptr && has_any(row->carries, any);
  });
}

std::string name_of(const Target& target) {
  return target.has_materials ? "the materials of " + placeholder(target.option) + ' ' + target.path
                              : placeholder(target.option, target.path);
}

std::vector<Target> list_targets(const OutputOptions& output) {
  std::vector<Target> targets;
  for (const std::string& file : output.files)
    targets.push_back({output.folder.empty() ? "output" : "output_dir", file});
  targets.push_back({"report", output.report});
  targets.push_back({"diagram", output.diagram});
  targets.push_back({"view", output.view});
  for (const auto& [option, file] : output.own) targets.push_back({option, *file});
  std::erase_if(targets, [](const Target& target) { return target.path.empty(); });
  return targets;
}

bool names_file(const OutputOptions& output) {
  const bool has_own =
      std::any_of(output.own.begin(), output.own.end(), [](const auto& own) { return !own.second->empty(); });
  return has_own || output.open || !output.files.empty() || !output.folder.empty() || !output.report.empty() ||
         !output.diagram.empty() || !output.view.empty();
}

bool is_read_once(const std::string& file) {
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  return file == "-" || (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
                         !std::filesystem::is_directory(status));
}

/// Longest chain of symbolic links that is followed: the limit of Linux.
constexpr int kMaxLinks = 40;

std::string one_name(const std::string& path) {
  std::error_code failed;
  std::filesystem::path target = std::filesystem::absolute(path, failed);
  for (int i = 0; i < kMaxLinks && std::filesystem::is_symlink(target, failed); ++i) {
    target = target.parent_path() / std::filesystem::read_symlink(target, failed);
  }
  target = std::filesystem::weakly_canonical(target, failed);
  return failed ? path : target.string();
}

std::string file_extension(const std::string& path) { return format_extension(path); }

bool contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

}  // namespace gvd::app
