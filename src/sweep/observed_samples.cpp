// SPDX-License-Identifier: MIT
// The bytes of a sample, and its number among all that there could be.
#include "observed_samples.h"

#include "moivre/numeric/bytes.h"
#include "moivre/tracker/followed.h"

namespace moivre {
namespace {

Fingerprint list_of(const std::vector<Varied>& varied, const Tracker& tracker,
                    const SweepOptions& options) {
  FingerprintMaker maker;
  maker.add(std::string_view("samples"));
  for (const Varied& number : varied) maker.add(number.name);
  add_to(maker, tracker);
  maker.add(options.closures.time);
  maker.add(options.closures.solve.seed);
  maker.add(static_cast<std::uint64_t>(options.closures.solve.start));
  maker.add(std::uint64_t{options.keep_closures});
  return maker.fingerprint();
}

std::uint64_t job_of(const std::vector<double>& at) {
  FingerprintMaker maker;
  for (const double number : at) maker.add(number);
  return maker.fingerprint().first;
}

void put(ByteWriter& bytes, const Assemblies& found) {
  for (const std::uint64_t count : {found.real, found.filtered, found.fitted}) bytes.put(count);
  bytes.put(found.moves);
}

Assemblies get_assemblies(ByteReader& bytes) {
  Assemblies found;
  for (std::uint64_t* count : {&found.real, &found.filtered, &found.fitted}) {
    *count = bytes.get<std::uint64_t>();
  }
  found.moves = bytes.get<bool>();
  return found;
}

}  // namespace

std::string bytes_of(const SweepSample& sample) {
  ByteWriter bytes;
  bytes.put(sample.at);
  bytes.put(sample.complex);
  put(bytes, sample.found);
  bytes.put(sample.complete);
  bytes.put(static_cast<std::uint64_t>(sample.closures.size()));
  for (const Eigen::VectorXd& q : sample.closures) {
    bytes.put(std::vector<double>(q.begin(), q.end()));
  }
  return bytes.bytes();
}

SweepSample sample_of(std::string_view text) {
  ByteReader bytes(text);
  SweepSample sample;
  sample.at = bytes.get_vector<double>();
  sample.complex = bytes.get<std::uint64_t>();
  sample.found = get_assemblies(bytes);
  sample.complete = bytes.get<bool>();
  for (auto left = bytes.get<std::uint64_t>(); left > 0; --left) {
    const std::vector<double> q = bytes.get_vector<double>();
    sample.closures.push_back(
        Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size())));
  }
  bytes.require_end();
  return sample;
}

std::string bytes_of(const std::vector<SweepBorder>& borders) {
  ByteWriter bytes;
  bytes.put(static_cast<std::uint64_t>(borders.size()));
  for (const SweepBorder& border : borders) {
    bytes.put(border.at);
    put(bytes, border.below);
    put(bytes, border.above);
    bytes.put(static_cast<std::uint64_t>(border.along));
  }
  return bytes.bytes();
}

std::vector<SweepBorder> borders_of(std::string_view text) {
  ByteReader bytes(text);
  std::vector<SweepBorder> borders(bytes.get<std::uint64_t>());
  for (SweepBorder& border : borders) {
    border.at = bytes.get_vector<double>();
    border.below = get_assemblies(bytes);
    border.above = get_assemblies(bytes);
    border.along = bytes.get<std::uint64_t>();
  }
  bytes.require_end();
  return borders;
}

ObservedSamples::ObservedSamples(const std::vector<Varied>& varied, const Tracker& tracker,
                                 const SweepOptions& options)
    : observations_(options.closures.solve.observations), list_(list_of(varied, tracker, options)) {
  if (observations_ != nullptr) known_ = observations_->recall(list_);
}

std::optional<SweepSample> ObservedSamples::recall(const std::vector<double>& at) const {
  const auto found = known_.find(job_of(at));
  if (found == known_.end()) return std::nullopt;
  SweepSample sample = sample_of(found->second);
  if (sample.at != at) return std::nullopt;
  return sample;
}

void ObservedSamples::keep(const SweepSample& sample) const {
  if (observations_ == nullptr) return;
  observations_->keep(list_, JobOutcome{job_of(sample.at), bytes_of(sample),
                                        sample.complete ? OutcomeKind::root : OutcomeKind::failed});
}

Fingerprint ObservedSamples::list_of_borders(const std::vector<SweepSample>& samples,
                                             const std::vector<SamplePair>& pairs) const {
  FingerprintMaker maker;
  maker.add(std::string_view("borders"));
  maker.add(list_.first);
  maker.add(list_.second);
  for (const SamplePair& pair : pairs) {
    for (const std::size_t k : {pair.first, pair.second}) {
      for (const double number : samples[k].at) maker.add(number);
    }
  }
  return maker.fingerprint();
}

}  // namespace moivre
