// SPDX-License-Identifier: MIT
// The names of starts.
#include "moivre/start/start_kind.h"

namespace moivre {

std::string to_string(StartKind kind) {
  switch (kind) {
    case StartKind::automatic:
      return "auto";
    case StartKind::total_degree:
      return "total-degree";
    case StartKind::multihomogeneous:
      return "multihomogeneous";
    case StartKind::polyhedral:
      return "polyhedral";
  }
  return "";
}

std::optional<StartKind> start_kind(const std::string& name) {
  for (const StartKind kind : {StartKind::automatic, StartKind::total_degree,
                               StartKind::multihomogeneous, StartKind::polyhedral}) {
    if (to_string(kind) == name) return kind;
  }
  return std::nullopt;
}

std::string to_string(StartSource source) {
  switch (source) {
    case StartSource::total_degree:
      return to_string(StartKind::total_degree);
    case StartSource::multihomogeneous:
      return to_string(StartKind::multihomogeneous);
    case StartSource::polyhedral:
      return to_string(StartKind::polyhedral);
    case StartSource::own:
      return "own";
    case StartSource::family:
      return "family";
    case StartSource::formula:
      return "formula";
    case StartSource::approach:
      return "approach";
  }
  return "";
}

std::optional<StartKind> asked_for(StartSource source) {
  switch (source) {
    case StartSource::total_degree:
      return StartKind::total_degree;
    case StartSource::multihomogeneous:
      return StartKind::multihomogeneous;
    case StartSource::polyhedral:
      return StartKind::polyhedral;
    case StartSource::own:
    case StartSource::family:
    case StartSource::formula:
    case StartSource::approach:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace moivre
