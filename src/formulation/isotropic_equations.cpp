// SPDX-License-Identifier: MIT
// Typed equations as polynomials: cosines and sines of whole multiples of angles become powers of t
// and u.
#include <algorithm>
#include <cmath>
#include <map>

#include "isotropic_frame.h"
#include "moivre/mechanism/jet.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

// Powers beyond this are refused: the number of paths would leave every bound.
constexpr double kLargestPower = 64;

/// offset + sum_k multiple_k * angle_k.
struct LinearAngle {
  std::map<std::size_t, double> multiples;
  double offset = 0;
  double size = 0;  ///< of the numbers that it was added up from
};

bool has_unknowns(const Polynomial& p) {
  return std::any_of(p.terms.begin(), p.terms.end(), [](const Term& term) {
    return std::any_of(term.monomial.begin(), term.monomial.end(),
                       [](const Power& power) { return power.variable < kFirstFactor; });
  });
}

bool is_number(const Formula& f) { return unknowns_of(f).empty(); }

class Equations {
 public:
  Equations(const Mechanism& mechanism, double t, bool has_factors = false)
      : mechanism_(mechanism), t_(t), frame_(names(mechanism), has_factors) {}

  Formulation build() && {
    write();
    return std::move(frame_.result());
  }

  EnclosedPolynomials enclosed(const Formulation& formulation) && {
    write();
    return with_factors(formulation, frame_);
  }

 private:
  void write() {
    hold_angles();
    add_unknowns();
    add_length_drivers();
    for (const Equation& equation : mechanism_.equations) {
      equation_ = equation.name;
      frame_.add_equation(equation.name, polynomial(equation.formula));
    }
  }

  static std::vector<std::string> names(const Mechanism& mechanism) {
    std::vector<std::string> names;
    for (const Unknown& unknown : mechanism.unknowns) names.push_back(unknown.name);
    return names;
  }

  // Lengths take part as nodes of the angle classes too; held at the ground they have no t and u.
  void hold_angles() {
    for (std::size_t k = 0; k < mechanism_.unknowns.size(); ++k) {
      if (!mechanism_.unknowns[k].is_angle) frame_.hold_angle(0, k + 1, {}, "");
    }
    for (const Driver& driver : mechanism_.drivers) {
      if (!mechanism_.unknowns[driver.unknown].is_angle) continue;
      frame_.hold_angle(0, driver.unknown + 1,
                        unit_at(driven_angle(driver.law, t_, mechanism_.units)),
                        "driver " + driver.name);
    }
  }

  void add_unknowns() {
    using Part = Formulation::Reading::Part;
    frame_.add_angles();
    for (std::size_t k = 0; k < mechanism_.unknowns.size(); ++k) {
      const Unknown& unknown = mechanism_.unknowns[k];
      lengths_.push_back(unknown.is_angle
                             ? constant({0, 0})
                             : frame_.add_unknown(unknown.name, false, {unknown.name}));
      frame_.result().coordinates.push_back(
          unknown.is_angle ? Formulation::Reading{Part::argument, frame_.t(k + 1).z}
                           : Formulation::Reading{Part::re, lengths_.back()});
    }
  }

  void add_length_drivers() {
    for (const Driver& driver : mechanism_.drivers) {
      if (mechanism_.unknowns[driver.unknown].is_angle) continue;
      const EnclosedNumber value = driven_length(driver.law, t_);
      frame_.add_equation("driver " + driver.name, lengths_[driver.unknown] - frame_.number(value));
    }
  }

  Polynomial polynomial(const Formula& f) {
    const Coefficient half{Rational(1, 2), 0};
    switch (f.kind) {
      case Formula::Kind::constant:
        return frame_.number(typed(f.value));
      case Formula::Kind::time:
        return constant({typed_decimal(t_), 0});
      case Formula::Kind::unknown:
        if (!mechanism_.unknowns[f.index].is_angle) return lengths_[f.index];
        refuse("the angle " + mechanism_.unknowns[f.index].name + " stands outside cos and sin");
      case Formula::Kind::sum: {
        Polynomial sum;
        for (const Formula& operand : f.operands) sum = sum + polynomial(operand);
        return sum;
      }
      case Formula::Kind::product: {
        Polynomial product = constant({1, 0});
        for (const Formula& operand : f.operands) product = product * polynomial(operand);
        return product;
      }
      case Formula::Kind::negate:
        return Coefficient{-1, 0} * polynomial(f.operands[0]);
      case Formula::Kind::reciprocal: {
        const Polynomial divisor = polynomial(f.operands[0]);
        if (!is_number(f.operands[0])) {
          if (divisor.terms.empty()) refuse("it divides by zero");
          if (has_unknowns(divisor)) {
            refuse("it divides by unknowns; multiply the equation by them");
          }
        }
        return inverse(divisor);
      }
      case Formula::Kind::power:
        if (!is_number(f) || is_whole_power(f)) return powered(f);
        break;
      case Formula::Kind::cos:
      case Formula::Kind::sin: {
        const Mirrored e = unit(f.operands[0]);
        return f.kind == Formula::Kind::cos ? half * (e.z + e.conjugate)
                                            : Coefficient{0, Rational(-1, 2)} * (e.z - e.conjugate);
      }
      case Formula::Kind::tan:
      case Formula::Kind::asin:
      case Formula::Kind::acos:
      case Formula::Kind::atan:
      case Formula::Kind::sqrt:
      case Formula::Kind::exp:
      case Formula::Kind::log:
        if (!is_number(f)) refuse("tan, asin, acos, atan, sqrt, exp and log stand over unknowns");
        break;
    }
    return frame_.number(computed(f));
  }

  /// Of a number, which may have factors.
  Polynomial inverse(const Polynomial& divisor) {
    Coefficient c;
    double error = 0;
    for (const Term& term : divisor.terms) c = c + term.coefficient;
    if (c == Coefficient{}) refuse("it divides by zero");
    for (const Term& term : divisor.terms) {
      double of_factors = 0;
      for (const Power& power : term.monomial) {
        of_factors += power.exponent * frame_.factor_errors()[power.variable - kFirstFactor];
      }
      error += of_factors * std::abs(to_complex(term.coefficient)) / std::abs(to_complex(c));
    }
    constexpr double kSecondOrder = 2;
    return frame_.enclosed(constant(Coefficient{1, 0} / c), kSecondOrder * error);
  }

  /// A constant part in which there is more than sums, products and quotients.
  EnclosedNumber computed(const Formula& f) const {
    const Magnitude value = evaluate<Magnitude>(f, {}, Magnitude(t_));
    if (!std::isfinite(value.f)) refuse("a constant part of it is not defined");
    return {typed_decimal(value.f), kComputed * value.sum};
  }

  /// A small whole power of a number, which is taken exactly.
  bool is_whole_power(const Formula& f) const {
    const Formula& exponent = f.operands[1];
    if (!is_number(exponent)) return false;
    const double p = number(exponent);
    return p >= 0 && p <= kLargestPower && p == std::floor(p);
  }

  Polynomial powered(const Formula& f) {
    const Formula& exponent = f.operands[1];
    const double p = is_number(exponent) ? number(exponent) : -1;
    if (!(p >= 0 && p <= kLargestPower) || p != std::floor(p)) {
      refuse("an exponent over unknowns must be a whole number from 0 to 64");
    }
    return power(polynomial(f.operands[0]), static_cast<int>(p));
  }

  /// exp(i angle) and its conjugate.
  Mirrored unit(const Formula& angle) {
    // Thirds and the like, multiplied back, miss whole numbers by rounding.
    constexpr double kWhole = 1e-12;
    const LinearAngle parts = linear(angle);
    const EnclosedUnit c = unit_at(offset_of(parts));
    const Mirrored turn{constant(c.value), constant(conjugate(c.value))};
    Mirrored product = frame_.enclosed(turn, c.error);
    for (const auto& [index, multiple] : parts.multiples) {
      const double whole = std::nearbyint(multiple);
      const std::string& name = mechanism_.unknowns[index].name;
      if (std::abs(multiple - whole) > kWhole) {
        refuse("the angle " + name + " is multiplied by a number that is not whole");
      }
      if (std::abs(whole) > kLargestPower)
        refuse("the angle " + name + " is multiplied by too much");
      const Mirrored t = whole < 0 ? swapped(frame_.t(index + 1)) : frame_.t(index + 1);
      const int count = static_cast<int>(std::abs(whole));
      product = product * Mirrored{power(t.z, count), power(t.conjugate, count)};
    }
    return product;
  }

  ExactAngle offset_of(const LinearAngle& angle) const {
    if (!std::isfinite(angle.size)) refuse("a constant part of it is not defined");
    if (angle.offset == 0 && angle.size == 0) return {};
    return {{}, Rational(angle.offset), kComputed * angle.size};
  }

  LinearAngle linear(const Formula& f) const {
    if (is_number(f)) {
      const Magnitude value = evaluate<Magnitude>(f, {}, Magnitude(t_));
      return {{}, value.f, value.sum};
    }
    if (f.kind == Formula::Kind::unknown) {
      if (!mechanism_.unknowns[f.index].is_angle) {
        refuse("the length " + mechanism_.unknowns[f.index].name + " stands inside cos or sin");
      }
      return {{{f.index, 1.0}}, 0, 0};
    }
    LinearAngle total;
    const auto add = [&total](const LinearAngle& part, double factor) {
      total.offset += factor * part.offset;
      total.size += std::abs(factor) * part.size;
      for (const auto& [index, multiple] : part.multiples) {
        total.multiples[index] += factor * multiple;
      }
    };
    if (f.kind == Formula::Kind::sum) {
      for (const Formula& operand : f.operands) add(linear(operand), 1);
      return total;
    }
    if (f.kind == Formula::Kind::negate) {
      add(linear(f.operands[0]), -1);
      return total;
    }
    if (f.kind == Formula::Kind::product) {
      double factor = 1;
      const Formula* angle = nullptr;
      for (const Formula& operand : f.operands) {
        if (is_number(operand)) {
          factor *= number(operand);
        } else if (angle == nullptr) {
          angle = &operand;
        } else {
          refuse("a product of unknowns stands inside cos or sin");
        }
      }
      add(linear(*angle), factor);
      return total;
    }
    refuse("inside cos and sin there may be sums of whole multiples of angles only");
  }

  double number(const Formula& f) const { return evaluate<Jet>(f, {}, Jet(t_)).f; }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw InvalidInput("equation " + equation_ + " is no polynomial: " + reason +
                       "; newton, mobility and motion take it as it is");
  }

  const Mechanism& mechanism_;
  double t_;
  IsotropicFrame frame_;
  std::vector<Polynomial> lengths_;  ///< of each unknown that is one
  std::string equation_;             ///< name of the one at work
};

}  // namespace

Formulation isotropic_equations(const Mechanism& mechanism, double t) {
  Formulation formulation = Equations(mechanism, t).build();
  formulation.enclosed = [mechanism, t, plain = formulation] {
    return Equations(mechanism, t, true).enclosed(plain);
  };
  return formulation;
}

}  // namespace moivre
