"""No source file has more than 600 lines: beyond that it holds more than one idea."""

from house import files, finish, read

LIMIT = 600

lengths = {name: read(name).count("\n")
           for name in files(".cpp", ".h", ".c", ".js", ".py", "dev", ".cmake")}
finish([f"{name}: {lines} lines, more than {LIMIT}"
        for name, lines in lengths.items() if lines > LIMIT],
       f"{len(lengths)} files, the longest has {max(lengths.values())} lines")
