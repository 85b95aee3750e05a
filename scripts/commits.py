"""Lists commits that violate the rules of CONTRIBUTING.md.

usage: commits.py [BASE]        those since BASE; without one, those that are not on the upstream branch
"""

import re
import subprocess
import sys

SUBJECT = re.compile(r"[a-z][a-z0-9./-]*(, [a-z][a-z0-9./-]*)*: \S.*")
LONGEST = 72
# A verb that is not in the imperative, at the beginning of a subject.
NO_IMPERATIVE = re.compile(r"(?:\w{2,}(?:ed|ing)|\w+[^su]s|the|a|an|what|it)\b", re.I)
IMPERATIVE = re.compile(r"(?:alias|bring|string|ring|need|feed|seed|embed|speed|shed|ping|proceed|exceed|succeed)\b", re.I)
MACHINE = re.compile(r"(?<![\w./-])(?:/(?:home|root|tmp|work|mnt|opt|Users|var|srv|data|build)/[\w.-]+|~/\w|[A-Z]:\\\\\w)")
TRAILER = re.compile(r"[A-Z][A-Za-z-]+-by: |(?:Fixes|Refs|See): ")


def complaints(subject, body):
    """The violations in a commit's message."""
    if not SUBJECT.fullmatch(subject):
        yield "the subject is not `area: what it does`"
    elif NO_IMPERATIVE.match(verb := subject.split(": ", 1)[1]) and not IMPERATIVE.match(verb):
        yield f"`{verb.split()[0]}` is no imperative: `area: do this`"
    if len(subject) > LONGEST:
        yield f"the subject has {len(subject)} characters, more than {LONGEST}"
    if not [line for line in body.splitlines() if line.strip() and not TRAILER.match(line)]:
        yield "there is no body that gives the reason"
    for path in MACHINE.findall(subject + "\n" + body):
        yield f"`{path}` is a path of one machine"


def git(*arguments):
    return subprocess.run(["git", *arguments], capture_output=True, text=True)


def base():
    """The merge base with the upstream branch, or with main."""
    for upstream in ("@{upstream}", "origin/main", "main"):
        found = git("merge-base", "HEAD", upstream)
        if found.returncode == 0:
            return found.stdout.strip()
    sys.exit("there is no branch to compare with: name a commit, ./dev commits BASE")


def commits(since):
    listed = git("log", "--no-merges", "--reverse", "--format=%h%x00%s%x00%b%x1e", f"{since}..HEAD")
    if listed.returncode:
        sys.exit(listed.stderr.strip())
    return [entry.strip("\n").split("\0") for entry in listed.stdout.split("\x1e") if entry.strip()]


def main():
    looked_at = commits(sys.argv[1] if len(sys.argv) > 1 else base())
    bad = 0
    for commit, subject, body in looked_at:
        found = list(complaints(subject, body))
        bad += bool(found)
        if found:
            print(f"{commit} {subject}", *(f"    {complaint}" for complaint in found), sep="\n")
    print(f"{len(looked_at)} commits, {bad} of them not in form")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
