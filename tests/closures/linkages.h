// SPDX-License-Identifier: MIT
// Linkages for tests of circuits: four-bars by their lengths, six-bars by a drawn pose, Klann's
// leg.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "../mechanism/files.h"
#include "moivre/report/number_text.h"

namespace moivre::test {

/// A body and its points, each named and placed in the drawn pose: q = 0 is that pose.
struct DrawnBody {
  std::string name;
  std::string points;
};

inline Mechanism drawn(const std::vector<DrawnBody>& bodies,
                       const std::vector<std::array<double, 2>>& places, const std::string& driven,
                       double start_deg = 0) {
  std::string text = "[units]\nangle = \"deg\"\n";
  std::string joints;
  std::vector<std::string> first(places.size());
  for (const DrawnBody& body : bodies) {
    text += body.name == "ground" ? "[ground.points]\n" : "[body." + body.name + ".points]\n";
    for (const char letter : body.points) {
      const auto k = static_cast<std::size_t>(letter - 'A');
      text += std::string(1, letter) + " = [" + exact_text(places[k][0]) + ", " +
              exact_text(places[k][1]) + "]\n";
      std::string point = body.name;
      point.append(1, '.').append(1, letter);
      if (first[k].empty()) {
        first[k] = point;
      } else {
        joints +=
            "[[joint]]\ntype = \"revolute\"\nat = [\"" + first[k] + "\", \"" + point + "\"]\n";
      }
    }
  }
  return typed(text + joints + "[[driver]]\nangle = \"" + driven +
               "\"\nstart = " + exact_text(start_deg) + "\nvelocity = 60\n");
}

/// Frame g along x, input a, coupler h, output b; the input at `start_deg`.
inline Mechanism four_bar(const std::array<double, 4>& lengths, double start_deg = 0) {
  const auto [g, a, h, b] = lengths;
  std::string text =
      "[units]\nangle = \"deg\"\n[ground.points]\nO = [0, 0]\nP = [" + exact_text(g) + ", 0]\n";
  const auto add_link = [&](const std::string& name, const char* ends, double length) {
    text += "[body." + name + ".points]\n" + ends[0] + " = [0, 0]\n" + ends[1] + " = [" +
            exact_text(length) + ", 0]\n";
  };
  add_link("input", "OA", a);
  add_link("coupler", "AB", h);
  add_link("output", "PB", b);
  const std::array<const char*, 4> joints{"\"ground.O\", \"input.O\"", "\"input.A\", \"coupler.A\"",
                                          "\"coupler.B\", \"output.B\"",
                                          "\"ground.P\", \"output.P\""};
  for (const char* joint : joints) {
    text += std::string("[[joint]]\ntype = \"revolute\"\nat = [") + joint + "]\n";
  }
  return typed(text + "[[driver]]\nangle = \"input\"\nstart = " + exact_text(start_deg) +
               "\nvelocity = 60\n");
}

/// Crank A-B, coupler B-C-D, rockers E-C and F-H, link D-H; A, E, F on the ground.
inline Mechanism stephenson_3(const std::vector<std::array<double, 2>>& places,
                              const std::string& driven, double start_deg = 0) {
  return drawn({{"ground", "AEF"},
                {"crank", "AB"},
                {"coupler", "BCD"},
                {"rocker", "EC"},
                {"link", "DG"},
                {"output", "FG"}},
               places, driven, start_deg);
}

/// Crank A-B, coupler B-C, rocker E-C-D, link D-G, output F-G: two four-bars in a row.
inline Mechanism watt_2(const std::vector<std::array<double, 2>>& places,
                        const std::string& driven) {
  return drawn({{"ground", "AEF"},
                {"crank", "AB"},
                {"coupler", "BC"},
                {"rocker", "ECD"},
                {"link", "DG"},
                {"output", "FG"}},
               places, driven);
}

/// The leg of United States patent 6,260,862, drawn with its crank pointing to the left; a
/// Stephenson III.
inline Mechanism klann(const std::string& driven, double start_deg = 0) {
  return stephenson_3({{1.599, 0.750},
                       {1.331, 0.750},
                       {0.741, 0.750},
                       {0.232, 0.866},
                       {1.009, 0.574},
                       {1.366, 1.366},
                       {0.866, 1.500}},
                      driven, start_deg);
}

}  // namespace moivre::test
