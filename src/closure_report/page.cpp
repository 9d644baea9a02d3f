// SPDX-License-Identifier: MIT
// The page: markup with the first poses drawn, and the data that its script drives them with.
//
// Data, as JSON: {"from", "to": seconds; "times": [..], "drivers": [{"name", "unit", "values": [a
// time]}], "quantities": [{"name", "units": [of value, velocity, acceleration]}] (of value alone
// where that is all), "branches": [{"t": [..], "frames": [[a b e f ...] a time], "series":
// [[values, velocities, accelerations] a quantity], "begins", "ends": sentences, "colour": class,
// "dashes"}]}; a frame puts (x, y) at (a x - b y + e, b x + a y + f), in pixels.
#include "moivre/closure_report/page.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include "circuits_report.h"
#include "joint_values.h"
#include "labels.h"
#include "moivre/closure_report/angles.h"
#include "moivre/closure_report/document.h"
#include "moivre/closure_report/sheet.h"
#include "moivre/expression/counted.h"
#include "moivre/mechanism/pose.h"
#include "moivre/report/json.h"
#include "moivre/report/markup.h"
#include "moivre/report/number_text.h"
#include "page_assets.h"
#include "page_columns.h"
#include "panels.h"
#include "pose_text.h"
#include "svg.h"
#include "traces.h"

namespace moivre {
namespace {

/// What can be plotted: a coordinate, or one coordinate of a point.
struct PlottedQuantity {
  std::string name;
  std::optional<Eigen::Index> coordinate;
  bool is_angle = false;
  PointOf point;
  int axis = 0;
};

/// A panel's branch: poses by time; one pose where it stands still.
struct PageBranch {
  std::string id;
  std::vector<TracedPose> poses;
  std::string begins;
  std::string ends;
  BranchLook look;
};

struct Page {
  std::string title;
  std::string summary;
  double from = 0;
  double to = 0;
  std::vector<double> times;
  std::vector<PageBranch> branches;
  std::vector<std::string> notes;
  PageColumns columns;
};

std::vector<PlottedQuantity> quantities(const Mechanism& mechanism) {
  std::vector<PlottedQuantity> all;
  const std::vector<Coordinate> names = coordinates(mechanism);
  const auto add_points = [&](bool is_jointed) {
    for (const MovingPoint& moving : moving_points(mechanism)) {
      if (moving.is_jointed != is_jointed) continue;
      const int axes = mechanism.space == Space::spatial ? 3 : 2;
      for (int axis = 0; axis < axes; ++axis) {
        all.push_back({moving.name + " " + "xyz"[axis], std::nullopt, false, moving.point, axis});
      }
    }
  };
  if (!is_typed(mechanism)) add_points(false);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool is_angle = names[k].kind == CoordinateKind::angle;
    if (!is_typed(mechanism) && !is_angle) continue;
    all.push_back({names[k].name, static_cast<Eigen::Index>(k), is_angle, {}, 0});
  }
  if (!is_typed(mechanism)) add_points(true);
  return all;
}

/// Pixels to a thousandth, turns to a hundred-thousandth.
Json at_grid(double x, double grid) { return std::round(x * grid) / grid; }

/// Value, velocity and acceleration, in the file's unit of angle; null where an event has none.
std::array<Json, 3> states(const PlottedQuantity& quantity, const TracedPose& pose,
                           const Mechanism& mechanism) {
  const bool in_degrees = quantity.is_angle && mechanism.units.angle == "deg";
  const double unit = in_degrees ? 180 / std::numbers::pi : 1;
  if (quantity.coordinate) {
    const Eigen::Index k = *quantity.coordinate;
    const Json value = rounded(unit * pose.q[k]);
    if (pose.sample == nullptr || !pose.sample->is_determined) return {value, nullptr, nullptr};
    const BranchSample& sample = *pose.sample;
    return {value, rounded(unit * sample.velocity[k]), rounded(unit * sample.acceleration[k])};
  }
  if (pose.sample == nullptr || !pose.sample->is_determined) {
    return {rounded(point_position(mechanism, quantity.point, pose.q)[quantity.axis]), nullptr,
            nullptr};
  }
  const PointState state = point_state(mechanism, quantity.point, pose.sample->q,
                                       pose.sample->velocity, pose.sample->acceleration);
  return {rounded(state.position[quantity.axis]), rounded(state.velocity[quantity.axis]),
          rounded(state.acceleration[quantity.axis])};
}

Json series_json(const PageBranch& branch, const PlottedQuantity& quantity,
                 const Mechanism& mechanism) {
  std::array<Json, 3> columns{Json::array(), Json::array(), Json::array()};
  for (const TracedPose& pose : branch.poses) {
    std::array<Json, 3> values = states(quantity, pose, mechanism);
    for (std::size_t k = 0; k < 3; ++k) columns[k].push_back(std::move(values[k]));
  }
  return columns;
}

std::string unit_of(const PlottedQuantity& quantity, const Mechanism& mechanism) {
  return quantity.is_angle ? mechanism.units.angle : mechanism.units.length;
}

/// "mm", "mm/s", "mm/s^2"; "1/s" where the unit has no name.
Json units_json(const std::string& unit) {
  const std::string over = unit.empty() ? "1" : unit;
  return Json::array({unit, over + "/s", over + "/s\u00b2"});
}

Json drivers_json(const Page& page, const Mechanism& mechanism) {
  Json drivers = Json::array();
  for (const Driver& driver : mechanism.drivers) {
    const bool is_angle = kind_of(mechanism, driver) == CoordinateKind::angle;
    const bool in_degrees = is_angle && mechanism.units.angle == "deg";
    Json values = Json::array();
    for (const double t : page.times) {
      const double value = driver_state(driver.law, t).value;
      values.push_back(rounded(in_degrees ? value * 180 / std::numbers::pi : value));
    }
    drivers.push_back({{"name", label_of(driver)},
                       {"unit", is_angle ? mechanism.units.angle : mechanism.units.length},
                       {"values", values}});
  }
  return drivers;
}

/// Figures in pixels of their own frames; `map` without its origin puts them there.
struct Canvas {
  Drawing drawing;
  PixelMap map;
  PixelMap own;  ///< of a figure in its frame
  double width = 0;
  double height = 0;

  std::array<double, 4> matrix(const Similarity& at) const {
    const Complex place = map(at.b);
    return {at.a.real(), -at.a.imag(), place.real(), place.imag()};
  }
};

Canvas make_canvas(const Page& page, const Mechanism& mechanism) {
  std::vector<Eigen::VectorXd> poses;
  for (const PageBranch& branch : page.branches) {
    for (const TracedPose& pose : branch.poses) poses.push_back(pose.q);
  }
  Canvas canvas;
  canvas.drawing = draw(mechanism, poses);
  Box box;
  for (const Eigen::VectorXd& q : poses) {
    const Box one = bounds(canvas.drawing, place(canvas.drawing, mechanism, q));
    box.include(one.lower);
    box.include(one.upper);
  }
  constexpr double kBorder = 28;
  canvas.map.scale = canvas.own.scale = pixel_scale(canvas.drawing);
  canvas.map.origin = Complex(kBorder, kBorder) -
                      std::conj(Complex(box.lower.real(), box.upper.imag())) * canvas.map.scale;
  canvas.width = box.width() * canvas.map.scale + 2 * kBorder;
  canvas.height = box.height() * canvas.map.scale + 2 * kBorder;
  return canvas;
}

Json branch_json(const PageBranch& branch, const Canvas& canvas,
                 const std::vector<PlottedQuantity>& plotted, const Mechanism& mechanism) {
  Json t = Json::array();
  Json frames = Json::array();
  for (const TracedPose& pose : branch.poses) {
    t.push_back(pose.time);
    Json row = Json::array();
    for (const Similarity& at : place(canvas.drawing, mechanism, pose.q)) {
      const std::array<double, 4> m = canvas.matrix(at);
      for (std::size_t k = 0; k < 4; ++k) row.push_back(at_grid(m[k], k < 2 ? 1e5 : 1e3));
    }
    frames.push_back(std::move(row));
  }
  Json series = Json::array();
  for (const PlottedQuantity& quantity : plotted) {
    series.push_back(series_json(branch, quantity, mechanism));
  }
  return {{"t", t},
          {"frames", frames},
          {"series", series},
          {"begins", branch.begins},
          {"ends", branch.ends},
          {"colour", colour_class(branch.look.colour)},
          {"dashes", branch.look.dashes}};
}

void add_columns(const PageColumns& columns, const std::string& id, Json& branch) {
  branch["id"] = id;
  for (std::size_t k = 0; k < columns.ids.size(); ++k) {
    if (columns.ids[k] != id) continue;
    for (const Json& series : columns.series[k]) branch["series"].push_back(series);
  }
}

std::string matrix_text(const std::array<double, 4>& m) {
  std::string text = "matrix(";
  for (const double x : {m[0], m[1], -m[1], m[0], m[2]}) text += exact_text(x) + ' ';
  return text + exact_text(m[3]) + ')';
}

/// A label keeps the place beside its anchor that it has in the branch's first pose; a body's turns
/// with the body.
std::string label_html(const PlacedLabel& placed, const Canvas& canvas,
                       const std::vector<Similarity>& places,
                       const std::vector<PlottedQuantity>& plotted) {
  const Label& label = *placed.label;
  const Complex anchor = canvas.map(places[label.frame](label.at));
  const Complex own = canvas.own(label.at);
  const bool turns = label.kind == LabelKind::body;
  const Complex turned = std::conj(places[label.frame].a);
  const Complex aside = placed.at - placed.baseline - anchor;
  const Complex kept = turns ? aside * std::abs(turned) / turned : aside;
  Json follow{{"frame", label.frame},
              {"x", at_grid(own.real(), 1e3)},
              {"y", at_grid(own.imag(), 1e3)},
              {"dx", at_grid(kept.real(), 1e2)},
              {"dy", at_grid(kept.imag(), 1e2)},
              {"base", at_grid(placed.baseline.imag(), 1e2)},
              {"turns", turns}};
  for (std::size_t k = 0; label.coordinate && k < plotted.size(); ++k) {
    if (plotted[k].coordinate == label.coordinate) follow["series"] = k;
  }
  std::string classes = "label ";
  if (label.kind == LabelKind::body) classes += "body ";
  return element("text",
                 {{"class", classes + colour_class(label.colour)},
                  {"text-anchor", "middle"},
                  {"x", pixel_text(placed.at.real())},
                  {"y", pixel_text(placed.at.imag())},
                  {"data-label", follow.dump()}},
                 escaped(placed.text));
}

std::string panel_html(const PageBranch& branch, std::size_t number, const Canvas& canvas,
                       const std::vector<PlottedQuantity>& plotted, const Mechanism& mechanism) {
  const Eigen::VectorXd& q = branch.poses.front().q;
  const std::vector<Similarity> places = place(canvas.drawing, mechanism, q);
  std::string svg;
  for (const Figure& figure : canvas.drawing.figures) {
    svg += element("g",
                   {{"data-frame", std::to_string(figure.frame)},
                    {"transform", matrix_text(canvas.matrix(places[figure.frame]))}},
                   figure_svg(figure, {}, canvas.own)) +
           '\n';
  }
  Box frame;
  frame.include(0);
  frame.include({canvas.width, canvas.height});
  for (const PlacedLabel& label :
       place_labels(canvas.drawing, mechanism, q, places, canvas.map, frame)) {
    svg += label_html(label, canvas, places, plotted) + '\n';
  }
  std::string view = "0 0 ";
  view += pixel_text(canvas.width) + ' ' + pixel_text(canvas.height);
  const std::string caption =
      element("b", {{"style", std::string("color:").append(colour_text(branch.look.colour))}},
              escaped(branch.id)) +
      (branch.look.circuit.empty() ? "" : element("small", {}, branch.look.circuit)) +
      element("span", {}, " ");
  return element("figure", {{"id", std::string("panel-").append(std::to_string(number))}},
                 element("figcaption", {}, caption) +
                     element("svg", {{"viewBox", view}, {"role", "img"}}, svg)) +
         '\n';
}

std::string list_html(const std::vector<std::string>& notes) {
  std::string items;
  for (const std::string& note : notes) items += element("li", {}, escaped(note)) + '\n';
  return items.empty() ? items : element("ul", {}, items);
}

std::string drive_html() {
  return element("div", {{"id", "drive"}},
                 element("button", {{"id", "play"}, {"type", "button"}}, "Play") +
                     element("input", {{"id", "time"},
                                       {"type", "range"},
                                       {"min", "0"},
                                       {"max", "1"},
                                       {"step", "0.001"},
                                       {"value", "0"},
                                       {"aria-label", "time"}}) +
                     element("output", {{"id", "readout"}}, " ")) +
         '\n';
}

/// `quantities`: as the page's data has them.
std::string plots_html(const Page& page, const Json& quantities) {
  std::string options;
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    options += element("option", {{"value", std::to_string(k)}},
                       escaped(quantities[k]["name"].get<std::string>()));
  }
  std::string legend;
  for (std::size_t k = 0; k < page.branches.size(); ++k) {
    const BranchLook& look = page.branches[k].look;
    const std::string line = look.dashes.empty() ? "solid" : "dashed";
    const std::string style =
        "border-top-color:" + colour_text(look.colour) + ";border-top-style:" + line;
    const std::string circuit = look.circuit.empty() ? "" : ", " + look.circuit;
    legend +=
        element("button", {{"type", "button"}, {"data-branch", std::to_string(k)}},
                element("i", {{"style", style}}, " ") + escaped(page.branches[k].id + circuit)) +
        '\n';
  }
  std::string plots;
  for (const char* kind : {"position", "velocity", "acceleration"}) {
    plots +=
        element("div", {{"class", "plot"}, {"id", std::string("plot-").append(kind)}}, " ") + '\n';
  }
  return element("h2", {}, "Plots") +
         element("select", {{"id", "quantity"}, {"aria-label", "quantity"}}, options) + '\n' +
         element("button", {{"id", "save"}, {"type", "button"}}, "Save all as CSV") + '\n' +
         element("button", {{"id", "animate"}, {"type", "button"}}, "Save as animated SVG") + '\n' +
         element("div", {{"id", "legend"}}, legend) + element("div", {{"id", "plots"}}, plots);
}

std::string page_html(const Page& page, const Mechanism& mechanism) {
  const bool moves = page.to > page.from && !page.branches.empty();
  const std::vector<PlottedQuantity> plotted = quantities(mechanism);
  std::string body = element("h1", {}, escaped(page.title)) + '\n' +
                     element("p", {}, escaped(page.summary)) + '\n';
  body += element("noscript", {}, "The first poses; a browser that runs scripts can move them.");
  body += element("p", {{"id", "error"}}, " ") + '\n';
  if (moves) body += drive_html();
  Json data{{"from", page.from}, {"to", page.to}, {"times", page.times}};
  data["drivers"] = drivers_json(page, mechanism);
  data["quantities"] = list_json(plotted, [&](const PlottedQuantity& quantity) {
    return Json{{"name", quantity.name}, {"units", units_json(unit_of(quantity, mechanism))}};
  });
  for (const Json& quantity : page.columns.quantities) data["quantities"].push_back(quantity);
  data["branches"] = Json::array();
  if (!page.branches.empty()) {
    const Canvas canvas = make_canvas(page, mechanism);
    // Few panels are shown large.
    const std::size_t count = page.branches.size();
    const std::string crowd = count <= 2 ? "few" : count <= 4 ? "some" : "many";
    std::string panels;
    for (std::size_t k = 0; k < page.branches.size(); ++k) {
      panels += panel_html(page.branches[k], k, canvas, plotted, mechanism);
      Json branch = branch_json(page.branches[k], canvas, plotted, mechanism);
      add_columns(page.columns, page.branches[k].id, branch);
      data["branches"].push_back(std::move(branch));
    }
    body += element("div", {{"id", "panels"}, {"class", crowd}}, panels) + '\n';
  }
  if (moves) body += plots_html(page, data["quantities"]);
  body += list_html(page.notes);
  body += element("script", {{"type", "application/json"}, {"id", "data"}}, script_data(data));
  return html_document(page.title, std::move(body), page_script());
}

std::string sentence(const MotionBranch& branch, const MotionResult& result,
                     const Mechanism& mechanism, bool is_end) {
  const std::optional<std::size_t>& event = is_end ? branch.end_event : branch.begin_event;
  const double time = is_end ? branch.ends : branch.begins;
  std::string text = is_end ? "ended at t = " : "begins at t = ";
  text += short_text(time) + " s";
  const std::string drivers = drivers_text(mechanism, time);
  if (!drivers.empty()) text.append(" (").append(drivers).append(1, ')');
  return event ? text + ": " + to_string(result.events[*event].at.kind) : text;
}

/// The joints' angles and slides in three digits, for those who compare closures; empty where there
/// are too many to read.
std::string values_text(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  constexpr std::size_t kMost = 8;
  constexpr double kDegree = std::numbers::pi / 180;
  const std::vector<JointValue> values = joint_values(mechanism, q);
  if (values.size() > kMost) return "";
  const bool in_degrees = mechanism.units.angle == "deg";
  std::string text;
  for (const JointValue& joint : values) {
    const bool turns = joint.kind == CoordinateKind::angle;
    text += (text.empty() ? "" : ", ") + joint.name + " " +
            short_text(turns && in_degrees ? joint.value / kDegree : joint.value, 3);
  }
  return text;
}

}  // namespace

std::string motion_html(const MotionResult& result, const Mechanism& mechanism,
                        const std::string& file, const Readings* readings) {
  Page page;
  if (readings != nullptr) page.columns = page_columns(*readings, result, mechanism);
  page.title = picture_title(mechanism, file);
  page.summary = counted(result.branches.size(), "branch", "branches") +
                 " from t = " + short_text(result.from) + " s to " + short_text(result.to) + " s";
  if (!result.checkpoints.empty()) {
    page.summary += "; at first " + counts_text(result.checkpoints.front().counts) +
                    fitted_text(result.checkpoints.front().counts);
  }
  page.summary += "; " + result.message;
  page.from = result.from;
  page.to = result.to;
  page.times = result.times;
  const std::vector<BranchLook> looks = branch_looks(find_circuits(mechanism, result), result);
  for (std::size_t k = 0; k < result.branches.size(); ++k) {
    const MotionBranch& branch = result.branches[k];
    const std::vector<TracedPose> poses = traced_poses(mechanism, branch, result);
    if (poses.empty()) continue;
    page.branches.push_back({branch.id, poses, sentence(branch, result, mechanism, false),
                             sentence(branch, result, mechanism, true), looks[k]});
    if (branch.begin_event) {
      page.notes.push_back(branch.id + " " + page.branches.back().begins);
    }
    if (branch.end_event) page.notes.push_back(branch.id + " " + page.branches.back().ends);
  }
  for (const std::string& failure : result.failures) page.notes.push_back(failure);
  return page_html(page, mechanism);
}

std::string closures_html(const ClosureResult& result, const Mechanism& mechanism,
                          const std::string& file) {
  const std::string summary =
      counts_text(result.counts) + fitted_text(result.counts) + "; " + result.message;
  if (mechanism.space == Space::spatial) {
    Sheet sheet{picture_title(mechanism, file), summary, {}};
    sheet.view.has_arrows = true;
    for (const Closure& closure : result.closures) {
      sheet.panels.push_back({closure.id, closure.q});
      const std::string values = values_text(mechanism, closure.q);
      if (!values.empty()) sheet.panels.back().notes.push_back(values);
    }
    return turning_html(sheet, mechanism);
  }
  Page page;
  page.title = picture_title(mechanism, file);
  page.summary = summary;
  page.from = page.to = result.time;
  for (const Closure& closure : result.closures) {
    const std::size_t colour = page.branches.size();
    page.branches.push_back({closure.id,
                             {{result.time, closure.q, nullptr}},
                             "",
                             "",
                             {colour, dashes_text(colour), ""}});
  }
  return page_html(page, mechanism);
}

}  // namespace moivre
