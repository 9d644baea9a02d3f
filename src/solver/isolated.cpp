// SPDX-License-Identifier: MIT
// The isolated roots brought back to the system as given, and the paths in doubt to the nearest.
#include "isolated.h"

#include <algorithm>
#include <limits>

#include "certificates.h"
#include "coincidence.h"
#include "ends.h"
#include "moivre/certify/distinct.h"
#include "moivre/certify/isolate.h"
#include "moivre/numeric/near_points.h"
#include "places.h"

namespace moivre {
namespace {

// What was seen of a path's end is no farther from its root, relative to max(1, |x|_inf).
constexpr double kFarthestEnd = 0.1;

/// Where nothing was eliminated the disc is the certificate.
Certificate certificate_of(const IsolatedRoot& root, const Place& place, int bits) {
  Certificate result;
  result.verdict = Verdict::certified;
  result.bits = bits;
  result.midpoint = place.x;
  result.finer = place.finer;
  result.sizes.assign({&root.radius, 1}, {&root.error, 1});
  if (!result.sizes.are_apart()) return {};
  const ProvedCoordinate coordinate{enclosure(result, 0), root.radius};
  const std::size_t itself = 0;
  result.reality = reality_of(std::span(&coordinate, 1), std::span(&itself, 1));
  return result;
}

/// nullopt where a simple root is not proved on the system as given, or two multiple ones are one
/// point of double.
std::optional<std::vector<ProvedPlace>> places_of(const Setting& setting,
                                                  const std::vector<IsolatedRoot>& roots,
                                                  int bits) {
  const Reduction& reduction = setting.prepared.reduction;
  Certifier certifier(setting.certify_program);
  std::vector<ProvedPlace> places;
  for (const IsolatedRoot& root : roots) {
    ProvedPlace& proved = places.emplace_back();
    proved.place = place_of(reduction, {root.parts});
    proved.multiplicity = root.multiplicity;
    if (root.multiplicity > 1) {
      const bool is_taken = std::any_of(places.begin(), places.end() - 1, [&](const auto& other) {
        return other.multiplicity > 1 && other.place.x == proved.place.x;
      });
      if (is_taken) return std::nullopt;
      continue;
    }
    const Certificate certificate =
        reduction.substitutions.empty()
            ? certificate_of(root, proved.place, bits)
            : certifier.certify_near(proved.place.x, proved.place.finer, bits);
    if (!certificate.holds_root()) return std::nullopt;
    proved.certificate = std::make_shared<const Certificate>(certificate);
  }
  return places;
}

/// Those that the paths in doubt may end at: all, or the multiple ones where as many simple ones
/// are proved as there are.
std::optional<std::vector<ProvedPlace>> proved_places(const Run& run) {
  const Setting& setting = run.setting;
  const System& f = setting.prepared.reduction.system;
  // Twice as many where roots are nearer than these part.
  for (int bits = kMostProofBits; bits <= kMostArbBits && !setting.stop; bits *= 2) {
    const auto isolated = isolated_roots(f.polynomials.front(), bits);
    if (!isolated) continue;
    if (isolated->other_simple > 0 && proved_roots(run) < isolated->other_simple) {
      return std::nullopt;
    }
    if (auto places = places_of(setting, isolated->roots, bits)) return places;
  }
  return std::nullopt;
}

/// The paths whose ends are not proved, each with the last that was seen of it.
std::vector<std::pair<std::uint64_t, Point>> paths_in_doubt(const Run& run) {
  std::vector<std::pair<std::uint64_t, Point>> paths;
  for (const auto& [path, root] : run.table.roots()) {
    if (!root.certificate) paths.emplace_back(path, root.point.x);
  }
  for (const auto& [path, failure] : run.table.failures()) {
    const auto last = run.table.last_points().find(path);
    if (last != run.table.last_points().end()) paths.emplace_back(path, last->second);
  }
  return paths;
}

}  // namespace

void isolate_roots(Run& run) {
  const Setting& setting = run.setting;
  if (setting.prepared.reduction.system.variables.size() != 1) return;
  auto paths = paths_in_doubt(run);
  if (paths.empty()) return;
  const auto places = proved_places(run);
  if (!places) return;
  std::vector<std::pair<std::uint64_t, const ProvedPlace*>> found;
  const std::vector<ProvedPlace> left = free_places(run, *places);
  for (const ProvedPlace& place : left) {
    for (std::uint64_t k = 0; k < place.multiplicity; ++k) {
      const auto nearest = std::min_element(paths.begin(), paths.end(), [&](auto& a, auto& b) {
        return max_distance(place.place.x, a.second) < max_distance(place.place.x, b.second);
      });
      if (nearest == paths.end()) return;
      if (relative_distance(place.place.x, nearest->second) > kFarthestEnd) return;
      found.emplace_back(nearest->first, &place);
      paths.erase(nearest);
    }
  }
  if (!paths.empty()) return;
  Refiner refiner(setting.refiner_program);
  for (const auto& [path, place] : found) enter_place(run, refiner, path, *place);
}

}  // namespace moivre
