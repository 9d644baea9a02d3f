// SPDX-License-Identifier: MIT
// Proofs of roots where the module certify was not built: there are none.
#include "moivre/closures/root_proofs.h"

namespace moivre {

struct RootProver::Work {};

RootProver::RootProver(const Formulation&, bool) {}
RootProver::~RootProver() = default;

bool RootProver::is_built() { return false; }

void RootProver::add_lone(const Block&) {}
void RootProver::close_group(const Block&) {}
bool RootProver::close() { return false; }
KnownProof RootProver::prove(const KnownProof&, const Point&) { return nullptr; }
std::vector<bool> RootProver::are_new(const std::vector<KnownProof>& proofs) {
  return std::vector<bool>(proofs.size());
}
std::optional<bool> RootProver::vanishes(const KnownProof&, const Formulation::Exclusion&) {
  return std::nullopt;
}
ProvedRoot RootProver::root(const KnownProof&) { return {}; }

}  // namespace moivre
