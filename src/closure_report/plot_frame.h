// SPDX-License-Identifier: MIT
// Where in a sweep's picture is a value? The rectangle of its plot, in pixels, y downwards.
#pragma once

namespace moivre {

inline constexpr double kPictureWidth = 760;
inline constexpr double kPictureHeight = 480;
inline constexpr double kPlotLeft = 70;
inline constexpr double kPlotRight = kPictureWidth - 150;
inline constexpr double kPlotTop = 40;
inline constexpr double kPlotBottom = kPictureHeight - 60;

}  // namespace moivre
