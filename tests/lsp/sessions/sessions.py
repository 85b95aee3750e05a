"""Scripted sessions with the real program: usage: sessions.py PROSKILL"""

import os
import re
import socket
import subprocess
import sys
import tempfile
import threading
import time

from client import CAPABILITIES, Cell, Client, Ended, PATIENCE, framed, position

PROGRAM = sys.argv[1]
LAMP = '(defsv lamp :states (On Off) :init Off)\n'
BAD = '(defsv lamp :states (On Off) :init Of)\n'
URI = 'file:///nowhere/lamp.proskill'


def server(**more):
    return Client([PROGRAM, 'lsp', '--debounce', '0'], **more)


def started(**more):
    client = server(**more)
    client.initialize()
    return client


def codes(diagnostics):
    return [each['code'] for each in diagnostics]


def at(uri, line, character):
    return {'textDocument': {'uri': uri}, 'position': position(line, character)}


def is_running(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    with open(f'/proc/{process}/stat') as stat:
        return stat.read().rpartition(')')[2].split()[0] != 'Z'


def wait_until_gone(process):
    """By looking, for it is no child of ours."""
    deadline = time.monotonic() + PATIENCE
    while is_running(process):
        assert time.monotonic() < deadline, 'the server lives on'
        threading.Event().wait(0.01)


# Sessions: each is a function, and its name says what holds ------------------------------------------


def an_orderly_end_is_0_and_any_other_1():
    assert started().end() == 0
    client = started()
    client.notify('exit', None)
    assert client.process.wait(PATIENCE) == 1
    assert started().hang_up() == 1
    assert server().hang_up() == 1


def what_comes_out_of_order_is_refused():
    client = server()
    client.open(URI, LAMP)  # before `initialize`: dropped
    assert client.error('textDocument/hover', at(URI, 0, 8)) == -32002
    client.initialize()
    assert client.error('initialize', {'capabilities': {}}) == -32600
    assert client.error('textDocument/definition', at(URI, 0, 8)) == -32602
    client.close(URI)  # never opened
    client.change(URI, 2, position(0, 0), position(0, 0), 'x')
    client.open(URI, LAMP)
    assert len(client.result('textDocument/definition', at(URI, 0, 8))) == 1
    client.result('shutdown', None)
    assert client.error('textDocument/definition', at(URI, 0, 8)) == -32600
    client.notify('exit', None)
    assert client.process.wait(PATIENCE) == 0


def an_older_edit_drops_the_text_until_it_is_opened_again():
    client = started()
    client.open(URI, LAMP, 5)
    client.change(URI, 4, position(0, 0), position(0, 0), ';')
    assert 'open' in client.note('window/showMessage')['message']
    assert client.error('textDocument/definition', at(URI, 0, 8)) == -32602
    client.change(URI, 6, position(0, 0), position(0, 0), ';')
    client.open(URI, LAMP, 7)
    assert len(client.result('textDocument/definition', at(URI, 0, 8))) == 1
    assert client.end() == 0


def a_cancelled_request_is_answered_and_its_work_ends():
    client = started()
    text = ''.join(f'(defsv lamp_{i} :states (On Off) :init Off)\n' for i in range(2000))
    client.open(URI, text)
    asked = [client.ask('textDocument/references', {**at(URI, 0, 8), 'context': {'includeDeclaration': True}})
             for _ in range(50)]
    for identifier in asked:
        client.notify('$/cancelRequest', {'id': identifier})
    for identifier in asked:
        answer = client.answer(identifier)
        assert 'result' in answer or answer['error']['code'] == -32800, answer
    status = client.result('proskill/status', None)
    assert status['pending'] == 1, status  # itself
    client.notify('$/cancelRequest', {'id': 4711})  # nobody waits for it
    assert client.end() == 0


def an_include_of_what_is_no_file_is_an_error_and_nobody_waits_for_it():
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.realpath(folder)
        os.mkfifo(f'{folder}/pipe.proskill')  # whoever reads it waits until somebody writes
        client = started()
        client.open(f'file://{folder}/main.proskill', '(include "pipe.proskill")\n' + LAMP)
        assert 'PS0006' in codes(client.note('textDocument/publishDiagnostics')['diagnostics'])
        assert client.end() == 0


def no_file_that_never_ends_or_cannot_be_read_stops_anybody():
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.realpath(folder)
        names = ['endless', 'pipe', 'nowhere', 'circle', 'folder']
        os.symlink('/dev/zero', f'{folder}/endless.proskill')
        os.mkfifo(f'{folder}/pipe.proskill')
        os.symlink('nothing', f'{folder}/nowhere.proskill')
        os.symlink('circle.proskill', f'{folder}/circle.proskill')
        os.mkdir(f'{folder}/folder.proskill')
        client = server()
        client.initialize(workspaceFolders=[{'uri': f'file://{folder}', 'name': 'w'}])
        main = f'file://{folder}/main.proskill'
        client.open(main, ''.join(f'(include "{name}.proskill")\n' for name in names))
        assert codes(client.diagnostics(main, 1)) == ['PS0006'] * len(names)
        for name in names:  # each may be opened as well
            uri = f'file://{folder}/{name}.proskill'
            client.open(uri, BAD)
            assert 'PS0203' in codes(client.diagnostics(uri, 1))
            client.close(uri)
        assert client.result('workspace/symbol', {'query': 'lamp'}) == []
        assert client.end() == 0


def one_file_is_one_whatever_links_lead_to_it():
    with tempfile.TemporaryDirectory() as top:
        top = os.path.realpath(top)
        lamp = '(defsv lamp :states (On Off) :init Off :transitions :all)\n'
        main = '(include "lamp.proskill")\n(include "also.proskill")\n(defskill on :start (lamp On) :action (on) :success (lit (:postcondition (lamp On))))\n'
        for name, text in [('w/lamp.proskill', lamp), ('w/main.proskill', main)]:
            os.makedirs(os.path.dirname(f'{top}/{name}'), exist_ok=True)
            with open(f'{top}/{name}', 'w') as file:
                file.write(text)
        os.mkdir(f'{top}/elsewhere')
        os.symlink('lamp.proskill', f'{top}/w/also.proskill')
        os.symlink('../w/lamp.proskill', f'{top}/elsewhere/lamp.proskill')
        os.symlink('w', f'{top}/linked')
        real, also, linked = f'file://{top}/w', f'file://{top}/w/also.proskill', f'file://{top}/elsewhere/lamp.proskill'

        def definition(client, uri):
            return client.result('textDocument/definition', at(uri, 2, 22))[0]['uri']

        def wait_for_main(has_errors):
            client.note('textDocument/publishDiagnostics',
                        lambda params: params['uri'] == f'{real}/main.proskill' and ('PS0202' in codes(params['diagnostics'])) == has_errors)

        client = started()
        client.open(f'{real}/main.proskill', main)
        wait_for_main(has_errors=False)
        assert definition(client, f'{real}/main.proskill') == f'{real}/lamp.proskill'
        client.open(linked, lamp)  # as the client spells it, and part of the program all the same
        assert client.diagnostics(linked, 1) == []
        assert definition(client, f'{real}/main.proskill') == linked
        links = client.result('textDocument/documentLink', {'textDocument': {'uri': f'{real}/main.proskill'}})
        assert [each['target'] for each in links] == [linked] * 2
        edits = client.result('textDocument/rename', {**at(linked, 0, 8), 'newName': 'light'})['documentChanges']
        assert {edit['textDocument']['uri']: len(edit['edits']) for edit in edits} == {linked: 1, f'{real}/main.proskill': 2}
        client.change(linked, 2, position(0, 7), position(0, 11), 'light')
        wait_for_main(has_errors=True)
        # The same file opened by one more name is a text of its own, and takes over when the first is closed.
        client.open(also, lamp)
        assert client.result('textDocument/definition', at(linked, 0, 8))[0]['uri'] == linked
        wait_for_main(has_errors=True)
        client.close(linked)
        wait_for_main(has_errors=False)
        assert definition(client, f'{real}/main.proskill') == also
        client.close(also)  # and is still called so, for the client knows it
        assert definition(client, f'{real}/main.proskill') == also
        assert client.end() == 0

        client = server()  # a folder that is a link is shown as one, and each file of it once
        client.initialize(workspaceFolders=[{'uri': f'file://{top}/linked', 'name': 'w'}])
        found = []
        while not found:  # the folder is read in the background
            found = client.result('workspace/symbol', {'query': 'lamp'})
        assert [each['location']['uri'] for each in found] == [f'file://{top}/linked/lamp.proskill'], found
        items = client.result('workspace/diagnostic', {'previousResultIds': []})['items']
        assert {item['uri']: codes(item['items']) for item in items} == {
            f'file://{top}/linked/main.proskill': [], f'file://{top}/linked/lamp.proskill': []}
        assert client.end() == 0


def half_a_message_and_its_rest_are_one():
    client = started()
    whole = framed('{"jsonrpc":"2.0","id":"half","method":"proskill/status"}')
    for byte in range(0, len(whole), 7):
        client.raw(whole[byte:byte + 7])
    assert 'result' in client.answer('half')
    client.raw(whole[:40])  # and then nothing more
    assert client.hang_up() == 1


def nonsense_is_answered_with_errors_and_survived():
    client = started()
    for body, code in [(b'{"jsonrpc":', -32700), (b'\xff\xfe\x00', -32700), (b'[]', -32600), (b'[{"jsonrpc":"2.0"}]', -32600),
                       (b'"text"', -32600), (b'{"jsonrpc":"2.0","id":null,"method":"x"}', -32600)]:
        client.raw(framed(body))
        assert client.answer(None)['error']['code'] == code, body
    client.raw(b'Content-Length: 2147483648\r\n\r\n')
    assert client.answer(None)['error']['code'] == -32700
    client.hang_up()
    client = started()
    client.raw(b'garbage\r\n\r\n' + framed('{"jsonrpc":"2.0","id":"after","method":"proskill/status"}'))
    assert client.answer(None)['error']['code'] == -32700
    assert 'result' in client.answer('after')
    assert client.end() == 0


def bytes_that_are_no_unicode_are_read_as_replacement_characters():
    client = started()
    client.raw(framed(b'{"jsonrpc":"2.0","id":"bad","method":"x","params":{"text":"\xff\xc0"}}'))
    assert client.answer('bad')['error']['code'] == -32601
    client.open(URI, '; \ud83d\ude00 \u0000 \ufffe\n' + BAD)
    assert codes(client.diagnostics(URI, 1))
    assert client.end() == 0


def fifty_files_at_once():
    client = started()
    uris = [f'file:///nowhere/{i}.proskill' for i in range(50)]
    for uri in uris:
        client.open(uri, BAD)
    for uri in uris:
        assert 'PS0203' in codes(client.diagnostics(uri, 1))
    for uri in uris:
        client.close(uri)
    for uri in uris:
        assert client.diagnostics(uri, None) == []
    assert client.end() == 0


def diagnostics_are_those_of_check():
    import json
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.realpath(folder)
        path = os.path.join(folder, 'main.proskill')
        text = ('(defskill grip :action (grip) :failure slipped)\n'
                '(defsv Idle :states (A B) :init A)\n; proskill-ignore: PS0612\n(defsv more :states (A B) :init A)\n'
                '(defskill mission :body ((grip)))\n')
        with open(path, 'w') as file:
            file.write(text)
        for settings in [None, '{"severity": {"PS0708": "error", "PS0612": "off"}}', '{"style": true}']:
            if settings:
                with open(os.path.join(folder, '.proskill.json'), 'w') as file:
                    file.write(settings)
            checked = json.loads(subprocess.run([PROGRAM, 'check', '--format=json', path],
                                                capture_output=True, text=True).stdout)['diagnostics']
            assert checked
            client = started()
            client.open('file://' + path, text)
            told = client.diagnostics('file://' + path, 1)
            severities = {1: 'error', 2: 'warning', 4: 'hint'}
            assert ([(each['code'], severities[each['severity']], each['message'], each['range']['start']['line'] + 1) for each in told] ==
                    [(each['code'], each['severity'], each['message'], each['location']['begin']['line']) for each in checked])
            if settings:  # a change of the file is seen when the client tells of it
                os.remove(os.path.join(folder, '.proskill.json'))
                client.notify('workspace/didChangeWatchedFiles',
                              {'changes': [{'uri': f'file://{folder}/.proskill.json', 'type': 3}]})
                client.note('textDocument/publishDiagnostics', lambda params: params['diagnostics'] != told)
            assert client.end() == 0


def the_code_of_a_diagnostic_leads_to_its_page():
    client = started()
    client.open(URI, BAD)
    (told,) = client.diagnostics(URI, 1)
    page, line = told['codeDescription']['href'].removeprefix('file://').split('#L')
    with open(page) as file:
        assert file.readlines()[int(line) - 1].startswith('## PS0203: ')
    assert client.end() == 0


def other_texts_of_a_program_are_asked_for_again():
    client = server()
    client.initialize({**CAPABILITIES, 'textDocument': {**CAPABILITIES['textDocument'], 'diagnostic': {}}})
    client.asked('workspace/diagnostic/refresh')  # the settings have come
    main = 'file:///nowhere/main.proskill'
    client.open(main, '(include "lamp.proskill")\n(defevent e :effects (lamp Oon))\n')
    client.open(URI, LAMP)
    for change in (lambda: None, lambda: client.change(URI, 2, position(0, 22), position(0, 24), 'Oon'), lambda: client.close(URI)):
        change()
        for what in ('semanticTokens', 'inlayHint', 'inlineValue', 'codeLens', 'diagnostic'):
            client.asked(f'workspace/{what}/refresh')
    client.change(main, 2, position(0, 0), position(0, 0), ';')  # a text alone is its client's own matter
    client.result('proskill/status', None)
    assert client.end() == 0
    assert not [each for each in client.questions if each.endswith('/refresh')], client.questions


def cells_of_a_notebook_are_one_program():
    with tempfile.TemporaryDirectory() as folder:
        notebook = f'file://{os.path.realpath(folder)}/mission.ipynb'
        with open(os.path.join(folder, 'mission.ipynb'), 'w') as file:
            file.write('{"cells": []}')  # no program
        lamp, event = Cell(notebook, 'W0', LAMP), Cell(notebook, 'W1', '(defevent e :effects (lamp On))\n')
        client = started()
        client.open_notebook(notebook, [lamp, event])
        assert client.diagnostics(event.uri, 1) == []
        assert client.result('textDocument/definition', at(event.uri, 0, 22))[0]['uri'] == lamp.uri
        edits = client.result('textDocument/rename', {**at(lamp.uri, 0, 8), 'newName': 'light'})['documentChanges']
        assert {edit['textDocument']['uri']: len(edit['edits']) for edit in edits} == {lamp.uri: 1, event.uri: 1}
        event.edit(client, 27, 29, 'Oon')
        assert 'PS0203' in codes(client.diagnostics(event.uri, 2))
        client.change_cells(notebook, 3, structure={'array': {'start': 0, 'deleteCount': 2, 'cells': [
            {'kind': 2, 'document': cell.uri} for cell in (event, lamp)]}})
        assert client.result('textDocument/definition', at(event.uri, 0, 22))[0]['uri'] == lamp.uri
        for mistake in ({'structure': {'array': {'start': 3, 'deleteCount': 0}}}, {'textContent': [{'document': {'uri': URI, 'version': 1}, 'changes': []}]}):
            client.change_cells(notebook, 4, **mistake)
            assert client.note('window/logMessage')['type'] == 1
        assert [each['uri'] for each in client.result('proskill/status', None)['documents']] == [lamp.uri, event.uri]
        client.notify('notebookDocument/didSave', {'notebookDocument': {'uri': notebook}})
        client.notify('notebookDocument/didClose', {'notebookDocument': {'uri': notebook}, 'cellTextDocuments': [{'uri': lamp.uri}]})
        assert client.diagnostics(lamp.uri, None) == client.diagnostics(event.uri, None) == []
        status = client.result('proskill/status', None)
        assert (status['documents'], status['files'], status['errors']) == ([], 0, 0), status
        assert client.end() == 0


def mistaken_settings_are_told_at_their_file():
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.realpath(folder)
        with open(os.path.join(folder, '.proskill.json'), 'w') as file:
            file.write('{"colour": true}')
        client = started()
        client.open(f'file://{folder}/main.proskill', LAMP)
        told = client.note('textDocument/publishDiagnostics', lambda params: params['uri'].endswith('.json'))
        assert 'colour' in told['diagnostics'][0]['message']
        assert client.end() == 0


def the_editor_s_settings_are_obeyed():
    client = started(settings={'diagnostics': {'enabled': False}})
    client.open(URI, BAD)
    client.result('proskill/status', None)
    client.settings = {'diagnostics': {'enabled': True, 'debounce': 0}}
    client.notify('workspace/didChangeConfiguration', {'settings': None})
    assert 'PS0203' in codes(client.diagnostics(URI, 1))
    client.settings = {'diagnostics': {'enabled': False}}
    client.notify('workspace/didChangeConfiguration', {'settings': None})
    assert client.diagnostics(URI, None) == []
    assert client.end() == 0


def closed_files_of_all_folders_are_checked():
    with tempfile.TemporaryDirectory() as top:
        top = os.path.realpath(top)
        for name, text in [('a/main.proskill', '(include "lamp.proskill")\n(defevent e :effects (lamp Oon))\n'),
                           ('a/lamp.proskill', LAMP), ('b/bad.proskill', BAD), ('b/build/not.proskill', BAD)]:
            os.makedirs(os.path.dirname(os.path.join(top, name)), exist_ok=True)
            with open(os.path.join(top, name), 'w') as file:
                file.write(text)
        folder = lambda name: {'uri': f'file://{top}/{name}', 'name': name}
        client = server()
        pull = {'textDocument': {'diagnostic': {}}}
        client.initialize(pull, workspaceFolders=[folder('a')])
        def whole(count, previous=()):
            deadline = time.monotonic() + PATIENCE
            while True:  # the folders are read in the background
                items = client.result('workspace/diagnostic', {'previousResultIds': list(previous)})['items']
                if len(items) == count:
                    return {item['uri'].removeprefix(f'file://{top}/'): item for item in items}
                assert time.monotonic() < deadline, items
        first = whole(2)
        assert codes(first['a/main.proskill']['items']) and first['a/main.proskill']['version'] is None
        client.notify('workspace/didChangeWorkspaceFolders', {'event': {'added': [folder('b')], 'removed': []}})
        both = whole(3)
        assert 'PS0203' in codes(both['b/bad.proskill']['items'])
        previous = [{'uri': item['uri'], 'value': item['resultId']} for item in both.values()]
        assert {item['kind'] for item in whole(3, previous).values()} == {'unchanged'}
        client.notify('workspace/didChangeWorkspaceFolders', {'event': {'added': [], 'removed': [folder('a')]}})
        after = whole(3, previous)  # two of them gone: reported once more, empty
        assert after['a/main.proskill']['items'] == [] and after['b/bad.proskill']['kind'] == 'unchanged'
        asked = client.ask('workspace/diagnostic', {'previousResultIds': [], 'partialResultToken': 'parts', 'workDoneToken': 'work'})
        assert client.answer(asked)['result']['items'] == []
        tokens = [note.message['params']['token'] for note, _ in client.notes if note.message['method'] == '$/progress']
        assert tokens.count('parts') == 1 and tokens.count('work') >= 2, tokens
        assert client.end() == 0


def uri_spellings_are_the_client_s():
    client = started()
    for uri in ['untitled:Untitled-1', 'file:///c%3A/w/a%20b.proskill', 'file:///nowhere/%C3%A9%2Bx.proskill', 'vscode-notebook:/x#1']:
        client.open(uri, BAD)
        assert 'PS0203' in codes(client.diagnostics(uri, 1))
        assert client.result('textDocument/definition', at(uri, 0, 8))[0]['uri'] == uri
    assert client.end() == 0


def requests_are_logged_and_traced():
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, 'log')
        client = Client([PROGRAM, 'lsp', '--log', log])
        client.initialize(trace='messages')
        client.open(URI, LAMP)
        client.result('textDocument/definition', at(URI, 0, 8))
        assert 'textDocument/definition' in client.note('$/logTrace')['message']
        status = client.result('proskill/status', None)
        assert status['requests']['textDocument/definition']['count'] == 1
        assert status['memoryBytes'] > 1_000_000 and status['errors'] == 0
        assert client.end() == 0
        lines = open(log).read().splitlines()
        form = re.compile(r'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z textDocument/definition \d+ \d+\.\d{3} ms ok$')
        assert any(form.match(line) for line in lines), lines


def a_killed_client_takes_the_server_along():
    script = ('import subprocess, sys, time\n'
              'p = subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE, stdout=subprocess.PIPE)\n'
              'print(p.pid, flush=True)\ntime.sleep(600)\n')
    between = subprocess.Popen([sys.executable, '-c', script, PROGRAM, 'lsp'], stdout=subprocess.PIPE, text=True)
    pid = int(between.stdout.readline())
    between.kill()
    between.wait()
    wait_until_gone(pid)


def a_client_may_come_by_a_port():
    process = subprocess.Popen([PROGRAM, 'lsp', '--port', '0'], stderr=subprocess.PIPE, text=True)
    port = int(re.search(r'port (\d+)', process.stderr.readline())[1])
    with socket.create_connection(('127.0.0.1', port)) as connection:
        client = Client.__new__(Client)
        client.process = process
        client.begin(connection.makefile('wb'), connection.makefile('rb'))
        client.initialize()
        client.open(URI, LAMP)
        assert len(client.result('textDocument/definition', at(URI, 0, 8))) == 1
        assert client.end() == 0
    process = subprocess.Popen([PROGRAM, 'lsp', '--port', '0'], stderr=subprocess.PIPE, text=True)
    port = int(re.search(r'port (\d+)', process.stderr.readline())[1])
    socket.create_connection(('127.0.0.1', port)).close()
    assert process.wait(PATIENCE) == 1


def main():
    sessions = [each for name, each in globals().items()
                if callable(each) and getattr(each, '__module__', '') == '__main__' and '_' in name
                and name not in ('is_running', 'wait_until_gone')]
    wanted = sys.argv[2:]
    for session in sessions:
        if not wanted or session.__name__ in wanted:
            print(session.__name__.replace('_', ' '), flush=True)
            session()


if __name__ == '__main__':
    main()
