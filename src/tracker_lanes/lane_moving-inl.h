// SPDX-License-Identifier: MIT
// What are the moving coefficients of W paths, each at its own t? As homotopy/moving.h, over lanes.
//
//   straight     of two ends broadcast to all lanes
//   toric        by Highway's exponential where t is real in all lanes; every lane has weights of
//                its own
//   parameters   p(t), and the polynomials q_k of it with their rates as truncated series
//                (lane_parameters-inl.h); every lane may have a member of its own to go to
//   else         lane by lane, in the scalar of one lane
//
// R: the scalar. Owns its memory, allocates nothing after construction.
#if defined(MOIVRE_LANE_MOVING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_MOVING_INL_H_
#undef MOIVRE_LANE_MOVING_INL_H_
#else
#define MOIVRE_LANE_MOVING_INL_H_
#endif

#include <hwy/contrib/math/math-inl.h>

#include <array>
#include <optional>
#include <vector>

#include "lane_complex-inl.h"
#include "lane_parameters-inl.h"
#include "moivre/homotopy/moving.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

/// t, 1 - t and dt/ds of every lane.
template <class R>
struct LaneTime {
  using Number = typename LaneScalar<R>::Number;

  LaneTime() : values(3) {}
  LaneComplex<R> t() const { return load(values[0]); }
  LaneComplex<R> rest() const { return load(values[1]); }
  LaneComplex<R> dt() const { return load(values[2]); }
  void set(std::size_t lane, const Time<Number>& time, Complex dt) {
    values.set(0, lane, time.t);
    values.set(1, lane, time.rest);
    values.set(2, lane, dt);
  }
  Time<Number> get(std::size_t lane) const { return {values.get(0, lane), values.get(1, lane)}; }

  LaneVector<R> values;
};

template <class R>
class LaneMoving {
 public:
  using Number = typename LaneScalar<R>::Number;
  using Program = HomotopyProgram<typename LaneScalar<R>::Real>;

  LaneMoving(const Homotopy& homotopy, const Program& program)
      : program_(program),
        scalar_(homotopy, program),
        c_(program.moving_count()),
        slope_(program.moving.size()) {
    if (program.is_framed) {
      factors_.resize(program.moving.size());
      weights_.resize(program.moving.size());
    }
    if (homotopy.parameter_law()) parameters_.emplace(*homotopy.parameter_law());
    if (program.law != CoefficientLaw::straight) return;
    for (std::size_t k = 0; k < program.moving.size(); ++k) {
      store(f(program.moving[k]) - g(program.moving[k]), slope_[k]);
    }
  }

  /// Of the path in `lane`.
  void set_frame(std::size_t lane, const FramePointer& frame) {
    if (parameters_) parameters_->set_target(lane, frame.get());
    if (!program_.is_framed) return;
    frames_[lane] = frame;
    for (std::size_t k = 0; k < program_.moving.size(); ++k) {
      const typename Program::Moving& moving = program_.moving[k];
      factors_[k].at[lane] = frame->factors[moving.term];
      if (!frame->weights.empty()) weights_[k].at[lane] = frame->weights[moving.term];
    }
    if (program_.law != CoefficientLaw::straight) return;
    for (std::size_t k = 0; k < program_.moving.size(); ++k) {
      const typename Program::Moving& moving = program_.moving[k];
      store(factors_[k].value() * (f(moving) - g(moving)), slope_[k]);
    }
  }

  void move(const LaneTime<R>& time) {
    if (program_.stands_still()) return;
    switch (program_.law) {
      case CoefficientLaw::straight:
        move_straight(time);
        break;
      case CoefficientLaw::toric:
        if (!is_real(time)) return move_each(time);
        move_toric(time);
        break;
      case CoefficientLaw::parameters:
        parameters_->move(time.t(), time.rest(), c_, slope_);
        break;
    }
    for (std::size_t k = 0; k < program_.multiples.size(); ++k) {
      const typename Program::Multiple& multiple = program_.multiples[k];
      store(broadcast(multiple.factor) * load(c_[multiple.base]), c_[program_.moving.size() + k]);
    }
  }

  const LaneVector<R>& c() const { return c_; }
  const LaneVector<R>& slope() const { return slope_; }

 private:
  static LaneComplex<R> f(const typename Program::Moving& moving) {
    return {LaneScalar<R>::spread(moving.f_re), LaneScalar<R>::spread(moving.f_im)};
  }
  static LaneComplex<R> g(const typename Program::Moving& moving) {
    return {LaneScalar<R>::spread(moving.g_re), LaneScalar<R>::spread(moving.g_im)};
  }

  static bool is_real(const LaneTime<R>& time) {
    const LaneCell<R>& rest = time.values[1];
    bool result = true;
    for (std::size_t lane = 0; lane < W; ++lane) {
      result &= to_complex(take(rest, lane)).imag() == 0;
    }
    return result;
  }

  void move_straight(const LaneTime<R>& time) {
    const LaneComplex<R> t = time.t();
    const LaneComplex<R> rest = time.rest();
    for (std::size_t k = 0; k < program_.moving.size(); ++k) {
      const typename Program::Moving& moving = program_.moving[k];
      const LaneComplex<R> c = add_product(t, f(moving), rest * g(moving));
      store(program_.is_framed ? factors_[k].value() * c : c, c_[k]);
    }
  }

  void move_toric(const LaneTime<R>& time) {
    const V rest = rounded(time.rest().re);
    for (std::size_t k = 0; k < program_.moving.size(); ++k) {
      const V w = weights_[k].value();
      const V decay = hn::Exp(Tag(), -(w * rest));
      const LaneComplex<R> c = (factors_[k].value() * decay) * g(program_.moving[k]);
      store(c, c_[k]);
      store(w * c, slope_[k]);
    }
  }

  void move_each(const LaneTime<R>& time) {
    for (std::size_t lane = 0; lane < W; ++lane) {
      if (program_.is_framed && !frames_[lane]) continue;  // idle
      scalar_.move(time.get(lane), frames_[lane].get());
      for (std::size_t k = 0; k < program_.moving.size(); ++k) {
        c_.set(k, lane, scalar_.c[k]);
        slope_.set(k, lane, scalar_.slope[k]);
      }
    }
  }

  const Program& program_;
  MovingCoefficients<Number> scalar_;
  LaneVector<R> c_;
  LaneVector<R> slope_;
  std::vector<LaneReals> factors_;  // of the moving coefficients
  std::vector<LaneReals> weights_;
  std::array<FramePointer, W> frames_;
  std::optional<LaneParameters<R>> parameters_;
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
