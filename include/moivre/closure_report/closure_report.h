// SPDX-License-Identifier: MIT
// How are closures reported? As text for people, as JSON and CSV for programs.
//
//   text  counts, stages, every closure with angles in the file's unit, what was left out
//   JSON  docs/json.md shows it; angles in radians in (-pi, pi], lengths in the file's unit;
//         unknown numbers are null
//   CSV   one closure per line: id, then the coordinates, shortest digits that read back as the
//         same double
// `file` is the name the user gave to the mechanism.
#pragma once

#include <string>

#include "moivre/closure_report/angles.h"
#include "moivre/closures/closures.h"
#include "moivre/report/text_sink.h"

namespace moivre {

struct Sensitivities;

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

}  // namespace moivre
