// SPDX-License-Identifier: MIT
// What are the moving coefficients at t, and how fast do they move? c_k(t) and dc_k/dt, by the
// homotopy's law.
//
//   straight     c = t f + (1 - t) g          dc = f - g,    evaluated as g + t dc, or as f - (1 -
//                                             t) dc near t = 1
//   toric        c = g e^{-w (1 - t)}         dc = w c        w: the weights of the path, one a
//                                             term of the homotopy
//   framed       as said, times the factor of the term in the path's frame
//   parameters   c = q((1 - t) p + t p')      dc = q_p (p' - p)
//
// The toric exponential is evaluated in double for every scalar. So it is one function of t
// everywhere, and exactly 1 at t = 1. A path needs no more.
// Source: [HuberSturmfels95] for the toric law.
#pragma once

#include <cmath>
#include <span>

#include "moivre/homotopy/program.h"
#include "moivre/numeric/scalar.h"

namespace moivre {

/// In the scalar S. Owns its memory; one per thread.
template <class S>
class MovingCoefficients {
 public:
  using Real = typename Scalar<S>::Real;
  using Program = HomotopyProgram<Real>;

  MovingCoefficients(const Homotopy& homotopy, const Program& program)
      : program_(program), c(program.moving_count()), slope(program.moving.size()) {
    if (homotopy.parameter_law()) parameters_.emplace(*homotopy.parameter_law());
    if (program.law != CoefficientLaw::straight) return;
    for (const typename Program::Moving& moving : program.moving) {
      const S f(moving.f_re, moving.f_im);
      const S g(moving.g_re, moving.g_im);
      lines_.push_back({f, g, f - g});
    }
  }

  /// frame: the path's where the homotopy is framed or of members, else nullptr. Fills `c` of the
  /// values, and `slope`.
  void move(const Time<S>& t, const PathFrame* frame) {
    switch (program_.law) {
      case CoefficientLaw::straight:
        move_straight(t);
        break;
      case CoefficientLaw::toric:
        move_toric(t, frame->weights);
        break;
      case CoefficientLaw::parameters:
        parameters_->evaluate(t, parameters_->law.target(frame), c, slope);
        break;
    }
    if (program_.is_framed) scale(frame->factors);
  }

  /// Fills the rest of `c`, which the Jacobian needs, after move().
  void multiply() {
    for (std::size_t k = 0; k < program_.multiples.size(); ++k) {
      const typename Program::Multiple& multiple = program_.multiples[k];
      c[program_.moving.size() + k] = product(Real(multiple.factor), c[multiple.base]);
    }
  }

 private:
  /// q(p(t)) by a tape of its own.
  struct Parameters {
    explicit Parameters(const ParameterLaw& the_law)
        : law(the_law),
          coefficients(round_coefficients<S>(law.tape, law.coefficients, Scalar<S>::round)),
          p(law.from.size()),
          registers(law.tape.register_count()),
          jacobian(law.tape.jacobian.size()) {}

    void evaluate(const Time<S>& t, const Point& to, std::vector<S>& values,
                  std::vector<S>& rates) {
      for (std::size_t j = 0; j < p.size(); ++j) {
        p[j] = add_product(t.t, S(to[j]), product(t.rest, S(law.from[j])));
      }
      const std::size_t count = rates.size();
      moivre::evaluate<S, S>(law.tape, std::span<const S>(coefficients), std::span<const S>(p),
                             std::span<S>(registers), std::span<S>(values).first(count),
                             std::span<S>(jacobian));
      std::fill(rates.begin(), rates.end(), S(0.0));
      for (std::size_t k = 0; k < jacobian.size(); ++k) {
        const Tape::Entry& entry = law.tape.jacobian[k];
        const S speed = S(to[entry.column]) - S(law.from[entry.column]);
        rates[entry.row] = add_product(jacobian[k], speed, rates[entry.row]);
      }
    }

    const ParameterLaw& law;
    std::vector<S> coefficients, p, registers, jacobian;
  };

  void move_straight(const Time<S>& t) {
    const bool is_near_end = magnitude1(t.rest) < 0.5;
    const S back = -t.rest;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const Line& line = lines_[k];
      c[k] =
          is_near_end ? add_product(back, line.rate, line.f) : add_product(t.t, line.rate, line.g);
      slope[k] = line.rate;
    }
  }

  void scale(const std::vector<double>& factors) {
    for (std::size_t k = 0; k < program_.moving.size(); ++k) {
      const Real factor(factors[program_.moving[k].term]);
      c[k] = product(factor, c[k]);
      slope[k] = product(factor, slope[k]);
    }
  }

  void move_toric(const Time<S>& t, const std::vector<double>& weights) {
    const Complex rest = to_complex(t.rest);
    for (std::size_t k = 0; k < program_.moving.size(); ++k) {
      const typename Program::Moving& moving = program_.moving[k];
      const double w = weights[moving.term];
      const Complex decay = w == 0 ? Complex(1) : std::exp(-w * rest);
      c[k] = product(S(decay), S(moving.g_re, moving.g_im));
      slope[k] = product(Real(w), c[k]);
    }
  }

  /// From g to f.
  struct Line {
    S f, g, rate;
  };

  const Program& program_;
  std::optional<Parameters> parameters_;
  std::vector<Line> lines_;  ///< of the straight law

 public:
  std::vector<S> c;      ///< c_k of all moving coefficients, multiples too
  std::vector<S> slope;  ///< dc_k/dt of those of the values
};

}  // namespace moivre
