// SPDX-License-Identifier: MIT
// How is a long text handed on without holding all of it? Gathered to pieces of some tens of
// kilobytes.
#pragma once

#include <functional>
#include <string>

#include "moivre/report/text_sink.h"

namespace moivre {

class TextPieces {
 public:
  explicit TextPieces(const TextSink& sink) : sink_(sink) {}

  TextPieces& operator+=(std::string_view text) {
    piece_ += text;
    if (piece_.size() >= kPiece) flush();
    return *this;
  }
  /// What is gathered. To be called at the end.
  void flush() {
    if (!piece_.empty()) sink_(piece_);
    piece_.clear();
  }

 private:
  static constexpr std::size_t kPiece = 1 << 16;
  const TextSink& sink_;
  std::string piece_;
};

/// All that `write` hands on.
inline std::string whole_text(const std::function<void(const TextSink&)>& write) {
  std::string text;
  write([&text](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace moivre
