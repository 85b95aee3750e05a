"""Measures the language server: a client types at random places of a large file, and sends requests. Compares it with another
server on a file of the same size: clangd if it is installed. Reports the time that a user waits, and the processor time of
the server's process, which does not depend on the load of the machine. Usage: lsp.py PROSKILL PRINT_PROGRAM [--lines N] [--edits N]
[--flat N] [--other COMMAND]"""

import argparse
import gc
import pathlib
import random
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'tests' / 'lsp' / 'sessions'))
from client import CAPABILITIES, Client, Text  # noqa: E402

REQUESTS = ['completion', 'hover', 'signatureHelp', 'definition', 'references', 'documentHighlight', 'prepareRename', 'codeAction',
            'selectionRange', 'linkedEditingRange', 'documentSymbol', 'foldingRange', 'inlayHint', 'codeLens']


def memory(client):
    """Resident memory of the server in MB: now, and the maximum."""
    with open(f'/proc/{client.process.pid}/status') as file:
        fields = dict(line.split(':', 1) for line in file)
    return tuple(int(fields[name].split()[0]) / 1024 for name in ('VmRSS', 'VmHWM'))


def quantile(values, part):
    return sorted(values)[min(len(values) - 1, int(part * len(values)))]


def row(what, samples, goal=''):
    """Statistics of pairs: seconds that passed, and processor time of the server."""
    parts = [(0, 0.5), (0, 0.95), (0, 0.99), (1, 0.5), (1, 0.95)]
    figures = '  '.join(f'{quantile([sample[of] for sample in samples], part) * 1000:9.2f}' for of, part in parts)
    print(f'  {what:44} {figures}  {len(samples):6}  {goal}', flush=True)


def heading(title):
    names = '  '.join(f'{name:>9}' for name in ('p50 ms', 'p95 ms', 'p99 ms', 'CPU p50', 'CPU p95'))
    print(f'\n{title}\n  {"":44} {names}  {"of":>6}  goal of p95')


class Stopwatch:
    """Measures from its construction. The processor time is that of all threads of a process."""

    def __init__(self, process=None):
        self.clock = (~process.pid << 3) | 2 if process else None  # as clock_getcpuclockid(3) computes it
        self.begin, self.cpu = time.perf_counter(), self.used()

    def used(self):
        return time.clock_gettime(self.clock) if self.clock else 0.0

    def until(self, when):
        """Times of diagnostics, noted when they arrive."""
        return when - self.begin, self.used() - self.cpu


class Bench:
    def __init__(self, command, uri, source, language, words):
        self.command, self.language, self.words = command, language, words
        self.random = random.Random(1)
        watch = Stopwatch()
        self.client = Client(command, stderr=subprocess.DEVNULL)
        watch.clock = self.watch().clock
        self.offered = self.client.initialize()['capabilities']
        self.text = Text(uri, source)
        self.client.open(uri, source, language=language)
        self.first = watch.until(self.diagnostics(1))

    def watch(self):
        return Stopwatch(self.client.process)

    def diagnostics(self, version):
        """When those of the version came; for a server without versions, the last ones."""
        return self.client.timed_note('textDocument/publishDiagnostics', lambda params: params['uri'] == self.text.uri and
                                      params.get('version', version) == version)[1]

    def place(self):
        return self.random.randrange(len(self.text.text))

    def type(self, at, letters):
        """Types letter by letter; returns the times until the diagnostics of each."""
        times = []
        for letter in letters:
            watch = self.watch()
            self.text.edit(self.client, at, at, letter)
            times.append(watch.until(self.diagnostics(self.text.version)))
            at += 1
        return times

    def undo(self, at, length):
        watch = self.watch()
        self.text.edit(self.client, at, at + length, '')
        return watch.until(self.diagnostics(self.text.version))

    def edits(self, count):
        """Half of them break the program, half fix it; some only change a comment, to measure an analysis of everything."""
        times = []
        while len(times) < count:
            at = self.place()
            letters = self.random.choice(self.words)
            times += self.type(at, letters)
            times.append(self.undo(at, len(letters)))
        return times

    def comments(self, count):
        """Edits that keep the program valid, so that no error shortens the analysis."""
        mark = '\n; ' if self.language == 'proskill' else '\n// '
        times = []
        for _ in range(count):
            at = self.text.text.index('\n', self.random.randrange(len(self.text.text) - 2000))
            watch = self.watch()
            self.text.edit(self.client, at, at, mark + 'x')
            times.append(watch.until(self.diagnostics(self.text.version)))
        return times

    def params(self, method, offset):
        place = self.text.position(offset)
        lines = {'start': {'line': max(0, place['line'] - 40), 'character': 0}, 'end': {'line': place['line'] + 40, 'character': 0}}
        return {'textDocument': {'uri': self.text.uri}, 'position': place, 'positions': [place],
                'range': lines if method == 'inlayHint' else {'start': place, 'end': place},
                'context': {'includeDeclaration': True, 'diagnostics': []}}

    def blank(self):
        """Types a blank at the end of some line: the program stays valid, and all of it is checked again."""
        at = self.text.text.index('\n', self.place() // 2)
        self.text.edit(self.client, at, at, ' ')

    def ask(self, method, count, before=None):
        times = []
        for _ in range(count):
            offset = self.place()
            if before:
                before()
            params = self.params(method, offset)
            watch = self.watch()
            answer, when = self.client.timed_answer(self.client.ask('textDocument/' + method, params))
            if 'error' in answer and answer['error']['code'] == -32601:
                return None
            times.append(watch.until(when))
        return times

    def tokens(self, count):
        if 'semanticTokensProvider' not in self.offered:
            return None
        document = {'textDocument': {'uri': self.text.uri}}
        answer = self.client.request('textDocument/semanticTokens/full', document)
        times = []
        for _ in range(count):
            at = self.place()
            self.text.edit(self.client, at, at, 'x')
            watch = self.watch()
            answer, when = self.client.timed_answer(self.client.ask(
                'textDocument/semanticTokens/full/delta', {**document, 'previousResultId': answer['result'].get('resultId', '')}))
            times.append(watch.until(when))
            self.undo(at, 1)
        return times

    def formatting(self, count):
        params = {'textDocument': {'uri': self.text.uri}, 'options': {'tabSize': 2, 'insertSpaces': True}}
        times = []
        for _ in range(count):
            watch = self.watch()
            answer, when = self.client.timed_answer(self.client.ask('textDocument/formatting', params))
            if 'error' in answer:
                return None
            times.append(watch.until(when))
        return times

    def cancellation(self, count):
        """Time from `$/cancelRequest` of an expensive request to the answer of the next one."""
        times = []
        for _ in range(count):
            self.text.edit(self.client, 0, 0, '\n')
            asked = self.client.ask('textDocument/references', self.params('references', self.place()))
            watch = self.watch()
            self.client.notify('$/cancelRequest', {'id': asked})
            times.append(watch.until(self.client.timed_answer(asked)[1]))
        return times

    def optional(self, what, times, goal=''):
        if times:
            row(what, times, goal)
        else:
            print(f'  {what:44} not offered')

    def typing(self, edits):
        """Edits with the default settings: the server may wait for a pause."""
        row('edit to diagnostics, default settings', self.edits(edits), '15')
        row('the same, in comments', self.comments(min(100, edits)), '15')
        self.client.end()

    def run(self, arguments):
        lines = self.text.text.count('\n')
        heading(f'{" ".join(self.command[:2])}: {lines} lines')
        row('start to the first diagnostics', [self.first])
        row('edit to diagnostics', self.edits(arguments.edits), '15')
        row('the same, in comments', self.comments(min(100, arguments.edits)), '15')
        for method in REQUESTS:
            self.optional(method, self.ask(method, 100), '5')
        for method in ('completion', 'hover'):
            self.optional(f'{method}, right after a letter',
                          self.ask(method, 50, before=self.blank), '5')
        self.optional('semanticTokens/full/delta', self.tokens(50), '5')
        self.optional('formatting', self.formatting(5), '50')
        row('cancellation', self.cancellation(20), '20')
        print('  memory: %.0f MB, at its most %.0f MB' % memory(self.client))

    def flat(self, count):
        """Memory while letters are typed and removed, without reading diagnostics."""
        figures = []
        for i in range(count // 2):
            at = self.place()
            self.text.edit(self.client, at, at, 'x')
            self.text.edit(self.client, at, at + 1, '')
            if i % max(1, count // 20) == 0:
                self.diagnostics(self.text.version)
                figures.append(memory(self.client)[0])
        print('  memory over %d edits: %s MB' % (count, ', '.join(f'{each:.0f}' for each in figures)))


def small_file(program, folder):
    """Seconds from the start of the process to the first diagnostics."""
    times = []
    for _ in range(20):
        watch = Stopwatch()
        client = Client([program, 'lsp', '--debounce', '0'])
        watch.clock = Stopwatch(client.process).clock
        client.initialize()
        client.open(f'file://{folder}/small.proskill', '(defsv lamp :states (On Off) :init Off)\n')
        times.append(watch.until(client.timed_note('textDocument/publishDiagnostics')[1]))
        client.end()
    row('start to first diagnostics, small file', times, '60')


def many_files(program, folder, source):
    """500 files opened at once, and their memory."""
    lines = source.splitlines()
    size = max(20, len(lines) // 500)
    watch = Stopwatch()
    client = Client([program, 'lsp', '--debounce', '0'])
    watch.clock = Stopwatch(client.process).clock
    client.initialize()
    uris = {f'file://{folder}/many/{i}.proskill' for i in range(500)}
    piece = '\n'.join(lines[:lines.index('', size)]) + '\n'
    for uri in uris:
        client.open(uri, piece)
    while uris:
        params, last = client.timed_note('textDocument/publishDiagnostics')
        uris.discard(params['uri'])
    row(f'500 files of {piece.count(chr(10))} lines, opened cold', [watch.until(last)], '1000')
    print('  memory: %.0f MB, at its most %.0f MB (goal 80)' % memory(client))
    client.end()


def in_c(lines):
    """A C file with this many lines, for the other server."""
    device = ('struct device_{0} {{\n  int state;\n  double speed;\n}};\n\n/* Device {0} does its work. */\n'
              'static int use_{0}(struct device_{0} *device, double speed, int times) {{\n  if (device->state == 0)\n    return -1;\n'
              '  device->speed = speed;\n  for (int i = 0; i < times; ++i)\n    device->state += i;\n  return device->state;\n}}\n\n')
    count = lines // device.count('\n')
    return ''.join(device.format(i) for i in range(count)) + 'int main(void) { return 0; }\n'


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('program')
    parser.add_argument('print_program')
    parser.add_argument('--lines', type=int, default=10_000)
    parser.add_argument('--edits', type=int, default=300)
    parser.add_argument('--flat', type=int, default=10_000, help='edits over which memory is watched')
    parser.add_argument('--other', default='clangd', help='the server to compare with; empty: none')
    arguments = parser.parse_args()
    gc.disable()  # the client's own pauses, which grow with the answers, do not count as the server's
    source = subprocess.run([arguments.print_program, str(arguments.lines)], capture_output=True, text=True, check=True).stdout
    with tempfile.TemporaryDirectory() as folder:
        heading('proskill lsp')
        small_file(arguments.program, folder)
        many_files(arguments.program, folder, source)
        words = ['(use_1 speed 2.0)', '; words', 'ready', ':time_interval [1,2]', '(x']
        Bench([arguments.program, 'lsp'], f'file://{folder}/main.proskill', source, 'proskill', words).typing(arguments.edits)
        bench = Bench([arguments.program, 'lsp', '--debounce', '0'], f'file://{folder}/main.proskill', source, 'proskill', words)
        bench.run(arguments)
        bench.flat(arguments.flat)
        other = shlex.split(arguments.other)
        if other and shutil.which(other[0]):
            Bench(other, f'file://{folder}/main.c', in_c(arguments.lines), 'c', ['use_1(0, 2.0, 1);', '// words', 'int x;']).run(arguments)
        elif other:
            print(f'\n{other[0]} is not installed: nothing to compare with')


if __name__ == '__main__':
    main()
