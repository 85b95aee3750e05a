"""Random sessions: edits at random places, requests at random places, cancellations, of texts and of a notebook whose cells come, go
and move. At the end the server holds the texts that the client holds, and its findings are those of a fresh `proskill check`. Usage:
random_sessions.py PROSKILL [--check PROSKILL] [--seed N] [--sessions N | --seconds S] [--steps N]"""

import argparse
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

from client import CAPABILITIES, Cell, Client, Text

EXAMPLES = pathlib.Path(__file__).resolve().parents[3] / 'examples'
SEVERITIES = {1: 'error', 2: 'warning', 4: 'hint'}
PIECES = ['(', ')', '"', ';', '\n', ' ', ':', '$', '^', '[', ']', 'x', 'On', '1', '-', ':states', '(defsv ', 'é', '😀', '\t', '\r\n',
          '(defskill s :action (a))\n', '(include "lamp.proskill")\n', '; proskill-ignore: PS0612\n', ':success done',
          '(if (/= takeoff.status success) (failure x))', '\u2028', '\0']
AT_PLACE = ['definition', 'declaration', 'typeDefinition', 'implementation', 'references', 'documentHighlight', 'hover',
            'completion', 'signatureHelp', 'prepareRename', 'rename', 'linkedEditingRange', 'prepareCallHierarchy',
            'prepareTypeHierarchy', 'selectionRange', 'codeAction', 'onTypeFormatting', 'inlayHint', 'inlineValue', 'rangeFormatting',
            'semanticTokens/range']
OF_TEXT = ['documentSymbol', 'foldingRange', 'semanticTokens/full', 'formatting', 'codeLens', 'documentLink', 'diagnostic']


def fnv1a(data):
    value = 14695981039346656037
    for byte in data:
        value = (value ^ byte) * 1099511628211 & 0xffffffffffffffff
    return f'{value:016x}'


class Session:
    def __init__(self, command, seed, steps):
        self.random = random.Random(seed)
        self.steps = steps
        self.folder = tempfile.TemporaryDirectory()
        self.path = os.path.realpath(self.folder.name)
        self.write('lamp.proskill', '(defsv lamp :states (On Off) :init Off)\n')
        self.texts = {}
        self.notebook = f'file://{self.path}/mission.ipynb'
        self.cells = []
        self.made = 0
        self.errors = open(os.path.join(self.path, 'stderr'), 'w+')
        self.client = Client(command, stderr=self.errors)
        encodings = self.random.choice([['utf-16'], ['utf-16', 'utf-32']])
        general = {'positionEncodings': encodings[:1], 'staleRequestSupport': {
            'cancel': True, 'retryOnContentModified': self.random.sample(['textDocument/hover', 'textDocument/references'], 1)}}
        result = self.client.initialize({**CAPABILITIES, 'general': general},
                                        workspaceFolders=[{'uri': 'file://' + self.path, 'name': 'w'}])
        self.offered = result['capabilities']
        self.asked = []

    def write(self, name, text):
        with open(os.path.join(self.path, name), 'w', newline='') as file:
            file.write(text)

    def run(self):
        sources = [path for path in EXAMPLES.rglob('*.proskill')]
        for name in ('main.proskill', 'other.proskill'):
            self.open(name, self.random.choice(sorted(sources)).read_text())
        source = self.random.choice(sorted(sources)).read_text()
        places = sorted(self.random.sample(range(len(source)), 2))
        self.cells = [self.cell(source[begin:end]) for begin, end in zip([0, *places], [*places, None])]
        self.client.open_notebook(self.notebook, self.cells)
        for _ in range(self.steps):
            self.random.choices([self.edit, self.ask, self.cancel, self.reopen, self.watch, self.restructure], [50, 40, 8, 1, 1, 2])[0]()
            if len(self.asked) > 50:
                self.settle(self.asked.pop(0))
        for asked in self.asked:
            self.settle(asked)
        for name, text in self.texts.items():
            self.compare(name, text)
        self.compare_cells()
        code = self.client.end()
        self.errors.seek(0)
        said = self.errors.read()
        assert code == 0 and not said, (code, said)

    def open(self, name, content, version=1):
        text = Text('file://' + os.path.join(self.path, name), content)
        text.version = version
        self.texts[name] = text
        self.client.open(text.uri, content, version)

    def pick(self):
        return self.random.choice([*self.texts.values(), *self.cells])

    def cell(self, content):
        self.made += 1
        return Cell(self.notebook, f'W{self.made}', content)

    def restructure(self):
        """Removes, adds and moves some cells."""
        start = self.random.randrange(len(self.cells) + 1)
        old = self.cells[start:start + self.random.randrange(4)]
        gone = [cell for cell in old if self.random.random() < 0.3]
        come = [self.cell(self.random.choice(['(defsv lamp_%d :states (On Off) :init Off)\n' % self.made, '', '(defevent']))
                for _ in range(self.random.choice([0, 0, 1, 2]))]
        new = [cell for cell in old if cell not in gone] + come
        self.random.shuffle(new)
        self.cells[start:start + len(old)] = new
        self.client.change_cells(self.notebook, 1, structure={
            'array': {'start': start, 'deleteCount': len(old), 'cells': [{'kind': 2, 'document': cell.uri} for cell in new]},
            'didOpen': [cell.item() for cell in come], 'didClose': [{'uri': cell.uri} for cell in gone]})

    def edit(self):
        text = self.pick()
        begin = self.random.randrange(len(text.text) + 1)
        end = min(len(text.text), begin + (0 if self.random.random() < 0.6 else self.random.randrange(40)))
        text.edit(self.client, begin, end, '' if end > begin and self.random.random() < 0.5 else self.random.choice(PIECES))

    def ask(self):
        text = self.pick()
        place = text.position(self.random.randrange(len(text.text) + 1))
        if self.random.random() < 0.2:
            method, params = self.random.choice(OF_TEXT), {}
        else:
            method = self.random.choice(AT_PLACE)
            params = {'position': place, 'positions': [place], 'range': {'start': place, 'end': place}, 'newName': 'new', 'ch': '\n',
                      'context': {'includeDeclaration': True, 'diagnostics': [], 'frameId': 0, 'stoppedLocation': {'start': place, 'end': place}}}
        params['options'] = {'tabSize': 2, 'insertSpaces': True}
        self.asked.append(self.client.ask('textDocument/' + method, {'textDocument': {'uri': text.uri}, **params}))

    def settle(self, asked):
        answer = self.client.answer(asked)
        assert 'result' in answer or answer['error']['code'] != -32603, answer

    def cancel(self):
        if self.asked:
            self.client.notify('$/cancelRequest', {'id': self.random.choice(self.asked)})

    def reopen(self):
        name, text = self.random.choice(list(self.texts.items()))
        self.client.close(text.uri)
        self.open(name, text.text, text.version + 1)  # so that notifications on an earlier one are not taken for new

    def watch(self):
        self.write('lamp.proskill', '(defsv lamp :states (On Off) :init %s)\n' % self.random.choice(['On', 'Off', 'Of']))
        self.client.notify('workspace/didChangeWatchedFiles',
                           {'changes': [{'uri': f'file://{self.path}/lamp.proskill', 'type': 2}]})

    def compare(self, name, text):
        """One more edit, so that there are diagnostics to wait for; then with what is on disk."""
        text.edit(self.client, len(text.text), len(text.text), '\n')
        told = self.client.diagnostics(text.uri, text.version)
        self.write(name, text.text)
        self.compare_with(told, self.check(name, name), name, text)

    def compare_cells(self):
        """With files that a file includes as the notebook has cells."""
        names = [f'cell_{i}.proskill' for i in range(len(self.cells))]
        for cell in self.cells:  # all of them, since an edit of one changes findings in others
            cell.edit(self.client, len(cell.text), len(cell.text), '\n')
        for name, cell in zip(names, self.cells):
            self.write(name, cell.text)
        self.write('notebook.proskill', ''.join(f'(include "{name}")\n' for name in names))
        for name, cell in zip(names, self.cells):
            checked = self.check('notebook.proskill', name)
            told = self.client.note('textDocument/publishDiagnostics', lambda params: params['uri'] == cell.uri and
                                    params['version'] == cell.version and len(params['diagnostics']) == len(checked))['diagnostics']
            self.compare_with(told, checked, name, cell)

    def compare_with(self, told, checked, name, text):
        seen = [(each['code'], SEVERITIES[each['severity']], each['message'], each['range']['start']['line'] + 1) for each in told]
        assert sorted(seen) == sorted(checked), (name, seen, checked, text.text)
        status = self.client.result('proskill/status', None)
        assert status['errors'] == 0, status
        held = next(each for each in status['documents'] if each['uri'] == text.uri)
        sent = text.text.encode()
        assert (held['bytes'], held['hash']) == (len(sent), fnv1a(sent)), ('the texts differ', held, len(sent))

    def check(self, root, name):
        """The findings in a file in the program of another."""
        done = subprocess.run([CHECKER, 'check', '--format=json', os.path.join(self.path, root)], capture_output=True)
        path = os.path.join(self.path, name)
        return [(each['code'], each['severity'], each['message'], each['location']['begin']['line'])
                for each in json.loads(done.stdout)['diagnostics']
                if os.path.realpath(each['location']['file']) == path]


def main():
    global CHECKER
    parser = argparse.ArgumentParser()
    parser.add_argument('program')
    parser.add_argument('--check', help='the program whose `check` is asked; the same where it is not given')
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--sessions', type=int, default=1)
    parser.add_argument('--seconds', type=float)
    parser.add_argument('--steps', type=int, default=300)
    arguments = parser.parse_args()
    CHECKER = arguments.check or arguments.program
    begin, done = time.monotonic(), 0
    while (time.monotonic() - begin < arguments.seconds) if arguments.seconds else done < arguments.sessions:
        seed = arguments.seed + done
        try:
            Session([arguments.program, 'lsp', '--debounce', '0', '--no-cache'], seed, arguments.steps).run()
        except BaseException:
            print(f'the session of seed {seed} failed', file=sys.stderr)
            raise
        done += 1
    print(f'{done} sessions of {arguments.steps} steps from seed {arguments.seed}')


if __name__ == '__main__':
    main()
