// SPDX-License-Identifier: MIT
// Certificates where the module certify was not built: nothing is proved.
#include "certificates.h"

namespace moivre {

bool has_certificates() { return false; }

std::shared_ptr<const CertifyProgram> certify_program(const System&, const SolveOptions&) {
  return nullptr;
}

struct Prover::Work {};

Prover::Prover(std::shared_ptr<const CertifyProgram>, double, int) {}
Prover::~Prover() = default;

std::shared_ptr<const Certificate> Prover::prove(const Point&) { return nullptr; }
std::shared_ptr<const Certificate> Prover::prove_in_double(const Point&) { return nullptr; }

std::vector<std::vector<std::uint64_t>> groups_of(const Run& run) {
  return groups_beside_sets(run);
}

std::uint64_t proved_roots(const Setting&, const std::vector<std::shared_ptr<const Certificate>>&) {
  return 0;
}
std::uint64_t proved_roots(const Run&) { return 0; }

}  // namespace moivre
