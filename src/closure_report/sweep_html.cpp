// SPDX-License-Identifier: MIT
// The page of a sweep: its picture, and the closures of one sample beside it.
//
// Data, as JSON: {"plot": [left, top, right, bottom] in pixels; "axes": [{"name", "unit", "values":
// [..]}]; "told": [sentence a sample];
// "closures": [[[x, y, x, y ...] of all points, a closure] a sample]; "bodies": [{"colour": class,
// "points": [..]}];
// "lines": [[class, point, point]]; "spots": [["pin" | "ground" | "mark", point]]; "box": [x, y, x,
// y] around all;
// "ids": [of the closures of any sample]; "unknowns": [name], whose values stand instead of points
// where there are no bodies}. The first axis varies slowest.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assemblies_text.h"
#include "moivre/closure_report/document.h"
#include "moivre/closure_report/drawing.h"
#include "moivre/closure_report/sheet.h"
#include "moivre/closure_report/sweep_report.h"
#include "moivre/expression/counted.h"
#include "moivre/mechanism/closure_id.h"
#include "moivre/mechanism/dimensions.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"
#include "moivre/report/markup.h"
#include "page_assets.h"
#include "plot_frame.h"

namespace moivre {
namespace {

/// Of each varied number, which values are shown: every `step`-th.
struct Shown {
  std::vector<std::vector<std::size_t>> places;
  bool is_thinned = false;
};

Shown shown_of(const SweepResult& result) {
  std::size_t step = 1;
  const auto count = [&] {
    std::size_t all = 1;
    for (const Varied& varied : result.varied) all *= (varied.count - 1) / step + 1;
    return all;
  };
  while (count() > kMostShown) ++step;
  Shown shown;
  shown.is_thinned = step > 1;
  for (const Varied& varied : result.varied) {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < varied.count; k += step) places.push_back(k);
    shown.places.push_back(std::move(places));
  }
  return shown;
}

/// The samples that are shown, the first number slowest.
std::vector<const SweepSample*> samples_of(const SweepResult& result, const Shown& shown) {
  std::vector<const SweepSample*> samples;
  for (const std::size_t i : shown.places[0]) {
    if (shown.places.size() == 1) {
      samples.push_back(&result.samples[i]);
      continue;
    }
    for (const std::size_t j : shown.places[1]) {
      samples.push_back(&result.samples[i * result.varied[1].count + j]);
    }
  }
  return samples;
}

/// In the file's units; a name that several dimensions share, as a driver's does, has the unit of
/// all.
std::string unit_of_dimension(const Mechanism& mechanism, const std::string& name) {
  for (const Dimension& dimension : dimensions(mechanism)) {
    if (dimension.name != name) continue;
    return dimension.is_angle ? mechanism.units.angle : mechanism.units.length;
  }
  return "";
}

std::string told(const SweepSample& sample) {
  if (!sample.complete) return "not decided";
  return counted(sample.complex, "complex closure") + ", " + std::to_string(sample.found.real) +
         " real" + beside_text(sample.found);
}

std::vector<PointOf> all_points(const Mechanism& mechanism) {
  std::vector<PointOf> points;
  for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
    for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
      points.push_back({body, k});
    }
  }
  return points;
}

/// Of as many closures as any sample has.
Json ids_json(const std::vector<const SweepSample*>& samples) {
  std::size_t most = 0;
  for (const SweepSample* sample : samples) most = std::max(most, sample->closures.size());
  Json ids = Json::array();
  for (std::size_t k = 0; k < most; ++k) ids.push_back(closure_id(k));
  return ids;
}

/// The place of a point among all_points().
std::size_t number_of(const Mechanism& mechanism, const PointOf& point) {
  std::size_t number = point.point;
  for (std::size_t body = 0; body < point.body; ++body) {
    number += mechanism.bodies[body].points.size();
  }
  return number;
}

Json bodies_json(const Mechanism& mechanism) {
  Json bodies = Json::array();
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    Json points = Json::array();
    for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
      points.push_back(number_of(mechanism, {body, k}));
    }
    bodies.push_back({{"colour", colour_class(body - 1)}, {"points", std::move(points)}});
  }
  return bodies;
}

Json lines_json(const Mechanism& mechanism) {
  Json lines = Json::array();
  for (const Joint& joint : mechanism.joints) {
    const JointPlace place = traits(joint.type).place;
    const bool is_rod = joint.type == JointType::rod || joint.type == JointType::actuator;
    if (!is_rod && place != JointPlace::on_line && place != JointPlace::in_plane) continue;
    lines.push_back({is_rod ? "rod" : "guide", number_of(mechanism, joint.at[0]),
                     number_of(mechanism, joint.at[1])});
  }
  return lines;
}

Json spots_json(const Mechanism& mechanism) {
  enum Kind { mark, pin, ground };  // what holds more is shown
  constexpr std::array kNames{"mark", "pin", "ground"};
  std::vector<Kind> kinds(all_points(mechanism).size(), mark);
  for (const Joint& joint : mechanism.joints) {
    if (is_transmission(joint.type)) continue;
    const bool at_ground = joint.at[0].body == 0 || joint.at[1].body == 0;
    const bool is_pin = traits(joint.type).place == JointPlace::at_point;
    for (const PointOf& point : joint.at) {
      const bool stands = is_pin ? at_ground : point.body == 0;
      Kind& kind = kinds[number_of(mechanism, point)];
      kind = std::max(kind, stands ? ground : pin);
    }
  }
  Json spots = Json::array();
  for (std::size_t k = 0; k < kinds.size(); ++k) spots.push_back({kNames[kinds[k]], k});
  return spots;
}

/// Angles in the file's unit.
Json unknowns_json(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  Json values = Json::array();
  for (std::size_t k = 0; k < mechanism.unknowns.size(); ++k) {
    const bool in_degrees = mechanism.unknowns[k].is_angle && mechanism.units.angle == "deg";
    values.push_back(
        rounded(q[static_cast<Eigen::Index>(k)] * (in_degrees ? 180 / std::numbers::pi : 1)));
  }
  return values;
}

/// Bodies, lines and spots, and where all points are in every closure.
void add_drawings(const Mechanism& mechanism, const SweepResult& result,
                  const std::vector<const SweepSample*>& samples, Json& data) {
  data["bodies"] = bodies_json(mechanism);
  data["lines"] = lines_json(mechanism);
  data["spots"] = spots_json(mechanism);
  const std::vector<PointOf> points = all_points(mechanism);
  Box box;
  for (const SweepSample* sample : samples) {
    Mechanism there = mechanism;
    for (std::size_t j = 0; j < sample->at.size(); ++j) {
      set_dimension(there, result.varied[j].name, sample->at[j]);
    }
    Json closures = Json::array();
    for (const Eigen::VectorXd& q : sample->closures) {
      Json flat = Json::array();
      for (const PointOf& point : points) {
        const Complex z = seen(there, point_position(there, point, q));
        box.include(z);
        flat.push_back(rounded(z.real()));
        flat.push_back(rounded(z.imag()));
      }
      closures.push_back(std::move(flat));
    }
    data["closures"].push_back(std::move(closures));
  }
  if (box.is_empty()) box.include(0, 1);
  data["box"] = {box.lower.real(), box.lower.imag(), box.upper.real(), box.upper.imag()};
}

Json axes_json(const Mechanism& mechanism, const SweepResult& result, const Shown& shown) {
  Json axes = Json::array();
  for (std::size_t j = 0; j < result.varied.size(); ++j) {
    Json values = Json::array();
    for (const std::size_t k : shown.places[j]) values.push_back(result.varied[j].at(k));
    axes.push_back({{"name", result.varied[j].name},
                    {"unit", unit_of_dimension(mechanism, result.varied[j].name)},
                    {"values", std::move(values)}});
  }
  return axes;
}

std::string sliders_html(const SweepResult& result, const Shown& shown) {
  std::string sliders;
  for (std::size_t j = 0; j < result.varied.size(); ++j) {
    const std::string number = std::to_string(j);
    sliders += element("label", {},
                       element("span", {}, escaped(result.varied[j].name)) +
                           element("input", {{"type", "range"},
                                             {"id", "axis-" + number},
                                             {"min", "0"},
                                             {"max", std::to_string(shown.places[j].size() - 1)},
                                             {"step", "1"}}) +
                           element("output", {{"id", "value-" + number}}, " "));
  }
  return sliders;
}

}  // namespace

std::string sweep_html(const SweepResult& result, const Mechanism& mechanism,
                       const std::string& file) {
  const std::string title = picture_title(mechanism, file);
  const Shown shown = shown_of(result);
  const std::vector<const SweepSample*> samples = samples_of(result, shown);
  Json data{{"plot", {kPlotLeft, kPlotTop, kPlotRight, kPlotBottom}},
            {"axes", axes_json(mechanism, result, shown)},
            {"told", Json::array()},
            {"ids", ids_json(samples)},
            {"closures", Json::array()},
            {"bodies", Json::array()},
            {"lines", Json::array()},
            {"spots", Json::array()},
            {"box", {0, 0, 1, 1}},
            {"unknowns", Json::array()}};
  for (const SweepSample* sample : samples) data["told"].push_back(told(*sample));
  if (is_typed(mechanism)) {
    for (const Unknown& unknown : mechanism.unknowns) data["unknowns"].push_back(unknown.name);
    for (const SweepSample* sample : samples) {
      Json closures = Json::array();
      for (const Eigen::VectorXd& q : sample->closures) {
        closures.push_back(unknowns_json(mechanism, q));
      }
      data["closures"].push_back(std::move(closures));
    }
  } else {
    add_drawings(mechanism, result, samples, data);
  }
  std::string hint =
      "Point at the picture, or move a slider: the closures there are drawn beside it.";
  if (shown.is_thinned) {
    hint += " Of " + counted(result.samples.size(), "sample") + " the closures of " +
            std::to_string(samples.size()) + " are in the page.";
  }
  std::string body = element("h1", {}, escaped(title)) + '\n' + element("p", {}, hint) + '\n' +
                     element("noscript", {}, "Closures are drawn by a script.") +
                     element("p", {{"id", "error"}}, " ") + '\n';
  body += element("div", {{"id", "sweep"}},
                  element("div", {{"id", "picture"}}, sweep_svg(result, file)) +
                      element("div", {{"id", "sample"}},
                              sliders_html(result, shown) + element("p", {{"id", "told"}}, " ") +
                                  element("div", {{"id", "closures"}}, " "))) +
          '\n';
  body += element("script", {{"type", "application/json"}, {"id", "data"}}, script_data(data));
  return html_document(title, std::move(body), sweep_page_script(), sweep_page_style());
}

}  // namespace moivre
