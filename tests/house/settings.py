"""The schema of `.proskill.json` is valid, contains every code, and agrees with the program.

usage: settings.py PROGRAM

PROSKILL_UPDATE=1 updates the codes in the schema.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from house import ROOT, finish, read

SKIPPED = 77  # as ctest expects

PROGRAM = sys.argv[1]
SCHEMA = "docs/proskill.schema.json"
MANUAL = "docs/checking.md"

# In addition to those of the manual: valid ones, and invalid ones with one error each.
GOOD = ["{}", '{"style": false}', '{"severity": {}}', '{"$schema": "x", "style": true}',
        '{"severity": {"PS0501": "off", "PS0708": "error", "PS0902": "hint"}}']
BAD = ["[]", "3", "null", '"style"', '{"style": 1}', '{"style": null}', '{"style": []}',
       '{"colour": true}', '{"severity": []}', '{"severity": "off"}', '{"severity": {"PS9999": "off"}}',
       '{"severity": {"PS0708": "loud"}}', '{"severity": {"PS0708": true}}', '{"$schema": 1}',
       '{"severity": {"PS0708": {}}}', '{"severity": {"PS0708": ["off"]}}',
       '{"severity": {"style": true}}', '{"severity": {"severity": {"PS0708": "off"}}}']


def codes():
    """Each code in the form of the schema, with the text that editors show when they complete it."""
    listed = subprocess.run([PROGRAM, "explain", "--list"], capture_output=True, text=True, check=True)
    rows = (line.split(maxsplit=2) for line in listed.stdout.splitlines())
    return {code: {"$ref": "#/$defs/severity", "description": f"{title} ({usual})"}
            for code, usual, title in rows}


def accepted(text, directory):
    """Whether the program accepts these settings."""
    (directory / ".proskill.json").write_text(text, encoding="utf-8")
    (directory / "main.proskill").write_text("(defskill mission :body ((^ 1)))\n", encoding="utf-8")
    done = subprocess.run([PROGRAM, "check", directory / "main.proskill"], capture_output=True)
    return done.returncode == 0


def update(schema):
    schema["properties"]["severity"]["properties"] = codes()
    with open(ROOT / SCHEMA, "w", encoding="utf-8") as file:
        file.write(json.dumps(schema, indent=2, ensure_ascii=False) + "\n")


schema = json.loads(read(SCHEMA))
if os.environ.get("PROSKILL_UPDATE"):
    update(schema)
if schema["properties"]["severity"]["properties"] != codes():
    finish([f"{SCHEMA}: its codes are not those of `proskill explain --list`;"
            " PROSKILL_UPDATE=1 writes them anew"], "")

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed (apt-get install python3-jsonschema); the codes alone were compared")
    sys.exit(SKIPPED)

jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
shown = re.findall(r"```json\n(.*?)```", read(MANUAL), re.S)
complaints = [] if shown else [f"{MANUAL}: shows no settings"]
with tempfile.TemporaryDirectory() as name:
    for text, good in [(text, True) for text in shown + GOOD] + [(text, False) for text in BAD]:
        if validator.is_valid(json.loads(text)) != good:
            complaints.append(f"{SCHEMA}: {'rejects' if good else 'accepts'} {text}")
        if accepted(text, pathlib.Path(name)) != good:
            complaints.append(f"the program {'rejects' if good else 'accepts'} {text}")
finish(complaints, f"{len(codes())} codes, {len(shown + GOOD + BAD)} settings")
