"""No folder reaches up: what each may include stands in the tables of ARCHITECTURE.md."""

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
OUTSIDE = {header: set(words(row[1])) for row in table("Who may use what")
           for header in words(row[0])}


def complain(name, bracket, header):
    folder = name.split("/")[0]
    if bracket == '"':
        target = header.split("/")[0]
        if "/" not in header:
            return f"{name}: {header}: include from the root of the tree"
        if target != folder and target not in FOLDERS[folder]:
            return f"{name}: includes {header}, but {folder}/ may not look into {target}/"
    for prefix, allowed in OUTSIDE.items():
        if header.startswith(prefix) and folder not in allowed:
            return f"{name}: includes {header}, which is for {', '.join(sorted(allowed))} alone"
    return None


def linked(folder):
    """The folders whose targets a folder's CMakeLists.txt names."""
    return set(re.findall(r"\bproskill_([a-z]+)\b", read(f"{folder}/CMakeLists.txt")))


SOURCES = [name for name in files(".cpp", ".h") if name.split("/")[0] in FOLDERS]
found = [complain(name, *include) for name in SOURCES for include in INCLUDE.findall(read(name))]
for folder in FOLDERS:
    for target in linked(folder) & set(FOLDERS) - FOLDERS[folder] - {folder}:
        found.append(f"{folder}/CMakeLists.txt: links proskill_{target}, which it may not include")
finish([complaint for complaint in found if complaint], f"{len(SOURCES)} files, {len(FOLDERS)} folders")
