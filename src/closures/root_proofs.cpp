// SPDX-License-Identifier: MIT
// Krawczyk's test for one group of blocks after another, the values of the groups before in their
// balls.
#include "moivre/closures/root_proofs.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "moivre/certify/certifier.h"
#include "moivre/certify/distinct.h"
#include "moivre/closures/stages.h"
#include "moivre/formulation/exact.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/value.h"

namespace moivre {

using KnownCertificate = std::shared_ptr<const Certificate>;

/// Roots that differ in nothing that a group knows share its certificate.
struct RootProof {
  KnownProof before;
  std::size_t group = 0;
  KnownCertificate certificate;
};

namespace {

// A root is no farther than this from the point that its path leads to, above roots before that are
// rounded. Which root it is does not hang on it: two paths that are led to one are told.
constexpr double kFarthest = 1e-4;
// Errors of the groups before are rounding in double; where they grow to this the groups are proved
// again with more digits.
constexpr double kBlurred = 1e-12;
// Lengths that are off by 1e-9 may leave an expression of the fourth degree at 1e-36 beside its
// terms, and a root that is known 1e20 times less sharply than the arithmetic.
constexpr int kFineBits = 256;
// Coefficients are right to this part of themselves: frames are right to 50 bits, and a product of
// a dozen of them to 45.
constexpr double kRightTo = 1e-13;
// They are shaken by so much less that every root stays what it is, however badly it is known: to
// first order a value moves in proportion.
constexpr double kShake = 1e-30;
// Numbers that are rounded to this have no relation by chance that those they stand for have not.
constexpr double kOfGeneralNumbers = 0x1p-100;
// One shake of all coefficients may happen to move a value by much less than another.
constexpr double kSureOfShake = 8;

/// The system with each coefficient off by up to kShake of itself.
Formulation shaken(Formulation formulation) {
  constexpr std::uint64_t kSeed = 2;
  constexpr int kSteps = 1000;
  std::uint64_t count = 0;
  for (Polynomial& p : formulation.system.polynomials) {
    for (Term& term : p.terms) {
      const std::uint64_t bits = random_bits(kSeed, RandomStream::formulation, count++);
      const int step = static_cast<int>(bits % (2 * kSteps + 1)) - kSteps;
      const Rational factor = 1 + Rational(step) * Rational(kShake / kSteps);
      term.coefficient.re *= factor;
      term.coefficient.im *= factor;
    }
  }
  return formulation;
}

double distance(const Enclosure& a, const Enclosure& b) {
  Complex apart = a.middle - b.middle;
  for (const Complex& part : a.finer) apart += part;
  for (const Complex& part : b.finer) apart -= part;
  return std::abs(apart);
}

CertifyOptions certify_options() {
  CertifyOptions options;
  options.accuracy = kFarthest;
  options.most_bits = kFineBits;
  options.decide_reality = false;  // the mirror image says it
  return options;
}

/// The certificates by group.
std::vector<const Certificate*> chain_of(const KnownProof& last) {
  std::vector<const Certificate*> chain;
  if (last) chain.resize(last->group + 1);
  for (const RootProof* proof = last.get(); proof != nullptr; proof = proof->before.get()) {
    chain[proof->group] = proof->certificate.get();
  }
  return chain;
}

/// Not blurred by what was known of the groups before.
bool is_sharp(const Certificate& certificate) {
  if (certificate.verdict != Verdict::certified) return false;
  const double error = certificate.sizes.largest_error();
  return error <= kBlurred * std::max(1.0, max_norm(certificate.midpoint));
}

}  // namespace

struct RootProver::Work {
  struct Shaken;

  /// Where a variable is proved: in which group, and which of its coordinates it is.
  struct Place {
    std::size_t group = 0;
    std::size_t coordinate = 0;
  };

  /// Some polynomials, and the numbers in them that are proved in groups before.
  struct Program {
    std::vector<std::size_t> given;  ///< variables of the formulation
    Certifier certifier;
  };

  /// What a certificate follows from: the certificates of the numbers that are given, and where the
  /// root is looked for.
  using Grounds = std::pair<std::vector<KnownCertificate>, std::vector<std::pair<double, double>>>;

  struct Group {
    std::vector<std::size_t> equations;
    std::vector<std::size_t> unknowns;                            ///< variables of the formulation
    std::optional<Program> program;                               ///< where it was needed
    std::map<const Formulation::Exclusion*, Program> with_value;  ///< likewise, by the exclusion
    std::map<Grounds, KnownCertificate> proved;
    std::map<Grounds, KnownCertificate> proved_finely;
    std::map<Grounds, KnownCertificate> sharpened;  ///< in kFineBits; the root itself is given, too
    /// What exclusions are at roots, likewise; nullopt where that failed.
    std::map<std::pair<const Formulation::Exclusion*, Grounds>, std::optional<Enclosure>> values;
  };

  explicit Work(const Formulation& the_formulation)
      : formulation(the_formulation),
        enclosed(formulation.enclosed ? formulation.enclosed() : EnclosedPolynomials()),
        place(the_formulation.system.variables.size()) {}

  void close();
  bool knows(const Program& program, std::size_t number) const;
  Program program(const Group& group, const Polynomial* value) const;
  std::vector<Enclosure> given(const Program& program, const KnownProof& before) const;
  Grounds grounds(const Program& program, const KnownProof& before) const;
  KnownProof prove(std::size_t number, const KnownProof& before, const Point& values);
  KnownCertificate certificate(Group& group, const KnownProof& before, const Point& x,
                               bool is_fine);
  KnownProof prove_beside(const KnownProof& proof, const Point& values);
  std::optional<Enclosure> value(const KnownProof& proof, const Formulation::Exclusion& exclusion);
  Work& shake();
  KnownProof finer(const KnownProof& proof);
  Point midpoints(const KnownProof& proof) const;
  Reality reality(const KnownProof& proof) const;

  /// Of the mechanism as it was typed.
  const Polynomial& polynomial(std::size_t equation) const {
    return formulation.enclosed ? enclosed.polynomials[equation]
                                : formulation.system.polynomials[equation];
  }

  const Formulation& formulation;
  const EnclosedPolynomials enclosed;
  Block waiting;
  std::vector<Group> groups;
  std::vector<std::optional<Place>> place;  ///< of each variable of the formulation
  std::unique_ptr<Shaken> shaken;           ///< where it was needed
};

/// The same blocks of the shaken system.
struct RootProver::Work::Shaken {
  explicit Shaken(const Formulation& of) : formulation(moivre::shaken(of)), work(formulation) {}
  Formulation formulation;
  Work work;
};

void RootProver::Work::close() {
  for (std::size_t k = 0; k < waiting.variables.size(); ++k) {
    place[waiting.variables[k]] = Place{groups.size(), k};
  }
  Group& group = groups.emplace_back();
  group.equations = std::move(waiting.equations);
  group.unknowns = std::move(waiting.variables);
  waiting = Block();
}

/// value: one more unknown, equal to this, or nullptr.
RootProver::Work::Program RootProver::Work::program(const Group& group,
                                                    const Polynomial* value) const {
  std::vector<const Polynomial*> polynomials;
  for (const std::size_t e : group.equations) {
    polynomials.push_back(&polynomial(e));
  }
  if (value != nullptr) polynomials.push_back(value);
  std::set<std::size_t> given;
  for (const Polynomial* p : polynomials) {
    for (const Term& term : p->terms) {
      for (const Power& power : term.monomial) given.insert(power.variable);
    }
  }
  for (const std::size_t v : group.unknowns) given.erase(v);

  System f;
  const std::size_t unknowns = formulation.system.variables.size();
  std::vector<std::uint32_t> at(unknowns + enclosed.factor_errors.size());
  const auto add = [&](std::size_t v) {
    at[v] = static_cast<std::uint32_t>(f.variables.size());
    f.variables.push_back(v < unknowns ? formulation.system.variables[v]
                                       : "factor " + std::to_string(v - unknowns));
  };
  for (const std::size_t v : group.unknowns) add(v);
  const auto z = static_cast<std::uint32_t>(f.variables.size());
  if (value != nullptr) f.variables.emplace_back("value");
  for (const std::size_t v : given) add(v);
  const std::vector<KnownValue> none(at.size());
  for (const Polynomial* p : polynomials) f.polynomials.push_back(substituted(*p, none, at));
  if (value != nullptr) {
    f.polynomials.back() = f.polynomials.back() + Coefficient{-1, 0} * unknown(z);
  }
  return {{given.begin(), given.end()},
          Certifier(make_certify_program(f, given.size()), certify_options())};
}

/// What is given has its group before this one. The polynomials of the mechanism as typed have
/// unknowns that those that are solved lack where a term was taken for rounding.
bool RootProver::Work::knows(const Program& program, std::size_t number) const {
  return std::all_of(program.given.begin(), program.given.end(), [&](std::size_t v) {
    return v >= place.size() || (place[v] && place[v]->group < number);
  });
}

std::vector<Enclosure> RootProver::Work::given(const Program& program,
                                               const KnownProof& before) const {
  const std::vector<const Certificate*> chain = chain_of(before);
  std::vector<Enclosure> numbers;
  for (const std::size_t v : program.given) {
    if (v >= place.size()) {
      numbers.push_back({1, {}, enclosed.factor_errors[v - place.size()]});
    } else {
      numbers.push_back(enclosure(*chain[place[v]->group], place[v]->coordinate));
    }
  }
  return numbers;
}

/// The certificates, one a group, of the numbers that are given.
RootProver::Work::Grounds RootProver::Work::grounds(const Program& program,
                                                    const KnownProof& before) const {
  std::set<std::size_t> needed;
  for (const std::size_t v : program.given) {
    if (v < place.size()) needed.insert(place[v]->group);
  }
  Grounds grounds;
  for (const RootProof* proof = before.get(); proof != nullptr; proof = proof->before.get()) {
    if (needed.contains(proof->group)) grounds.first.push_back(proof->certificate);
  }
  return grounds;
}

/// The same root in balls of kFineBits; nullptr where that failed.
KnownProof RootProver::Work::finer(const KnownProof& proof) {
  KnownProof before;
  if (proof->before && !(before = finer(proof->before))) return nullptr;
  auto& group = groups[proof->group];
  Program& program = *group.program;
  Grounds from = grounds(program, before);
  from.first.push_back(proof->certificate);
  const auto [place_of_sharp, is_new] = group.sharpened.try_emplace(std::move(from));
  KnownCertificate& sharp = place_of_sharp->second;
  if (is_new) {
    Certificate certificate = *proof->certificate;
    if (program.certifier.sharpen(certificate, kFineBits, given(program, before))) {
      sharp = std::make_shared<const Certificate>(std::move(certificate));
    }
  }
  if (!sharp) return nullptr;
  return std::make_shared<const RootProof>(RootProof{before, proof->group, sharp});
}

/// The root of group `number` near `values`, of all variables.
KnownProof RootProver::Work::prove(std::size_t number, const KnownProof& before,
                                   const Point& values) {
  if (number > 0 && !before) return nullptr;
  auto& group = groups[number];
  if (!group.program) group.program.emplace(program(group, nullptr));
  if (!knows(*group.program, number)) return nullptr;
  Point x;
  for (const std::size_t v : group.unknowns) x.push_back(values[v]);
  const KnownCertificate first = certificate(group, before, x, false);
  if (is_sharp(*first)) return std::make_shared<const RootProof>(RootProof{before, number, first});
  KnownProof sharp_before;
  if (before && !(sharp_before = finer(before))) return nullptr;
  const KnownCertificate sharp = certificate(group, sharp_before, x, true);
  if (sharp->verdict != Verdict::certified) return nullptr;
  return std::make_shared<const RootProof>(RootProof{sharp_before, number, sharp});
}

/// Of a root of the group near x; in kFineBits where that is wanted.
KnownCertificate RootProver::Work::certificate(Group& group, const KnownProof& before,
                                               const Point& x, bool is_fine) {
  Grounds from = grounds(*group.program, before);
  for (const Complex& xi : x) from.second.emplace_back(xi.real(), xi.imag());
  auto& known = is_fine ? group.proved_finely : group.proved;
  const auto [at, is_new] = known.try_emplace(std::move(from));
  if (!is_new) return at->second;
  Certificate made;
  const std::vector<Enclosure> numbers = given(*group.program, before);
  Certifier& certifier = group.program->certifier;
  certifier.certify(x, made, numbers);
  if (is_fine && made.holds_root()) certifier.sharpen(made, kFineBits, numbers);
  at->second = std::make_shared<const Certificate>(std::move(made));
  return at->second;
}

/// The root nearest to one that is proved of another system with the same blocks, `values` its
/// midpoints.
KnownProof RootProver::Work::prove_beside(const KnownProof& proof, const Point& values) {
  const KnownProof before = proof->before ? prove_beside(proof->before, values) : nullptr;
  return prove(proof->group, before, values);
}

/// Of the exclusion's polynomial at the root, in kFineBits.
std::optional<Enclosure> RootProver::Work::value(const KnownProof& proof,
                                                 const Formulation::Exclusion& exclusion) {
  const KnownProof fine = proof ? finer(proof) : nullptr;
  if (!fine) return std::nullopt;
  auto& group = groups[fine->group];
  auto place_of_value = group.with_value.find(&exclusion);
  if (place_of_value == group.with_value.end()) {
    place_of_value = group.with_value.emplace(&exclusion, program(group, &exclusion.of)).first;
  }
  Program& with_value = place_of_value->second;
  if (!knows(with_value, fine->group)) return std::nullopt;
  Grounds from = grounds(with_value, fine->before);
  from.first.push_back(fine->certificate);
  const auto [known, is_new] = group.values.try_emplace({&exclusion, std::move(from)});
  if (!is_new) return known->second;
  const std::vector<Enclosure> numbers = given(with_value, fine->before);
  Point x = fine->certificate->midpoint;
  x.push_back(value_at(exclusion.of, midpoints(fine)));
  Certificate certificate = with_value.certifier.certify(x, numbers);
  if (!certificate.holds_root() || !with_value.certifier.sharpen(certificate, kFineBits, numbers)) {
    return std::nullopt;
  }
  known->second = enclosure(certificate, group.unknowns.size());
  return known->second;
}

RootProver::Work& RootProver::Work::shake() {
  if (!shaken) shaken = std::make_unique<Shaken>(formulation);
  Work& work = shaken->work;
  work.place = place;
  while (work.groups.size() < groups.size()) {
    const Group& group = groups[work.groups.size()];
    Group& same = work.groups.emplace_back();
    same.equations = group.equations;
    same.unknowns = group.unknowns;
  }
  return work;
}

/// 0 where nothing is proved yet.
Point RootProver::Work::midpoints(const KnownProof& proof) const {
  const std::vector<const Certificate*> chain = chain_of(proof);
  Point x(place.size());
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (place[v] && place[v]->group < chain.size()) {
      x[v] = chain[place[v]->group]->midpoint[place[v]->coordinate];
    }
  }
  return x;
}

Reality RootProver::Work::reality(const KnownProof& proof) const {
  const std::vector<const Certificate*> chain = chain_of(proof);
  std::vector<ProvedCoordinate> root;
  for (const auto& at : place) {
    const Certificate& certificate = *chain[at->group];
    root.push_back({enclosure(certificate, at->coordinate), certificate.radius(at->coordinate)});
  }
  return reality_of(root, formulation.mirror);
}

RootProver::RootProver(const Formulation& formulation, bool is_wanted) {
  if (is_wanted) work_ = std::make_unique<Work>(formulation);
}
RootProver::~RootProver() = default;

void RootProver::add(const Block& block) {
  if (!work_) return;
  Block& waiting = work_->waiting;
  waiting.equations.insert(waiting.equations.end(), block.equations.begin(), block.equations.end());
  waiting.variables.insert(waiting.variables.end(), block.variables.begin(), block.variables.end());
}

bool RootProver::knows_terms() const { return !work_ || work_->enclosed.has_same_terms; }

bool RootProver::has_exact_numbers() const {
  if (!work_) return false;
  const Formulation& formulation = work_->formulation;
  return formulation.is_exact && !formulation.has_rounded_frames &&
         work_->enclosed.factor_errors.empty();
}

bool RootProver::has_general_numbers() const {
  if (!work_) return true;
  const std::vector<double>& errors = work_->enclosed.factor_errors;
  return std::all_of(errors.begin(), errors.end(),
                     [](double error) { return error <= kOfGeneralNumbers; });
}

bool RootProver::close() {
  if (!work_ || work_->waiting.variables.empty()) return false;
  work_->close();
  return true;
}

KnownProof RootProver::prove(const KnownProof& before, const Point& values) {
  if (!work_ || work_->groups.empty()) return nullptr;
  return work_->prove(work_->groups.size() - 1, before, values);
}

std::vector<bool> RootProver::are_new(const std::vector<KnownProof>& proofs) {
  std::vector<Certificate> certificates;
  for (const KnownProof& proof : proofs) {
    certificates.push_back(proof ? *proof->certificate : Certificate());
  }
  const Distinctness told = compare(certificates);
  std::vector<bool> result;
  for (std::size_t k = 0; k < proofs.size(); ++k) {
    result.push_back(proofs[k] && told.first_of[k] == k);
  }
  for (const auto& [first, second] : told.doubtful) result[second] = false;
  return result;
}

std::optional<bool> RootProver::vanishes(const KnownProof& proof,
                                         const Formulation::Exclusion& exclusion) {
  if (!proof) return std::nullopt;
  const auto z = work_->value(proof, exclusion);
  if (!z || holds_zero(*z)) return z.has_value() ? std::optional(true) : std::nullopt;
  if (work_->formulation.is_exact) return false;
  Work& shaken = work_->shake();
  const auto moved = shaken.value(shaken.prove_beside(proof, work_->midpoints(proof)), exclusion);
  if (!moved) return std::nullopt;
  const double step = distance(*z, *moved) + z->error + moved->error;
  return std::abs(z->middle) <= kSureOfShake * (kRightTo / kShake) * step;
}

std::optional<std::vector<double>> RootProver::moved_by_rounding(const KnownProof& proof) {
  Work& shaken = work_->shake();
  const KnownProof beside = shaken.prove_beside(proof, work_->midpoints(proof));
  const KnownProof here = work_->finer(proof);
  const KnownProof there = beside ? shaken.finer(beside) : nullptr;
  if (!here || !there) return std::nullopt;
  const std::vector<const Certificate*> from = chain_of(here);
  const std::vector<const Certificate*> to = chain_of(there);
  std::vector<double> moved;
  for (const auto& at : work_->place) {
    const double step = distance(enclosure(*from[at->group], at->coordinate),
                                 enclosure(*to[at->group], at->coordinate));
    moved.push_back(kSureOfShake * (kRightTo / kShake) * step);
  }
  return moved;
}

std::vector<Coefficient> RootProver::fine_values(const KnownProof& proof,
                                                 const std::vector<std::size_t>& unknowns) {
  const KnownProof fine = proof ? work_->finer(proof) : nullptr;
  std::vector<Coefficient> values;
  if (!fine) return values;
  for (const std::size_t v : unknowns) {
    const Enclosure at = enclosure(*fine->certificate, work_->place[v]->coordinate);
    Coefficient value = exactly(at.middle);
    for (const Complex& part : at.finer) value = value + exactly(part);
    values.push_back(std::move(value));
  }
  return values;
}

ProvedRoot RootProver::root(const KnownProof& proof) {
  ProvedRoot root;
  root.x = work_->midpoints(proof);
  for (const Certificate* certificate : chain_of(proof)) {
    for (std::size_t j = 0; j < certificate->midpoint.size(); ++j) {
      double error = certificate->error(j);
      for (const Point& part : certificate->finer) error += std::abs(part[j]);
      root.accuracy = std::max(root.accuracy, error);
    }
  }
  root.accuracy /= std::max(1.0, max_norm(root.x));
  Reality reality = work_->reality(proof);
  if (reality == Reality::unknown) {
    if (const KnownProof fine = work_->finer(proof)) reality = work_->reality(fine);
  }
  if (reality != Reality::unknown) root.real = reality == Reality::real;
  return root;
}

}  // namespace moivre
