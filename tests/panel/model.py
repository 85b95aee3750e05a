"""The panel's types, and the tests of what it computes without a page."""

import sys

from packages import run

sys.exit(run("npm", "test", "--silent"))
