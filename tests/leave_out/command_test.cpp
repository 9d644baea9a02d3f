// SPDX-License-Identifier: MIT
// Does a run over polynomials leave TOML alone, and with the lanes SUNDIALS? The command line, run inside this program.
#include <gtest/gtest.h>
#include <sundials/sundials_context.h>

#include "command_line.h"
#include "counted_calls.h"
#include "moivre/mechanism/read.h"

namespace {

moivre::test::CallCounter toml_files;
moivre::test::CallCounter sundials_contexts;

}  // namespace

moivre::Mechanism real_read(const moivre::Source& source) __asm__(
    "__real__ZN6moivre14read_mechanismERKNS_6SourceE");
moivre::Mechanism wrap_read(const moivre::Source& source) __asm__(
    "__wrap__ZN6moivre14read_mechanismERKNS_6SourceE");
moivre::Mechanism wrap_read(const moivre::Source& source) {
  toml_files.raise();
  return real_read(source);
}

extern "C" {
int __real_SUNContext_Create(void* communicator, SUNContext* context);
int __wrap_SUNContext_Create(void* communicator, SUNContext* context) {
  sundials_contexts.raise();
  return __real_SUNContext_Create(communicator, context);
}
}

namespace moivre {
namespace {

const std::string kProblems = MOIVRE_SOURCE_DIR "/problems";

struct Calls {
  int exit_code = -1;
  int toml = 0;
  int sundials = 0;
};

Calls run(std::vector<std::string> words) {
  words.insert(words.begin(), "moivre");
  words.push_back("--quiet");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  Calls calls;
  calls.toml = toml_files.calls_of([&] {
    calls.sundials = sundials_contexts.calls_of([&] {
      calls.exit_code = run_command_line(static_cast<int>(arguments.size()), arguments.data());
    });
  });
  return calls;
}

TEST(LeaveOut, APolynomialRunReadsNoToml) {
  const Calls calls = run({"solve", kProblems + "/polynomials/katsura-5.phc"});
  EXPECT_EQ(calls.exit_code, kDecided);
  EXPECT_EQ(calls.toml, 0);
}

TEST(LeaveOut, TheCommandWithLanesInitialisesNothingOfSundials) {
  const std::string file = kProblems + "/polynomials/katsura-5.phc";
  EXPECT_EQ(run({"solve", file, "--tracker", "lanes"}).sundials, 0);
  EXPECT_GT(run({"solve", file, "--tracker", "cvode", "--threads", "1"}).sundials, 0);
}

TEST(LeaveOut, MobilityTracksNoPath) {
  const Calls calls = run({"mobility", kProblems + "/mechanisms/four-bar.toml"});
  EXPECT_EQ(calls.exit_code, kDecided);
  EXPECT_EQ(calls.toml, 1);
  EXPECT_EQ(calls.sundials, 0);
}

}  // namespace
}  // namespace moivre
