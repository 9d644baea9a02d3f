// SPDX-License-Identifier: MIT
// What does a certificate cost? Microseconds a root, in double and in more digits, and how many
// roots each proves.
//
//   bench_certify FILE...    one thread; roots: Newton's method from random points, then what
//                            double leaves of them
//
// The roots are brought to double by Newton's method and moved by some of the last digits, as a
// tracker leaves them. A root that is found more than once counts each time. CPU time, the fastest
// of a few rounds.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>

#include "moivre/certify/certifier.h"
#include "moivre/certify/distinct.h"
#include "moivre/factorization/lu.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/read.h"
#include "moivre/polynomial/tape.h"

namespace moivre {
namespace {

constexpr std::size_t kRoots = 200;
constexpr std::size_t kMostStarts = 4000;
constexpr int kNewtonIterations = 60;
constexpr int kRounds = 5;             // the fastest counts: others were disturbed
constexpr double kEndError = 0x1p-46;  // of a tracker, relative
constexpr double kConverged = 0x1p-48;
constexpr std::uint64_t kSeed = 1;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Newton's method in double; false where it does not converge.
bool find_root(const Tape& tape, const std::vector<Complex>& c, Point& x) {
  const std::size_t n = x.size();
  std::vector<Complex> registers(tape.register_count()), f(n), jacobian(tape.jacobian.size());
  Lu lu(n);
  for (int k = 0; k < kNewtonIterations; ++k) {
    evaluate<Complex, Complex>(tape, c, x, registers, f, jacobian);
    std::fill(lu.matrix().begin(), lu.matrix().end(), Complex(0));
    for (std::size_t s = 0; s < jacobian.size(); ++s) {
      lu.matrix()[tape.jacobian[s].row * n + tape.jacobian[s].column] = jacobian[s];
    }
    if (!lu.factor()) return false;
    lu.solve(f);
    for (std::size_t j = 0; j < n; ++j) x[j] -= f[j];
    if (max_norm(f) <= kConverged * max_norm(x)) return true;
  }
  return false;
}

std::vector<Point> some_roots(const System& f) {
  const Tape tape = make_tape(f);
  const std::vector<Complex> c = complex_coefficients(tape, f);
  const std::size_t n = f.variables.size();
  std::vector<Point> roots;
  std::uint64_t next = 0;
  const auto unit = [&] { return random_unit(kSeed, RandomStream::test, next++); };
  for (std::size_t start = 0; start < kMostStarts && roots.size() < kRoots; ++start) {
    Point x;
    for (std::size_t j = 0; j < n; ++j) x.emplace_back(2 * unit() - 1, 2 * unit() - 1);
    if (!find_root(tape, c, x)) continue;
    for (Complex& xj : x) xj *= 1 + kEndError * (2 * unit() - 1);
    roots.push_back(x);
  }
  return roots;
}

struct Measured {
  double microseconds = 0;  ///< a root
  std::size_t certified = 0, real = 0, not_real = 0;
  int bits = 0;  ///< the most that were needed
  std::vector<Certificate> certificates;
};

Measured measure(const System& f, const std::vector<Point>& roots, int most_bits) {
  CertifyOptions options;
  options.most_bits = most_bits;
  Certifier certifier(make_certify_program(f), options);
  Measured m;
  m.certificates.resize(roots.size());
  m.microseconds = HUGE_VAL;
  for (int round = 0; round < kRounds; ++round) {
    const double begin = cpu_seconds();
    for (std::size_t k = 0; k < roots.size(); ++k) certifier.certify(roots[k], m.certificates[k]);
    const double seconds = cpu_seconds() - begin;
    m.microseconds = std::min(m.microseconds, 1e6 * seconds / static_cast<double>(roots.size()));
  }
  for (const Certificate& c : m.certificates) {
    m.certified += c.verdict == Verdict::certified;
    m.real += c.reality == Reality::real;
    m.not_real += c.reality == Reality::not_real;
    m.bits = std::max(m.bits, c.bits);
  }
  return m;
}

void print(const char* file, const char* kind, std::size_t roots, const Measured& m) {
  std::printf("%-36s %-7s %6zu %9zu %6zu %8zu %5d %10.1f\n", file, kind, roots, m.certified, m.real,
              m.not_real, m.bits, m.microseconds);
}

void run(const char* file) {
  const System f = read_system(read_source(file));
  const std::vector<Point> roots = some_roots(f);
  if (roots.empty()) {
    std::printf("%-36s no root found\n", file);
    return;
  }
  print(file, "double", roots.size(), measure(f, roots, kDoubleBits));
  Measured all = measure(f, roots, kMostArbBits);
  print(file, "all", roots.size(), all);
  Certifier certifier(make_certify_program(f));
  const double begin = cpu_seconds();
  const Distinctness found = tell_apart(certifier, all.certificates);
  std::printf("    %zu different roots, %zu pairs in doubt, %.1f us a root\n", found.distinct_roots,
              found.doubtful.size(),
              1e6 * (cpu_seconds() - begin) / static_cast<double>(roots.size()));
  for (Certificate& c : all.certificates) c.bits = 0;
  const double again = cpu_seconds();
  std::size_t sharper = 0;
  for (Certificate& c : all.certificates) {
    if (c.holds_root()) sharper += certifier.sharpen(c, kFirstArbBits);
  }
  std::printf("    %zu sharpened in %d bits, %.1f us a root\n", sharper, kFirstArbBits,
              1e6 * (cpu_seconds() - again) / static_cast<double>(roots.size()));
}

}  // namespace
}  // namespace moivre

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: bench_certify FILE...\n");
    return 2;
  }
  try {
    std::printf("%-36s %-7s %6s %9s %6s %8s %5s %10s\n", "file", "digits", "roots", "certified",
                "real", "not real", "bits", "us a root");
    for (int k = 1; k < argc; ++k) moivre::run(argv[k]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "certify: %s\n", error.what());
    return 2;
  }
}
