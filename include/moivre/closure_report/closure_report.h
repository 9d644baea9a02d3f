// SPDX-License-Identifier: MIT
// How are closures reported? As text and pictures for people, as JSON and CSV for programs.
//
//   text  counts, stages, every closure with angles in the file's unit, what was left out
//   JSON  docs/json.md shows it; angles in radians in (-pi, pi], lengths in the file's unit;
//         unknown numbers are null
//   CSV   one closure per line: id, then the coordinates, shortest digits that read back as the
//         same double
//   SVG   one panel per closure with its id, all to one scale, the ground at the same place in
//         each; title, counts, the drivers' values, a scale bar. Where there is no closure, the
//         bodies are drawn at the initial guess, with a note. Names are escaped: whatever they
//         hold, the document stays well-formed.
// `file` is the name the user gave to the mechanism.
#pragma once

#include <string>

#include "moivre/closures/closures.h"
#include "moivre/report/text_sink.h"

namespace moivre {

struct Sensitivities;

/// In which unit a table writes angles, and whether they jump at half a turn.
struct AngleForm {
  bool in_degrees = false;  ///< else radians
  bool goes_on = false;     ///< along a branch beyond half a turn, else in (-pi, pi]
};

/// From where a spatial mechanism is seen.
enum class Views {
  standing,  ///< one, by the sheet's view
  /// From the front (x right, z up), from the right (y right, z up), from above (x right, y up).
  three
};

std::string closures_text(const ClosureResult& result, const Mechanism& mechanism,
                          const std::string& file);
/// `sensitivities` (sensitivity_report.h) are told where they are given. One closure at a time is
/// held as JSON.
void write_closures_json(const TextSink& sink, const ClosureResult& result,
                         const Mechanism& mechanism, const std::string& file,
                         const Sensitivities* sensitivities = nullptr);
/// The same as one text.
std::string closures_json(const ClosureResult& result, const Mechanism& mechanism,
                          const std::string& file, const Sensitivities* sensitivities = nullptr);
std::string closures_csv(const ClosureResult& result, const Mechanism& mechanism,
                         const AngleForm& form = {});
/// Throws std::invalid_argument where three views are asked for of what lies in a plane.
std::string closures_svg(const ClosureResult& result, const Mechanism& mechanism,
                         const std::string& file, Views views = Views::standing);

}  // namespace moivre
