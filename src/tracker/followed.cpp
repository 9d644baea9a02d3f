// SPDX-License-Identifier: MIT
// Supports, coefficients and options, one after the other.
#include "moivre/tracker/followed.h"

#include <type_traits>
#include <typeinfo>

namespace moivre {
namespace {

void add_support(FingerprintMaker& maker, const System& system) {
  for (const Polynomial& p : system.polynomials) {
    maker.add(std::uint64_t{p.terms.size()});
    for (const Term& term : p.terms) {
      maker.add(std::uint64_t{term.monomial.size()});
      for (const Power& power : term.monomial) {
        maker.add(std::uint64_t{power.variable} << 32 | power.exponent);
      }
    }
  }
}

void add_coefficients(FingerprintMaker& maker, const System& system) {
  for (const Polynomial& p : system.polynomials) {
    for (const Term& term : p.terms) maker.add(to_complex(term.coefficient));
  }
}

}  // namespace

void add_to(FingerprintMaker& maker, const Homotopy& homotopy) {
  maker.add(static_cast<std::uint64_t>(homotopy.law()));
  maker.add(std::uint64_t{homotopy.is_framed()});
  add_support(maker, homotopy.support());
  if (const auto& parameters = homotopy.parameter_law()) {
    add_support(maker, parameters->coefficients);
    add_coefficients(maker, parameters->coefficients);
    maker.add(parameters->from);
    maker.add(parameters->to);
    return;
  }
  for (std::size_t k = 0; k < homotopy.terms(); ++k) {
    maker.add(to_complex(homotopy.f(k)));
    maker.add(to_complex(homotopy.g(k)));
  }
  maker.add(homotopy.largest_error());
}

void add_to(FingerprintMaker& maker, const FramePointer& frame) {
  if (!frame) return;
  for (const int e : frame->log2) maker.add(static_cast<double>(e));
  for (const double factor : frame->factors) maker.add(factor);
  for (const double weight : frame->weights) maker.add(weight);
  maker.add(frame->member);
}

void add_to(FingerprintMaker& maker, const Tracker& tracker) {
  maker.add(tracker.kind());
  maker.add(std::string_view(typeid(tracker).name()));
  for (const OptionInForce& option : tracker.options_in_force()) {
    maker.add(option.name);
    std::visit(
        [&maker](const auto& value) {
          if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::int64_t>) {
            maker.add(static_cast<std::uint64_t>(value));
          } else {
            maker.add(value);
          }
        },
        option.value);
  }
}

}  // namespace moivre
