// SPDX-License-Identifier: MIT
// Groups of three first, then the pair whose axes are farthest from meeting and from being parallel.
#include "cut.h"

#include <Eigen/Core>
#include <cmath>

#include "moivre/factorization/svd.h"

namespace moivre {
namespace {

/// Pairs that are nearer to meeting or to being parallel, beside the arm's size, are taken as if they were: the equations
/// for that hold for all pairs, and the others lose as many digits as this has zeros.
constexpr double kLeastQuality = 1e-5;

using Row = Eigen::Matrix<double, 1, 8>;

Row unit_row(const ExactDisplacement& g) {
  Integer largest = 1;
  for (const Integer& part : g) largest = std::max<Integer>(largest, abs(part));
  Row row;
  for (std::size_t k = 0; k < g.size(); ++k) {
    row[static_cast<Eigen::Index>(k)] = to_double(ratio(g[k], largest));
  }
  return row.normalized();
}

/// Study's form between the products 1 1 and step step, whose coordinates it couples: a sin(twist), beside the arm's size.
double quality(const std::vector<ExactDisplacement>& products) {
  const Row first = unit_row(products.front());
  const Row last = unit_row(products.back());
  return std::abs(first.head<4>().dot(last.tail<4>()) + first.tail<4>().dot(last.head<4>()));
}

/// How far the four are from being dependent.
double independence(const std::vector<ExactDisplacement>& products) {
  Eigen::Matrix<double, 4, 8> rows;
  for (Eigen::Index k = 0; k < 4; ++k)
    rows.row(k) = unit_row(products[static_cast<std::size_t>(k)]);
  return singular_values(rows)[3];
}

/// Whether rank 4 of a pair's products with a third joint is not out of the question: exact ranks cost more than this.
bool may_be_group(const std::vector<ExactDisplacement>& products, const LoopJoint& third) {
  constexpr double kClearlyMore = 1e-6;
  Eigen::Matrix<double, 8, 8> rows;
  for (Eigen::Index k = 0; k < 4; ++k) {
    const ExactDisplacement before = products[static_cast<std::size_t>(k)] * third.before;
    rows.row(2 * k) = unit_row(before);
    rows.row(2 * k + 1) = unit_row(before * third.step);
  }
  return singular_values(rows)[4] < kClearlyMore;
}

Cut cut_at(const Loop& loop, std::size_t first, std::size_t count) {
  const std::size_t n = loop.joints.size();
  Cut cut;
  cut.first = first;
  for (std::size_t k = 0; k < n; ++k) {
    (k < count ? cut.inside : cut.outside).push_back((first + k) % n);
  }
  return cut;
}

/// The group that three joints make, if they do.
std::optional<Cut> cut_of_three(const Loop& loop, std::size_t first) {
  std::vector<ExactDisplacement> products = pair_products(loop, first, first + 1);
  if (!may_be_group(products, loop.joints[first + 2])) return std::nullopt;
  if (vanishing_forms(products).size() != 4) return std::nullopt;
  if (vanishing_forms(pair_products(loop, first + 1, first + 2)).size() != 4) return std::nullopt;
  const LoopJoint& third = loop.joints[first + 2];
  for (std::size_t k = 0; k < 4; ++k) products.push_back(products[k] * third.before * third.step);
  for (std::size_t k = 0; k < 4; ++k) products[k] = products[k] * third.before;
  Cut cut = cut_at(loop, first, 3);
  cut.kind = CutKind::three;
  cut.forms = vanishing_forms(products);
  if (cut.forms.size() != 4) return std::nullopt;
  return cut;
}

Cut cut_of_two(const Loop& loop, CutPlace place) {
  const std::size_t n = loop.joints.size();
  const bool has_more = n > 2 && place == CutPlace::anywhere;
  std::size_t best = 0, loosest = 0;
  double best_quality = -1, best_independence = -1;
  for (std::size_t k = 0; k < (has_more ? n : n - 1); ++k) {
    const auto products = pair_products(loop, k, (k + 1) % n);
    const double here = quality(products);
    const double apart = independence(products);
    if (here > best_quality) best_quality = here, best = k;
    if (apart > best_independence) best_independence = apart, loosest = k;
  }
  const bool is_plain = best_quality >= kLeastQuality;
  Cut cut = cut_at(loop, is_plain ? best : loosest, 2);
  const auto products = pair_products(loop, cut.inside[0], cut.inside[1]);
  cut.forms = vanishing_forms(products);
  cut.kind = is_plain ? CutKind::two : CutKind::two_in_quadric;
  if (!is_plain && cut.forms.size() == 4) cut.coordinates = coordinate_forms(products);
  return cut;
}

}  // namespace

std::vector<ExactDisplacement> pair_products(const Loop& loop, std::size_t a, std::size_t b) {
  const LoopJoint& first = loop.joints[a];
  const LoopJoint& second = loop.joints[b];
  const ExactDisplacement moved = first.step * second.before;
  return {second.before, second.before * second.step, moved, moved * second.step};
}

Cut choose_cut(const Loop& loop, CutPlace place) {
  const std::size_t n = loop.joints.size();
  if (n == 1) {
    Cut cut = cut_at(loop, 0, 1);
    cut.kind = CutKind::one;
    cut.forms = vanishing_forms({ExactDisplacement{1}, loop.joints[0].step});
    return cut;
  }
  for (std::size_t first = 0; first + 2 < n; ++first) {
    if (auto cut = cut_of_three(loop, first)) return *cut;
  }
  return cut_of_two(loop, place);
}

}  // namespace moivre
