"""A client of language servers over pipes, for the scripted sessions, the random ones and the benchmark."""

import atexit
import functools
import json
import os
import queue
import subprocess
import threading
import time

PATIENCE = 120  # seconds; only a server that hangs takes so long

CAPABILITIES = {
    'experimental': {'verdicts': 'all'},
    'general': {'positionEncodings': ['utf-16']},
    'window': {'workDoneProgress': True},
    'workspace': {
        'configuration': True,
        'workspaceEdit': {'documentChanges': True},
        'didChangeConfiguration': {'dynamicRegistration': True},
        'didChangeWatchedFiles': {'dynamicRegistration': True},
        **{what: {'refreshSupport': True} for what in ('semanticTokens', 'inlayHint', 'inlineValue', 'codeLens', 'diagnostics')},
    },
    'textDocument': {
        'publishDiagnostics': {'relatedInformation': True, 'codeDescriptionSupport': True, 'tagSupport': {'valueSet': [1, 2]}},
        'completion': {'completionItem': {'snippetSupport': True, 'documentationFormat': ['markdown']}},
        'documentSymbol': {'hierarchicalDocumentSymbolSupport': True},
        'hover': {'contentFormat': ['markdown']},
        'inlayHint': {'resolveSupport': {'properties': ['tooltip', 'label.location']}},
        'foldingRange': {'lineFoldingOnly': False},
        'codeAction': {'codeActionLiteralSupport': {'codeActionKind': {'valueSet': ['quickfix', 'refactor']}},
                       'dataSupport': True, 'resolveSupport': {'properties': ['edit']}},
        'semanticTokens': {'requests': {'full': {'delta': True}, 'range': True}, 'formats': ['relative'],
                           'tokenTypes': [], 'tokenModifiers': []},
    },
}


class Ended(Exception):
    """The server has closed its output."""


def framed(body):
    data = body if isinstance(body, bytes) else body.encode()
    return b'Content-Length: %d\r\n\r\n' % len(data) + data


class Note:
    """A notification. It is parsed when a test reads it: a long one would delay the answer after it."""

    BEGIN = b'{"jsonrpc":"2.0","method":'  # both servers that are driven here sort their keys, so that requests begin with "id"

    def __init__(self, body):
        self.body = body

    @functools.cached_property
    def message(self):
        return json.loads(self.body)


class Client:
    """One server. Messages come in by a thread of their own; requests of the server are answered there."""

    def __init__(self, command, settings=None, recording=False, **more):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, **more)
        atexit.register(self.process.kill)  # ends the server of a session that fails
        self.begin(self.process.stdin, self.process.stdout, settings, recording)

    def begin(self, output, source, settings=None, recording=False):
        self.output = output
        self.settings = settings
        self.recording = recording
        self.last = 0
        self.answers = {}     # id: (message, when it came)
        self.notes = []       # (Note, when it came)
        self.questions = []   # of the server, by their methods
        self.record = []      # ('in' | 'out', message)
        self.lock = threading.Condition()
        self.ended = False
        self.outgoing = queue.SimpleQueue()
        threading.Thread(target=self.write_all, daemon=True).start()
        self.reader = threading.Thread(target=self.read_all, args=(source,), daemon=True)
        self.reader.start()

    # The stream ---------------------------------------------------------------------------------

    def write_all(self):
        while (data := self.outgoing.get()) is not None:
            try:
                self.output.write(data)
                self.output.flush()
            except (OSError, ValueError):
                return

    def read_all(self, source):
        try:
            while True:
                length = None
                while (line := source.readline()) not in (b'\r\n', b''):
                    name, _, value = line.partition(b':')
                    if name.lower() == b'content-length':
                        length = int(value)
                if length is None:
                    break
                body = source.read(length)
                when = time.perf_counter()
                self.take(body, when)
        except (OSError, ValueError):
            pass
        with self.lock:
            self.ended = True
            self.lock.notify_all()

    def take(self, body, when):
        if body.startswith(Note.BEGIN):
            note = Note(body)
            with self.lock:
                if self.recording:
                    self.record.append(('in', note.message))
                self.notes.append((note, when))
                self.lock.notify_all()
            return
        message = json.loads(body)
        with self.lock:
            if self.recording:
                self.record.append(('in', message))
            if 'method' in message:
                self.serve(message)
            else:
                self.answers[message['id']] = (message, when)
            self.lock.notify_all()

    def serve(self, message):
        result = None
        self.questions.append(message['method'])
        if message['method'] == 'workspace/configuration':
            result = [self.settings for _ in message['params']['items']]
        self.send({'jsonrpc': '2.0', 'id': message['id'], 'result': result})

    def raw(self, data):
        self.outgoing.put(data)

    def send(self, message):
        if self.recording:
            self.record.append(('out', message))
        self.raw(framed(json.dumps(message)))

    # Messages -----------------------------------------------------------------------------------

    def notify(self, method, params):
        self.send({'jsonrpc': '2.0', 'method': method, 'params': params})

    def ask(self, method, params):
        """Sends a request and gives its identifier."""
        self.last += 1
        self.send({'jsonrpc': '2.0', 'id': self.last, 'method': method, 'params': params})
        return self.last

    def wait(self, condition):
        """The value of `condition` once it is true."""
        deadline = time.monotonic() + PATIENCE
        with self.lock:
            while (found := condition()) is None:
                if self.ended:
                    raise Ended()
                if not self.lock.wait(deadline - time.monotonic()):
                    raise TimeoutError('the server does not answer')
            return found

    def timed_answer(self, identifier):
        return self.wait(lambda: self.answers.pop(identifier, None))

    def answer(self, identifier):
        return self.timed_answer(identifier)[0]

    def request(self, method, params):
        return self.answer(self.ask(method, params))

    def result(self, method, params):
        message = self.request(method, params)
        assert 'error' not in message, (method, message)
        return message['result']

    def error(self, method, params):
        return self.request(method, params)['error']['code']

    def note(self, method, accepts=lambda params: True):
        """The first notification of the method that is accepted; those before it about the same text are dropped."""
        return self.timed_note(method, accepts)[0]

    def timed_note(self, method, accepts=lambda params: True):
        def find():
            found = next((i for i, (note, _) in enumerate(self.notes)
                          if note.message['method'] == method and accepts(note.message['params'])), None)
            if found is None:
                return None
            taken, when = self.notes[found]
            about = lambda note: (note.message['method'], note.message['params'].get('uri'))
            self.notes[:found + 1] = [entry for entry in self.notes[:found] if about(entry[0]) != about(taken)]
            return taken.message['params'], when
        return self.wait(find)

    def asked(self, method):
        """Waits for a request of the server; each counts once."""
        self.wait(lambda: self.questions.remove(method) or True if method in self.questions else None)

    # A session ----------------------------------------------------------------------------------

    def initialize(self, capabilities=None, **more):
        result = self.result('initialize', {'processId': os.getpid(), 'rootUri': None,
                                            'capabilities': CAPABILITIES if capabilities is None else capabilities, **more})
        self.notify('initialized', {})
        return result

    def open(self, uri, text, version=1, language='proskill'):
        self.notify('textDocument/didOpen',
                    {'textDocument': {'uri': uri, 'languageId': language, 'version': version, 'text': text}})

    def change(self, uri, version, start, end, text):
        self.notify('textDocument/didChange', {
            'textDocument': {'uri': uri, 'version': version},
            'contentChanges': [{'range': {'start': start, 'end': end}, 'text': text}]})

    def close(self, uri):
        self.notify('textDocument/didClose', {'textDocument': {'uri': uri}})

    def open_notebook(self, uri, cells):
        """The cells are texts, by their URIs."""
        self.notify('notebookDocument/didOpen', {
            'notebookDocument': {'uri': uri, 'notebookType': 'jupyter-notebook', 'version': 1,
                                 'cells': [{'kind': 2, 'document': cell.uri} for cell in cells]},
            'cellTextDocuments': [cell.item() for cell in cells]})

    def change_cells(self, uri, version, **cells):
        self.notify('notebookDocument/didChange', {'notebookDocument': {'uri': uri, 'version': version}, 'change': {'cells': cells}})

    def diagnostics(self, uri, version):
        return self.note('textDocument/publishDiagnostics',
                         lambda params: params['uri'] == uri and params.get('version') == version)['diagnostics']

    def end(self):
        """The exit code after a regular end."""
        self.result('shutdown', None)
        self.notify('exit', None)
        return self.process.wait(PATIENCE)

    def hang_up(self):
        self.outgoing.put(None)
        self.output.close()
        return self.process.wait(PATIENCE)


def position(line, character):
    return {'line': line, 'character': character}


class Text:
    """A text as an editor holds it, with positions in UTF-16."""

    def __init__(self, uri, text):
        self.uri, self.text, self.version = uri, text, 1

    def position(self, offset):
        line_start = self.text.rfind('\n', 0, offset) + 1
        before = self.text[line_start:offset]
        return position(self.text.count('\n', 0, offset), len(before.encode('utf-16-le')) // 2)

    def expressible(self, offset):
        """No position lies within the end of a line."""
        return offset - 1 if self.text[max(offset - 1, 0):offset + 1] == '\r\n' and offset > 0 else offset

    def item(self):
        return {'uri': self.uri, 'languageId': 'proskill', 'version': self.version, 'text': self.text}

    def edit(self, client, begin, end, text):
        """Replaces a piece here and in the server."""
        begin, end = self.expressible(begin), self.expressible(end)
        start, stop = self.position(begin), self.position(end)
        self.version += 1
        self.text = self.text[:begin] + text + self.text[end:]
        self.send(client, start, stop, text)

    def send(self, client, start, stop, text):
        client.change(self.uri, self.version, start, stop, text)


class Cell(Text):
    """A cell of a notebook."""

    def __init__(self, notebook, name, text):
        super().__init__(f'vscode-notebook-cell:{notebook.removeprefix("file://")}#{name}sZmlsZQ%3D%3D', text)
        self.notebook = notebook

    def send(self, client, start, stop, text):
        client.change_cells(self.notebook, self.version, textContent=[{
            'document': {'uri': self.uri, 'version': self.version},
            'changes': [{'range': {'start': start, 'end': stop}, 'text': text}]}])
