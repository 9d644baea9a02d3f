// SPDX-License-Identifier: MIT
// Sections in the order of man-pages(7). The page has no date: the same sources make the same
// bytes.
#include "man_page.h"

#include <algorithm>
#include <stdexcept>

#include "manual_text.h"
#include "moivre/expression/joined.h"

namespace moivre {
namespace {

/// Text as troff takes it: a backslash and a hyphen as typed, and no line that begins like a
/// request.
std::string escaped(const std::string& text) {
  std::string result = text.find_first_of(".'") == 0 ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

/// "--start WORD", "-o, --output PATH".
std::string head_of(const ManualOption& option) {
  std::vector<std::string> names;
  std::transform(option.names.rbegin(), option.names.rend(), std::back_inserter(names), bold);
  return joined(names, ", ") + (option.value.empty() ? "" : " " + italic(option.value));
}

/// But for a word that is meant as it is written: one of the choices, or the name before a colon.
std::string with_capital(const ManualOption& option) {
  std::string sentence = option.sentence;
  const std::string first = sentence.substr(0, sentence.find(' '));
  const bool is_choice = std::count(option.choices.begin(), option.choices.end(), first) > 0;
  if (is_choice || first.ends_with(':')) return sentence;
  if (!sentence.empty()) sentence.front() = static_cast<char>(std::toupper(sentence.front()));
  return sentence;
}

/// The sentence, then what else is known: default, repetition, what it goes with.
std::string told(const ManualOption& option) {
  std::string text = escaped(with_capital(option)) + '.';
  if (option.value.empty() || option.standard.empty()) {
    // no default to be told
  } else if (option.sentence.find("default") == std::string::npos) {
    text += " The default is " + bold(option.standard) + '.';
  }
  const bool is_said = option.sentence.find("repeated") != std::string::npos;
  if (option.repeated && !is_said) text += " More than one may be given.";
  if (!option.needs.empty()) text += " It needs " + bold(joined(option.needs, ", ")) + '.';
  if (!option.excludes.empty()) text += " Not with " + bold(joined(option.excludes, ", ")) + '.';
  if (option.required && option.names.front().front() == '-') text += " It must be given.";
  return text;
}

std::string item(const std::string& head, const std::string& text) {
  return ".TP\n" + head + '\n' + text + '\n';
}

std::string synopsis(const ManualCommand& command) {
  std::string line = bold(command.call.empty() ? command.name : command.call);
  for (const ManualOption& option : command.options) {
    if (option.required) line += ' ' + head_of(option);
  }
  line += " [" + italic("OPTION") + "]...";
  for (const ManualOption& argument : command.arguments) {
    line += ' ' + italic(argument.names.front()) + (argument.repeated ? "..." : "");
  }
  if (!command.commands.empty()) line += ' ' + italic("COMMAND") + " ...";
  return ".SH SYNOPSIS\n" + line + '\n';
}

std::string description(const ManualCommand& command) {
  const std::vector<std::string> paragraphs = paragraphs_on(words_of(command));
  if (paragraphs.empty()) {
    throw std::logic_error("manual_text.cpp says nothing of " + command.name);
  }
  std::string text = ".SH DESCRIPTION\n" + escaped(paragraphs.front()) + '\n';
  for (std::size_t k = 1; k < paragraphs.size(); ++k) {
    text += ".PP\n" + escaped(paragraphs[k]) + '\n';
  }
  for (const ManualOption& argument : command.arguments) {
    text += item(italic(argument.names.front()), told(argument));
  }
  return text;
}

std::string commands(const ManualCommand& command) {
  if (command.commands.empty()) return "";
  std::string text = ".SH COMMANDS\n";
  for (const ManualCommand& below : command.commands) {
    text += item(bold(below.name.substr(command.name.size() + 1)), escaped(below.sentence) + '.');
  }
  return text;
}

/// Groups in the order of --help; the first one has no heading of its own.
std::string options(const ManualCommand& command) {
  std::vector<std::string> groups;
  for (const ManualOption& option : command.options) {
    if (std::find(groups.begin(), groups.end(), option.group) == groups.end()) {
      groups.push_back(option.group);
    }
  }
  std::string text = ".SH OPTIONS\n";
  for (const std::string& group : groups) {
    if (group != groups.front()) text += ".SS " + escaped(group) + '\n';
    for (const ManualOption& option : command.options) {
      if (option.group == group) text += item(head_of(option), told(option));
    }
  }
  return text;
}

std::string exit_status() {
  return ".SH \"EXIT STATUS\"\n" +
         item("0", "Every path was decided. That no root exists is an answer, too.") +
         item("1",
              "The call or the file is wrong, or a result could not be written. Every fault is "
              "told on "
              "standard error.") +
         item("2",
              "A path failed, a claim was refuted, or the run was interrupted. What is known was "
              "written.") +
         item("3", "An internal error of Moivre.");
}

std::string examples(const ManualCommand& command) {
  if (command.examples.empty()) return "";
  std::string text = ".SH EXAMPLES\n.nf\n";
  for (const std::string& example : command.examples) text += escaped(example) + '\n';
  return text + ".fi\n";
}

std::string see_also(const ManualCommand& command, const ManualCommand& program) {
  std::vector<std::string> pages;
  if (words_of(command).empty()) {
    for_each_command(program, [&](const ManualCommand& other) {
      if (!words_of(other).empty()) pages.push_back(page_name(other));
    });
  } else {
    pages = related_to(words_of(command));
    pages.insert(pages.begin(), page_name(program));
    if (command.call.empty()) {
      for (const ManualCommand& below : command.commands) pages.push_back(page_name(below));
    }
  }
  std::vector<std::string> named;
  for (const std::string& page : pages) named.push_back(".BR " + escaped(page) + " (1)");
  return ".SH \"SEE ALSO\"\n" + joined(named, ",\n") + '\n';
}

}  // namespace

std::string page_name(const ManualCommand& command) {
  std::string name = command.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string man_page(const ManualCommand& command, const ManualCommand& program,
                     const std::string& version) {
  std::string title = page_name(command);
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string summary = command.sentence;
  if (!summary.empty()) summary.front() = static_cast<char>(std::tolower(summary.front()));
  if (!summary.empty() && summary.back() == '.') summary.pop_back();
  return ".\\\" Made by the build from the options of the program.\n.TH " + escaped(title) +
         " 1 \"\" \"Moivre " + version + "\" \"Moivre\"\n.nh\n.ad l\n.SH NAME\n" +
         escaped(page_name(command)) + " \\- " + escaped(summary) + '\n' + synopsis(command) +
         description(command) + commands(command) + options(command) + examples(command) +
         exit_status() + see_also(command, program);
}

}  // namespace moivre
