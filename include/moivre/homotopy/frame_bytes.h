// SPDX-License-Identifier: MIT
// How is a path's frame kept, and sent to another process? To the last bit; none at all is kept
// too.
#pragma once

#include <memory>
#include <utility>

#include "moivre/homotopy/frame.h"
#include "moivre/numeric/bytes.h"

namespace moivre {

/// frame may be nullptr.
inline void put_frame(ByteWriter& bytes, const FramePointer& frame) {
  bytes.put(frame != nullptr);
  if (!frame) return;
  bytes.put(frame->log2);
  bytes.put(frame->factors);
  bytes.put(frame->weights);
  bytes.put(frame->member);
}

/// What put_frame() has put.
inline FramePointer get_frame(ByteReader& bytes) {
  if (!bytes.get<bool>()) return nullptr;
  PathFrame frame;
  frame.log2 = bytes.get_vector<int>();
  frame.factors = bytes.get_vector<double>();
  frame.weights = bytes.get_vector<double>();
  frame.member = bytes.get_vector<Complex>();
  return std::make_shared<const PathFrame>(std::move(frame));
}

}  // namespace moivre
