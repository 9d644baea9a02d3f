# SPDX-License-Identifier: MIT
# How many isolated roots does a system have? Exact algebra in Macaulay2, modulo a prime.
#
# Modulo a prime the ideal of a system has a dimension and a degree; the components of positive dimension are taken away by
# saturation, so that the isolated roots in C^n are left: the degree of what is left counts them with multiplicity, and the
# degree of its radical, as many values as a random linear form takes on them, the distinct ones. All but finitely many primes
# give what the rationals give. A square root of -1 modulo the prime stands for i. An answer:
#   dimension           of the set of all roots, -1 where it is empty
#   degree              of its components of that dimension; 0 where it is empty
#   with_multiplicity   isolated roots, as the ideal counts them
#   distinct            isolated roots
# Python's standard library only.
import queue
import re
import subprocess
import threading

# Below 2^15, as Macaulay2's F4 wants, and of the form 4k+1.
PRIMES = ((32749, 32717), (32633, 32609))
ANSWER = re.compile(r"ANSWER((?: -?\d+)+)")      # what Macaulay2 repeats of its input does not look so
KEYS = ("dimension", "degree", "with_multiplicity", "distinct")
ISOLATED = """
isolated = I -> (J := I; while dim J > 0 do J = saturate(J, topComponents J); J);
"""
PRELUDE = ISOLATED + """
prepare = I -> if numgens I > 1 then forceGB groebnerBasis(I, Strategy=>"F4") else gb I;
-- The values that a random linear form takes on the roots of J: its minimal polynomial in R/J from a Krylov sequence, and of
-- that the squarefree part. Two roots with one value make them too few, never too many.
values1 = J -> (
  R := ring J; k := coefficientRing R; D := degree J; Q := R/J; B := basis Q;
  l := sum(gens R, x -> random k * x);
  M := lift(last coefficients(sub(l, Q) * B, Monomials=>B), k);
  v := random(k^D, k^1); K := v; scan(D, i -> (v = M * v; K = K | v));
  r := rank K; c := flatten entries matrix solve(mutableMatrix K_{0..r-1}, mutableMatrix K_{r});
  T := k(monoid [getSymbol "t"]); f := T_0^r - sum(r, i -> c#i * T_0^i);
  r - first degree gcd(f, diff(T_0, f)));
distinct = J -> max apply(3, i -> values1 J);
tell = I -> (
  prepare I; d := dim I; J := isolated I; e := dim J;
  << "ANSWER " << d << " " << (if d < 0 then 0 else degree I) << " "
     << (if e < 0 then 0 else degree J) << " " << (if e < 0 then 0 else distinct J) << endl;);
"""


# The real roots of a real system, over the rationals: of a linear form that takes as many values as there are roots, the real
# values are those of the real roots, and Sturm's sequence counts them.
REAL_KEYS = ("real", "distinct")
REAL_PRELUDE = ISOLATED + """
needsPackage "RealRoots";
real1 = J -> (
  R := ring J; D := degree J; Q := R/J; B := basis Q;
  l := sum(gens R, x -> (random 199 - 99) * x);
  M := lift(last coefficients(sub(l, Q) * B, Monomials=>B), QQ);
  v := matrix apply(D, i -> {random 19 - 9_QQ}); K := v; scan(D, i -> (v = M * v; K = K | v));
  r := rank K; c := flatten entries solve(K_{0..r-1}, K_{r});
  T := QQ[getSymbol "t"]; f := T_0^r - sum(r, i -> c#i * T_0^i); f = f // gcd(f, diff(T_0, f));
  (first degree f, SturmCount f));
tell = I -> (
  J := isolated I;
  if dim J < 0 then << "ANSWER 0 0" << endl
  else (best := max apply(2, i -> real1 J); << "ANSWER " << best#1 << " " << best#0 << endl));
"""


def residue(c, prime):
    return c.numerator * pow(c.denominator, -1, prime) % prime


def real_question(system):
    """Macaulay2's text for REAL_PRELUDE; the coefficients must be real."""
    polynomials = []
    for p in system.polynomials:
        terms = ["*".join([f"({c[0]})"] + [f"x_{v}^{e}" for v, e in enumerate(m) if e] + ["1_R"]) for m, c in p.items()]
        polynomials.append("+".join(terms))
    return f"R = QQ[x_0..x_{len(system.variables) - 1}];\ntell ideal({','.join(polynomials)});\n"


def question(system, prime):
    """Macaulay2's text that prints the answer for one system modulo one prime."""
    unit = next(pow(a, (prime - 1) // 4, prime) for a in range(2, prime) if pow(a, (prime - 1) // 2, prime) != 1)
    polynomials = []
    for p in system.polynomials:
        terms = []
        for m, c in p.items():
            number = (residue(c[0], prime) + unit * residue(c[1], prime)) % prime
            terms.append("*".join([str(number)] + [f"x_{v}^{e}" for v, e in enumerate(m) if e] + ["1_R"]))
        polynomials.append("+".join(terms))
    return f"R = ZZ/{prime}[x_0..x_{len(system.variables) - 1}];\ntell ideal({','.join(polynomials)});\n"


class Macaulay2:
    """One process that answers questions; it is started again after one that took too long."""

    def __init__(self, prelude=PRELUDE, keys=KEYS):
        self.process, self.prelude, self.keys = None, prelude, keys

    def _start(self):
        self.process = subprocess.Popen(["nice", "M2", "-q", "--silent", "--no-readline", "--stop"], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, bufsize=1)
        self.lines = queue.Queue()
        threading.Thread(target=self._listen, args=(self.process, self.lines), daemon=True).start()
        self.process.stdin.write(self.prelude)

    def _listen(self, process, lines):
        for line in process.stdout:
            if match := ANSWER.fullmatch(line.strip()):
                lines.put(dict(zip(self.keys, map(int, match[1].split()))))
        lines.put(None)

    def stop(self):
        if self.process:
            self.process.kill()
            self.process.wait()
        self.process = None

    def ask(self, text, timeout_s):
        """{key: number} for the keys, or None where no answer came."""
        if not self.process:
            self._start()
        try:
            self.process.stdin.write(text)
            self.process.stdin.flush()
            answer = self.lines.get(timeout=timeout_s)
        except (queue.Empty, BrokenPipeError):
            answer = None
        if answer is None:
            self.stop()
        return answer
