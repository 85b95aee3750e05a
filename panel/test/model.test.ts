import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Trace, Verdict } from '../src/api.ts';
import { actorsOf } from '../src/model/actors.ts';
import { compare, isDifferent } from '../src/model/compare.ts';
import { difference } from '../src/model/diff.ts';
import { fileName, traceJson, traceText } from '../src/model/export.ts';
import { everything, groups, search, select } from '../src/model/filter.ts';
import { highlight } from '../src/model/highlight.ts';
import { axisOf, drawBars, drawMarks, endOfAxis, lanesOf, nearest } from '../src/model/lanes.ts';
import { open } from '../src/model/parse.ts';
import { continuation, tellsTheSame } from '../src/model/renew.ts';
import { badTimes, clockTime, fractions, positionAt } from '../src/model/seek.ts';
import { decimal, ticks, windowOf } from '../src/model/time.ts';
import { Values } from '../src/model/values.ts';
import { changesSince, withChanges } from '../src/model/verdict_changes.ts';
import { Rows } from '../src/model/virtual.ts';
import { watched, watchOf } from '../src/model/watch.ts';
import { flight, step, trace } from './traces.ts';

test('the values at a step are the first ones and all changes up to it', () => {
  const values = new Values(flight);
  assert.equal(values.at(-1).get('level'), '4');
  assert.equal(values.at(2).get('level'), '3');
  assert.equal(values.at(2).get('battery'), 'Good');
  assert.equal(values.at(9).get('takeoff.status'), 'failed_inv');
});

test('the values of a long trace are those of going through it', () => {
  const lines = Array.from({ length: 1000 }, (_, i) => `a: counts @${i} n=${i}>${i + 1} ${i % 7 ? '' : `m=${i}>${i + 7}`}`);
  const long = trace({ n: '0', m: '0' }, lines);
  const values = new Values(long);
  const now = new Map(Object.entries(long.initial));
  long.steps.forEach((it, index) => {
    for (const change of it.changes) now.set(change.variable, change.after);
    assert.deepEqual(values.at(index), now);
  });
});

test('statements are coloured where they open a form, and nowhere else', () => {
  const forms = (text: string): string[] => highlight(text)[0]!.filter((it) => it.kind === 'form').map((it) => it.text);
  assert.deepEqual(forms('(case (drive) (failure (goto again)))'), ['case', 'failure', 'goto']);
  assert.deepEqual(forms('(always (set case))'), ['set']);
});

test('a trace without steps has its first values', () => {
  assert.equal(new Values(trace({ a: '1' }, [])).at(-1).get('a'), '1');
});

test('variables are listed by their numbers', () => {
  const numbered = trace({ s10: 'a', s2: 'a', s1: 'a', 's2.status': 'a', room: 'a' }, ['e: occurs @0 s10=a>b s2=a>b s1=a>b']);
  assert.deepEqual(new Values(numbered).names, ['room', 's1', 's2', 's2.status', 's10']);
  assert.deepEqual(lanesOf(numbered).filter(({ kind }) => kind === 'variable').map(({ name }) => name), ['s1', 's2', 's10']);
});

test('differences of values say what is new within them', () => {
  assert.equal(difference('4', '3').delta, '−1');
  assert.equal(difference('0.1', '0.3').delta, '+0.2');
  assert.equal(difference('Good', 'Good').kind, 'same');
  assert.equal(difference('', 'x').kind, 'added');
  assert.equal(difference('x', '').kind, 'removed');
  assert.equal(difference('Good', 'Low').kind, 'replaced');
  const within = difference('{goal: A, speed: 3}', '{goal: A, speed: 4}');
  assert.equal(within.kind, 'within');
  assert.deepEqual(within.after.filter((part) => part.changed).map((part) => part.text), ['4']);
  assert.equal(within.after.map((part) => part.text).join(''), '{goal: A, speed: 4}');
});

test('only the rows in view are drawn', () => {
  const rows = new Rows([10, 20, 30, 40]);
  assert.equal(rows.height, 100);
  assert.deepEqual(rows.visible(0, 5), [0, 1]);
  assert.deepEqual(rows.visible(10, 20), [1, 3]);
  assert.deepEqual(rows.visible(95, 500), [3, 4]);
  assert.deepEqual(new Rows([]).visible(0, 100), [0, 0]);
  assert.equal(rows.at(-7), 0);
  assert.equal(rows.at(29.9), 1);
});

test('a row that is in view is not scrolled to', () => {
  const rows = new Rows(new Array(100).fill(10));
  assert.equal(rows.reveal(3, 0, 100), 0);
  assert.equal(rows.reveal(12, 0, 100), 30);
  assert.equal(rows.reveal(2, 500, 100), 20);
  assert.equal(rows.reveal(99, 0, 100, 40), 900);
});

test('actors are known by their names and words', () => {
  const kinds = Object.fromEntries(actorsOf(flight).map((actor) => [actor.name, actor.kind]));
  assert.deepEqual(kinds, {
    mission: 'skill', takeoff: 'skill', battery_low: 'event', 'mission branch 1': 'branch',
    'watchdog of mission': 'watchdog',
  });
  assert.equal(actorsOf(flight).find((actor) => actor.kind === 'branch')?.skill, 'mission');
  const given = actorsOf({ ...flight, actors: [{ name: 'takeoff', kind: 'environment', skill: null }] });
  assert.equal(given.find((actor) => actor.name === 'takeoff')?.kind, 'environment');
});

test('who has no status is an event, or the automaton of a variable', () => {
  const moved = trace({ battery: 'Good', 'takeoff.status': 'no_status' }, [
    'battery_low: makes a forbidden move: x @0 battery=Good>Low', 'battery: has made a forbidden move @0', 'takeoff: is refused @1']);
  assert.deepEqual(actorsOf(moved).map((actor) => actor.kind), ['event', 'variable', 'skill']);
  assert.deepEqual(lanesOf(moved).map((lane) => [lane.name, lane.kind]),
    [['takeoff', 'skill'], ['battery_low', 'event'], ['battery', 'variable']]);
});

test('of a model by hand the instances of processes act, alone or together', () => {
  const met = trace({ P_1: 'a', P_2: 'a', x: '0' }, ['P_1: to b @0 P_1=a>b', 'P_1, P_2: meet @1 x=0>1']);
  met.steps[0]!.transitions = ['P_1_t0'];
  met.steps[1]!.transitions = ['P_2_t1_P_1_t1'];
  assert.deepEqual(actorsOf(met).map((actor) => actor.kind), ['process', 'process']);
  assert.deepEqual(lanesOf(met).map((lane) => lane.name), ['P_1', 'x']);
});

test('what the last step did is seen beside it, and what was before the first', () => {
  const changes = trace({ v: 'A' }, ['e: occurs @0 v=A>B', 'e: occurs @0 v=B>C']);
  const axis = axisOf(changes, 'step');
  const lane = lanesOf(changes).find((it) => it.name === 'v')!;
  assert.deepEqual(drawBars(lane, axis, 0, endOfAxis(axis, 'step'), 300).map((it) => [it.bar!.label, it.x, it.width]),
    [['A', 0, 100], ['B', 100, 100], ['C', 200, 100]]);
});

test('filters take actors, variables and steps that change something', () => {
  assert.deepEqual(select(flight, everything).length, flight.steps.length);
  assert.deepEqual(select(flight, { ...everything, actors: new Set(['takeoff']) }), [2, 4, 5]);
  assert.deepEqual(select(flight, { ...everything, variables: new Set(['battery', 'level']) }), [2, 3]);
  assert.deepEqual(select(flight, { ...everything, changing: true, actors: new Set(['takeoff']) }), [2, 5]);
});

test('steps of one actor in a row are a group', () => {
  const shown = groups(flight, select(flight, everything));
  assert.deepEqual(shown.slice(0, 3).map((group) => [group.actor, group.steps]), [
    ['mission', [0, 1]], ['takeoff', [2]], ['battery_low', [3]],
  ]);
});

test('the search looks at actors, words and values, without their quotes', () => {
  assert.deepEqual(search(flight, 'calls takeoff'), [1]);
  assert.deepEqual(search(flight, 'BATTERY'), [3]);
  assert.deepEqual(search(flight, 'good low'), [3]);
  assert.deepEqual(search(flight, '  '), []);
});

test('a skill has a bar from its start to when its status says that it ended', () => {
  const lanes = lanesOf(flight);
  const takeoff = lanes.find((lane) => lane.name === 'takeoff')!;
  assert.deepEqual(takeoff.bars.map((bar) => [bar.from, bar.to, bar.tone, bar.open]), [[2, 5, 'failure', false]]);
  assert.deepEqual(takeoff.marks, [2, 4, 5]);
  const mission = lanes.find((lane) => lane.name === 'mission')!;
  assert.deepEqual(mission.bars.map((bar) => [bar.from, bar.tone, bar.open]), [[0, 'running', true]]);
  const branch = lanes.find((lane) => lane.name === 'mission branch 1')!;
  assert.deepEqual(branch.bars.map((bar) => [bar.from, bar.to, bar.tone]), [[7, 9, 'success']]);
});

test('what is said of a recorded run ends no bar', () => {
  const recorded = trace({ 'a.status': 'no_status' }, ['a: starts @0', 'a: undershoot: took less time than its interval says @1',
    'a: succeeds with `done` @1 a.status=no_status>success']);
  recorded.steps[1]!.remark = 'undershoot';
  const lane = lanesOf(recorded).find((it) => it.name === 'a')!;
  assert.deepEqual(lane.bars.map((bar) => [bar.from, bar.to, bar.tone]), [[0, 2, 'success']]);
  assert.deepEqual(lane.marks, [0, 1, 2]);
});

test('a call that is refused is no run', () => {
  const lanes = lanesOf(trace({ 'a.status': 'no_status' }, ['a: is refused because of its precondition @0']));
  assert.deepEqual(lanes[0]!.bars, []);
  assert.deepEqual(lanes[0]!.marks, [0]);
});

test('a variable that changes has a bar for each value; what skills return is seen in their lanes', () => {
  const lanes = lanesOf(flight).filter((lane) => lane.kind === 'variable');
  assert.deepEqual(lanes.map((lane) => lane.name), ['battery', 'level']);
  assert.deepEqual(lanes[0]!.bars.map((bar) => [bar.label, bar.from, bar.to]), [['Good', -1, 3], ['Low', 3, 9]]);
});

test('bars are drawn where they are on the axis, and only those in view', () => {
  const battery = lanesOf(flight).find((lane) => lane.name === 'battery')!;
  const axis = axisOf(flight, 'date');
  const drawn = drawBars(battery, axis, 0, 4, 400);
  assert.deepEqual(drawn.map((it) => [it.x, it.width]), [[0, 200], [200, 200]]);
  assert.deepEqual(drawBars(battery, axis, 0, 1, 400).length, 1);
});

test('ten thousand bars in a hundred pixels are not drawn one by one', () => {
  const lines = Array.from({ length: 10000 }, (_, i) => `e: occurs @${i} v=${i}>${i + 1}`);
  const long = trace({ v: '0' }, lines);
  const [events, values] = lanesOf(long);
  const axis = axisOf(long, 'date');
  assert.ok(drawBars(values!, axis, 0, 10000, 100).length <= 101);
  assert.ok(drawMarks(events!, axis, 0, 10000, 100).length <= 101);
  assert.equal(drawMarks(events!, axis, 0, 10000, 100).reduce((sum, mark) => sum + mark.count, 0), 10000);
});

test('the nearest step of a lane', () => {
  assert.equal(nearest([0, 3, 9], axisOf(flight, 'date'), 2.2), 3);
  assert.equal(nearest([], axisOf(flight, 'date'), 1), null);
});

test('dates are written as intervals', () => {
  const at = step('a: b @1');
  assert.equal(windowOf(at), '1');
  assert.equal(windowOf({ ...at, latest: { exact: '2', seconds: 2, strict: true } }), '[1, 2[');
  assert.equal(windowOf({ ...at, latest: { exact: '19/18', seconds: 19 / 18, strict: true } }), '[1, 1.056[');
  assert.equal(windowOf({ ...at, earliest: { ...at.earliest, strict: true }, latest: null }), ']1, …[');
});

test('dates of recordings are written to the millisecond, and never as zero', () => {
  const written = (exact: string): string => decimal({ exact, seconds: Number(exact) });
  assert.deepEqual(['15.164572266', '0.005', '120', '3.4007', '0.000166', '0'].map(written), ['15.165', '0.005', '120', '3.401', '0.0002', '0']);
  assert.equal(decimal({ exact: '1/3000', seconds: 1 / 3000 }), '0.0003');
});

test('marks of an axis are round', () => {
  assert.deepEqual(ticks(0, 10, 5), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(ticks(0.25, 1.1, 4), [0.5, 1]);
  assert.deepEqual(ticks(3, 3, 4), []);
});

const shape = (pairs: { left: number | null; right: number | null }[]): string =>
  pairs.map((pair) => (pair.left === null ? '+' : pair.right === null ? '-' : '=')).join('');

test('two traces are aligned by what happens', () => {
  const other: Trace = { ...flight, steps: flight.steps.filter((_, i) => i !== 3) };
  assert.equal(shape(compare(flight, other)), '===-======');
  assert.equal(shape(compare(other, flight)), '===+======');
  assert.equal(shape(compare(flight, flight)), '==========');
});

test('every step of both traces stands in the comparison once and in order, whatever they are', () => {
  let seed = 7;
  const random = (n: number) => (seed = (seed * 48271) % 2147483647) % n;
  for (let round = 0; round < 500; ++round) {
    const make = () => trace({}, Array.from({ length: random(12) }, () => `a: ${'xyz'[random(3)]} @0`));
    const [left, right] = [make(), make()];
    const pairs = compare(left, right);
    assert.deepEqual(pairs.flatMap((pair) => pair.left ?? []), left.steps.map((_, i) => i));
    assert.deepEqual(pairs.flatMap((pair) => pair.right ?? []), right.steps.map((_, i) => i));
    for (const pair of pairs)
      if (!isDifferent(pair)) assert.equal(left.steps[pair.left!]!.description, right.steps[pair.right!]!.description);
    const differences = pairs.filter(isDifferent).length;
    assert.equal(differences, left.steps.length + right.steps.length - 2 * longestCommon(left, right));
  }
});

function longestCommon(left: Trace, right: Trace): number {
  const [a, b] = [left, right].map((it) => it.steps.map((s) => s.description)) as [string[], string[]];
  const best = (i: number, j: number): number =>
    i === a.length || j === b.length ? 0
      : a[i] === b[j] ? 1 + best(i + 1, j + 1) : Math.max(best(i + 1, j), best(i, j + 1));
  return best(0, 0);
}

test('what is exported is opened again', () => {
  assert.deepEqual(open(traceJson(flight)).traces, [flight]);
  assert.match(traceText(flight), /4 {2} +2 s {2}battery_low: occurs\n +battery: Good -> Low/);
  assert.equal(fileName('a b/c', 'json'), 'a_b_c.json');
});

test('a report of the command line is opened, its places counted from 0', () => {
  const file = { file: 'm.proskill', begin: { line: 3, column: 5 }, end: { line: 3, column: 9 }, bytes: [1, 5] };
  const report = {
    version: 1, program: 'dir/m.proskill', main: null,
    properties: [
      { name: 'p', description: 'never P', verdict: 'violated', location: file,
        trace: { initial: {}, steps: [{ ...flight.steps[0], location: file }] } },
      { name: 'q', description: 'q', verdict: 'holds', location: null, trace: null },
    ],
  };
  const { program, traces } = open(JSON.stringify(report));
  assert.equal(program!.label, 'm.proskill');
  assert.deepEqual(program!.verdicts.map((verdict) => verdict.steps), [1, null]);
  assert.deepEqual(traces[0]!.steps[0]!.location, {
    uri: 'm.proskill', range: { start: { line: 2, character: 4 }, end: { line: 2, character: 8 } },
  });
});

test('what is no trace is refused with a reason', () => {
  assert.throws(() => open('{'), /not valid JSON/);
  assert.throws(() => open('[]'), /neither/);
  assert.throws(() => open('{"a": 1}'), /neither/);
  assert.throws(() => open('{"initial": {}, "steps": [{}]}'), /step 1/);
});

test('a watch is asked of the values after each step', () => {
  const at = (text: string): string[] => {
    const values = new Values(watched(flight, [watchOf(text, flight)]));
    return [-1, 2, 3, 5].map((index) => values.at(index).get(text)!);
  };
  assert.deepEqual(at('(battery Low)'), ['false', 'false', 'true', 'true']);
  assert.deepEqual(at('(and (battery Low) (= takeoff.status failed_inv))'), ['false', 'false', 'false', 'true']);
  assert.deepEqual(at('(| (battery Low) (< level 4))'), ['false', 'true', 'true', 'true']);
  assert.deepEqual(at('(not (/= battery Good))'), ['true', 'true', 'false', 'false']);
  assert.deepEqual(at('(>= (+ level 1) 5)'), ['true', 'false', 'false', 'false']);
  assert.deepEqual(at('(- level 5)'), ['-1', '-2', '-2', '-2']);
  assert.deepEqual(at('battery'), ['Good', 'Good', 'Low', 'Low']);
});

test('a watch is a variable like any other: it changes at steps, which are found by it, and has a lane', () => {
  const text = '(battery Low)';
  const seen = watched(flight, [watchOf(text, flight)]);
  assert.deepEqual(seen.steps[3]!.changes.at(-1), { variable: text, before: 'false', after: 'true' });
  assert.deepEqual(select(seen, { ...everything, variables: new Set([text]) }), [3]);
  assert.deepEqual(lanesOf(seen).find((lane) => lane.name === text)!.bars.map((bar) => bar.label), ['false', 'true']);
  assert.deepEqual(flight.steps[3]!.changes.length, 1, 'the trace itself stays as it is');
  assert.equal(watched(flight, []), flight);
});

test('what is wrong with a watch is said', () => {
  const wrong = (text: string): string => {
    try {
      watchOf(text, flight);
      return 'nothing';
    } catch (error) {
      return (error as Error).message;
    }
  };
  assert.equal(wrong('(batery Low)'), 'there is no variable `batery` in this trace');
  assert.equal(wrong('(or (battery Good) (batery Low))'), 'there is no variable `batery` in this trace');
  assert.equal(wrong('(battery Low'), 'a `)` is missing');
  assert.equal(wrong('battery)'), 'a `(` is missing');
  assert.equal(wrong(''), 'one condition is expected, as `(door Open)`');
  assert.equal(wrong('(battery Low) (battery Low)'), 'one condition is expected, as `(door Open)`');
  assert.equal(wrong('(< battery 3)'), '`battery` is not a number');
  assert.equal(wrong('(not (battery Low) (battery Low))'), '`not` takes one operand');
  assert.equal(wrong('(= battery)'), '`=` takes two operands');
  assert.equal(wrong('(and (battery Low) level)'), '`level` is not a condition');
  assert.equal(wrong('()'), '`()` is not a condition');
  assert.equal(wrong('nobody'), 'there is no variable `nobody` in this trace');
});

test('in a trace that takes the place of another, one goes on at the step that does the same', () => {
  const former = trace({ n: '0' }, ['a: starts @0', 'b: starts @1', 'a: starts @2', 'a: succeeds @3']);
  const longer = trace({ n: '0' }, ['c: occurs @0', ...['a: starts @0', 'b: starts @1', 'a: starts @2', 'a: succeeds @3']]);
  assert.deepEqual([0, 1, 2, 3].map((at) => continuation(former, at, longer)), [1, 2, 3, 4].map((index) => ({ index, same: true })));
  const other = trace({ n: '0' }, ['a: starts @0', 'd: occurs @1']);
  assert.deepEqual(continuation(former, 2, other), { index: 0, same: true }, 'the last of those that do the same');
  assert.deepEqual(continuation(former, 3, other), { index: 1, same: false }, 'else the nearest');
  assert.deepEqual(continuation(former, -1, other), { index: 0, same: false });
});

test('a trace tells the same where only its places are others', () => {
  const lines = ['a: starts @0', 'b: starts @1'];
  const one = trace({ n: '0' }, lines);
  const moved = trace({ n: '0' }, lines);
  moved.steps[0]!.location = { uri: 'file:///p', range: { start: { line: 7, character: 0 }, end: { line: 7, character: 1 } } };
  assert.equal(tellsTheSame(one, moved), true);
  assert.equal(tellsTheSame(one, trace({ n: '0' }, ['a: starts @0', 'c: starts @1'])), false);
});

test('changes of verdicts are found by reference, and give the same list again', () => {
  const named = (name: string, word = 'holds'): Verdict => ({ name, verdict: word }) as Verdict;
  const known = ['a', 'b', 'c'].map((name) => named(name));
  const now = [known[0]!, named('b', 'violated'), known[2]!];
  assert.deepEqual(changesSince(known, now), [now[1]]);
  assert.deepEqual(withChanges(known, [now[1]!]), now);
  assert.equal(withChanges(known, []), known);
  assert.deepEqual(changesSince(known, known), []);
  assert.equal(changesSince(known, now.slice(1)), null);
  assert.equal(changesSince(known, [now[1]!, known[0]!, known[2]!]), null);
  assert.equal(changesSince(undefined, now), null);
});

test('a time of a run is that of the last step that has happened, among those that are shown', () => {
  const times = trace({}, [0, 1, 1, 2.5, 4].map((seconds) => `a: waits @${seconds}`));
  const all = [0, 1, 2, 3, 4];
  assert.deepEqual([-1, 0, 0.5, 1, 2.4, 2.5, 9].map((time) => positionAt(times, all, time)), [0, 0, 0, 2, 2, 3, 4]);
  assert.deepEqual([0.5, 1, 3].map((time) => positionAt(times, [1, 3], time)), [0, 0, 1]);
  assert.equal(positionAt(times, [], 1), -1);
});

test('what went wrong is marked on the bar, and marks that would be in one place are one', () => {
  const remarks = ['fault', 'note', 'violated', 'overshoot'];
  const run = trace({}, [1, 2, 3, 3.001].map((seconds) => `a: has a remark @${seconds}`));
  run.steps = run.steps.map((it, index) => ({ ...it, remark: remarks[index]! }));
  assert.deepEqual(badTimes(run), [1, 3, 3.001]);
  assert.deepEqual(fractions(badTimes(run), { from: 0, to: 4 }, 100), [0.25, 0.75]);
  assert.deepEqual(fractions([2], { from: 2, to: 2 }, 100), [0]);
});

test('times of a run are words that people read', () => {
  assert.deepEqual([0, 12.3456, 99.9, 100, 754.56, 3599.96, 3600, 43261.9].map(clockTime), ['0 s', '12.346 s', '99.9 s', '1:40.0', '12:34.5', '59:59.9', '1:00:00', '12:01:01']);
});
