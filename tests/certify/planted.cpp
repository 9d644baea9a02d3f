// SPDX-License-Identifier: MIT
// Planted roots: built and judged in exact rational arithmetic, with nothing of the module under
// test.
#include "planted.h"

#include <algorithm>
#include <sstream>

#include "moivre/numeric/random.h"

namespace moivre::test {
namespace {

/// Small random numbers; fractions are 15ths, which double rounds.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : seed_(seed) {}
  std::int64_t integer(std::int64_t least, std::int64_t most) {
    const auto span = static_cast<std::uint64_t>(most - least + 1);
    return least +
           static_cast<std::int64_t>(random_bits(seed_, RandomStream::test, next_++) % span);
  }
  Rational fraction() { return Rational(integer(-48, 48), 15); }

 private:
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

struct Line {
  Coefficient r;
  Rational s;
};

using Matrix = std::vector<std::vector<std::int64_t>>;

/// Unit lower times unit upper triangle.
Matrix turned(Draw& draw, std::size_t n) {
  Matrix lower(n, std::vector<std::int64_t>(n, 0)), upper = lower, a = lower;
  for (std::size_t i = 0; i < n; ++i) {
    lower[i][i] = upper[i][i] = 1;
    for (std::size_t j = 0; j < i; ++j) lower[i][j] = draw.integer(-1, 1);
    for (std::size_t j = i + 1; j < n; ++j) upper[i][j] = draw.integer(-1, 1);
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) a[i][j] += lower[i][k] * upper[k][j];
    }
  }
  return a;
}

/// x with A x = u by elimination; A has determinant 1.
ExactPoint solved(const Matrix& a, ExactPoint u) {
  const std::size_t n = u.size();
  std::vector<std::vector<Rational>> m(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i].emplace_back(a[i][j]);
  }
  // The leading minors are 1, so that no pivot vanishes.
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || m[i][k].is_zero()) continue;
      const Rational factor = m[i][k] / m[k][k];
      for (std::size_t j = 0; j < n; ++j) m[i][j] -= factor * m[k][j];
      u[i] = u[i] - Coefficient{factor, 0} * u[k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) u[k] = u[k] / Coefficient{m[k][k], 0};
  return u;
}

std::vector<Line> lines_of(Draw& draw, Factors kind, std::size_t i) {
  const auto slope = [&] { return i == 0 ? Rational(0) : Rational(draw.integer(-4, 4), 4); };
  std::vector<Line> lines;
  if (kind == Factors::conjugate_pairs) {
    const Rational re = draw.fraction(), s = slope();
    // Down to 1e-9: nearly real.
    const Rational im = Rational(draw.integer(1, 16), 16) *
                        (draw.integer(0, 2) == 0 ? Rational(1, 1000000000) : Rational(1));
    lines = {{{re, im}, s}, {{re, -im}, s}, {{draw.fraction(), 0}, slope()}};
    return lines;
  }
  const std::int64_t count = draw.integer(1, 3);
  for (std::int64_t k = 0; k < count; ++k) {
    const Rational im = kind == Factors::complex ? draw.fraction() : Rational(0);
    lines.push_back({{draw.fraction(), im}, slope()});
  }
  if (kind == Factors::repeated && (i == 0 || draw.integer(0, 1) == 0)) {
    lines.push_back(lines.front());
  }
  return lines;
}

void add_root(Planted& p, ExactPoint x) {
  const auto known = std::find(p.roots.begin(), p.roots.end(), x);
  if (known != p.roots.end()) {
    ++p.multiplicity[static_cast<std::size_t>(known - p.roots.begin())];
    return;
  }
  p.roots.push_back(std::move(x));
  p.multiplicity.push_back(1);
}

void add_roots(Planted& p, const Matrix& a, const std::vector<std::vector<Line>>& lines,
               ExactPoint u) {
  if (u.size() == lines.size()) {
    add_root(p, solved(a, u));
    return;
  }
  for (const Line& line : lines[u.size()]) {
    ExactPoint longer = u;
    longer.push_back(u.empty() ? line.r : line.r + Coefficient{line.s, 0} * u.back());
    add_roots(p, a, lines, longer);
  }
}

std::string told(const Certificate& c, const Point& given) {
  std::ostringstream text;
  text.precision(17);
  text << "verdict " << static_cast<int>(c.verdict) << ", reality " << static_cast<int>(c.reality)
       << ", bits " << c.bits << ", given";
  for (const Complex& x : given) text << ' ' << x;
  text << ", ball";
  for (std::size_t j = 0; j < c.midpoint.size(); ++j) {
    text << ' ' << c.midpoint[j] << " +- " << c.radius(j);
  }
  return text.str();
}

}  // namespace

Planted planted(std::uint64_t seed, std::uint32_t dimension, Factors kind) {
  Draw draw(seed);
  const Matrix a = turned(draw, dimension);
  std::vector<Polynomial> u;
  for (std::uint32_t i = 0; i < dimension; ++i) {
    Polynomial sum;
    for (std::uint32_t j = 0; j < dimension; ++j) {
      sum = sum + Coefficient{Rational(a[i][j]), 0} * unknown(j);
    }
    u.push_back(sum);
  }
  Planted p;
  std::vector<std::vector<Line>> lines;
  for (std::uint32_t i = 0; i < dimension; ++i) {
    p.f.variables.emplace_back(1, static_cast<char>('a' + i));
    lines.push_back(lines_of(draw, kind, i));
    Polynomial f = constant({1, 0});
    for (const Line& line : lines.back()) {
      Polynomial factor = u[i] + constant(-line.r);
      if (i > 0) factor = factor + Coefficient{-line.s, 0} * u[i - 1];
      f = f * factor;
    }
    p.f.polynomials.push_back(f);
  }
  add_roots(p, a, lines, {});
  return p;
}

System system_of(const std::string& text) { return read_system(Source{"test.phc", text}); }

System problem(const std::string& name) {
  return read_system(read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/polynomials/" + name));
}

Point to_double(const ExactPoint& x) {
  Point result;
  for (const Coefficient& xi : x) result.push_back(to_complex(xi));
  return result;
}

bool lies_within(const ExactPoint& x, const Certificate& c,
                 double (Certificate::*reach)(std::size_t) const) {
  for (std::size_t j = 0; j < x.size(); ++j) {
    Coefficient d =
        x[j] - Coefficient{Rational(c.midpoint[j].real()), Rational(c.midpoint[j].imag())};
    for (const Point& part : c.finer) {
      d = d - Coefficient{Rational(part[j].real()), Rational(part[j].imag())};
    }
    if (d.re * d.re + d.im * d.im > Rational((c.*reach)(j)) * Rational((c.*reach)(j))) return false;
  }
  return true;
}

double distance(const Point& a, const Point& b) {
  double largest = 0;
  for (std::size_t j = 0; j < a.size(); ++j) largest = std::max(largest, std::abs(a[j] - b[j]));
  return largest;
}

std::string untruth(const Certificate& c, const Planted& p, const Point& given, double accuracy) {
  if (!c.holds_root()) return "";
  std::vector<std::size_t> inside;
  for (std::size_t k = 0; k < p.roots.size(); ++k) {
    if (lies_within(p.roots[k], c, &Certificate::radius)) inside.push_back(k);
  }
  const std::string all = told(c, given);
  if (inside.size() != 1) return std::to_string(inside.size()) + " roots in the ball: " + all;
  const ExactPoint& root = p.roots[inside.front()];
  if (p.multiplicity[inside.front()] != 1) return "a multiple root: " + all;
  if (!lies_within(root, c, &Certificate::error)) return "the root lies beyond the error: " + all;
  const bool root_is_real =
      std::all_of(root.begin(), root.end(), [](const Coefficient& z) { return is_real(z); });
  if (c.reality == Reality::real && !root_is_real) return "not real: " + all;
  if (c.reality == Reality::not_real && root_is_real) return "real: " + all;
  // Of the distance only the last digits are rounded here.
  const double allowed = accuracy * std::max(1.0, max_norm(given)) * (1 + 1e-9);
  const bool near = distance(to_double(root), given) <= allowed;
  if (c.verdict == Verdict::certified && !near) return "no root is near: " + all;
  return "";
}

}  // namespace moivre::test
