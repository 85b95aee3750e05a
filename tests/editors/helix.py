"""What Helix is given is in order. Helix itself is not in Debian 12; its queries are tried on the parser in
tests/syntax/queries_test.cpp."""

import pathlib
import subprocess
import sys
import tomllib

HELIX = pathlib.Path(__file__).resolve().parents[2] / "editors/helix"
complaints = []

settings = tomllib.loads((HELIX / "languages.toml").read_text())
language, fiacre = settings["language"]
grammar, = settings["grammar"]
if language["name"] != "proskill" or language["file-types"] != ["proskill"]:
    complaints.append("languages.toml: not for *.proskill")
if fiacre["name"] != "fiacre" or fiacre["file-types"] != ["fcr"]:
    complaints.append("languages.toml: not for *.fcr")
for server in language["language-servers"] + fiacre["language-servers"]:
    if server not in settings["language-server"]:
        complaints.append(f"languages.toml: no server {server}")
if settings["language-server"]["proskill"] != {"command": "proskill", "args": ["lsp"]}:
    complaints.append("languages.toml: the server is `proskill lsp`")
if language["grammar"] != grammar["name"]:
    complaints.append("languages.toml: another grammar than the one that is built")

made = subprocess.run([sys.executable, "-B", HELIX / "make_queries.py", "--print"],
                      capture_output=True, text=True, check=True).stdout
if made != (HELIX / "queries/proskill/highlights.scm").read_text():
    complaints.append("highlights.scm: run editors/helix/make_queries.py")

print("\n".join(complaints) or "languages.toml and highlights.scm")
sys.exit(bool(complaints))
