"""`proskill view` and reports in Chromium, used as a person would.

usage: browser.py PROGRAM SCREENSHOTS
"""

import os
import shutil
import sys

from npm import ROOT, install, run, skip

chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
if chromium is None:
    skip("chromium is not installed")
install()
os.environ.update(PROSKILL=sys.argv[1], SCREENSHOTS=sys.argv[2], CHROMIUM=chromium, EXAMPLES=str(ROOT / "examples"))
os.makedirs(sys.argv[2], exist_ok=True)
sys.exit(run("node", "--test", "--test-reporter=spec", "--test-concurrency=1",
             "--test-timeout=300000", "e2e/"))
