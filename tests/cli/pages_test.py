#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Do man pages and completion know what --help knows? Every command and option of the program is looked for in both.
#
#   pages_test.py PROGRAM SHARE      SHARE: the folder share of an installation, or of the build
#
# bash is needed; man, zsh and fish are asked where they are installed.
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SHARE = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
BASH = SHARE / "bash-completion/completions/moivre"
ZSH = SHARE / "zsh/site-functions/_moivre"
FISH = SHARE / "fish/vendor_completions.d/moivre.fish"


def said(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, f"{words}: {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


def help_of(command):
    return said(PROGRAM, *command.split(), "--help")


def commands(command=""):
    """This command and all below it, as --help lists them."""
    yield command
    listed = re.search(r"\nSubcommands:\n(.*?)\n\n", help_of(command), re.DOTALL)
    for name in re.findall(r"^  (\w+) ", listed[1] if listed else "", re.MULTILINE):
        yield from commands(f"{command} {name}".strip())


COMMANDS = list(commands())


def options(command):
    """Every name of every option: --json, -o."""
    names = re.findall(r"^  (-\S+)", help_of(command), re.MULTILINE)
    return sorted(name for line in names for name in line.split(","))


def page(command):
    return SHARE / "man/man1" / ("-".join(["moivre", *command.split()]) + ".1")


RANKS = page("mpi")


def bash_completes(*words, folder=None):
    """What bash offers for the last word; readline cuts words at '='."""
    quoted = " ".join(f"'{word}'" for word in words)
    script = f"source {BASH}; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _moivre; printf '%s\\n' \"${{COMPREPLY[@]}}\""
    return [line for line in said("bash", "--norc", "-c", script, cwd=folder).splitlines() if line]


def fish_completes(line, folder=None):
    script = f"source {FISH}; complete -C '{line}'"
    return [text.split("\t")[0] for text in said("fish", "--no-config", "-c", script, cwd=folder).splitlines()]


class ManPages(unittest.TestCase):
    def test_every_command_has_one_and_every_option_stands_in_it(self):
        there = sorted(path.name for path in page("").parent.iterdir() if path != RANKS)
        self.assertEqual(there, sorted(page(c).name for c in COMMANDS))
        for command in COMMANDS:
            text = page(command).read_text(encoding="utf-8").replace("\\-", "-")
            for name in options(command):
                self.assertIn(f"\\fB{name}\\fR", text, f"{command}: {name}")

    def test_examples_and_groups_stand_in_it(self):
        text = page("closures").read_text(encoding="utf-8").replace("\\-", "-")
        self.assertIn("\nmoivre closures four-bar.toml --json - | jq .counts\n", text)
        self.assertIn(".SS Robots (URDF)\n", text)
        self.assertIn("The default is \\fBauto\\fR.", text)
        self.assertIn("x*y <= 2 among the equations is a condition, and --where",
                      page("solve").read_text(encoding="utf-8").replace("\\-", "-").replace("\n", " "))

    def test_every_page_that_is_named_is_there(self):
        for path in page("").parent.iterdir():
            for name in re.findall(r"^\.BR (\S+) \(1\)", path.read_text(encoding="utf-8"), re.MULTILINE):
                self.assertTrue((page("").parent / (name.replace("\\-", "-") + ".1")).exists(), f"{path.name}: {name}")

    @unittest.skipUnless(RANKS.exists(), "the program was built without MPI")
    def test_the_program_for_many_processes_has_one_with_every_command(self):
        text = RANKS.read_text(encoding="utf-8").replace("\\-", "-")
        self.assertIn("\nmoivre-mpi - the commands of moivre", text)
        self.assertIn("\\fBmpirun -n RANKS moivre-mpi\\fR", text)
        for command in COMMANDS:
            if command and " " not in command:
                self.assertIn(f"\n\\fB{command}\\fR\n", text)

    @unittest.skipUnless(shutil.which("man"), "man is not installed")
    def test_man_shows_them_without_a_warning(self):
        for path in sorted(page("").parent.iterdir()):
            command = path.name
            done = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", str(path)], capture_output=True,
                                  text=True, check=False, env=dict(os.environ, LC_ALL="C.UTF-8", MANWIDTH="80", MANROFFSEQ=""))
            if done.returncode != 0 and not done.stdout:
                self.skipTest("man shows nothing here: " + done.stderr)
            self.assertEqual(done.stderr, "", command)
            for section in ("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "SEE ALSO"):
                self.assertRegex(re.sub(r"\x1b\[\d*m|.\x08", "", done.stdout), f"(?m)^{section}$")


class Bash(unittest.TestCase):
    def test_completes_commands(self):
        self.assertEqual(bash_completes("moivre", "so"), ["solve"])
        self.assertEqual(sorted(bash_completes("moivre", "")), sorted(c for c in COMMANDS if c and " " not in c))
        self.assertEqual(sorted(bash_completes("moivre", "family", "")), ["info", "learn", "solve"])
        self.assertEqual(bash_completes("moivre", "ledger", "mer"), ["merge"])

    def test_completes_every_option_of_every_command(self):
        for command in COMMANDS:
            self.assertEqual(sorted(bash_completes("moivre", *command.split(), "-")), options(command), command)

    def test_completes_the_words_of_an_option(self):
        self.assertEqual(bash_completes("moivre", "solve", "--start", "t"), ["total-degree"])
        self.assertEqual(bash_completes("moivre", "solve", "a.phc", "--precision", "double-"), ["double-double"])
        self.assertEqual(sorted(bash_completes("moivre", "motion", "--angles", "")), ["deg", "rad"])
        self.assertEqual(sorted(bash_completes("moivre", "family", "learn", "--tracker", "=", "")), ["cvode", "lanes"])
        self.assertEqual(bash_completes("moivre", "solve", "--predictor", "=", "q"), ["quintic"])
        self.assertEqual(bash_completes("moivre", "solve", "--tracker", "="), ["cvode", "lanes"])

    def test_completes_files_and_folders_alone_where_these_are_meant(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "two words.phc").touch()
            (pathlib.Path(folder) / "two").mkdir()
            both = ["two", "two words.phc"]
            self.assertEqual(sorted(bash_completes("moivre", "solve", "tw", folder=folder)), both)
            self.assertEqual(sorted(bash_completes("moivre", "solve", "--all", "tw", folder=folder)), both)
            self.assertEqual(sorted(bash_completes("moivre", "solve", "--where", "x > 0", "tw", folder=folder)), both)
            self.assertEqual(sorted(bash_completes("moivre", "ledger", "tw", folder=folder)), both)
            self.assertEqual(sorted(bash_completes("moivre", "check", "two words.phc", "tw", folder=folder)), both)
            self.assertEqual(sorted(bash_completes("moivre", "family", "learn", "x", "-o", "tw", folder=folder)), both)
            self.assertEqual(bash_completes("moivre", "study", "--out", "t", folder=folder), ["two"])
            self.assertEqual(bash_completes("moivre", "solve", "--seed", "", folder=folder), [])


@unittest.skipUnless(shutil.which("fish"), "fish is not installed")
class Fish(unittest.TestCase):
    def test_completes_commands_options_words_and_files(self):
        self.assertEqual(fish_completes("moivre so"), ["solve"])
        self.assertEqual(fish_completes("moivre family "), ["info", "learn", "solve"])
        for command in COMMANDS:
            offered = fish_completes(f"moivre {command} --".replace("  ", " "))
            self.assertEqual(sorted(offered), [name for name in options(command) if name.startswith("--")], command)
        self.assertEqual(fish_completes("moivre solve --start t"), ["total-degree"])
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "a.phc").touch()
            self.assertEqual(fish_completes("moivre solve --json a", folder), ["a.phc"])
            self.assertEqual(fish_completes("moivre solve a", folder), ["a.phc"])
            self.assertEqual(fish_completes("moivre solve --seed a", folder), [])


@unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
class Zsh(unittest.TestCase):
    def test_is_read_and_has_every_option(self):
        said("zsh", "-n", ZSH)
        text = ZSH.read_text(encoding="utf-8")
        for command in COMMANDS:
            function = text.split("\n_" + "_".join(["moivre", *command.split()]) + "() {\n")[1].split("\n}\n")[0]
            for name in options(command):
                self.assertRegex(function, rf"[){{,*]{re.escape(name)}[\[,}}]", command)


unittest.main(argv=sys.argv[:1], verbosity=1)
