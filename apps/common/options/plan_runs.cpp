#include "common/options/plan_runs.hpp"

#include <filesystem>
#include <string>

namespace gvd::app {

std::vector<Options> plan_runs(const Options& options) {
  namespace fs = std::filesystem;
  std::vector<Options> runs;
  for (const std::string& path : options.input.paths) {
    Options& run = runs.emplace_back(options);
    run.input.path = path;
    if (options.output.folder.empty()) continue;
    for (const std::string& format : options.output.formats) {
      fs::path name = fs::path(path).stem();
      name += '.' + format;
      run.output.files.push_back((fs::path(options.output.folder) / name).string());
    }
  }
  return runs;
}

}  // namespace gvd::app
