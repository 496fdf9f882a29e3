// Linear least squares with coefficients of 0 or more, and how sure they are.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace headland {

// Rows of terms (one column each) and the value that each row adds up to: least squares over the
// coefficients. `terms` has at most kMostTerms columns. The fit is exact: of all sets of terms the
// one whose unbounded least squares are 0 or more and leave the least residual, which is where the
// conditions of Karush, Kuhn and Tucker hold. Terms that are no part of it have 0.
Eigen::VectorXd nonnegative_fit(const Eigen::MatrixXd& terms, const Eigen::VectorXd& values);
inline constexpr Eigen::Index kMostTerms = 10;

// Columns that cannot be told apart: those of a direction in which the columns, each scaled to
// length 1, all but cancel (singular value below kCollinear of the largest), or that are 0
// throughout. Empty: the fit has one answer.
std::vector<Eigen::Index> collinear_terms(const Eigen::MatrixXd& terms);
inline constexpr double kCollinear = 1e-3;

// The 95 % percentile interval of a coefficient over fits to rows drawn anew.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

// `group` says which rows belong together and are drawn together: plans on one field are no
// independent observations. Draws come from `seed` alone.
std::vector<Interval> bootstrap_intervals(const Eigen::MatrixXd& terms,
                                          const Eigen::VectorXd& values,
                                          const std::vector<int>& group, int draws,
                                          std::uint64_t seed);

}  // namespace headland
