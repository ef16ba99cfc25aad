#!/usr/bin/env python3
"""Makes the reference docs/api from the comments of include/fascia: a page for each header and an index.

  scripts/api_docs.py            writes the pages
  scripts/api_docs.py --check    fails if the pages differ from what it would write

The headers keep to these rules:
- The comment block at the top is the introduction. Its first paragraph is the purpose in the index. Indented lines are code.
- A comment `///` above a declaration, or a comment `//` behind it, describes it. Declarations without a comment that follow without an
  empty line share the one above, for example a destructor. Operators of structs need none.
- A comment `//` inside a class, on a line of its own after an empty line, begins a section: its first sentence is the title.
- What mentions Impl, is private or is marked FASCIA_HIDDEN belongs to the library alone and is left out.
"""
import re
import sys
import textwrap
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADERS = ROOT / "include" / "fascia"
PAGES = ROOT / "docs" / "api"
EXCEPTIONS = ("Error", "Interrupted", "ContextLost")


@dataclass
class Item:
    kind: str  # "struct", "class", "enum", "macro", "alias", "function", "member" or "section"
    name: str
    declarations: list  # one text each, without comments and bodies
    comment: str
    items: list = field(default_factory=list)  # of a struct or class


class Header:
    """The items of one header, in its order."""

    def __init__(self, path):
        self.file = path.name.removesuffix(".in")
        self.path = path
        self.lines = path.read_text().splitlines()
        self.at = 0
        self.introduction = self.read_introduction()
        self.items = self.read_items()
        self.includes = re.findall(r'#include "fascia/(\w+)\.h"', path.read_text())

    def fail(self, message):
        sys.exit(f"api_docs.py: {self.path.relative_to(ROOT)}:{self.at}: {message}")

    def read_introduction(self):
        lines = []
        while self.at < len(self.lines) and self.lines[self.at].startswith("//"):
            lines.append(self.lines[self.at][2:].removeprefix(" "))
            self.at += 1
        if not lines:
            self.fail("the header begins with no comment; expected its purpose")
        return lines

    def read_items(self, outer=None):
        """Reads to the end of the file, or of the class `outer`."""
        items, comment, after_blank, visible = [], [], True, True
        while self.at < len(self.lines):
            line = self.lines[self.at].strip()
            self.at += 1
            if outer and line == "};":
                return items
            if not line:
                after_blank = True
            elif line.startswith("///"):
                comment.append(line[3:].strip())
            elif line.startswith("//"):
                if outer and visible and after_blank:
                    items.append(self.read_section(line))
            elif line in ("public:", "private:", "protected:"):
                visible = line == "public:"
            elif re.match(r"#define FASCIA_VERSION", line):
                self.add(items, Item("macro", line.split()[1], [" ".join(line.split()[:2])], " ".join(comment)), after_blank)
                comment, after_blank = [], False
            elif re.match(r"#|}|namespace|(FASCIA_INLINE )?namespace", line):
                comment = []
            else:
                item = self.read_declaration(line, " ".join(comment), outer)
                if visible and item:
                    self.add(items, item, after_blank)
                comment, after_blank = [], False
        return items

    def read_section(self, line):
        text = [line[2:].strip()]
        while self.lines[self.at].strip().startswith("// "):
            text.append(self.lines[self.at].strip()[2:].strip())
            self.at += 1
        title, _, rest = " ".join(text).partition(".")
        return Item("section", title, [], rest.strip())

    def read_declaration(self, line, comment, outer):
        """One declaration with its body and the comment behind it; None: it belongs to the library alone."""
        code, behind = self.split(line)
        if re.match(r"(class|struct)\b[^;]*{$", code):
            head = self.tidy(code.rstrip("{"))
            kind, name = head.split()[:2]
            return Item(kind, name, [head], comment, self.read_items(outer=name))
        while not self.complete(code):
            more, behind = self.split(self.lines[self.at].strip())
            code += ("" if code.endswith("(") else " ") + more
            self.at += 1
        while behind and re.match(r"\s*//(?!/)", self.lines[self.at]):  # the comment goes on
            behind += " " + self.lines[self.at].strip()[2:].strip()
            self.at += 1
        if "FASCIA_HIDDEN" in code or "Impl" in code:
            return None
        code = self.tidy(re.sub(r"\s*{ return .*}$", ";", code))
        kind, name = self.name_of(code)
        return Item(kind, name, [code], " ".join(filter(None, [comment, behind])))

    @staticmethod
    def split(line):
        code, _, behind = line.partition("// ")
        return code.strip(), behind.strip()

    @staticmethod
    def complete(code):
        return code.count("{") == code.count("}") and code.count("(") == code.count(")") and code[-1:] in ";}"

    @staticmethod
    def tidy(code):
        return re.sub(r"\s+", " ", re.sub(r"FASCIA_(EXPORT|HIDDEN) ", "", code)).strip()

    def name_of(self, code):
        if found := re.match(r"enum class (\w+)", code):
            return "enum", found[1]
        if found := re.match(r"using (\w+)", code):
            return "alias", found[1]
        if found := re.search(r"operator\S+(?=\()|~?\w+(?=\()", re.sub(r"std::function<.*>", "F", code)):
            return "function", found[0]
        if found := re.search(r"(\w+)(\s*=[^=].*|{.*})?;$", code):
            return "member", found[1]
        self.fail(f"not understood: {code}")

    def add(self, items, item, after_blank):
        before = items[-1] if items else None
        if not item.comment and before and before.kind == item.kind and not after_blank:
            before.declarations += item.declarations
        elif not item.comment and item.kind != "section" and not item.name.startswith("operator"):
            self.fail(f"{item.declarations[0]} has no comment")
        else:
            items.append(item)


def code_block(declarations):
    lines = []
    for declaration in declarations:  # broken between parameters: other spaces are no-break spaces meanwhile
        kept = re.sub(r"(?<!,) ", "\N{NO-BREAK SPACE}", declaration)
        lines += textwrap.wrap(kept, 100, subsequent_indent="    ", break_long_words=False)
    lines = [line.replace("\N{NO-BREAK SPACE}", " ") for line in lines]
    return ["```cpp", *lines, "```", ""]


class Links:
    """Names of the reference in a text become links, shapes and calls become code."""

    def __init__(self, headers):
        self.targets = {}
        for header in headers:
            for item in header.items:
                self.targets[item.name] = f"{header.file[:-2]}.md#{item.name.lower()}"
                for member in item.items:
                    own = member.kind == "function" and f"{item.name}{member.name}".lower() or item.name.lower()
                    self.targets.setdefault(f"{item.name}::{member.name}", f"{header.file[:-2]}.md#{own}")

    def apply(self, text, page, inside=None):
        def reference(match):
            name = match[0].removesuffix("()")
            target = self.targets.get(name) if "::" in name or name in EXCEPTIONS or match[0].endswith("()") else None
            if not target and inside:
                target = self.targets.get(f"{inside}::{name}")
            if not target:
                return match[0] if name in EXCEPTIONS else f"`{match[0]}`"
            return f"[`{match[0]}`]({target.removeprefix(page + '.md')})"

        text = re.sub(r"(\[\w*_\w+\](\[\d\])?)", r"`\1`", text)
        pieces = re.split(r"(`[^`]*`|\"[^\"]*\")", text)
        for i in range(0, len(pieces), 2):
            pieces[i] = re.sub(r"\b(\w+::)?\w+\(\)|\b\w+(::\w+)+\b|\b(?:%s)\b" % "|".join(EXCEPTIONS), reference, pieces[i])
        return "".join(pieces)


def introduction_of(header, links, page):
    """As Markdown: indented lines are code."""
    out, code = [], []
    for line in [*header.introduction, ""]:
        if line.startswith("  "):
            code.append(line[2:])
            continue
        if code:
            out += ["```cpp", *code, "```"]
            code = []
        if line or (out and out[-1]):
            out.append(links.apply(line, page))
    return out


def struct_block(item):
    lines = ["```cpp", item.declarations[0] + " {"]
    for member in item.items:
        lines += ["  " + d for d in member.declarations]
    return [*lines, "};", "```", ""]


def type_page(item, links, page):
    out = [f"## `{item.name}`", "", links.apply(item.comment, page, item.name), ""]
    members = [m for m in item.items if m.kind == "member"]
    level = "####" if any(m.kind == "section" for m in item.items) else "###"
    if item.kind == "struct":
        out += struct_block(item)
        out += ["| member | meaning |", "|---|---|"]
        out += [f"| `{m.name}` | {links.apply(m.comment, page, item.name)} |" for m in members] + [""]
    else:
        out += code_block([item.declarations[0] + ";"])
    for member in item.items:
        if member.kind == "section":
            out += [f"### {member.name}", ""] + ([links.apply(member.comment, page, item.name), ""] if member.comment else [])
        elif member.kind != "member" and not member.name.startswith("operator"):
            heading = f"{level} `{item.name}::{member.name}`"
            out += [heading, ""] if heading not in out else []  # else another one of the same name
            out += code_block(member.declarations) + [links.apply(member.comment, page, item.name), ""]
    return out


def make_page(header, links):
    page = header.file[:-2]
    out = [f"# `fascia/{header.file}`", "", *introduction_of(header, links, page)]
    for item in header.items:
        if item.kind in ("struct", "class"):
            out += type_page(item, links, page)
        else:
            out += [f"## `{item.name}`", "", *code_block(item.declarations), links.apply(item.comment, page), ""]
    if not header.items:
        out += ["It includes " + ", ".join(f"[`{i}.h`]({i}.md)" for i in header.includes) + ".", ""]
    return "\n".join(out).rstrip() + "\n"


def purpose_of(header):
    text = []
    for line in header.introduction:
        if not line:
            break
        text.append(line)
    return " ".join(text)


def make_index(headers, links):
    out = ["# Reference of libfascia", "",
           "These pages describe every public name of the library. [The library](../guide/library.md) is the introduction.",
           "All names are in the namespace `fascia`. Units are SI. `#include <fascia/fascia.h>` includes every header.", "",
           "| header | purpose | names |", "|---|---|---|"]
    for header in headers:
        page = header.file[:-2]
        names = ", ".join(f"[`{i.name}`]({page}.md#{i.name.lower()})" for i in header.items)
        out.append(f"| [`{header.file}`]({page}.md) | {links.apply(purpose_of(header), 'README')} | {names} |")
    out += ["", "`scripts/api_docs.py` makes these pages from the comments of [include/fascia](../../include/fascia). Edit the headers, then run it."]
    return "\n".join(out) + "\n"


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    paths = sorted([*HEADERS.glob("*.h"), *HEADERS.glob("*.h.in")], key=lambda p: (p.name != "fascia.h", p.name))
    headers = [Header(path) for path in paths]
    links = Links(headers)
    pages = {"README.md": make_index(headers, links)}
    for header in headers:
        pages[header.file[:-2] + ".md"] = make_page(header, links)
    if sys.argv[1:]:
        there = {path.name: path.read_text() for path in PAGES.glob("*")}
        wrong = sorted(name for name in there.keys() | pages.keys() if there.get(name) != pages.get(name))
        if wrong:
            sys.exit(f"docs/api differs from the headers: {', '.join(wrong)}. Run scripts/api_docs.py and commit docs/api.")
        return
    PAGES.mkdir(exist_ok=True)
    for path in PAGES.glob("*"):
        path.unlink()
    for name, text in pages.items():
        (PAGES / name).write_text(text)


main()
