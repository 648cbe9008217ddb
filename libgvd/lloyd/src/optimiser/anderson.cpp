#include "anderson.hpp"

#include <Eigen/Dense>

namespace gvd {
namespace {

Eigen::VectorXd flat(const TangentField& field) {
  Eigen::VectorXd v(2 * std::ssize(field));
  for (std::size_t i = 0; i < field.size(); ++i) v.segment<2>(2 * static_cast<Eigen::Index>(i)) = field[i];
  return v;
}

}  // namespace

TangentField anderson_step(const StepHistory& history, const TangentField& residual) {
  if (history.pairs().empty()) return residual;
  Eigen::MatrixXd changes(2 * std::ssize(residual), std::ssize(history.pairs()));
  Eigen::Index column = 0;
  for (const StepPair& pair : history.pairs()) changes.col(column++) = flat(pair.change);
  const Eigen::VectorXd factors = changes.colPivHouseholderQr().solve(flat(residual));
  TangentField step = residual;
  column = 0;
  for (const StepPair& pair : history.pairs()) {
    step = add_scaled(std::move(step), -factors[column], pair.step);
    step = add_scaled(std::move(step), -factors[column++], pair.change);
  }
  return step;
}

}  // namespace gvd
