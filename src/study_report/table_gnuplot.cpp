// SPDX-License-Identifier: MIT
// The diagram of a study's table, a mechanism's motion: errors over CPU time, a curve a column.
#include <cmath>

#include "gnuplot_axes.h"
#include "moivre/report/number_text.h"
#include "study_cells.h"

namespace moivre {
namespace {

const std::string kError = "_error";
const std::string kTime = "cpu_s";

struct Column {
  std::string name;  ///< "velocity"
  std::size_t at;
};

std::vector<Column> error_columns(const StudyTable& table) {
  std::vector<Column> columns;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const std::string& name = table.columns[k];
    if (name.ends_with(kError)) {
      columns.push_back({name.substr(0, name.size() - kError.size()), k});
    }
  }
  return columns;
}

std::size_t time_column(const StudyTable& table) {
  return static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), kTime) -
                                  table.columns.begin());
}

}  // namespace

bool is_drawn(const StudyTable& table) {
  return !table.rows.empty() && time_column(table) < table.columns.size() &&
         !error_columns(table).empty();
}

std::string table_gnuplot(const std::string& name, const StudyTable& table) {
  const std::vector<Column> columns = error_columns(table);
  const std::size_t time = time_column(table);
  DiagramRange times;
  DiagramRange errors;
  std::string blocks;
  std::string plot = "plot";
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::string block = "error" + std::to_string(k);
    blocks += "$" + block + " << EOD\n";
    for (const std::vector<double>& row : table.rows) {
      const double error = drawn_error(row[columns[k].at]);
      times.take(row[time]);
      errors.take(error);
      blocks += exact_text(row[time]) + ' ' + exact_text(error) + ' ' + exact_text(row[0]) + '\n';
    }
    blocks += "EOD\n";
    const std::string style = curve_style(k);
    plot += std::string(k == 0 ? "" : ",") + " \\\n  $" + block +
            " using 1:2 with linespoints lw 1.5 ps 0.7 " + style + " title \"" + columns[k].name +
            "\"";
  }
  // How many samples: said once, above the last curve.
  plot += ", \\\n  $error" + std::to_string(columns.size() - 1) +
          " using 1:2:3 with labels offset 0,0.9 font \",10\" tc rgb \"#555555\" notitle\n";
  return gnuplot_head(name) + blocks + gnuplot_terminal(name, 760, 560) + "set title \"" + name +
         ": " + table.title + "\" noenhanced\n" +
         "set xlabel \"CPU time of the motion [s]; numbers: samples\"\n"
         "set ylabel \"largest relative error\"\n"
         "set xrange " +
         times.text(0) + "\nset yrange " + errors.text(1) +
         "\nset bmargin at screen 0.22\nset key at screen 0.55,0.04 center bottom "
         "horizontal\nunset mytics\n" +
         plot;
}

}  // namespace moivre
