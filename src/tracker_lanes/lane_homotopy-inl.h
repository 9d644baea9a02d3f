// SPDX-License-Identifier: MIT
// What are H, H_x and H_t of W points at once, each at its own t? The program of a homotopy, over
// lanes.
//
//   Coefficients that stand still are the same in all lanes and are broadcast: a real one costs
//   half of a complex one, so terms with real and complex coefficients are kept apart. Those that
//   move are every lane's own (lane_moving-inl.h).
//   H_x is summed over registers that t and 1 - t have been multiplied into, where these are fewer
//   than its entries.
//   expand(): H(x + dx s, t + dt s) to first order in s: its value and its derivative along the
//   direction (dx, dt).
//
// R: the scalar. x: N, H, H_t: n, H_x: n x N into the rows of a LaneLu. move() comes before the
// others wherever t changes.
// Owns its registers, allocates nothing after construction.
// Source: [GriewankWalther08, ch. 13] for the truncated series.
#if defined(MOIVRE_LANE_HOMOTOPY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_HOMOTOPY_INL_H_
#undef MOIVRE_LANE_HOMOTOPY_INL_H_
#else
#define MOIVRE_LANE_HOMOTOPY_INL_H_
#endif

#include "lane_complex-inl.h"
#include "lane_lu-inl.h"
#include "lane_moving-inl.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

template <class R>
class LaneHomotopy {
 public:
  using Program = HomotopyProgram<typename LaneScalar<R>::Real>;

  LaneHomotopy(const Homotopy& homotopy, const Program& program)
      : program_(program),
        moving_(homotopy, program),
        registers_(program.register_count),
        slopes_(program.register_count),
        weighted_(program.weighted_count()) {}

  /// Of the path in `lane`, where the homotopy is framed.
  void set_frame(std::size_t lane, const FramePointer& frame) { moving_.set_frame(lane, frame); }

  /// Takes the coefficients to the times given.
  void move(const LaneTime<R>& time) { moving_.move(time); }

  /// h <- H, rows 0..n-1 of j <- H_x, ht <- H_t.
  void linearize(const LaneVector<R>& x, const LaneTime<R>& time, LaneVector<R>& h, LaneLu<R>& j,
                 LaneVector<R>& ht) {
    begin(x, program_.products.size());
    const LaneComplex<R> t = time.t();
    const LaneComplex<R> rest = time.rest();
    for (std::size_t i = 0; i < program_.values.size(); ++i) {
      const typename Program::Blend& value = program_.values[i];
      const LaneComplex<R> f = sum(value.f, registers_);
      const LaneComplex<R> g = sum(value.g, registers_);
      LaneComplex<R> total = add_product(t, f, rest * g);
      LaneComplex<R> rate = f - g;
      for (std::uint32_t k = value.moving_begin; k < value.moving_end; ++k) {
        const typename Program::MovingTerm& term = program_.moving_terms[k];
        const LaneComplex<R> r = load(registers_[term.monomial]);
        total = add_product(load(moving_.c()[term.coefficient]), r, total);
        rate = add_product(load(moving_.slope()[term.coefficient]), r, rate);
      }
      store(total, h[i]);
      store(rate, ht[i]);
    }
    if (program_.has_weighted_registers()) {
      sum_weighted(t, rest, j);
    } else {
      sum_blends(t, rest, j);
    }
    for (const typename Program::Position& p : program_.zeros)
      store(zero<R>(), j.at(p.row, p.column));
  }

  /// h <- H(x, t), slope <- H_x dx + H_t dt.
  void expand(const LaneVector<R>& x, const LaneVector<R>& dx, const LaneTime<R>& time,
              LaneVector<R>& h, LaneVector<R>& slope) {
    begin(x, dx);
    const LaneComplex<R> t = time.t();
    const LaneComplex<R> rest = time.rest();
    const LaneComplex<R> dt = time.dt();
    for (std::size_t i = 0; i < program_.values.size(); ++i) {
      const typename Program::Blend& value = program_.values[i];
      const Series f = sum_series(value.f);
      const Series g = sum_series(value.g);
      LaneComplex<R> total = add_product(t, f.value, rest * g.value);
      LaneComplex<R> direction = add_product(t, f.slope, rest * g.slope);
      LaneComplex<R> rate = f.value - g.value;
      for (std::uint32_t k = value.moving_begin; k < value.moving_end; ++k) {
        const typename Program::MovingTerm& term = program_.moving_terms[k];
        const LaneComplex<R> c = load(moving_.c()[term.coefficient]);
        const LaneComplex<R> r = load(registers_[term.monomial]);
        total = add_product(c, r, total);
        direction = add_product(c, load(slopes_[term.monomial]), direction);
        rate = add_product(load(moving_.slope()[term.coefficient]), r, rate);
      }
      store(total, h[i]);
      store(add_product(dt, rate, direction), slope[i]);
    }
  }

 private:
  void begin(const LaneVector<R>& x, std::size_t products) {
    const std::size_t n = program_.variables;
    for (std::size_t i = 0; i < n; ++i) store(load(x[i]), registers_[i]);
    store(one<R>(), registers_[n]);
    LaneCell<R>* next = &registers_[n + 1];
    for (std::size_t k = 0; k < products; ++k, ++next) {
      const Tape::Product& p = program_.products[k];
      store(load(registers_[p.a]) * load(registers_[p.b]), *next);
    }
  }

  void begin(const LaneVector<R>& x, const LaneVector<R>& dx) {
    const std::size_t n = program_.variables;
    for (std::size_t i = 0; i < n; ++i) {
      store(load(x[i]), registers_[i]);
      store(load(dx[i]), slopes_[i]);
    }
    store(one<R>(), registers_[n]);
    store(zero<R>(), slopes_[n]);
    LaneCell<R>* next = &registers_[n + 1];
    LaneCell<R>* next_slope = &slopes_[n + 1];
    for (std::size_t k = 0; k < program_.value_products; ++k, ++next, ++next_slope) {
      const Tape::Product& p = program_.products[k];
      const LaneComplex<R> a = load(registers_[p.a]);
      const LaneComplex<R> b = load(registers_[p.b]);
      store(a * b, *next);
      store(add_product(a, load(slopes_[p.b]), load(slopes_[p.a]) * b), *next_slope);
    }
  }

  void sum_weighted(const LaneComplex<R>& t, const LaneComplex<R>& rest, LaneLu<R>& j) {
    LaneCell<R>* next = &weighted_[0];
    for (const std::uint32_t r : program_.by_t) store(t * load(registers_[r]), *next++);
    for (const std::uint32_t r : program_.by_rest) store(rest * load(registers_[r]), *next++);
    for (const typename Program::Entry& entry : program_.jacobian) {
      store(add_moving(entry.blend, sum(entry.blend.f, weighted_)), j.at(entry.row, entry.column));
    }
  }

  void sum_blends(const LaneComplex<R>& t, const LaneComplex<R>& rest, LaneLu<R>& j) {
    for (const typename Program::Entry& entry : program_.jacobian) {
      LaneComplex<R> value = zero<R>();
      if (!entry.blend.f.is_empty()) value = t * sum(entry.blend.f, registers_);
      if (!entry.blend.g.is_empty()) {
        value = add_product(rest, sum(entry.blend.g, registers_), value);
      }
      store(add_moving(entry.blend, value), j.at(entry.row, entry.column));
    }
  }

  LaneComplex<R> add_moving(const typename Program::Blend& blend, LaneComplex<R> total) const {
    for (std::uint32_t k = blend.moving_begin; k < blend.moving_end; ++k) {
      const typename Program::MovingTerm& term = program_.moving_terms[k];
      total =
          add_product(load(moving_.c()[term.coefficient]), load(registers_[term.monomial]), total);
    }
    return total;
  }

  LaneComplex<R> sum(const typename Program::Sum& terms, const LaneVector<R>& r) const {
    LaneComplex<R> total = zero<R>();
    for (std::uint32_t k = terms.real_begin; k < terms.real_end; ++k) {
      const typename Program::RealTerm& term = program_.real_terms[k];
      total = add_product(LaneScalar<R>::spread(term.c), load(r[term.monomial]), total);
    }
    for (std::uint32_t k = terms.complex_begin; k < terms.complex_end; ++k) {
      const typename Program::ComplexTerm& term = program_.complex_terms[k];
      const LaneComplex<R> c{LaneScalar<R>::spread(term.re), LaneScalar<R>::spread(term.im)};
      total = add_product(c, load(r[term.monomial]), total);
    }
    return total;
  }

  /// The first two terms of a series in s.
  struct Series {
    LaneComplex<R> value, slope;
  };
  Series sum_series(const typename Program::Sum& terms) const {
    Series total{zero<R>(), zero<R>()};
    for (std::uint32_t k = terms.real_begin; k < terms.real_end; ++k) {
      const typename Program::RealTerm& term = program_.real_terms[k];
      total.value =
          add_product(LaneScalar<R>::spread(term.c), load(registers_[term.monomial]), total.value);
      total.slope =
          add_product(LaneScalar<R>::spread(term.c), load(slopes_[term.monomial]), total.slope);
    }
    for (std::uint32_t k = terms.complex_begin; k < terms.complex_end; ++k) {
      const typename Program::ComplexTerm& term = program_.complex_terms[k];
      const LaneComplex<R> c{LaneScalar<R>::spread(term.re), LaneScalar<R>::spread(term.im)};
      total.value = add_product(c, load(registers_[term.monomial]), total.value);
      total.slope = add_product(c, load(slopes_[term.monomial]), total.slope);
    }
    return total;
  }

  const Program& program_;
  LaneMoving<R> moving_;
  LaneVector<R> registers_;
  LaneVector<R> slopes_;    // of the registers along the direction
  LaneVector<R> weighted_;  // registers times t or 1 - t
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
