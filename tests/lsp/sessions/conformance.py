"""Whether the server's messages are of the protocol's types: a session that calls every request that the server offers,
recorded and handed to ../conformance/check.mjs. Whether its numbers are the protocol's, too. Usage: conformance.py PROSKILL"""

import json
import pathlib
import subprocess
import sys
import tempfile

from client import CAPABILITIES, Cell, Client, Text

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[2]))
import npm  # noqa: E402

ROOT = HERE.parents[3]
CHECKER = HERE.parents[1] / 'conformance'
PLACES = 40  # in the text that each request about a place asks about


def about(text, **more):
    return {'textDocument': {'uri': text.uri}, **more}


def places(text):
    """Spread over the text, most of them within words."""
    step = max(1, len(text.text) // PLACES)
    return [text.position(offset) for offset in range(1, len(text.text), step)]


def whole(text):
    return {'start': text.position(0), 'end': text.position(len(text.text))}


def at_places(method, **more):
    return lambda client, text: [client.request(method, about(text, position=place, **more)) for place in places(text)]


def once(method, **more):
    return lambda client, text: [client.request(method, about(text, **more))]


def resolved(method, resolve, ask):
    """Asks, and has the first few of what comes completed."""
    def run(client, text):
        answers = ask(method)(client, text) if callable(ask) else ask
        for answer in answers:
            result = answer.get('result') or []
            for item in (result['items'] if isinstance(result, dict) else result)[:5]:
                client.request(resolve, item)
    return run


def hierarchy(prepare, *follow):
    def run(client, text):
        for answer in at_places(prepare)(client, text):
            for item in answer.get('result') or []:
                for method in follow:
                    client.request(method, {'item': item})
    return run


def code_actions(client, text):
    for place in places(text):
        answer = client.request('textDocument/codeAction', about(text, range={'start': place, 'end': place},
                                                                 context={'diagnostics': []}))
        for action in (answer.get('result') or [])[:5]:
            if 'data' in action:
                client.request('codeAction/resolve', action)


def rename(client, text):
    for place in places(text):
        client.request('textDocument/prepareRename', about(text, position=place))
        client.request('textDocument/rename', about(text, position=place, newName='renamed'))


def semantic_tokens(client, text):
    answer = client.request('textDocument/semanticTokens/full', about(text))
    client.request('textDocument/semanticTokens/range', about(text, range=whole(text)))
    text.edit(client, 0, 0, '; a comment\n')
    client.request('textDocument/semanticTokens/full/delta',
                   about(text, previousResultId=answer['result'].get('resultId', '')))


def diagnostics(client, text):
    answer = client.request('textDocument/diagnostic', about(text))
    client.request('textDocument/diagnostic', about(text, previousResultId=answer['result'].get('resultId')))
    client.request('workspace/diagnostic', {'previousResultIds': [], 'workDoneToken': 'work'})
    client.request('workspace/diagnostic', {'previousResultIds': [], 'partialResultToken': 'parts'})


def execute_command(client, text):
    client.request('workspace/executeCommand', {'command': 'proskill.none', 'arguments': []})


FORMATTING = {'tabSize': 2, 'insertSpaces': True}

# What each capability of the server lets a client ask.
REQUESTS = {
    'callHierarchyProvider': hierarchy('textDocument/prepareCallHierarchy', 'callHierarchy/incomingCalls',
                                       'callHierarchy/outgoingCalls'),
    'codeActionProvider': code_actions,
    'codeLensProvider': resolved('textDocument/codeLens', 'codeLens/resolve', once),
    'completionProvider': resolved('textDocument/completion', 'completionItem/resolve', at_places),
    'declarationProvider': at_places('textDocument/declaration'),
    'definitionProvider': at_places('textDocument/definition'),
    'diagnosticProvider': diagnostics,
    'documentFormattingProvider': once('textDocument/formatting', options=FORMATTING),
    'documentHighlightProvider': at_places('textDocument/documentHighlight'),
    'documentLinkProvider': resolved('textDocument/documentLink', 'documentLink/resolve', once),
    'documentOnTypeFormattingProvider': at_places('textDocument/onTypeFormatting', ch='\n', options=FORMATTING),
    'documentRangeFormattingProvider':
        lambda client, text: client.request('textDocument/rangeFormatting',
                                            about(text, range=whole(text), options=FORMATTING)),
    'documentSymbolProvider': once('textDocument/documentSymbol'),
    'executeCommandProvider': execute_command,
    'foldingRangeProvider': once('textDocument/foldingRange'),
    'hoverProvider': at_places('textDocument/hover'),
    'implementationProvider': at_places('textDocument/implementation'),
    'inlayHintProvider': resolved('textDocument/inlayHint', 'inlayHint/resolve', lambda method: lambda client, text: [
        client.request(method, about(text, range=whole(text)))]),
    'inlineValueProvider':
        lambda client, text: client.request('textDocument/inlineValue', about(text, range=whole(text), context={
            'frameId': 1, 'stoppedLocation': whole(text)})),
    'linkedEditingRangeProvider': at_places('textDocument/linkedEditingRange'),
    'referencesProvider': at_places('textDocument/references', context={'includeDeclaration': True}),
    'renameProvider': rename,
    'selectionRangeProvider':
        lambda client, text: client.request('textDocument/selectionRange', about(text, positions=places(text))),
    'semanticTokensProvider': semantic_tokens,
    'signatureHelpProvider': at_places('textDocument/signatureHelp'),
    'typeDefinitionProvider': at_places('textDocument/typeDefinition'),
    'typeHierarchyProvider': hierarchy('textDocument/prepareTypeHierarchy', 'typeHierarchy/supertypes',
                                       'typeHierarchy/subtypes'),
    'workspace':
        lambda client, text: client.request('workspace/willRenameFiles', {
            'files': [{'oldUri': (ROOT / 'examples' / 'drone' / 'drone.proskill').as_uri(), 'newUri': 'file:///elsewhere'}]}),
    'workspaceSymbolProvider':
        lambda client, text: [client.request('workspace/symbol', {'query': query}) for query in ('', 'take')],
}
NO_REQUESTS = {'positionEncoding', 'textDocumentSync', 'notebookDocumentSync', 'experimental'}


def session(program):
    """Calls every method, with a valid program and one with many errors. Returns the messages."""
    client = Client([program, 'lsp', '--debounce', '0', '--no-cache'], recording=True, settings={'diagnostics': {'style': True}})
    drone = ROOT / 'examples' / 'drone'
    offered = client.initialize({**CAPABILITIES, 'workspace': {**CAPABILITIES['workspace'], 'symbol': {}}},
                                workspaceFolders=[{'uri': drone.as_uri(), 'name': 'drone'}], trace='verbose')['capabilities']
    unknown = set(offered) - set(REQUESTS) - NO_REQUESTS
    assert not unknown, f'{unknown}: say in conformance.py what these let a client ask'
    source = (drone / 'drone.proskill').read_text()
    middle = source.index('(defskill')
    notebook = 'file:///nowhere/drone.ipynb'
    cells = [Cell(notebook, 'W0', source[:middle]), Cell(notebook, 'W1', source[middle:])]
    client.open_notebook(notebook, cells)
    for text in [Text((drone / 'drone.proskill').as_uri(), source), cells[1],
                 Text('untitled:broken', source.replace(':states', ':sttes').replace('takeoff', 'take off'))]:
        if text is not cells[1]:
            client.open(text.uri, text.text)
        client.diagnostics(text.uri, 1)
        for capability in sorted(set(offered) & set(REQUESTS)):
            REQUESTS[capability](client, text)
    client.notify('workspace/didChangeWorkspaceFolders', {'event': {'added': [], 'removed': []}})  # may mean all
    for what in ('semanticTokens', 'inlayHint', 'inlineValue', 'codeLens'):
        client.asked(f'workspace/{what}/refresh')
    client.request('proskill/status', None)
    client.request('textDocument/nonsense', {})
    assert client.end() == 0
    return client.record


def main():
    npm.install(CHECKER)
    if subprocess.run(['node', CHECKER / 'numbers.mjs', 'check']).returncode:
        sys.exit(1)
    record = session(sys.argv[1])
    with tempfile.NamedTemporaryFile('w', suffix='.json') as file:
        json.dump(record, file)
        file.flush()
        sys.exit(subprocess.run(['node', CHECKER / 'check.mjs', file.name]).returncode)


if __name__ == '__main__':
    main()
