// SPDX-License-Identifier: MIT
// What are the coefficients of W members of a family, each on its own way to its own target? c =
// q(p(t)) and dc/dt over lanes.
//
//   p(t) = (1 - t) p + t p',  dp/dt = p' - p;  q_k: the values of a tape, with their derivatives
//                                              along dp/dt as truncated series
//
// A coefficient 1, which nearly all are where the parameters are the coefficients themselves, is no
// product.
// R: the scalar. p: broadcast; p': one a lane. Owns its memory, allocates nothing after
// construction.
// Source: [GriewankWalther08, ch. 13] for the truncated series.
#if defined(MOIVRE_LANE_PARAMETERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_PARAMETERS_INL_H_
#undef MOIVRE_LANE_PARAMETERS_INL_H_
#else
#define MOIVRE_LANE_PARAMETERS_INL_H_
#endif

#include <vector>

#include "lane_complex-inl.h"
#include "moivre/homotopy/homotopy.h"
#include "moivre/numeric/scalar.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

template <class R>
class LaneParameters {
 public:
  using Number = typename LaneScalar<R>::Number;

  explicit LaneParameters(const ParameterLaw& law)
      : law_(law),
        c_(law.tape.coefficients.size()),
        from_(law.from.size()),
        to_(law.from.size()),
        registers_(law.tape.variables + 1 + law.tape.value_products),
        rates_(law.tape.variables + 1 + law.tape.value_products) {
    const auto c = round_coefficients<Number>(law.tape, law.coefficients, Scalar<Number>::round);
    for (const Number& ck : c) is_one_.push_back(to_complex(ck) == 1.0);
    for (std::size_t lane = 0; lane < W; ++lane) {
      for (std::size_t k = 0; k < c.size(); ++k) c_.set(k, lane, c[k]);
      for (std::size_t j = 0; j < law.from.size(); ++j) {
        from_.set(j, lane, Number(law.from[j]));
        to_.set(j, lane, Number(law.to.empty() ? law.from[j] : law.to[j]));
      }
    }
  }

  /// Of the path in `lane`, where every path has its own.
  void set_target(std::size_t lane, const PathFrame* frame) {
    if (!law_.to.empty()) return;
    for (std::size_t j = 0; j < frame->member.size(); ++j) {
      to_.set(j, lane, Number(frame->member[j]));
    }
  }

  /// The first coefficients of c, one a polynomial, and their slopes.
  void move(const LaneComplex<R>& t, const LaneComplex<R>& rest, LaneVector<R>& c,
            LaneVector<R>& slope) {
    run(t, rest);
    const Tape& tape = law_.tape;
    for (std::size_t i = 0; i < tape.equations; ++i) {
      LaneComplex<R> value = zero<R>();
      LaneComplex<R> rate = zero<R>();
      for (std::uint32_t k = tape.value_begin[i]; k < tape.value_begin[i + 1]; ++k) {
        const Tape::Summand& summand = tape.value_summands[k];
        const LaneComplex<R> r = load(registers_[summand.monomial]);
        const LaneComplex<R> dr = load(rates_[summand.monomial]);
        if (is_one_[summand.coefficient]) {
          value = value + r;
          rate = rate + dr;
        } else {
          const LaneComplex<R> a = load(c_[summand.coefficient]);
          value = add_product(a, r, value);
          rate = add_product(a, dr, rate);
        }
      }
      store(value, c[i]);
      store(rate, slope[i]);
    }
  }

 private:
  void run(const LaneComplex<R>& t, const LaneComplex<R>& rest) {
    const Tape& tape = law_.tape;
    for (std::size_t j = 0; j < tape.variables; ++j) {
      const LaneComplex<R> from = load(from_[j]);
      const LaneComplex<R> to = load(to_[j]);
      store(add_product(t, to, rest * from), registers_[j]);
      store(to - from, rates_[j]);
    }
    store(one<R>(), registers_[tape.variables]);
    store(zero<R>(), rates_[tape.variables]);
    std::size_t next = tape.variables + 1;
    for (std::uint32_t k = 0; k < tape.value_products; ++k, ++next) {
      const Tape::Product& p = tape.products[k];
      const LaneComplex<R> a = load(registers_[p.a]);
      const LaneComplex<R> b = load(registers_[p.b]);
      store(a * b, registers_[next]);
      store(add_product(a, load(rates_[p.b]), load(rates_[p.a]) * b), rates_[next]);
    }
  }

  const ParameterLaw& law_;
  LaneVector<R> c_;  // the same in all lanes
  std::vector<bool> is_one_;
  LaneVector<R> from_, to_;
  LaneVector<R> registers_;
  LaneVector<R> rates_;  // of the registers in t
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
