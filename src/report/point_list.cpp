// SPDX-License-Identifier: MIT
// Point lists, read line by line: PHCpack's solutions, a table with a head, plain numbers.
#include "moivre/report/point_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "moivre/expression/counted.h"
#include "moivre/expression/words.h"

namespace moivre {
namespace {

struct Line {
  std::size_t number;
  std::size_t offset;
  std::string_view text;
};

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back({lines.size() + 1, begin, text.substr(begin, end - begin)});
    begin = end + 1;
  }
  return lines;
}

/// Words between blanks or commas.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  constexpr std::string_view separators = " \t\r,";
  for (std::size_t begin = text.find_first_not_of(separators); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
  return words;
}

/// Cells between commas; empty ones count.
std::vector<std::string_view> cells_of(std::string_view text) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    cells.push_back(trimmed(text.substr(begin, end - begin)));
    if (end == text.size()) return cells;
    begin = end + 1;
  }
}

class PointReader {
 public:
  PointReader(const Source& source, const std::vector<std::string>& variables)
      : source_(source), variables_(variables) {}

  std::vector<Point> read() {
    std::vector<Line> lines = lines_of(source_.text);
    const auto begins_solution = [](const Line& line) { return is_solution_head(line.text); };
    if (std::any_of(lines.begin(), lines.end(), begins_solution)) {
      read_phc(lines);
    } else {
      drop_comments(lines);
      if (!lines.empty() && lines.front().text.find(".re") != std::string_view::npos) {
        read_table(lines);
      } else {
        read_plain(lines);
      }
    }
    if (points_.empty() && faults_.empty()) fault(Line{1, 0, {}}, "the file lists no point");
    if (!faults_.empty()) throw ParseError(source_, std::move(faults_));
    return std::move(points_);
  }

 private:
  static bool is_solution_head(std::string_view text) {
    const std::string_view line = trimmed(text);
    return line.substr(0, 9) == "solution " && line.find(':') != std::string_view::npos;
  }

  static void drop_comments(std::vector<Line>& lines) {
    for (Line& line : lines) line.text = line.text.substr(0, line.text.find('#'));
    lines.erase(std::remove_if(lines.begin(), lines.end(),
                               [](const Line& line) { return trimmed(line.text).empty(); }),
                lines.end());
  }

  void fault(const Line& line, const std::string& message, std::size_t column = 0) {
    faults_.push_back({{line.offset + column, line.number, column + 1}, message});
  }

  std::size_t place_of(std::string_view name) const {
    const auto found = std::find(variables_.begin(), variables_.end(), name);
    return static_cast<std::size_t>(found - variables_.begin());
  }

  std::string missing(const std::vector<bool>& given) const {
    std::string names;
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (!given[i]) names += (names.empty() ? "" : ", ") + variables_[i];
    }
    return names;
  }

  void read_phc(const std::vector<Line>& lines) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (!is_solution_head(lines[k].text)) continue;
      const Line& head = lines[k];
      Point x(variables_.size());
      std::vector<bool> given(variables_.size());
      while (++k < lines.size() && trimmed(lines[k].text) != "the solution for t :" &&
             !is_solution_head(lines[k].text)) {
      }
      while (++k < lines.size() && trimmed(lines[k].text).substr(0, 2) != "==" &&
             !is_solution_head(lines[k].text)) {
        read_phc_coordinate(lines[k], x, given);
      }
      const std::string names = missing(given);
      if (!names.empty()) fault(head, "the solution does not say " + names);
      points_.push_back(std::move(x));
      if (k < lines.size() && is_solution_head(lines[k].text)) --k;
    }
  }

  void read_phc_coordinate(const Line& line, Point& x, std::vector<bool>& given) {
    const std::size_t colon = line.text.find(':');
    if (colon == std::string_view::npos) return;
    const std::string_view name = trimmed(line.text.substr(0, colon));
    const std::size_t place = place_of(name);
    if (place == variables_.size()) {
      return fault(line, std::string(name) + " is not a variable of the system");
    }
    const auto words = words_of(line.text.substr(colon + 1));
    const auto re = words.size() == 2 ? to_number(words[0]) : std::nullopt;
    const auto im = words.size() == 2 ? to_number(words[1]) : std::nullopt;
    if (!re || !im) return fault(line, "expected a real and an imaginary part", colon + 1);
    x[place] = {*re, *im};
    given[place] = true;
  }

  void read_table(const std::vector<Line>& lines) {
    const auto head = cells_of(lines.front().text);
    std::vector<std::size_t> columns;  // of re and im of each variable in turn
    for (const std::string& name : variables_) {
      for (const char* part : {".re", ".im"}) {
        const auto found = std::find(head.begin(), head.end(), name + part);
        if (found == head.end()) fault(lines.front(), "there is no column " + name + part);
        columns.push_back(static_cast<std::size_t>(found - head.begin()));
      }
    }
    if (!faults_.empty()) return;
    for (std::size_t k = 1; k < lines.size(); ++k) {
      const auto cells = cells_of(lines[k].text);
      if (cells.size() != head.size()) {
        fault(lines[k], "expected " + std::to_string(head.size()) +
                            " cells as in the head, found " + std::to_string(cells.size()));
        continue;
      }
      std::vector<std::string_view> words;
      for (const std::size_t column : columns) words.push_back(cells[column]);
      take_numbers(lines[k], words);
    }
  }

  void read_plain(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      const auto words = words_of(line.text);
      if (words.size() == 2 * variables_.size()) {
        take_numbers(line, words);
      } else {
        fault(line, "expected " + counted(2 * variables_.size(), "number") +
                        ", re and im of each variable, found " + std::to_string(words.size()));
      }
    }
  }

  void take_numbers(const Line& line, const std::vector<std::string_view>& words) {
    Point x(variables_.size());
    for (std::size_t k = 0; k < words.size(); ++k) {
      const std::optional<double> number = to_number(words[k]);
      if (!number || !std::isfinite(*number)) {
        fault(line, number ? "not a finite number" : "not a number",
              static_cast<std::size_t>(words[k].data() - line.text.data()));
        continue;
      }
      Complex& xi = x[k / 2];
      xi = k % 2 == 0 ? Complex(*number, 0) : Complex(xi.real(), *number);
    }
    points_.push_back(std::move(x));
  }

  const Source& source_;
  const std::vector<std::string>& variables_;
  std::vector<Point> points_;
  std::vector<Diagnostic> faults_;
};

}  // namespace

std::vector<Point> read_points(const Source& source, const std::vector<std::string>& variables) {
  return PointReader(source, variables).read();
}

}  // namespace moivre
