// SPDX-License-Identifier: MIT
// One table: the command, its paragraphs, and the pages that belong to it.
#include "manual_text.h"

#include <map>

namespace moivre {
namespace {

struct Text {
  std::vector<std::string> paragraphs;
  std::vector<std::string> related = {};
};

const std::string kSystemFile =
    "The file is a list of equations, such as x/(y - 1) = 2, with sqrt(2), 2x and # comments, or "
    "is in the text form of PHCpack, Bertini, msolve or HomotopyContinuation.jl; what stands in it "
    "tells which. Numbers are kept exactly as they are typed. A faulty file is refused, "
    "and every fault is shown at once with its line and a caret.";
const std::string kConditions =
    "A line x > 0 or 0 < x*y <= 2 among the equations is a condition, and --where types one beside "
    "the file. All roots are looked for, those are told that are real and meet every condition, "
    "and the others are counted. A root that is on a boundary as far as its digits tell meets <= "
    "and >=, and not < and >; it is said to be there.";
const std::string kRoots =
    "Finds all isolated roots of a polynomial system, and tells of each its multiplicity, "
    "residual, accuracy and condition "
    "number, whether it is real, and whether it is certified.";
const std::string kNotSquare =
    "Systems need not be square. Equations that are too many are combined at random, and the "
    "roots that this adds are dropped and "
    "counted; --slice adds random linear equations where some are missing.";
const std::string kStop =
    "Ctrl-C, SIGTERM, SIGHUP and memory that runs out end a run with what is finished; the exit "
    "status is 2 then.";
const std::string kSame =
    "The same call gives the same result, byte for byte but for run times, with any number of "
    "threads.";
const std::string kMechanismFile =
    "A mechanism file (TOML) has bodies with points in their own frames, joints that say which "
    "points coincide, and drivers. It may "
    "have typed equations in their place.";

const std::map<std::string, Text> kTexts{
    {"",
     {{"Moivre finds every isolated root of a polynomial system, complex ones included, and "
       "every way in which a mechanism or a "
       "robot arm can be assembled. It follows one path to each root by homotopy continuation.",
       "Every path is accounted for: it ends at a root, at infinity, or has failed. Regular "
       "roots are certified: a simple root of "
       "the system as typed is proved to lie within the stated accuracy. Where as many are "
       "certified as a proved bound allows, the "
       "list is proved complete. What could not be decided is said to be undecided.",
       "Each command writes text for people; --json, --csv and the like write files for "
       "programs. Later versions may add keys to "
       "the JSON; they rename none."}}},
    {"moivre-mpi",
     {{"The ranks of an MPI job follow the paths of one run together, on one machine or many. The "
       "result is byte for byte that of moivre, but for run times, with any number of ranks and "
       "threads.",
       "Every rank reads the files and runs the command, so that all need these under the same "
       "names. Where it comes to a list of jobs, rank 0 hands out pieces of it. Rank 0 alone "
       "writes, and its exit status is that of the run. Paths are shared by solve, closures, "
       "motion, family learn and family solve, samples by sweep; the other commands are done by "
       "rank 0. --threads says how many each rank has.",
       "With --ledger the same command goes on after a kill or the death of a rank, with as many "
       "ranks as there are then, or by moivre alone. " +
           kStop,
       "MOIVRE_MPI_TRAFFIC=1 in the environment lets each rank tell its messages, bytes and "
       "processor time."},
      {"moivre-solve", "moivre-closures", "moivre-motion", "moivre-family", "moivre-ledger"}}},
    {"solve",
     {{kRoots, kSystemFile, kConditions, kNotSquare,
       "The last word on a result is its completeness: proved (there can be no other root), "
       "shown (every path was decided) or open. " +
           kSame,
       kStop},
      {"moivre-check", "moivre-info", "moivre-track", "moivre-family", "moivre-study"}}},
    {"track",
     {{"Follows one path of those that moivre solve follows, and writes a line of CSV for each "
       "step: the parameter t, the step, and "
       "the point. --from and --points take a start system of your own with its roots in place "
       "of the program's.",
       kSystemFile},
      {"moivre-solve"}}},
    {"info",
     {{"Shows what a solve would begin with: degrees, terms, which linear equations are "
       "eliminated, how rows and variables are "
       "scaled, and how many paths each start system has. Nothing is solved.",
       kSystemFile},
      {"moivre-solve"}}},
    {"closures",
     {{"Finds every way in which a mechanism can be assembled, planar or spatial, and counts "
       "those that are not real, too. That it "
       "cannot be assembled, or that it moves while its drivers stand, are answers. Each closure "
       "is certified from the dimensions as "
       "typed, and the result says whether there can be no other.",
       kMechanismFile,
       "Of a robot arm (URDF) with up to six joints, the closures are all joint values that hold "
       "its tip in a pose: --pose takes one, "
       "--poses a file of many. Robots whose links close loops take --loops.",
       kSame},
      {"moivre-motion", "moivre-sweep", "moivre-mobility", "moivre-guesses", "moivre-mechanism"}}},
    {"motion",
     {{"Follows every closure along the drivers, with velocities and accelerations. A branch "
       "ends at a dead point, at a bifurcation or "
       "at a limit of a joint; the result names the driver's value there. Branches that pass "
       "into one another are joined to circuits. "
       "The closures are solved again at checkpoints, so that an exchange of branches is seen.",
       kMechanismFile},
      {"moivre-closures", "moivre-newton"}}},
    {"newton",
     {{"Runs the Newton-Raphson method from one guess and shows every iteration, as textbooks "
       "print it. It finds one pose or root, and "
       "says nothing of others: moivre closures and moivre solve find all.",
       "Where constraints depend on one another or are too few, the step is that of least norm, "
       "in which --weight counts coordinates "
       "more or less."},
      {"moivre-closures", "moivre-guesses", "moivre-solve"}}},
    {"mobility",
     {{"Finds the degrees of freedom of a mechanism and names redundant constraints, from the "
       "rank of the constraints' Jacobian at the "
       "closures. Without solving for closures, --guess names the pose to look at.",
       kMechanismFile},
      {"moivre-closures"}}},
    {"guesses",
     {{"Writes every closure of a mechanism, or every real root of a system, as an initial guess "
       "for a Newton solver of your own: names "
       "and values, as JSON or as a table."},
      {"moivre-closures", "moivre-newton", "moivre-solve"}}},
    {"mechanism",
     {{"Writes a robot (URDF) as a mechanism file that can be read, changed and given to the "
       "other commands. --pose makes the pose of its "
       "tip a driver; --loops closes loops of links by a side file."},
      {"moivre-closures", "moivre-motion"}}},
    {"study",
     {{"Solves each file with many trackers and tolerances, from several seeds, and compares the "
       "roots with references of 50 digits: what "
       "accuracy costs how much time. --out writes tables, diagrams and a page for a browser; "
       "gnuplot, where it is installed, draws."},
      {"moivre-solve"}}},
    {"check",
     {{"Judges a result of moivre solve, or a solution list of PHCpack, independently of what "
       "made it: certifies every root from the exact "
       "coefficients, adds up every sum, asks whether every root meets the conditions of the file, "
       "and compares the counts with proved bounds. Each false "
       "claim is named, and each proof that "
       "cannot be repeated; the exit status is 2 then."},
      {"moivre-solve"}}},
    {"family",
     {{"A family is a system with parameters. moivre family learn solves it once at random "
       "complex values and keeps the roots in a file. "
       "moivre family solve then follows, for values of your own, only as many paths as a "
       "generic member has roots."},
      {"moivre-solve"}}},
    {"family learn",
     {{"Solves a random complex member of a system with parameters and keeps its roots in a "
       "file. The parameters are those that a "
       "Bertini file declares, those that --parameters names, or the dimensions of a mechanism.",
       "Without --monodromy the member is solved from a start system. With it one root is found "
       "and carried along loops of members until "
       "nothing new appears, for systems that no start system fits. " +
           kStop},
      {"moivre-family-solve", "moivre-family-info"}}},
    {"family solve",
     {{"Finds all roots of members of a family that moivre family learn has written: one by "
       "--at, or one for each row of a table. What the "
       "file says is judged before it is used: it proves nothing by itself."},
      {"moivre-family-learn", "moivre-family-info"}}},
    {"family info",
     {{"Shows what a family file holds: its system and parameters, how many roots a generic "
       "member has, and whether these are proved to "
       "be all."},
      {"moivre-family-learn", "moivre-family-solve"}}},
    {"sweep",
     {{"Counts the real closures of a mechanism while one or two of its numbers vary, as a curve "
       "or a map, and finds where the count "
       "changes. On the page of --html the closures are drawn where you point.",
       kMechanismFile},
      {"moivre-closures", "moivre-motion"}}},
    {"ledger",
     {{"Shows how a run stands that is kept by --ledger: what is done, the rate, the time left "
       "and "
       "what became of the paths so far; when it has ended, its result too. The run may be going "
       "on meanwhile. After a kill the run's own command goes on from the ledger; its result is "
       "byte for byte that of a run that nothing disturbed, but for the times.",
       "The exit code is that of the run, and 2 where it has not ended."},
      {"moivre-ledger-merge", "moivre-solve", "moivre-closures", "moivre-sweep",
       "moivre-family-solve"}}},
    {"ledger merge",
     {{"Puts together what the parts of one run have kept, each with --part K/N in a ledger of its "
       "own, on any machines: from there the run's own command goes on, and its result is byte for "
       "byte that of one process, but for the times. The parts' ledgers stay as they are. Ledgers "
       "of another run, with what differs, and damaged ones are refused."},
      {"moivre-ledger", "moivre-solve", "moivre-sweep", "moivre-family-solve"}}}};

}  // namespace

std::vector<std::string> paragraphs_on(const std::string& command) {
  const auto text = kTexts.find(command);
  return text != kTexts.end() ? text->second.paragraphs : std::vector<std::string>();
}

std::vector<std::string> related_to(const std::string& command) {
  const auto text = kTexts.find(command);
  return text != kTexts.end() ? text->second.related : std::vector<std::string>();
}

}  // namespace moivre
