// SPDX-License-Identifier: MIT
// How is a motion reported? As text and a picture for people, as JSON and CSV for programs.
//
//   text  branches, where they begin and end, events with the drivers' values, whether the
//         checkpoints agree
//   JSON  docs/json.md shows it: every sample with position, velocity and acceleration of every
//         coordinate and named point
//   CSV   one sample per line: branch, t, drivers, then for each coordinate and each point's x, y
//         (z) the value, velocity and acceleration
//   SVG   the curves of points over the mechanism's first pose, one colour per branch, where
//         branches begin and end, a legend. The points: those without a joint, else those of bodies
//         that no joint holds to the ground.
// Angles are in radians in (-pi, pi] unless an AngleForm says otherwise, their rates per second and
// per second squared. Lengths are in the file's unit. The text is in the file's units.
#pragma once

#include <string>

#include "moivre/closure_report/closure_report.h"
#include "moivre/motion/motion.h"
#include "moivre/report/text_sink.h"

namespace moivre {

struct Readings;

std::string motion_text(const MotionResult& result, const Mechanism& mechanism,
                        const std::string& file);
/// Angles in radians; `form` says whether they go on. `readings` (readings_report.h) are told where
/// they are given. One sample at a time is held as JSON.
void write_motion_json(const TextSink& sink, const MotionResult& result, const Mechanism& mechanism,
                       const std::string& file, const AngleForm& form = {},
                       const Readings* readings = nullptr);
/// The same as one text.
std::string motion_json(const MotionResult& result, const Mechanism& mechanism,
                        const std::string& file, const AngleForm& form = {},
                        const Readings* readings = nullptr);
std::string motion_csv(const MotionResult& result, const Mechanism& mechanism,
                       const AngleForm& form = {});
/// Curves of points; for typed equations, which have none, each unknown over the time.
std::string motion_svg(const MotionResult& result, const Mechanism& mechanism,
                       const std::string& file);

}  // namespace moivre
