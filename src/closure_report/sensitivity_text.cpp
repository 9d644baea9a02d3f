// SPDX-License-Identifier: MIT
// For each closure: the dimensions that move its points, angles and slides most, and their spreads.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "moivre/closure_report/sensitivity_report.h"
#include "moivre/expression/counted.h"
#include "moivre/report/number_text.h"
#include "traces.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// As many as a designer can act on at once; the table has all.
constexpr std::size_t kShown = 5;
constexpr std::size_t kListed = 8;

using TableRow = std::vector<std::string>;

// Of the largest number of its kind; less is rounding.
constexpr double kSensitivityNoise = 1e-11;

/// Four digits; rounding noise relative to `size` is 0.
std::string rate_text(double x, double size) {
  if (std::isnan(x)) return "-";
  if (std::abs(x) <= kSensitivityNoise * size) return "0";
  return short_text(x);
}

/// Columns as wide as their widest cell; the `numbers` behind the first are right-aligned. A row of
/// one cell is a line of words.
std::string aligned(const std::vector<TableRow>& rows, std::size_t numbers) {
  std::vector<std::size_t> width;
  for (const TableRow& row : rows) {
    width.resize(std::max(width.size(), row.size()));
    if (row.size() == 1) continue;
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
  }
  std::string text;
  for (const TableRow& row : rows) {
    if (row.size() == 1) {
      text += "  " + row[0] + '\n';
      continue;
    }
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string gap(width[k] - row[k].size(), ' ');
      line += "  " + (k > 0 && k <= numbers ? gap + row[k] : row[k] + gap);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

/// What the tables of one closure are made from.
class Tables {
 public:
  Tables(const Sensitivities& told, const ClosureSensitivity& closure, const Mechanism& mechanism)
      : told_(told), closure_(closure), mechanism_(mechanism) {
    for (std::size_t i = 0; i < told.quantities.size(); ++i) {
      const bool is_length = told.quantities[i].kind == CoordinateKind::length;
      const MatrixXd rates = closure.rates.row(static_cast<Index>(i));
      double& noise = is_length ? length_noise_ : angle_noise_;
      for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
        noise = std::max(noise, kSensitivityNoise * weight(rates, k));
      }
    }
  }

  std::string of_point(const MovingPoint& point) const {
    const auto is_here = [&](const SensitiveQuantity& quantity) {
      return quantity.group == SensitiveGroup::point && quantity.point.body == point.point.body &&
             quantity.point.point == point.point.point;
    };
    const auto begin = std::find_if(told_.quantities.begin(), told_.quantities.end(), is_here);
    const auto first = static_cast<Index>(begin - told_.quantities.begin());
    const Index axes = mechanism_.space == Space::planar ? 2 : 3;
    const MatrixXd rates = closure_.rates.middleRows(first, axes);
    const std::vector<std::size_t> order = ranked(rates);
    constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
    std::vector<TableRow> rows{{point.name}};
    rows.front().insert(rows.front().end(), kAxes.begin(), kAxes.begin() + axes);
    for (std::size_t k = 0; k < std::min(kShown, order.size()); ++k) {
      const std::size_t dimension = order[k];
      const auto column = rates.col(static_cast<Index>(dimension));
      TableRow row{"  " + told_.dimensions[dimension].name};
      for (Index axis = 0; axis < axes; ++axis) {
        row.push_back(rate_text(column[axis] * unit(dimension), column.norm() * unit(dimension)));
      }
      if (told_.has_tolerances()) {
        const double tolerance = told_.tolerances[dimension] / unit(dimension);
        row.push_back("tolerance " + with_unit(rate_text(tolerance, tolerance),
                                               told_.dimensions[dimension].is_angle));
      }
      rows.push_back(std::move(row));
    }
    if (order.size() > kShown) rows.push_back({"  " + rest_text(rates, order)});
    if (told_.has_tolerances()) add_spreads(first, axes, rows);
    return aligned(rows, static_cast<std::size_t>(axes));
  }

  /// What a designer reads off as output: the bodies' angles (in space the joints'), and the
  /// slides.
  std::string of_angles_and_slides() const {
    std::vector<TableRow> rows{{"angles and slides", "most", "by"}};
    if (told_.has_tolerances()) {
      rows.front().insert(rows.front().end(), {"worst case", "root sum square"});
    }
    for (std::size_t i = 0; i < told_.quantities.size(); ++i) {
      const SensitiveQuantity& quantity = told_.quantities[i];
      const bool is_angle = quantity.kind == CoordinateKind::angle;
      const bool is_of_body = is_angle && mechanism_.space == Space::planar;
      const auto group = is_of_body ? SensitiveGroup::coordinate : SensitiveGroup::joint;
      if (quantity.group != group) continue;
      const MatrixXd rates = closure_.rates.row(static_cast<Index>(i));
      const std::vector<std::size_t> order = ranked(rates);
      const double noise = is_angle ? angle_noise_ : length_noise_;
      if (order.empty() || weight(rates, order[0]) <= noise) continue;
      const double one = is_angle && mechanism_.units.angle == "deg" ? std::numbers::pi / 180 : 1;
      const double most = rates(0, static_cast<Index>(order[0])) * unit(order[0]) / one;
      TableRow row{"  " + quantity.name, with_unit(rate_text(most, most), is_angle),
                   told_.dimensions[order[0]].name};
      for (const Eigen::VectorXd* spread : {&closure_.worst_case, &closure_.root_sum_square}) {
        if (!told_.has_tolerances()) break;
        const double value = (*spread)[static_cast<Index>(i)] / one;
        row.push_back(std::isnan(value) ? "none" : with_unit(rate_text(value, value), is_angle));
      }
      rows.push_back(std::move(row));
    }
    return rows.size() == 1 ? "" : aligned(rows, 0);
  }

 private:
  std::string rest_text(const MatrixXd& rates, const std::vector<std::size_t>& order) const {
    const std::size_t left = order.size() - kShown;
    const double most = weight(rates, order[kShown]);
    return "and " + counted(left, "dimension") + " that " + (left == 1 ? "moves" : "move") +
           " it by " + with_unit(rate_text(most, most), false) + " or less";
  }

  /// One unit of the dimension in the file, in radians or lengths.
  double unit(std::size_t dimension) const {
    const bool in_degrees = told_.dimensions[dimension].is_angle && mechanism_.units.angle == "deg";
    return in_degrees ? std::numbers::pi / 180 : 1;
  }

  std::string with_unit(const std::string& number, bool is_angle) const {
    const std::string& unit = is_angle ? mechanism_.units.angle : mechanism_.units.length;
    return unit.empty() ? number : number + " " + unit;
  }

  /// Dimensions that move the point, most first; those that move it equally in the file's order.
  std::vector<std::size_t> ranked(const MatrixXd& rates) const {
    // Rates that are equal but for rounding, as those of both ends of a link are, stand in one
    // order everywhere.
    constexpr double kEqual = 1e-9;
    std::vector<std::size_t> order;
    double largest = 0;
    for (std::size_t k = 0; k < told_.dimensions.size(); ++k) {
      largest = std::max(largest, weight(rates, k));
    }
    for (std::size_t k = 0; k < told_.dimensions.size(); ++k) {
      if (weight(rates, k) > kEqual * largest) order.push_back(k);
    }
    const auto step = [&](std::size_t k) {
      return std::round(weight(rates, k) / (kEqual * largest));
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return step(a) > step(b); });
    return order;
  }

  /// How far the point moves: by its tolerance where there are any, else by one unit of the file.
  double weight(const MatrixXd& rates, std::size_t k) const {
    const double change = told_.has_tolerances() ? told_.tolerances[k] : unit(k);
    const double moved = rates.col(static_cast<Index>(k)).norm() * change;
    return std::isnan(moved) ? 0 : moved;
  }

  void add_spreads(Index first, Index axes, std::vector<TableRow>& rows) const {
    const auto add = [&](const char* name, const Eigen::VectorXd& spread) {
      TableRow row{std::string("  ") + name};
      for (Index axis = 0; axis < axes; ++axis) {
        const double value = spread[first + axis];
        row.push_back(std::isnan(value) ? "none" : rate_text(value, value));
      }
      row.push_back(mechanism_.units.length);
      rows.push_back(std::move(row));
    };
    add("worst case, up or down", closure_.worst_case);
    add("root sum square", closure_.root_sum_square);
  }

  const Sensitivities& told_;
  const ClosureSensitivity& closure_;
  const Mechanism& mechanism_;
  double length_noise_ = 0;  ///< what moves by no more stands, but for rounding
  double angle_noise_ = 0;
};

std::string breaking_text(const Sensitivities& told, const ClosureSensitivity& closure) {
  if (closure.breaking.empty()) return "";
  std::string text = "  cannot change alone, the mechanism would not close: ";
  const std::size_t shown = std::min(kListed, closure.breaking.size());
  for (std::size_t k = 0; k < shown; ++k) {
    text += (k == 0 ? "" : ", ") + told.dimensions[closure.breaking[k]].name;
  }
  if (closure.breaking.size() > shown) {
    text += " and " + std::to_string(closure.breaking.size() - shown) + " more";
  }
  text += '\n';
  const bool has_tolerance = std::any_of(closure.breaking.begin(), closure.breaking.end(),
                                         [&](std::size_t k) { return told.tolerances[k] > 0; });
  if (has_tolerance) {
    text +=
        "  so worst case and root sum square are not known; a tolerance of 0 leaves such a "
        "dimension out\n";
  }
  return text;
}

std::string corner_text(const Sensitivities& told, const ClosureSensitivity& closure,
                        const std::string& unit) {
  if (!closure.corner) return "";
  constexpr std::array<const char*, 3> kAxes{".x", ".y", ".z"};
  const SensitiveQuantity& quantity = told.quantities[closure.corner->quantity];
  const auto moved = [&](const std::optional<double>& x) {
    return x ? rate_text(*x, *x) + unit : "no closure found";
  };
  return "  solved afresh at the worst of " + quantity.name +
         kAxes[static_cast<std::size_t>(quantity.axis)] + ": up " + moved(closure.corner->up) +
         ", down " + moved(closure.corner->down) + '\n';
}

}  // namespace

std::string sensitivity_text(const Sensitivities& told, const Mechanism& mechanism) {
  const std::string length = mechanism.units.length.empty() ? "" : " " + mechanism.units.length;
  std::string text;
  for (const ClosureSensitivity& closure : told.closures) {
    text += "\nsensitivity of closure " + closure.id;
    if (!closure.missing.empty()) {
      text += ": none; " + closure.missing + '\n';
      continue;
    }
    text += ", by a change of 1" + length + " or 1 " + mechanism.units.angle + '\n' +
            breaking_text(told, closure);
    const Tables tables(told, closure, mechanism);
    for (const MovingPoint& point : traced_points(mechanism)) text += tables.of_point(point);
    text += tables.of_angles_and_slides() + corner_text(told, closure, length);
  }
  return text.empty() ? "\nsensitivity: none, as no closure is isolated\n" : text;
}

}  // namespace moivre
