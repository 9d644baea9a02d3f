# SPDX-License-Identifier: MIT
# How does Doxygen see what a header says of itself? Its first comment becomes the file's: the question, then the rest as typed.
function plain(text) {
  gsub(/[\\@<>#%&]/, "\\\\&", text)
  return text
}
NR == 1 { is_head = 1; next }
is_head && /^\/\// {
  line = substr($0, 3)
  sub(/^ /, "", line)
  if (NR == 2) {
    printf "/** @file\n@brief %s\n", plain(line)
  } else {
    if (!has_more) print "@verbatim"
    has_more = 1
    print line
  }
  next
}
is_head {
  if (has_more) print "@endverbatim"
  print "*/"
  is_head = 0
}
{ print }
