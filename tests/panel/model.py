"""The panel's types, and the tests of what it computes without a page."""

import sys

from npm import install, run

install()
sys.exit(run("npm", "test", "--silent"))
