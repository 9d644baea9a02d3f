// SPDX-License-Identifier: MIT
// PHCpack's solution list, line by line: t, m, coordinates by name, then err, rco and res.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "moivre/expression/words.h"
#include "read_forms.h"

namespace moivre {
namespace {

constexpr std::string_view kHead = "SOLUTIONS";
constexpr std::string_view kCoordinatesFollow = "the solution for t";

std::optional<double> to_finite_number(std::string_view word) {
  const std::optional<double> x = to_number(word);
  return x && std::isfinite(*x) ? x : std::nullopt;
}

std::optional<std::uint64_t> to_count(std::string_view word) {
  std::uint64_t n = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), n);
  if (read.ec != std::errc() || read.ptr != word.data() + word.size()) return std::nullopt;
  return n;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin = text.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

struct ListLine {
  std::size_t number, offset;
  std::string_view text;
};

class ListReader {
 public:
  ListReader(const Source& source, const std::vector<std::string>& variables)
      : source_(source), variables_(variables) {
    claims_.form = ClaimForm::solution_list;
    const std::string_view text = source.text;
    for (std::size_t begin = 0, number = 1; begin < text.size(); ++number) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      lines_.push_back({number, begin, text.substr(begin, end - begin)});
      begin = end + 1;
    }
  }

  Claims read() {
    next_ = begin_of_list();
    while (next_ < lines_.size()) {
      const ListLine& line = lines_[next_++];
      if (is_solution_head(line.text)) read_solution(line);
    }
    if (!claims_.listed && claims_.roots.empty() && faults_.empty()) {
      fault(lines_.front(), "the file lists no solution");
    }
    if (!faults_.empty()) throw ParseError(source_, std::move(faults_));
    return std::move(claims_);
  }

 private:
  /// "solution 3 : ..." of a refined list, "== 3 =  #step : ..." of one that was just tracked.
  static bool is_solution_head(std::string_view text) {
    const std::string_view line = trimmed(text);
    if (line.substr(0, 3) == "== ") return line.find("#step") != std::string_view::npos;
    return line.substr(0, 9) == "solution " && line.find(':') != std::string_view::npos;
  }

  void fault(const ListLine& line, const std::string& message) {
    faults_.push_back({{line.offset, line.number, 1}, message});
  }

  /// Behind the head of the last list and its "n dimension" line; 0 where no list has a head.
  std::size_t begin_of_list() {
    std::size_t begin = 0;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (lines_[k].text.find(kHead) == std::string_view::npos) continue;
      std::size_t head = k + 1;
      while (head < lines_.size() && trimmed(lines_[head].text).empty()) ++head;
      const auto words =
          head < lines_.size() ? words_of(lines_[head].text) : std::vector<std::string_view>{};
      const auto count = words.size() == 2 ? to_count(words[0]) : std::nullopt;
      const auto dimension = words.size() == 2 ? to_count(words[1]) : std::nullopt;
      if (!count || !dimension) continue;
      claims_.listed = count;
      begin = head + 1;
    }
    return begin;
  }

  void read_solution(const ListLine& head) {
    RootClaim root;
    root.x.resize(variables_.size());
    std::vector<bool> given(variables_.size());
    bool coordinates = false;
    for (; next_ < lines_.size() && !is_solution_head(lines_[next_].text); ++next_) {
      const ListLine& line = lines_[next_];
      const std::string_view text = trimmed(line.text);
      if (text.substr(0, 2) == "==") {
        if (text.find("err") != std::string_view::npos) read_figures(line, root);
        ++next_;
        break;
      }
      if (text.substr(0, kCoordinatesFollow.size()) == kCoordinatesFollow) {
        coordinates = true;
      } else if (coordinates) {
        read_coordinate(line, root.x, given);
      } else if (text.substr(0, 1) == "m") {
        const auto words = words_of(text.substr(std::min(text.find(':'), text.size() - 1) + 1));
        const auto m = words.empty() ? std::nullopt : to_count(words.front());
        if (!m) fault(line, "expected a multiplicity");
        root.multiplicity = m.value_or(1);
      }
    }
    for (std::size_t j = 0; j < given.size(); ++j) {
      if (!given[j]) fault(head, "the solution does not say " + variables_[j]);
    }
    claims_.roots.push_back(std::move(root));
  }

  void read_coordinate(const ListLine& line, Point& x, std::vector<bool>& given) {
    const std::size_t colon = line.text.find(':');
    if (colon == std::string_view::npos) return;
    const std::string_view name = trimmed(line.text.substr(0, colon));
    const auto found = std::find(variables_.begin(), variables_.end(), name);
    if (found == variables_.end()) {
      return fault(line, std::string(name) + " is not a variable of the system");
    }
    const auto words = words_of(line.text.substr(colon + 1));
    const auto re = words.size() == 2 ? to_finite_number(words[0]) : std::nullopt;
    const auto im = words.size() == 2 ? to_finite_number(words[1]) : std::nullopt;
    if (!re || !im) return fault(line, "expected a finite real and imaginary part");
    const auto place = static_cast<std::size_t>(found - variables_.begin());
    x[place] = {*re, *im};
    given[place] = true;
  }

  /// "== err :  1.0E-15 = rco :  0.2 = res :  5.5E-17 ==": err is how far the last correction went.
  void read_figures(const ListLine& line, RootClaim& root) {
    const std::size_t begin = line.text.find(':', line.text.find("err"));
    const auto words = words_of(line.text.substr(std::min(begin, line.text.size() - 1) + 1));
    if (!words.empty()) root.accuracy = to_finite_number(words.front());
  }

  const Source& source_;
  const std::vector<std::string>& variables_;
  std::vector<ListLine> lines_;
  std::size_t next_ = 0;
  Claims claims_;
  std::vector<Diagnostic> faults_;
};

}  // namespace

Claims read_solution_list(const Source& source, const std::vector<std::string>& variables) {
  return ListReader(source, variables).read();
}

}  // namespace moivre
