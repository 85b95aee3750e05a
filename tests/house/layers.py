"""Folders include only what the tables of ARCHITECTURE.md allow."""

import re

from house import files, finish, read

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)


def table(heading):
    """The rows of the first table below a heading, each a list of its cells without backquotes."""
    section = read("ARCHITECTURE.md").split(f"## {heading}\n", 1)[1]
    rows = re.search(r"^\|.*\n\|[-| ]+\n((?:\|.*\n)+)", section, re.M).group(1)
    return [[cell.strip() for cell in row.strip("|\n").split("|")] for row in rows.splitlines()]


def words(cell):
    return re.findall(r"`([^`]+)`", cell)


FOLDERS = {words(row[0])[0].rstrip("/"): set(words(row[2])) for row in table("Code map")}
TOPS = {folder for folder in FOLDERS if "/" not in folder}
OUTSIDE = {header: set(words(row[1])) for row in table("Restricted headers")
           for header in words(row[0])}


def row_of(path):
    """The deepest row that a file is below."""
    folder = path.rsplit("/", 1)[0]
    while folder not in FOLDERS:
        folder = folder.rsplit("/", 1)[0]
    return folder


def is_allowed(name, header):
    """Another library, or one folder of it, is allowed by the row of the whole library, a part of the same by the part's own row.
    A file that lies in no subfolder is the library's face: it may include all subfolders."""
    top, target_top = name.split("/")[0], header.split("/")[0]
    if target_top != top:
        return bool({target_top, row_of(header)} & FOLDERS[top])
    here, there = row_of(name), row_of(header)
    return here == there or here == top or there in FOLDERS[here]


def complain(name, bracket, header):
    top = name.split("/")[0]
    if bracket == '"':
        if "/" not in header:
            return f"{name}: {header}: include from the root of the tree"
        if header.split("/")[0] in TOPS and not is_allowed(name, header):
            return f"{name}: includes {header}, but {row_of(name)}/ may not look into {row_of(header)}/"
    for prefix, allowed in OUTSIDE.items():
        if header.startswith(prefix) and top not in allowed:
            return f"{name}: includes {header}, which is for {', '.join(sorted(allowed))} alone"
    return None


def linked(folder):
    """The folders whose targets a folder's CMakeLists.txt names."""
    return set(re.findall(r"\bproskill_([a-z]+)\b", read(f"{folder}/CMakeLists.txt")))


def cycles():
    """Subfolders that may include one another, by one step or by many; a library's face does not count."""
    rows = {folder: {to for to in allowed if "/" in to} for folder, allowed in FOLDERS.items()
            if "/" in folder}
    reach = {folder: set(allowed) for folder, allowed in rows.items()}
    for _ in rows:
        for folder in reach:
            reach[folder] |= set().union(*(reach.get(to, set()) for to in reach[folder]))
    return [f"ARCHITECTURE.md: {folder}/ is part of a cycle" for folder in rows
            if folder in reach[folder]]


SOURCES = [name for name in files(".cpp", ".h") if name.split("/")[0] in FOLDERS]
found = [complain(name, *include) for name in SOURCES for include in INCLUDE.findall(read(name))]
for folder in TOPS:
    for target in linked(folder) & TOPS - {it.split("/")[0] for it in FOLDERS[folder]} - {folder}:
        found.append(f"{folder}/CMakeLists.txt: links proskill_{target}, which it may not include")
found += cycles()
finish([complaint for complaint in found if complaint], f"{len(SOURCES)} files, {len(FOLDERS)} folders")
