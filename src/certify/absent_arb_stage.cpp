// SPDX-License-Identifier: MIT
// Proofs beyond double where the program was built without Arb: there are none.
#include "arb_stage.h"
#include "moivre/certify/certifier.h"

namespace moivre {

bool proves_beyond_double() { return false; }

class ArbStage::Work {};

ArbStage::ArbStage(const CertifyProgram&) {}
ArbStage::~ArbStage() = default;

ArbOutcome ArbStage::prove(std::span<const Complex>, std::span<const Point>,
                           std::span<const Enclosure>, int, double, Certificate&) {
  return ArbOutcome::left;
}

}  // namespace moivre
