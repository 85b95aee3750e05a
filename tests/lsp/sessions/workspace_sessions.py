"""Scripted sessions about files, folders and settings: usage: workspace_sessions.py PROSKILL [SESSION...]

Each session is a function, and its name says what holds."""

import os
import tempfile
import time

from client import CAPABILITIES, PATIENCE, position
from scripted import BAD, LAMP, URI, at, codes, server, started, run


def an_include_of_what_is_no_file_is_an_error_and_nobody_waits_for_it():
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.realpath(folder)
        os.mkfifo(f'{folder}/pipe.proskill')  # reading it blocks until somebody writes
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
        client.open(linked, lamp)  # as the client spells it, and still part of the program
        assert client.diagnostics(linked, 1) == []
        assert definition(client, f'{real}/main.proskill') == linked
        links = client.result('textDocument/documentLink', {'textDocument': {'uri': f'{real}/main.proskill'}})
        assert [each['target'] for each in links] == [linked] * 2
        edits = client.result('textDocument/rename', {**at(linked, 0, 8), 'newName': 'light'})['documentChanges']
        assert {edit['textDocument']['uri']: len(edit['edits']) for edit in edits} == {linked: 1, f'{real}/main.proskill': 2}
        client.change(linked, 2, position(0, 7), position(0, 11), 'light')
        wait_for_main(has_errors=True)
        # The same file, opened by another name, is a separate text, and takes over when the first is closed.
        client.open(also, lamp)
        assert client.result('textDocument/definition', at(linked, 0, 8))[0]['uri'] == linked
        wait_for_main(has_errors=True)
        client.close(linked)
        wait_for_main(has_errors=False)
        assert definition(client, f'{real}/main.proskill') == also
        client.close(also)  # and keeps this name, which the client knows
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


def other_texts_of_a_program_are_asked_for_again():
    client = server()
    client.initialize({**CAPABILITIES, 'textDocument': {**CAPABILITIES['textDocument'], 'diagnostic': {}}})
    client.asked('workspace/diagnostic/refresh')  # the settings have arrived
    main = 'file:///nowhere/main.proskill'
    client.open(main, '(include "lamp.proskill")\n(defevent e :effects (lamp Oon))\n')
    client.open(URI, LAMP)
    for change in (lambda: None, lambda: client.change(URI, 2, position(0, 22), position(0, 24), 'Oon'), lambda: client.close(URI)):
        change()
        for what in ('semanticTokens', 'inlayHint', 'inlineValue', 'codeLens', 'diagnostic'):
            client.asked(f'workspace/{what}/refresh')
    client.change(main, 2, position(0, 0), position(0, 0), ';')  # a single text is configured by its client
    client.result('proskill/status', None)
    assert client.end() == 0
    assert not [each for each in client.questions if each.endswith('/refresh')], client.questions


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


if __name__ == '__main__':
    run(dict(globals()))
