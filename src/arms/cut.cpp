// SPDX-License-Identifier: MIT
// Groups of three first, then the pair whose axes are farthest from meeting and from being
// parallel.
#include "cut.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "moivre/factorization/svd.h"
#include "moivre/mechanism/joint_type.h"

namespace moivre {
namespace {

/// Pairs that are nearer to meeting or to being parallel, relative to the arm's size, are taken as
/// if they were: the equations for that hold for all pairs, and the others lose as many digits as
/// this has zeros.
constexpr double kLeastQuality = 1e-5;

/// A pair with a slide is taken only where others are nearly special: its space also holds slides
/// that leave.
constexpr double kSlidePenalty = 1e-3;

using Columns = Eigen::Matrix<double, 8, Eigen::Dynamic>;

/// As columns of norm 1.
Columns unit_columns(const std::vector<RealDisplacement>& all) {
  Columns columns(8, static_cast<Eigen::Index>(all.size()));
  Eigen::Index k = 0;
  for (const RealDisplacement& g : all) columns.col(k++) = column(unit(g));
  return columns;
}

/// Study's form between the products 1 1 and step step, whose coordinates it couples: a sin(twist),
/// relative to the arm's size.
double quality(const Columns& products) {
  const auto first = products.col(0);
  const auto last = products.col(3);
  return std::abs(first.head<4>().dot(last.tail<4>()) + first.tail<4>().dot(last.head<4>()));
}

/// Whether rank 4 of a pair's products with a third joint is not out of the question: exact ranks
/// cost more than this.
bool may_be_group(const Loop& loop, std::size_t first) {
  constexpr double kClearlyMore = 1e-6;
  const auto& [before, one, step] = loop.joints[first + 2].rounded;
  std::vector<RealDisplacement> products;
  for (const RealDisplacement& of_pair :
       pair_products(loop, first, first + 1, &LoopJoint::rounded)) {
    products.push_back(of_pair * before);
    products.push_back(products.back() * step);
  }
  return singular_values(unit_columns(products))[4] < kClearlyMore;
}

Cut cut_at(const Loop& loop, std::size_t first, std::size_t count) {
  const std::size_t n = loop.joints.size();
  Cut cut;
  for (std::size_t k = 0; k < n; ++k) {
    (k < count ? cut.inside : cut.outside).push_back((first + k) % n);
  }
  return cut;
}

/// The group that three joints make, if they do.
std::optional<Cut> cut_of_three(const Loop& loop, std::size_t first) {
  if (!may_be_group(loop, first)) return std::nullopt;
  auto products = pair_products(loop, first, first + 1, &LoopJoint::exact);
  const auto others = pair_products(loop, first + 1, first + 2, &LoopJoint::exact);
  if (vanishing_forms(products).size() != 4 || vanishing_forms(others).size() != 4) {
    return std::nullopt;
  }
  const auto& [before, one, step] = loop.joints[first + 2].exact;
  for (std::size_t k = 0; k < 4; ++k) {
    products[k] = products[k] * before;
    products.push_back(products[k] * step);
  }
  Cut cut = cut_at(loop, first, 3);
  cut.kind = CutKind::three;
  cut.forms = vanishing_forms(products);
  if (cut.forms.size() != 4) return std::nullopt;
  return cut;
}

Cut cut_of_two(const Loop& loop, CutPlace place) {
  const std::size_t n = loop.joints.size();
  std::size_t best = 0, loosest = 0;
  double best_quality = -1, best_independence = -1;
  for (std::size_t k = 0; k < (place == CutPlace::anywhere ? n : n - 1); ++k) {
    const Columns products = unit_columns(pair_products(loop, k, (k + 1) % n, &LoopJoint::rounded));
    const bool has_slide = loop.joints[k].is_slide || loop.joints[(k + 1) % n].is_slide;
    const double here = quality(products) * (has_slide ? kSlidePenalty : 1);
    const double apart = singular_values(products)[3];
    if (here > best_quality) best_quality = here, best = k;
    if (apart > best_independence) best_independence = apart, loosest = k;
  }
  const bool is_plain = best_quality >= kLeastQuality;
  Cut cut = cut_at(loop, is_plain ? best : loosest, 2);
  const auto products = pair_products(loop, cut.inside[0], cut.inside[1], &LoopJoint::exact);
  cut.forms = vanishing_forms(products);
  cut.kind = is_plain ? CutKind::two : CutKind::two_in_quadric;
  if (!is_plain && cut.forms.size() == 4) cut.coordinates = coordinate_forms(products).forms;
  return cut;
}

/// Two slides that leave take the whole product to 0, whatever the others do: such a set is better
/// at infinity.
void choose_chart(const Loop& loop, Cut& cut) {
  constexpr int kChart = 3;
  const auto slides = std::count_if(cut.outside.begin(), cut.outside.end(),
                                    [&](std::size_t joint) { return loop.joints[joint].is_slide; });
  cut.chart = slides == 1 ? kChart : 0;
}

Cut plain_cut(const Loop& loop, CutPlace place) {
  for (std::size_t first = 0; first + 2 < loop.joints.size(); ++first) {
    if (auto cut = cut_of_three(loop, first)) return *cut;
  }
  return cut_of_two(loop, place);
}

}  // namespace

Cut choose_cut(const Loop& loop, CutPlace place) {
  Cut cut = plain_cut(loop, place);
  choose_chart(loop, cut);
  return cut;
}

}  // namespace moivre
