// SPDX-License-Identifier: MIT
// moivre mechanism ARM.urdf: the robot as a mechanism file, to be read, changed and given to the
// other commands.
#include <memory>

#include "arm_closures.h"
#include "command.h"
#include "common_options.h"
#include "moivre/mechanism/read.h"
#include "output.h"

namespace moivre {
namespace {

struct MechanismCommand {
  std::string file;
  std::string output = "-";
  ArmOptions arm;
};

int run(const MechanismCommand& command) {
  for (const std::string& input : {command.file, command.arm.loops}) {
    require_distinct({command.output}, input);
  }
  require_ending(command.output, ".toml");
  const std::string text = robot_as_mechanism(command.file, read_source(command.file), command.arm);
  Output output(command.output);
  // What is written can be read: a robot beyond the bounds of mechanism files is told so here.
  read_mechanism(
      {command.output == "-" ? command.file + ", as a mechanism" : command.output, text});
  output.write(text);
  return kDecided;
}

}  // namespace

void add_mechanism_command(CLI::App& moivre, Chosen& chosen) {
  const auto command = std::make_shared<MechanismCommand>();
  CLI::App& app = *moivre.add_subcommand(
      "mechanism", "Write a robot (URDF) as a mechanism file that you can edit");
  app.add_option("FILE", command->file, "robot (.urdf); - is standard input")->required();
  app.add_option("-o,--output", command->output,
                 "write the mechanism file here; - is standard output")
      ->capture_default_str()
      ->type_name("PATH");
  add_robot_options(app, command->arm);
  add_examples(app, {"moivre mechanism arm.urdf", "moivre mechanism arm.urdf -o arm.toml",
                     "moivre mechanism delta.urdf --loops delta.loops.toml -o delta.toml",
                     "moivre mechanism arm.urdf | moivre mobility -"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
