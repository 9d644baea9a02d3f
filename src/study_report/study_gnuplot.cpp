// SPDX-License-Identifier: MIT
// The work-precision diagram as a script for gnuplot 5: data, axes, two panels, one legend.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "gnuplot_axes.h"
#include "moivre/expression/counted.h"
#include "moivre/report/number_text.h"
#include "moivre/study_report/study_report.h"

namespace moivre {
namespace {

// The legend's rows, and where it stands, in thousandths of the picture.
constexpr std::size_t kLegendRows = 3;
constexpr int kLegendLeft = 75;
constexpr int kLegendColumn = 230;
constexpr int kLegendTop = 125;
constexpr int kLegendRow = 42;

struct Mark {
  double cpu_s;
  std::optional<double> error;
  std::uint64_t lost;
};

struct Curve {
  std::string name;
  std::vector<Mark> own;    ///< left panel
  std::vector<Mark> solve;  ///< right panel, filled
  std::vector<Mark> plain;  ///< right panel, hollow
};

std::vector<Curve> curves_of(const StudyResult& result) {
  std::vector<Curve> curves;
  for (const StudyRow& row : result.rows) {
    if (curves.empty() || curves.back().name != row.curve)
      curves.push_back({row.curve, {}, {}, {}});
    Curve& curve = curves.back();
    const auto end = row.walk ? row.walk->end_error : row.own.error;
    curve.own.push_back({row.own.cpu_s.median, end, row.own.lost});
    curve.solve.push_back({row.repaired.cpu_s.median, row.repaired.error, row.repaired.lost});
    if (row.repaired.plain_error) {
      curve.plain.push_back({row.repaired.cpu_s.median, row.repaired.plain_error, 0});
    }
  }
  return curves;
}

double drawn(const std::optional<double>& error) { return drawn_error(error.value_or(kMostDrawn)); }

/// A data block, a line a mark: CPU seconds, error, roots lost.
std::string block(const std::string& name, const std::vector<Mark>& marks) {
  std::string text = "$" + name + " << EOD\n";
  for (const Mark& mark : marks) {
    text += exact_text(mark.cpu_s) + ' ' + exact_text(drawn(mark.error)) + ' ' +
            std::to_string(mark.lost) + '\n';
  }
  return text + "EOD\n";
}

std::vector<Mark> lossy(const std::vector<Mark>& marks) {
  std::vector<Mark> chosen;
  std::copy_if(marks.begin(), marks.end(), std::back_inserter(chosen),
               [](const Mark& mark) { return mark.lost > 0; });
  return chosen;
}

/// The curve as a line, dashed for a variant ("+newton"), and its symbol where no root is lost.
std::string line_plot(const std::string& data, std::size_t k, const Curve& curve) {
  const std::string dashes = curve.name.find('+') == std::string::npos ? "" : " dt 2";
  return "  $" + data + " using 1:2 with lines lw 1.5 lc rgb \"" + curve_colour(k) + "\"" + dashes +
         " notitle, \\\n  $" + data + " using 1:($3 > 0 ? NaN : $2) with points ps 0.7 " +
         curve_style(k) + " notitle";
}

/// Crosses on the marks that lost roots, and their numbers beside them. A block without marks is
/// not to be drawn:
/// gnuplot 5.4 crashes on labels without data.
std::string cross_plots(const std::string& data, std::size_t k) {
  return ", \\\n  $lost_" + data + " using 1:2 with points pt 2 ps 0.9 lw 1.5 lc rgb \"" +
         curve_colour(k) + "\" notitle, \\\n  $lost_" + data +
         " using 1:2:3 with labels offset 0.9,0.5 font \",9\" tc rgb \"" + curve_colour(k) +
         "\" notitle";
}

std::string panel(const std::string& kind, const std::vector<Curve>& curves,
                  std::vector<Mark> Curve::*marks) {
  std::string text = "plot";
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const std::string number = std::to_string(k);
    text += (k == 0 ? " \\\n" : ", \\\n") + line_plot(kind + number, k, curves[k]);
    if (kind == "solve" && !curves[k].plain.empty()) {
      text += ", \\\n  $plain" + number + " using 1:2 with points pt 6 ps 0.9 lc rgb \"" +
              curve_colour(k) + "\" notitle";
    }
    if (!lossy(curves[k].*marks).empty()) text += cross_plots(kind + number, k);
  }
  return text + '\n';
}

/// Every block that the panels draw, and how far the axes have to reach.
struct DiagramData {
  std::string blocks;
  DiagramRange time;
  DiagramRange end;
  DiagramRange delivered;
};

DiagramData data_of(const std::vector<Curve>& curves) {
  DiagramData data;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Curve& curve = curves[k];
    const std::string number = std::to_string(k);
    data.blocks += block("own" + number, curve.own) + block("lost_own" + number, lossy(curve.own)) +
                   block("solve" + number, curve.solve) +
                   block("lost_solve" + number, lossy(curve.solve)) +
                   block("plain" + number, curve.plain);
    for (const Mark& mark : curve.own) data.end.take(drawn(mark.error));
    for (const Mark& mark : curve.solve) data.delivered.take(drawn(mark.error));
    for (const Mark& mark : curve.plain) data.delivered.take(drawn(mark.error));
    for (const auto& marks : {curve.own, curve.solve}) {
      for (const Mark& mark : marks) data.time.take(mark.cpu_s);
    }
  }
  return data;
}

/// Under both panels, column by column: gnuplot's own key cannot stand there in columns.
std::string legend(const std::vector<Curve>& curves) {
  struct Entry {
    std::string text;
    std::string point;
  };
  std::vector<Entry> entries;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    entries.push_back({curves[k].name, "ps 0.8 " + curve_style(k)});
  }
  entries.push_back({"roots are lost, so many", "pt 2 ps 1.4 lw 2 lc rgb \"#555555\""});
  entries.push_back({"residuals in plain double", "pt 6 ps 0.9 lc rgb \"#555555\""});
  std::string text;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const int x = kLegendLeft + kLegendColumn * static_cast<int>(k / kLegendRows);
    const int y = kLegendTop - kLegendRow * static_cast<int>(k % kLegendRows);
    text += "set label \"" + entries[k].text + "\" at screen " + exact_text(x / 1000.0) + "," +
            exact_text(y / 1000.0) + " left offset 1.5,0 noenhanced point " + entries[k].point +
            '\n';
  }
  return text;
}

std::string own_title(const StudyResult& result) {
  const bool walked = std::any_of(result.rows.begin(), result.rows.end(),
                                  [](const StudyRow& row) { return row.walk.has_value(); });
  return walked ? "as the tracker leaves its paths, nothing repaired" : "nothing repaired";
}

std::string remark(const StudyReference& reference) {
  return reference.exact > 0 ? "" : "; errors not known, since no root is simple: drawn as 1";
}

std::string settings_gnuplot(const StudiedFile& study) {
  const std::vector<Curve> curves = curves_of(study.result);
  const DiagramData data = data_of(curves);
  return gnuplot_head(study.name) + data.blocks + gnuplot_terminal(study.name, 1180, 700) +
         "set multiplot title \"" + study.name + ": " +
         counted(study.result.reference.roots, "root") + ", " +
         counted(study.result.paths, "path") + remark(study.result.reference) +
         "\" noenhanced\n"
         "set tmargin at screen 0.88\nset bmargin at screen 0.25\n"
         "set xrange " +
         data.time.text(0) +
         "\n"
         "set lmargin at screen 0.075\nset rmargin at screen 0.475\n"
         "set title \"" +
         own_title(study.result) +
         "\"\n"
         "set xlabel \"CPU time of all paths [s]\"\n"
         "set ylabel \"largest relative error of a root\"\n"
         "set yrange " +
         data.end.text(1) +
         "\n"
         "unset key\nunset mytics\n" +
         legend(curves) + panel("own", curves, &Curve::own) +
         "unset label\n"
         "set lmargin at screen 0.575\nset rmargin at screen 0.975\n"
         "set title \"as solve delivers them\"\n"
         "set xlabel \"CPU time of solve with repairs [s]\"\n"
         "set yrange " +
         data.delivered.text(1) + "\n" + panel("solve", curves, &Curve::solve) +
         "unset multiplot\n";
}

}  // namespace

std::vector<StudyDiagram> study_diagrams(const StudiedFile& study) {
  std::vector<StudyDiagram> diagrams;
  if (!study.result.rows.empty() && study.result.reference.roots > 0)
    diagrams.push_back({study.name, settings_gnuplot(study), ""});
  for (const StudyTable& table : study.result.tables) {
    if (!is_drawn(table)) continue;
    const std::string name = study.name + "-motion";
    diagrams.push_back({name, table_gnuplot(name, table), ""});
  }
  return diagrams;
}

}  // namespace moivre
