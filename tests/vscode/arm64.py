"""The server of the extension for arm64 in QEMU: it starts as the extension starts it, with nothing but the C library beside it, and reports the errors,
pictures, verdicts and traces that the server of this computer reports.

usage: arm64.py FILE.vsix PROSKILL

Programs that it starts, such as the one that verifies, are run by QEMU, too: in a user namespace, which has interpreters of its own
since Linux 6.7. Nothing is registered on this computer.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / 'tests'), str(ROOT / 'tests/lsp/sessions')]
import client as lsp  # noqa: E402
from npm import skip  # noqa: E402

QEMU = shutil.which('qemu-aarch64')
CROSS = pathlib.Path('/usr/aarch64-linux-gnu/lib')
C_LIBRARY = ('ld-linux-aarch64.so.1', 'libc.so.6', 'libm.so.6')
SERVER = 'extension/server/linux-arm64/'
PROGRAM = 'lift/bug.proskill'
PROPERTY = 'doors_closed_when_moving'

lsp.PATIENCE = 600  # QEMU is slow, and so is a busy computer


def interpreter():
    """The line that registers QEMU for programs of arm64."""
    header = b'\x7fELF\x02\x01\x01' + bytes(9) + b'\x02\x00\xb7\x00'
    mask = b'\xff' * 7 + bytes(9) + b'\xfe\xff\xff\xff'
    quoted = [''.join(f'\\x{byte:02x}' for byte in data) for data in (header, mask)]
    return f':qemu-aarch64:M::{quoted[0]}:{quoted[1]}:{QEMU}:F'


def enter():
    """Starts this script again in a namespace in which programs of arm64 run."""
    if os.environ.get('PROSKILL_ARM64') == 'entered':
        return
    with tempfile.TemporaryDirectory() as folder:
        inner = 'mount -t binfmt_misc binfmt_misc "$1" && printf "%s" "$2" >"$1/register" || exit 99; shift 2; exec "$@"'
        ended = subprocess.run(['unshare', '--user', '--map-root-user', '--mount', 'sh', '-c', inner, 'sh', folder, interpreter(), sys.executable, '-B', *sys.argv],
                               env={**os.environ, 'PROSKILL_ARM64': 'entered'})
    if ended.returncode == 99:
        skip('the kernel has no interpreters for user namespaces (Linux 6.7)')
    sys.exit(ended.returncode)


def check_tools(vsix, native):
    if not vsix.exists():
        skip(f'{vsix.name} is not built (./dev vsix linux-arm64)')
    if vsix.stat().st_mtime < native.stat().st_mtime:
        skip(f'{vsix.name} is older than this program (./dev vsix linux-arm64)')
    if QEMU is None:
        skip('qemu-aarch64 is not installed (apt-get install qemu-user)')
    if not all((CROSS / name).exists() for name in C_LIBRARY):
        skip('the C library of arm64 is not installed (apt-get install g++-aarch64-linux-gnu)')


def unpack(vsix, folder):
    with zipfile.ZipFile(vsix) as packed:
        for entry in packed.infolist():
            if entry.filename.startswith(SERVER):
                path = packed.extract(entry, folder)
                os.chmod(path, entry.external_attr >> 16 & 0o777)
    return folder / SERVER / 'proskill'


def computer(folder):
    """What QEMU takes for the root of the computer: a C library."""
    (folder / 'root/lib').mkdir(parents=True)
    for name in C_LIBRARY:
        shutil.copy(CROSS / name, folder / 'root/lib')
    return folder / 'root'


def started(program, root):
    """The environment in which the program runs: without its fallback libraries, which must fail here, and with them."""
    plain = {**os.environ, 'QEMU_LD_PREFIX': str(root), 'PATH': '/nowhere'}
    version = lambda env: subprocess.run([program, '--version'], env=env, capture_output=True, text=True)
    without = version(plain)
    assert without.returncode != 0 and 'error while loading shared libraries' in without.stderr, without
    env = {**plain, 'LD_LIBRARY_PATH': str(program.parent / 'fallback')}
    ended = version(env)
    assert ended.returncode == 0 and ended.stdout.startswith('proskill '), ended
    print(f'{ended.stdout.splitlines()[0]}, with its libraries and a C library')
    return env


def explained(diagnostic):
    """A diagnostic without the path of its explanation, whose page must exist."""
    page, _, line = diagnostic.pop('codeDescription')['href'].removeprefix('file://').partition('#')
    assert pathlib.Path(page).exists(), page
    return diagnostic, line


class Answers:
    """What a server answers about a program with a bug."""

    def __init__(self, command, examples, env=None):
        client = lsp.Client([*command, 'lsp', '--no-cache'], env=env)
        client.initialize(initializationOptions={'trusted': True, 'verify': {'live': False, 'requestSeconds': 500}})
        path = examples / PROGRAM
        uri, document = path.as_uri(), {'textDocument': {'uri': path.as_uri()}}
        client.open(uri, path.read_text() + '(defskill wrong :body ((nowhere)))\n')
        self.errors = [explained(each) for each in client.diagnostics(uri, 1)]
        client.notify('textDocument/didChange', {'textDocument': {'uri': uri, 'version': 2}, 'contentChanges': [{'text': path.read_text()}]})
        self.later = [explained(each) for each in client.diagnostics(uri, 2)]
        self.picture = client.result('proskill/automaton', {**document, 'kind': 'body', 'name': 'monitor_button', 'format': 'svg'})['content']
        found = client.result('proskill/verify', {**document, 'names': []})
        self.verdicts = {each['name']: each['verdict'] for each in found['verdicts']}
        trace = client.result('proskill/trace', {**document, 'name': PROPERTY})
        self.steps = [(each['actor'], each['description'], each['date']) for each in trace['steps']]
        self.code = client.end()


def main():
    vsix, native = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    check_tools(vsix, native)
    enter()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        examples = shutil.copytree(ROOT / 'examples', folder / 'examples')
        program = unpack(vsix, folder)
        env = started(program, computer(folder))
        here, there = Answers([native], examples), Answers([program], examples, env)
    assert here.verdicts[PROPERTY] == 'violated' and len(here.steps) > 3 and len(here.errors) > 0, vars(here)
    for what, wanted in vars(here).items():
        found = getattr(there, what)
        assert found == wanted, f'{what}: {json.dumps(found)[:2000]}, where {json.dumps(wanted)[:2000]} was expected'
    print(f'errors, {len(there.verdicts)} verdicts, a trace of {len(there.steps)} steps and a picture are those of this computer')


main()
