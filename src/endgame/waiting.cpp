// SPDX-License-Identifier: MIT
// What does a path that waits need, to go on in another process? All that it has seen so far, to
// the last bit.
#include <memory>
#include <utility>

#include "moivre/endgame/endgame.h"
#include "moivre/homotopy/frame_bytes.h"
#include "moivre/numeric/bytes.h"

namespace moivre {
std::string Endgame::bytes_of_waiting() const {
  ByteWriter bytes;
  put_frame(bytes, frame_);
  bytes.put(phase_);
  bytes.put(creeping_);
  bytes.put(steps_of_way_);
  for (const double number : {radius_, next_radius_, best_difference_}) {
    bytes.put(number);
  }
  bytes.put(looks_again_);
  bytes.put(turns_);
  for (const Point* point : {&endgame_start_, &patch_, &turn_begin_, &turn_end_}) {
    bytes.put(*point);
  }
  bytes.put(static_cast<std::uint64_t>(samples_.size()));
  for (const Point& sample : samples_) bytes.put(sample);
  for (const std::optional<Estimate>* estimate : {&last_, &best_}) {
    bytes.put(estimate->has_value());
    if (!*estimate) continue;
    bytes.put((*estimate)->x);
    bytes.put((*estimate)->winding);
  }
  return bytes.bytes();
}

void Endgame::wait_as(std::string_view text, PathEnd end) {
  ByteReader bytes(text);
  frame_ = get_frame(bytes);
  phase_ = bytes.get<Phase>();
  creeping_ = bytes.get<int>();
  steps_of_way_ = bytes.get<std::uint64_t>();
  for (double* number : {&radius_, &next_radius_, &best_difference_}) {
    *number = bytes.get<double>();
  }
  looks_again_ = bytes.get<bool>();
  turns_ = bytes.get<int>();
  for (Point* point : {&endgame_start_, &patch_, &turn_begin_, &turn_end_}) {
    *point = bytes.get_vector<Complex>();
  }
  samples_.clear();
  for (auto left = bytes.get<std::uint64_t>(); left > 0; --left) {
    samples_.push_back(bytes.get_vector<Complex>());
  }
  for (std::optional<Estimate>* estimate : {&last_, &best_}) {
    estimate->reset();
    if (!bytes.get<bool>()) continue;
    Point x = bytes.get_vector<Complex>();
    *estimate = Estimate{std::move(x), bytes.get<int>()};
  }
  bytes.require_end();
  end_ = std::move(end);
  waits_ = true;
}

}  // namespace moivre
