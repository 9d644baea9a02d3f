// SPDX-License-Identifier: MIT
// Double first, then Arb's precisions one after the other, until the root is proved and known to be
// real or not.
#include "moivre/certify/certifier.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <string>

#include "arb_stage.h"
#include "double_stage.h"
#include "moivre/certify/distinct.h"
#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/threads.h"
#include "reality.h"
#include "upward.h"

namespace moivre {
namespace {

CertifyOptions checked(CertifyOptions options) {
  if (!(options.accuracy > 0) || !std::isfinite(options.accuracy)) {
    throw InvalidInput("the accuracy of a certificate must be a positive number");
  }
  if (options.most_bits < kDoubleBits || options.most_bits > kMostArbBits) {
    throw InvalidInput("bits of a certificate must lie between " + std::to_string(kDoubleBits) +
                       " and " + std::to_string(kMostArbBits) + ", not " +
                       std::to_string(options.most_bits));
  }
  return options;
}

/// max(1, |x|_inf).
double scale_of(std::span<const Complex> x) {
  double scale = 1;
  for (const Complex& xi : x) scale = std::max(scale, modulus(xi));
  return scale;
}

/// Bound on |x* - x|_inf.
double distance_bound(std::span<const Complex> x, const Certificate& c) {
  double largest = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    double beyond = c.error(j);
    for (const Point& part : c.finer) beyond += size_bound(part[j]);
    // The difference is rounded to a share of itself.
    largest = std::max(largest, raised(raised(size_bound(c.midpoint[j] - x[j])) + raised(beyond)));
  }
  return largest;
}

}  // namespace

class Certifier::Work {
 public:
  Work(std::shared_ptr<const CertifyProgram> program, CertifyOptions options)
      : program_(std::move(program)), options_(checked(options)), double_stage_(*program_) {}

  std::size_t dimension() const { return program_->dimension(); }
  int most_bits() const { return options_.most_bits; }

  void certify(std::span<const Complex> x, std::span<const Enclosure> given, Certificate& result) {
    require_dimension(x.size(), given.size());
    result.verdict = Verdict::undecided;
    result.reality = Reality::unknown;
    result.bits = kDoubleBits;
    if (double_stage_.prove(x, given, options_.accuracy, result)) {
      judge(x, result);
      if (is_settled(x, result)) return;
    }
    const double farthest = 2 * options_.accuracy * scale_of(x);
    int most_bits = options_.most_bits;
    for (int bits = kFirstArbBits; bits <= most_bits; bits *= 2) {
      Certificate finer;
      const ArbOutcome outcome = arb().prove(x, {}, given, bits, farthest, finer);
      if (outcome == ArbOutcome::proved) {
        // Discs of given numbers stay as wide as they are, whatever the digits.
        if (result.holds_root() && finer.sizes.largest_error() >= result.sizes.largest_error())
          return;
        judge(x, finer);
        result = std::move(finer);
        if (is_settled(x, result)) return;
      } else if (!result.holds_root()) {
        result.bits = bits;
      }
      if (outcome == ArbOutcome::left) return;
      if (outcome == ArbOutcome::converged) {
        most_bits = std::max(most_bits, std::min(2 * bits, kMostArbBits));
      }
    }
  }

  Certificate certify_near(std::span<const Complex> x, std::span<const Point> finer, int bits) {
    require_dimension(x.size(), 0);
    Certificate result;
    const double farthest = options_.accuracy * scale_of(x);
    if (arb().prove(x, finer, {}, bits, farthest, result) != ArbOutcome::proved) return {};
    judge(x, result);
    return result;
  }

  bool sharpen(Certificate& certificate, std::span<const Enclosure> given, int bits) {
    require_dimension(certificate.midpoint.size(), given.size());
    if (!certificate.holds_root()) throw InvalidInput("no root is proved to sharpen");
    Certificate finer;
    const double farthest = certificate.sizes.largest_radius();
    const std::vector<Point> beyond(certificate.finer.begin(), certificate.finer.end());
    if (arb().prove(certificate.midpoint, beyond, given, bits, farthest, finer) !=
        ArbOutcome::proved) {
      return false;
    }
    finer.verdict = certificate.verdict;
    if (relation(finer, certificate) != Relation::same) return false;
    finer.reality = reality_of(finer, program_->real);
    if (finer.reality == Reality::unknown) finer.reality = certificate.reality;
    certificate = std::move(finer);
    return true;
  }

 private:
  void require_dimension(std::size_t n, std::size_t given) const {
    if (n != dimension()) {
      throw InvalidInput("a point has " + counted(n, "coordinate") + ", the system " +
                         counted(dimension(), "unknown"));
    }
    if (given != program_->given) {
      throw InvalidInput(counted(given, "number") + " are given, the system has " +
                         std::to_string(program_->given));
    }
  }

  ArbStage& arb() {
    if (!arb_stage_) arb_stage_.emplace(*program_);
    return *arb_stage_;
  }

  void judge(std::span<const Complex> x, Certificate& result) const {
    const bool near = distance_bound(x, result) <= options_.accuracy * scale_of(x);
    result.verdict = near ? Verdict::certified : Verdict::elsewhere;
    result.reality = reality_of(result, program_->real);
  }

  /// More bits tell nothing new: the ball is small enough for its place to be told, and reality is
  /// known where it is asked for.
  bool is_settled(std::span<const Complex> x, const Certificate& result) const {
    if (result.sizes.largest_error() > options_.accuracy * scale_of(x)) return false;
    return !options_.decide_reality || !program_->real || result.reality != Reality::unknown;
  }

  std::shared_ptr<const CertifyProgram> program_;
  CertifyOptions options_;
  DoubleStage double_stage_;
  std::optional<ArbStage> arb_stage_;
};

Certifier::Certifier(std::shared_ptr<const CertifyProgram> program, CertifyOptions options)
    : work_(std::make_unique<Work>(std::move(program), options)) {}
Certifier::Certifier(Certifier&&) noexcept = default;
Certifier& Certifier::operator=(Certifier&&) noexcept = default;
Certifier::~Certifier() = default;

std::size_t Certifier::dimension() const noexcept { return work_->dimension(); }
int Certifier::most_bits() const noexcept { return work_->most_bits(); }

void Certifier::certify(std::span<const Complex> x, Certificate& result,
                        std::span<const Enclosure> given) {
  work_->certify(x, given, result);
}

Certificate Certifier::certify(std::span<const Complex> x, std::span<const Enclosure> given) {
  Certificate result;
  work_->certify(x, given, result);
  return result;
}

Certificate Certifier::certify_near(std::span<const Complex> x, std::span<const Point> finer,
                                    int bits) {
  return work_->certify_near(x, finer, bits);
}

bool Certifier::sharpen(Certificate& certificate, int bits, std::span<const Enclosure> given) {
  return work_->sharpen(certificate, given, bits);
}

Enclosure enclosure(const Certificate& certificate, std::size_t j) {
  Enclosure result{certificate.midpoint[j], {}, certificate.error(j)};
  for (const Point& part : certificate.finer) result.finer.push_back(part[j]);
  return result;
}

std::optional<Certificate> about(const Certificate& certificate, const Point& x) {
  if (!certificate.finer.empty()) return std::nullopt;
  Certificate result = certificate;
  result.midpoint = x;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j] == certificate.midpoint[j]) continue;
    const double moved = size_bound(x[j] - certificate.midpoint[j]);
    // What is lost in rounding is added to what is taken away.
    const double radius = certificate.radius(j);
    result.sizes.set(j, std::max(0.0, radius - raised(raised(radius) - radius + moved)),
                     raised(certificate.error(j) + moved));
    if (!(result.error(j) < result.radius(j))) return std::nullopt;
  }
  return result;
}

std::vector<Certificate> certify(const System& f, const std::vector<Point>& points,
                                 const CertifyOptions& options, int threads,
                                 const std::atomic<bool>& stop) {
  const auto program = make_certify_program(f);
  checked(options);
  for (const Point& x : points) {
    if (x.size() == program->dimension()) continue;
    throw InvalidInput("a point has " + counted(x.size(), "coordinate") + ", the system " +
                       counted(program->dimension(), "unknown"));
  }
  std::vector<Certificate> certificates(points.size());
  const auto workers = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)), 1,
                                               std::max<std::size_t>(points.size(), 1));
  std::atomic<std::size_t> next = 0;
  on_threads(static_cast<int>(workers), [&] {
    Certifier certifier(program, options);
    for (std::size_t k = next++; k < points.size() && !stop; k = next++) {
      certifier.certify(points[k], certificates[k]);
    }
  });
  return certificates;
}

}  // namespace moivre
