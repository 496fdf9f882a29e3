#include "evaluate/nonnegative_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "planner/seeded_random.h"

namespace headland {
namespace {

// All that a fit needs of its rows; those of several sets of rows add up.
struct NormalEquations {
  Eigen::MatrixXd gram;  // terms^T terms
  Eigen::VectorXd moment;
};

NormalEquations normal_equations(const Eigen::MatrixXd& terms, const Eigen::VectorXd& values) {
  return {terms.transpose() * terms, terms.transpose() * values};
}

std::vector<Eigen::Index> members(unsigned set, Eigen::Index terms) {
  std::vector<Eigen::Index> list;
  for (Eigen::Index i = 0; i < terms; ++i) {
    if ((set >> static_cast<unsigned>(i) & 1U) != 0U) list.push_back(i);
  }
  return list;
}

Eigen::VectorXd solved(const NormalEquations& rows) {
  const Eigen::Index terms = rows.moment.size();
  assert(terms <= kMostTerms);
  // Scaled, so that terms of any unit are told apart as well.
  const Eigen::VectorXd scale =
      rows.gram.diagonal().unaryExpr([](double g) { return g > 0.0 ? 1.0 / std::sqrt(g) : 0.0; });
  const Eigen::MatrixXd gram = scale.asDiagonal() * rows.gram * scale.asDiagonal();
  const Eigen::VectorXd moment = scale.asDiagonal() * rows.moment;
  Eigen::VectorXd best = Eigen::VectorXd::Zero(terms);
  double most_explained = 0.0;
  for (unsigned set = 1; set < 1U << static_cast<unsigned>(terms); ++set) {
    const std::vector<Eigen::Index> list = members(set, terms);
    const Eigen::VectorXd part = moment(list);
    const Eigen::VectorXd fit = gram(list, list).ldlt().solve(part);
    const double explained = part.dot(fit);
    if (!fit.allFinite() || fit.minCoeff() < 0.0 || explained <= most_explained) continue;
    most_explained = explained;
    best.setZero();
    best(list) = fit;
  }
  return scale.asDiagonal() * best;
}

}  // namespace

Eigen::VectorXd nonnegative_fit(const Eigen::MatrixXd& terms, const Eigen::VectorXd& values) {
  return solved(normal_equations(terms, values));
}

std::vector<Eigen::Index> collinear_terms(const Eigen::MatrixXd& terms) {
  std::vector<Eigen::Index> named;
  Eigen::MatrixXd unit = terms;
  for (Eigen::Index i = 0; i < unit.cols(); ++i) {
    const double length = unit.col(i).norm();
    if (length > 0.0) {
      unit.col(i) /= length;
    } else {
      named.push_back(i);
    }
  }
  if (!named.empty()) return named;
  if (unit.rows() < unit.cols()) {
    for (Eigen::Index i = 0; i < unit.cols(); ++i) named.push_back(i);
    return named;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(unit, Eigen::ComputeThinV);
  const Eigen::VectorXd& sizes = svd.singularValues();
  if (sizes(sizes.size() - 1) >= kCollinear * sizes(0)) return named;
  const Eigen::VectorXd direction = svd.matrixV().col(unit.cols() - 1).cwiseAbs();
  constexpr double kPart = 0.1;  // of the largest, to take part in the direction
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    if (direction(i) >= kPart * direction.maxCoeff()) named.push_back(i);
  }
  return named;
}

std::vector<Interval> bootstrap_intervals(const Eigen::MatrixXd& terms,
                                          const Eigen::VectorXd& values,
                                          const std::vector<int>& group, int draws,
                                          std::uint64_t seed) {
  const int groups = *std::max_element(group.begin(), group.end()) + 1;
  std::vector<NormalEquations> of_group;
  for (int g = 0; g < groups; ++g) {
    std::vector<Eigen::Index> rows;
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (group[i] == g) rows.push_back(static_cast<Eigen::Index>(i));
    }
    of_group.push_back(normal_equations(terms(rows, Eigen::all), values(rows)));
  }
  SeededRandom random(seed);
  std::vector<std::vector<double>> drawn(static_cast<std::size_t>(terms.cols()));
  for (int draw = 0; draw < draws; ++draw) {
    NormalEquations rows{Eigen::MatrixXd::Zero(terms.cols(), terms.cols()),
                         Eigen::VectorXd::Zero(terms.cols())};
    for (int g = 0; g < groups; ++g) {
      const NormalEquations& more = at(of_group, draw_below(random, groups));
      rows.gram += more.gram;
      rows.moment += more.moment;
    }
    const Eigen::VectorXd fit = solved(rows);
    for (Eigen::Index i = 0; i < fit.size(); ++i)
      drawn[static_cast<std::size_t>(i)].push_back(fit(i));
  }
  std::vector<Interval> intervals;
  for (std::vector<double>& fits : drawn) {
    std::sort(fits.begin(), fits.end());
    constexpr double kTail = 0.025;
    const auto at_share = [&](double share) {
      return fits[static_cast<std::size_t>(
          std::lround(share * static_cast<double>(fits.size() - 1)))];
    };
    intervals.push_back({at_share(kTail), at_share(1.0 - kTail)});
  }
  return intervals;
}

}  // namespace headland
