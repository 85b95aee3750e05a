"""No namespace has two types of one name: the linker would silently use the members of one for both."""

import collections
import re

from house import files, finish, read

NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.M)
ANONYMOUS = re.compile(r"^namespace \{.*?^\} // namespace$", re.S | re.M)
TYPE = re.compile(r"^(?:template <[^>]*>\s*)?(?:struct|class|union|enum class) (\w+)(?: final)?(?: : [^{;]*)?\s*\{", re.M)

places = collections.defaultdict(set)
for name in files(".cpp", ".h"):
    shared = ANONYMOUS.sub("", read(name))
    starts = [(match.start(), match[1]) for match in NAMESPACE.finditer(shared)]
    for match in TYPE.finditer(shared):
        around = [space for start, space in starts if start < match.start()]
        places[(around[-1] if around else f"the global one of {name}", match[1])].add(name)
finish([f"{space}::{name} is defined in {' and in '.join(sorted(where))}"
        for (space, name), where in places.items() if len(where) > 1],
       f"{len(places)} types")
