# SPDX-License-Identifier: MIT
# Does all English of results stand in the sentences files of the modules that have one? Prints each breach and fails if any.
#
# Run as: cmake -D ROOT=<tree> -P check_sentences.cmake. In src/<module>/ a statement outside of <name>_sentences.cpp has no three words of
# English in its literals. A literal without a space is a key or a name, and counts nothing. Edges, which are no breach:
#   - what refuses an input: a throw, a broken rule, a fault in a file; it stands beside the rule;
#   - the names of a list below.
# Not seen: English that is put together in several statements, of two words each.
cmake_minimum_required(VERSION 3.25)

set(modules motion family closures solver)
# What is thrown, or becomes so: broken rules and faults are collected first.
set(refusals "throw |InvalidInput\\(|broken\\.(push|emplace)_back|, broken\\)|faults_?\\.(push|emplace)_back|refuse\\(|refusal \\+=")
# Names of several words: values of an enumeration as results have them.
set(names "turns over dead points" "at infinity as rounded"
  # of four-bars, as src/closures/four_bars.cpp has them
  "double-crank with change points" "crank-rocker with change points" "double-rocker with change points"
  "rocker-crank with change points" "two pairs of equal links, with change points" "four equal links, with change points"
  "cannot be closed")

string(ASCII 1 end)  # for ";", and 2 and 3 for brackets, which have a meaning in lists
string(ASCII 2 left)
string(ASCII 3 right)
set(breaches 0)

# Text without comments and includes, as a list of literals, ends of statements and what is between.
function(tokens_of variable file)
  file(READ ${file} text)
  string(REPLACE ";" "${end}" text "${text}")
  string(REPLACE "[" "${left}" text "${text}")
  string(REPLACE "]" "${right}" text "${text}")
  string(REPLACE "\\\"" "'" text "${text}")
  string(REPLACE "'\"'" "" text "${text}")
  string(REGEX REPLACE "//[^\n]*|#include[^\n]*" "" text "${text}")
  string(REGEX MATCHALL "\"[^\"\n]*\"|${end}|[^\"${end}]+" tokens "${text}")
  set(${variable} "${tokens}" PARENT_SCOPE)
endfunction()

function(count_words variable literal)
  set(count 0)
  if(literal MATCHES " " AND NOT literal IN_LIST names)
    string(REGEX MATCHALL "[A-Za-z][A-Za-z'-]+" words "${literal}")
    list(LENGTH words count)
  endif()
  set(${variable} ${count} PARENT_SCOPE)
endfunction()

function(check_sentences file)
  tokens_of(tokens ${file})
  set(code "")
  set(english "")
  set(total 0)
  foreach(token IN LISTS tokens)
    if(token MATCHES "^\"(.*)\"$")
      set(literal "${CMAKE_MATCH_1}")
      count_words(count "${literal}")
      math(EXPR total "${total} + ${count}")
      string(APPEND english " \"${literal}\"")
    elseif(NOT token STREQUAL end)
      string(APPEND code "${token}")
    else()
      if(total GREATER_EQUAL 3 AND NOT code MATCHES "${refusals}")
        file(RELATIVE_PATH shown ${ROOT} ${file})
        string(REPLACE "${end}" ";" english "${english}")
        string(REPLACE "${left}" "[" english "${english}")
        string(REPLACE "${right}" "]" english "${english}")
        message("${shown}: English outside of a sentences file:${english}")
        math(EXPR breaches "${breaches} + 1")
      endif()
      set(code "")
      set(english "")
      set(total 0)
    endif()
  endforeach()
  set(breaches ${breaches} PARENT_SCOPE)
endfunction()

foreach(module IN LISTS modules)
  file(GLOB sources ${ROOT}/src/${module}/*.h ${ROOT}/src/${module}/*.cpp)
  set(has_sentences FALSE)
  foreach(file IN LISTS sources)
    if(file MATCHES "_sentences\\.cpp$")
      set(has_sentences TRUE)
    else()
      check_sentences(${file})
    endif()
  endforeach()
  if(NOT has_sentences)
    message("src/${module}: no sentences file")
    math(EXPR breaches "${breaches} + 1")
  endif()
endforeach()

if(breaches)
  message(FATAL_ERROR "${breaches} breaches")
endif()
