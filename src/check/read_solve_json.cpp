// SPDX-License-Identifier: MIT
// The JSON of solve, key by key as in docs/json.md; keys that no claim is made of are passed over.

#include "json_reader.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/numeric/invalid_input.h"
#include "read_forms.h"

namespace moivre {
namespace {

// More faults than this tell no more.
constexpr std::size_t kMostFaults = 20;
// Digits that solve can be asked for.
constexpr std::uint64_t kMostDigits = 1000;

/// The roots of a result, taken one by one while it is parsed: as a tree they would take ten times
/// the text.
struct TakenRoots {
  std::optional<std::size_t> dimension;  ///< once the system was read
  bool are_read = false;
  std::vector<RootClaim> roots;
  std::vector<std::string> faults;
};

RootClaim read_root(const JsonPlace& place, std::size_t dimension);

/// What the parser calls. A root that is taken is kept in no tree.
class RootTaker {
 public:
  explicit RootTaker(TakenRoots& taken) : taken_(taken) {}

  bool operator()(int depth, JsonValue::parse_event_t event, const JsonValue& value) {
    using Event = JsonValue::parse_event_t;
    if (depth == 1 && event == Event::key) key_ = value.get<std::string>();
    const bool is_end =
        event == Event::object_end || event == Event::array_end || event == Event::value;
    if (depth == 1 && event == Event::array_start && key_ == "solutions" && taken_.dimension) {
      taken_.are_read = true;
      taken_.roots.clear();
      taken_.faults.clear();
    }
    if (depth == 1 && event == Event::object_end && key_ == "system") take_dimension(value);
    if (depth != 2 || !is_end || key_ != "solutions" || !taken_.are_read) return true;
    const std::string name = "solutions[" + std::to_string(taken_.roots.size()) + ']';
    taken_.roots.push_back(
        read_root(JsonPlace(value, name, taken_.faults), taken_.dimension.value_or(0)));
    return false;
  }

 private:
  void take_dimension(const JsonValue& system) {
    const auto variables = system.find("variables");
    if (variables != system.end() && variables->is_array()) taken_.dimension = variables->size();
  }

  TakenRoots& taken_;
  std::string key_;
};

JsonValue parse(const Source& source, TakenRoots& taken) {
  try {
    return JsonValue::parse(source.text, RootTaker(taken));
  } catch (const JsonValue::parse_error& error) {
    const std::size_t place = error.byte > 0 ? error.byte - 1 : 0;
    const std::string_view before(source.text.data(), std::min(place, source.text.size()));
    throw ParseError(source, {{after({}, before), "the JSON is broken or cut off here"}});
  } catch (const JsonValue::exception&) {
    throw InvalidInput(source.name + ": a number in the JSON is beyond double");
  }
}

Point read_point(const JsonPlace& place, std::size_t dimension) {
  Point x;
  if (!place.is_list()) return x;
  if (place.size() != dimension) {
    place.fault("expected " + counted(dimension, "coordinate") + ", found " +
                std::to_string(place.size()));
  }
  for (std::size_t j = 0; j < place.size(); ++j) {
    const JsonPlace xj = place.element(j);
    if (!xj.is_list()) continue;
    if (xj.size() != 2) {
      xj.fault("expected [re, im]");
      continue;
    }
    x.emplace_back(xj.element(0).number(), xj.element(1).number());
  }
  return x;
}

std::vector<ComplexDecimal> read_digits(const JsonPlace& place) {
  std::vector<ComplexDecimal> x;
  if (!place.is_list()) return x;
  for (std::size_t j = 0; j < place.size(); ++j) {
    const std::vector<std::string> parts = place.element(j).texts();
    if (parts.size() == 2) x.push_back({parts[0], parts[1]});
  }
  if (x.size() != place.size()) place.fault("expected two texts a coordinate");
  return x;
}

RootClaim read_root(const JsonPlace& place, std::size_t dimension) {
  RootClaim root;
  if (!place.is_object()) return root;
  if (const auto x = place.member("x", true)) root.x = read_point(*x, dimension);
  if (const auto path = place.member("path", true)) root.path = path->count();
  if (const auto real = place.member("real", true)) root.real = real->flag();
  if (const auto singular = place.member("singular", true)) root.singular = singular->flag();
  if (const auto m = place.member("multiplicity", true)) root.multiplicity = m->count();
  if (const auto cluster = place.member("cluster")) root.cluster = cluster->flag();
  if (const auto winding = place.member("winding")) root.winding = winding->counts();
  if (const auto residual = place.member("residual")) root.residual = residual->number();
  if (const auto accuracy = place.member("accuracy")) root.accuracy = accuracy->number();
  if (const auto condition = place.member("condition")) root.condition = condition->number();
  if (const auto certified = place.member("certified")) root.certified = certified->flag();
  if (const auto digits = place.member("x_digits")) root.x_digits = read_digits(*digits);
  return root;
}

SystemClaim read_system_claim(const JsonPlace& place) {
  SystemClaim system;
  if (!place.is_object()) return system;
  if (const auto names = place.member("variables", true)) system.variables = names->texts();
  if (const auto degrees = place.member("degrees", true)) system.degrees = degrees->counts();
  if (const auto total = place.member("total_degree")) system.total_degree = total->count();
  return system;
}

ReducedClaim read_reduced(const JsonPlace& place) {
  ReducedClaim reduced;
  if (!place.is_object()) return reduced;
  if (const auto count = place.member("variables", true)) reduced.variables = count->count();
  if (const auto degrees = place.member("degrees", true)) reduced.degrees = degrees->counts();
  if (const auto pairs = place.member("isotropic_pairs")) reduced.isotropic_pairs = pairs->count();
  return reduced;
}

StartClaim read_start(const JsonPlace& place) {
  StartClaim start;
  if (!place.is_object()) return start;
  if (const auto kind = place.member("kind", true)) start.kind = kind->text();
  if (const auto paths = place.member("paths", true)) start.paths = paths->count();
  const auto counts = place.member("counts");
  if (!counts || !counts->is_object()) return start;
  if (const auto n = counts->member("total_degree")) start.total_degree = n->count();
  if (const auto n = counts->member("multihomogeneous")) start.multihomogeneous = n->count();
  if (const auto n = counts->member("mixed_volume")) start.mixed_volume = n->count();
  return start;
}

PathClaim read_paths(const JsonPlace& place) {
  PathClaim paths;
  if (!place.is_object()) return paths;
  const auto count = [&](const char* key) {
    const auto member = place.member(key, true);
    return member ? member->count() : 0;
  };
  paths.tracked = count("tracked");
  paths.finite = count("finite");
  paths.at_infinity = count("at_infinity");
  paths.failed = count("failed");
  paths.on_positive_dimensional = count("on_positive_dimensional");
  if (const auto n = place.member("not_needed")) paths.not_needed = n->count();
  if (const auto n = place.member("by_count")) paths.by_count = n->count();
  if (const auto n = place.member("retracked")) paths.retracked = n->count();
  if (const auto n = place.member("handed_over")) paths.handed_over = n->count();
  return paths;
}

std::string read_level(const JsonPlace& place) {
  const std::string level = place.text();
  if (level != "proved" && level != "shown" && level != "open") {
    place.fault("expected \"proved\", \"shown\", \"open\" or null");
  }
  return level;
}

void read_roots(const JsonPlace& place, std::size_t dimension, Claims& claims) {
  if (!place.is_list()) return;
  for (std::size_t k = 0; k < place.size(); ++k) {
    claims.roots.push_back(read_root(place.element(k), dimension));
  }
}

int read_digit_count(const JsonPlace& place) {
  const std::uint64_t digits = place.count();
  if (digits < 1 || digits > kMostDigits) place.fault("expected 1 to 1000 digits");
  return static_cast<int>(std::min(digits, kMostDigits));
}

BoundClaim read_bound(const JsonPlace& place) {
  BoundClaim bound;
  if (!place.is_object()) return bound;
  if (const auto kind = place.member("kind", true)) bound.kind = kind->text();
  if (const auto value = place.member("value", true)) bound.value = value->count();
  if (const auto certainty = place.member("certainty")) bound.certainty = certainty->text();
  return bound;
}

void read_planes(const JsonPlace& place, Claims& claims) {
  if (!place.is_list()) return;
  for (std::size_t k = 0; k < place.size(); ++k) {
    const JsonPlace plane = place.element(k);
    if (!plane.is_object()) continue;
    PlaneClaim& claim = claims.planes.emplace_back();
    if (const auto names = plane.member("zero", true)) claim.zero = names->texts();
    if (const auto size = plane.member("dimension", true)) claim.dimension = size->count();
  }
}

Claims read_top(const JsonPlace& top, TakenRoots& taken) {
  Claims claims;
  if (!top.is_object()) return claims;
  if (const auto command = top.member("command", true); command && command->text() != "solve") {
    command->fault("expected the JSON of \"solve\"");
    return claims;
  }
  if (const auto seed = top.member("seed", true)) claims.seed = seed->count();
  if (const auto complete = top.member("complete", true)) claims.complete = complete->flag();
  if (const auto system = top.member("system", true)) claims.system = read_system_claim(*system);
  if (const auto reduced = top.member("reduced")) claims.reduced = read_reduced(*reduced);
  if (const auto start = top.member("start")) claims.start = read_start(*start);
  if (const auto paths = top.member("paths", true)) claims.paths = read_paths(*paths);
  if (const auto list = top.member("failures"); list && list->is_list()) {
    claims.failures = list->size();
  }
  if (const auto excess = top.member("excess")) claims.excess = excess->count();
  for (const char* kind : {"on_denominators", "filtered"}) {
    if (const auto left_out = top.member(kind)) claims.left_out += left_out->count();
  }
  if (const auto digits = top.member("digits")) claims.digits = read_digit_count(*digits);
  if (const auto level = top.member("completeness")) claims.completeness = read_level(*level);
  if (const auto bound = top.member("bound")) claims.bound = read_bound(*bound);
  if (const auto counts = top.member("counts"); counts && counts->is_object()) {
    if (const auto n = counts->member("complex")) claims.counts.complex = n->count();
    if (const auto n = counts->member("real")) claims.counts.real = n->count();
  }
  if (const auto planes = top.member("planes")) read_planes(*planes, claims);
  const auto roots = top.member("solutions", true);
  if (!roots || !claims.system) return claims;
  if (taken.are_read && roots->is_list()) {
    claims.roots = std::move(taken.roots);
    for (const std::string& fault : taken.faults) top.note(fault);
  } else {
    read_roots(*roots, claims.system->variables.size(), claims);
  }
  return claims;
}

}  // namespace

Claims read_solve_json(const Source& source) {
  TakenRoots taken;
  const JsonValue json = parse(source, taken);
  std::vector<std::string> faults;
  Claims claims = read_top(JsonPlace(json, "", faults), taken);
  if (faults.empty()) return claims;
  const std::size_t found = faults.size();
  faults.resize(std::min(found, kMostFaults));
  if (found > kMostFaults) faults.push_back("and " + std::to_string(found - kMostFaults) + " more");
  throw InvalidInput(source.name + ": no result of moivre solve\n  " + joined(faults, "\n  "));
}

}  // namespace moivre
