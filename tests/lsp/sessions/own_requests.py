"""Whether what ProSkill's own requests answer is what docs/lsp.md says, member by member. Usage: own_requests.py PROSKILL"""

import json
import pathlib
import subprocess
import sys
import tempfile

from client import CAPABILITIES, Client, position
from manual_types import Types

ROOT = pathlib.Path(__file__).resolve().parents[3]
DRONE = ROOT / 'examples' / 'drone' / 'drone.proskill'
# A lasso, a violated property, a call with a branch, an event: what the drone's program has none of.
SMALL = '''(defsv lamp :states (On Off) :init Off :transitions :all)
(defsv door :states (Open Shut) :init Shut :transitions :all)
(defevent dusk :effects (lamp On))
(defskill blink :start (lamp Off) :time_interval [1,2] :action (blink) :success lit (:effects (lamp On)) :failure broken)
(defskill mission :success well
  :body ((while true (// ((blink)) ((^ 1)) ))))
(defproperty never_open (always (not (door Open))))
(defproperty shut (always (lamp Off)))
(defproperty at_last (ltl (<> (door Open))))
'''


# All skills share a variable, so the question about deadlocks is practically endless, and progress is reported until
# the time limit.
ENDLESS = '(defsv last :states (' + ' '.join(f'T{i}' for i in range(5, 14)) + ') :init T5)\n' + ''.join(
    f'(defskill s{i} :precondition (other (/= last T{i})) :time_interval [1,{i}] :action (a) '
    f':success ok (:effects (last T{i})) :failure bad)\n' for i in range(5, 14))


def about(uri, **more):
    return {'textDocument': {'uri': uri}, **more}


def pictures(client, types, uri):
    calls = client.result('proskill/automaton', about(uri, format='json', kind='calls'))
    for each in calls['pictures']:
        for form in ['svg', 'dot', 'json']:
            asked = about(uri, kind=each['kind'], name=each['name'], format=form, forbidden=True)
            types.check(client.result('proskill/automaton', asked), 'Automaton')
    for line in range(8):
        types.check(client.result('proskill/automaton', about(uri, position=position(line, 10))), 'Automaton')


def models(client, types, uri):
    for edition in ['compact', 'expanded', 'runtime']:
        types.check(client.result('proskill/model', about(uri, edition=edition)), 'Model')


def traces(client, types, uri, verdicts):
    for verdict in verdicts:
        if verdict['steps'] is not None:
            types.check(client.result('proskill/trace', about(uri, name=verdict['name'])), 'Trace')


def simulations(client, types, uri):
    """The first steps that are offered, the last of them late; then one that there is not."""
    steps = []
    for _ in range(6):
        now = client.result('proskill/simulate', about(uri, steps=steps, expect={'nobody': 'x'}))
        types.check(now, 'Simulation')
        if not now['choices']:
            break
        steps.append({**now['choices'][0], 'late': True})
    missing = client.result('proskill/simulate', about(uri, steps=[{'actor': 'nobody', 'description': 'does this'}]))
    types.check(missing, 'Simulation')
    assert missing['missing']['index'] == 0


def recordings(client, types):
    """A long one, of which a part is read; and what is none."""
    with tempfile.TemporaryDirectory() as directory:
        program, recording = pathlib.Path(directory, 'endless.proskill'), pathlib.Path(directory, 'run.mcap')
        program.write_text('(defskill m :body ((while true (^ 1))))')
        subprocess.run([sys.argv[1], 'run', '--until', '2d', '--record', recording, program], stdout=subprocess.DEVNULL)
        last = client.result('proskill/recording', {'uri': recording.as_uri()})
        first = client.result('proskill/recording', {'uri': recording.as_uri(), 'from': 0})
        for part in (last, first):
            types.check(part, 'Recording')
            steps = json.loads(part['trace'])['steps']
            assert not part['whole'] and part['length'] == 2 * 86400
            assert steps[-1]['date']['seconds'] == part['end']
        assert first['begin'] == 0 and last['end'] == last['length']
        assert client.error('proskill/recording', {'uri': program.as_uri()}) == -32803  # it is not one
        sources = {program.as_uri(): digest for digest in json.loads(last['trace'])['sources'].values()}
        assert edited(client, types, sources) == []
        program.write_text('(defskill m :body ((while true (^ 2))))')
        assert edited(client, types, sources) == [program.as_uri()]
    assert edited(client, types, sources) == []  # the file is gone
    assert client.error('proskill/edited', {'sources': []}) == -32602


def edited(client, types, sources):
    result = client.result('proskill/edited', {'sources': sources})
    types.check(result, 'Edited')
    return result['edited']


def verdicts(client, types, uri):
    result = client.result('proskill/verify', about(uri))
    types.check(result, 'VerifyResult')
    traces(client, types, uri, result['verdicts'])
    types.check(client.result('proskill/verify', about(uri, limits={'classes': 3})), 'VerifyResult')


def main():
    types = Types((ROOT / 'docs' / 'lsp.md').read_text())
    client = Client([sys.argv[1], 'lsp', '--debounce', '0', '--no-cache'])
    client.initialize(CAPABILITIES, initializationOptions={'verify': {'live': False}})
    for uri, text in [(DRONE.as_uri(), DRONE.read_text()), ('untitled:small', SMALL)]:
        client.open(uri, text)
        pictures(client, types, uri)
        models(client, types, uri)
        simulations(client, types, uri)
        verdicts(client, types, uri)
        types.check(client.result('proskill/tests', about(uri)), 'Tests')
    client.open('untitled:endless', ENDLESS)
    types.check(client.result('proskill/verify', about('untitled:endless', limits={'seconds': 1})), 'VerifyResult')
    client.open('untitled:broken', '(defskill a :body ((b)))')
    types.check(client.result('proskill/automaton', about('untitled:broken', kind='calls')), 'Automaton')
    types.check(client.result('proskill/tests', {}), 'Tests')
    types.check(client.result('proskill/explain', {'code': 'PS0301'}), 'Explanation')
    recordings(client, types)
    types.check(client.result('proskill/status', None), 'Status')
    for note, _ in client.notes:
        if note.message['method'] == 'proskill/verdicts':
            types.check(note.message['params'], 'Verdicts')
    for name in ['Automaton', 'Model', 'Tests', 'VerifyResult', 'Trace', 'Verdicts', 'Explanation', 'Status']:
        unseen = types.unseen(name)
        assert not unseen, f'no answer had {unseen}'
    assert client.end() == 0


if __name__ == '__main__':
    main()
