"""No script has the name of a module of Python's: in its folder it would take that module's place, for all scripts there."""

import pathlib
import sys

from house import files, finish

scripts = list(files(".py"))
finish([f"{name}: Python has a module of this name" for name in scripts
        if pathlib.Path(name).stem in sys.stdlib_module_names], f"{len(scripts)} scripts")
