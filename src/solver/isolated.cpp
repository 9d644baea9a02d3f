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

namespace moivre {
namespace {

// So many bits at first, then twice as many where roots are nearer than these part.
constexpr int kFirstBits = 256;
// What was seen of a path's end is no farther from its root, relative to max(1, |x|_inf).
constexpr double kFarthestEnd = 0.1;

std::vector<Coefficient> exact_midpoint(const IsolatedRoot& root) {
  Coefficient y;
  for (const Complex& part : root.parts) {
    y = y + Coefficient{Rational(part.real()), Rational(part.imag())};
  }
  return {y};
}

/// A number as a sum of doubles, largest first.
std::vector<Complex> parts_of(Coefficient z, std::size_t count) {
  std::vector<Complex> parts;
  while (parts.size() < count) {
    parts.push_back(to_complex(z));
    z = z - Coefficient{Rational(parts.back().real()), Rational(parts.back().imag())};
  }
  return parts;
}

/// Of the system as given, all unknowns.
struct Place {
  Point x;
  std::vector<Point> finer;
};

Place place_of(const Reduction& reduction, const IsolatedRoot& root) {
  const auto x = restore(reduction, exact_midpoint(root), [](const Coefficient& c) { return c; });
  Place place{Point(x.size()), std::vector<Point>(root.parts.size() - 1, Point(x.size()))};
  for (std::size_t j = 0; j < x.size(); ++j) {
    const std::vector<Complex> parts = parts_of(x[j], root.parts.size());
    place.x[j] = parts.front();
    for (std::size_t k = 1; k < parts.size(); ++k) place.finer[k - 1][j] = parts[k];
  }
  return place;
}

/// Where nothing was eliminated the disc is the certificate.
Certificate certificate_of(const IsolatedRoot& root, const Place& place, int bits) {
  Certificate result;
  result.verdict = Verdict::certified;
  result.bits = bits;
  result.midpoint = place.x;
  result.finer = place.finer;
  result.error = {root.error};
  result.radius = {root.radius};
  const ProvedCoordinate coordinate{enclosure(result, 0), root.radius};
  const std::size_t itself = 0;
  result.reality = reality_of(std::span(&coordinate, 1), std::span(&itself, 1));
  return result;
}

struct ProvedPlace {
  Place place;
  std::shared_ptr<const Certificate> certificate;  ///< of a simple root
  std::uint64_t multiplicity = 1;
};

/// nullopt where a simple root is not proved on the system as given, or two multiple ones are one point of double.
std::optional<std::vector<ProvedPlace>> places_of(const Setting& setting,
                                                  const std::vector<IsolatedRoot>& roots,
                                                  int bits) {
  const Reduction& reduction = setting.prepared.reduction;
  Certifier certifier(setting.certify_program);
  std::vector<ProvedPlace> places;
  for (const IsolatedRoot& root : roots) {
    ProvedPlace& proved = places.emplace_back();
    proved.place = place_of(reduction, root);
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

/// Those that the paths in doubt may end at: all, or the multiple ones where as many simple ones are proved as there are.
std::optional<std::vector<ProvedPlace>> proved_places(const Run& run) {
  const Setting& setting = run.setting;
  const System& f = setting.prepared.reduction.system;
  for (int bits = kFirstBits; bits <= kMostArbBits && !setting.stop; bits *= 2) {
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
  for (const auto& [path, root] : run.ledger.roots()) {
    if (!root.certificate) paths.emplace_back(path, root.point.x);
  }
  for (const auto& [path, failure] : run.ledger.failures()) {
    const auto last = run.ledger.last_points().find(path);
    if (last != run.ledger.last_points().end()) paths.emplace_back(path, last->second);
  }
  return paths;
}

void enter(Run& run, Refiner& refiner, std::uint64_t path, const ProvedPlace& place) {
  Root root;
  if (place.certificate) {
    root.point = refiner.take(*place.certificate);
    root.tolerance = simple_tolerance(root.point);
    root.certificate = place.certificate;
  } else {
    root.point = refiner.keep(place.place.x, std::numeric_limits<double>::epsilon(), 1);
    root.point.accuracy = std::numeric_limits<double>::epsilon();
    root.is_exact = root.is_counted = true;
    root.on_set = SetHere::none;
  }
  run.ledger.enter_root(path, std::move(root));
}

/// Those that no path is proved to end at.
std::vector<ProvedPlace> free_places(const Run& run, std::vector<ProvedPlace> places) {
  std::erase_if(places, [&](const ProvedPlace& place) {
    if (!place.certificate) return false;
    return std::any_of(run.ledger.roots().begin(), run.ledger.roots().end(),
                       [&](const auto& entry) {
                         const auto& proof = entry.second.certificate;
                         return proof && relation(*place.certificate, *proof) != Relation::distinct;
                       });
  });
  return places;
}

}  // namespace

bool settle_by_isolation(Run& run) {
  const Setting& setting = run.setting;
  if (setting.prepared.reduction.system.variables.size() != 1 || run.interrupted) return false;
  auto paths = paths_in_doubt(run);
  if (paths.empty()) return false;
  const auto places = proved_places(run);
  if (!places) return false;
  std::vector<std::pair<std::uint64_t, const ProvedPlace*>> found;
  const std::vector<ProvedPlace> left = free_places(run, *places);
  for (const ProvedPlace& place : left) {
    for (std::uint64_t k = 0; k < place.multiplicity; ++k) {
      const auto nearest = std::min_element(paths.begin(), paths.end(), [&](auto& a, auto& b) {
        return max_distance(place.place.x, a.second) < max_distance(place.place.x, b.second);
      });
      if (nearest == paths.end()) return false;
      if (relative_distance(place.place.x, nearest->second) > kFarthestEnd) return false;
      found.emplace_back(nearest->first, &place);
      paths.erase(nearest);
    }
  }
  if (!paths.empty()) return false;
  Refiner refiner(setting.refiner_program);
  for (const auto& [path, place] : found) enter(run, refiner, path, *place);
  return true;
}

}  // namespace moivre
