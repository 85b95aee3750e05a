"""`./dev commits` knows a message in form from others."""

import sys

from house import ROOT, finish

sys.path.insert(0, str(ROOT / "scripts"))
from commits import complaints  # noqa: E402

WHY = "Because it was wrong."
GOOD = [("dev: try both commands on a bare Debian 12", WHY), ("lsp, dap: share framing", WHY),
        ("syntax: embed the table", f"{WHY}\n\nCo-authored-by: A <a@b>"), ("cli/view: need no lock", "As /dev/full does."),
        ("lsp: pass it on", WHY),
        ("x: " + "a" * 69, WHY)]
BAD = {("Values are cut", WHY): "is not `area", ("The lsp: cut values", WHY): "is not `area", ("lsp: cut", ""): "no body", ("lsp: cuts values", WHY): "imperative",
       ("lsp: fixed values", WHY): "imperative", ("lsp: adding values", WHY): "imperative", ("lsp: the values", WHY): "imperative",
       ("x: " + "a" * 70, WHY): "73 characters", ("x: cut", "Signed-off-by: A <a@b>"): "no body",
       ("x: cut", "See /home/me/notes."): "/home/me", ("x: cut", "from /mnt/disk"): "/mnt/disk"}

found = [f"{message}: {complaint}" for message in GOOD for complaint in complaints(*message)]
for message, why in BAD.items():
    if not any(why in complaint for complaint in complaints(*message)):
        found.append(f"nobody complains about {message}: {why}")
finish(found, f"{len(GOOD) + len(BAD)} messages")
