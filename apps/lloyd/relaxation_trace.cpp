#include "lloyd/relaxation_trace.hpp"

#include <fmt/format.h>

#include <ostream>

#include "common/options/options.hpp"
#include "lloyd/lloyd_report.hpp"

namespace gvd::app {

void RelaxationTrace::note(std::int64_t iterations, const std::vector<SurfacePoint>& generators) {
  const std::size_t count = static_cast<std::size_t>(iterations) + 1;
  seconds_.resize(count);
  seconds_.back() = timer_.seconds();
  generators_.resize(count);
  generators_.back() = generators;
}

void RelaxationTrace::write(std::ostream& out, const LloydResult& result, const Method& method) const {
  out << "iteration,energy,largest_move,mean_move,method,step,seconds\n";
  const char* first = result.iterations.empty() ? method_name(method) : measure_name(result.iterations.front());
  out << fmt::format("0,{},0,0,{},start,{:.6f}\n", result.initial_energy, first, seconds_.front());
  for (std::size_t i = 0; i < result.iterations.size(); ++i) {
    const LloydIteration& done = result.iterations[i];
    out << fmt::format("{},{},{},{},{},{},{:.6f}\n", i + 1, done.energy, done.largest_move, done.mean_move,
                       measure_name(done), step_name(done), seconds_[i + 1]);
  }
}

}  // namespace gvd::app
