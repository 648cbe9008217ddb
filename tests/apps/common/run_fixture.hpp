#pragma once

#include <nlohmann/json.hpp>
#include <sstream>

#include "common/process.hpp"
#include "common/run.hpp"

namespace gvd::test {

/// A run that prints nothing, of the options that it is given.
struct QuietRun {
  explicit QuietRun(const app::Options& options) : run("gvd-test", options, console) { app::install_signal_handlers(); }

  nlohmann::ordered_json report() {
    std::ostringstream out;
    run.report().write(out);
    return nlohmann::ordered_json::parse(out.str());
  }

  app::Console console{"gvd-test", {}, true, false};
  app::Run run;
};

}  // namespace gvd::test
