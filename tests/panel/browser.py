"""Tests `proskill view` and reports in Chromium as a user would.

usage: browser.py PROGRAM SCREENSHOTS
"""

import os
import shutil
import sys

from packages import npm, run

chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
if chromium is None:
    npm.skip("chromium is not installed (apt-get install chromium)")
os.environ.update(PROSKILL=sys.argv[1], SCREENSHOTS=sys.argv[2], CHROMIUM=chromium, EXAMPLES=str(npm.ROOT / "examples"))
os.makedirs(sys.argv[2], exist_ok=True)
sys.exit(run("node", "--test", "--test-reporter=spec", "--test-concurrency=1",
             "--test-timeout=300000", "e2e/"))
