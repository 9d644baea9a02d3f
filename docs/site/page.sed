# SPDX-License-Identifier: MIT
# How do pages that name each other as `docs/robots.md` link to each other? Paths of pages become links, outside blocks of code.
/^ *```/,/^ *```$/b
s|`\(docs/[a-zA-Z0-9/_-]*\.md\)`|[\1](\1)|g
s|`docs/decisions/`|[docs/decisions/](decisions.md)|g
s|`\(CHANGELOG\.md\)`|[\1](\1)|g
s|`\(CONTRIBUTING\.md\)`|[\1](\1)|g
# Headings that links lead to.
s|^## Glossary$|## Glossary {#glossary}|
