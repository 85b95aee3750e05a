"""Scripted sessions with the real program: usage: sessions.py PROSKILL [SESSION...]

Each session is a function, and its name says what holds."""

import os
import re
import socket
import subprocess
import sys
import tempfile

from client import Cell, Client, PATIENCE, framed, position
from scripted import BAD, LAMP, PROGRAM, URI, at, codes, server, started, wait_until_gone, run


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
    assert client.error('textDocument/definition', at(URI, 0, 8)) == -32801
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
            if settings:  # the server reads the file again when the client reports a change
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


def requests_are_logged_and_traced():
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, 'log')
        client = Client([PROGRAM, 'lsp', '--no-cache', '--log', log])
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


if __name__ == '__main__':
    run(dict(globals()))
