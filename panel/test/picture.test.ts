import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Location, Picture } from '../src/api.ts';
import { highlight } from '../src/model/highlight.ts';
import { find, neighbour, partAt, skillAt } from '../src/model/picture.ts';

const at = (line: number, from: number, to = from, lastLine = line): Location => ({
  uri: 'm', range: { start: { line, character: from }, end: { line: lastLine, character: to } },
});
const node = (id: string, label: string, location: Location) => ({ id, role: 'call', label, details: [], location, cluster: null });

/** A loop in lines 1 to 4, with its test in line 1 and its calls in lines 2 and 3. */
const picture: Picture = {
  kind: 'body', name: 'm', title: 'm', note: '', content: '', errors: false,
  nodes: [node('n0', '(ready)', at(1, 9, 16)), node('n1', 'takeoff', at(2, 4, 13)), node('n2', 'landing', at(3, 4, 13))],
  edges: [{ id: 'e0', from: 'n1', to: 'n2', role: 'next', label: '', location: null }],
  clusters: [{ id: 'cluster_0', label: 'branch 1', parent: null, location: at(1, 2, 20, 4) }],
};

test('the caret is at the innermost part that holds it', () => {
  assert.equal(partAt(picture, at(2, 6))?.id, 'n1');
  assert.equal(partAt(picture, at(2, 13))?.id, 'n1');
  assert.equal(partAt(picture, at(4, 0))?.id, 'cluster_0');
  assert.equal(partAt(picture, at(9, 0)), null);
  assert.equal(partAt(picture, { ...at(2, 6), uri: 'other' }), null);
});

test('a range that holds nodes leads to the largest of them', () => {
  const flat = { ...picture, clusters: [] };
  assert.equal(partAt(flat, at(0, 0, 99, 2))?.id, 'n0');
});

test('beside its condition, the caret is still at the test of its line', () => {
  assert.equal(partAt({ ...picture, clusters: [] }, at(1, 3))?.id, 'n0');
  assert.equal(partAt({ ...picture, clusters: [] }, at(5, 3)), null);
});

test('calls, the start, and in the picture of the calls all nodes stand for skills', () => {
  const start = { ...node('n3', '', at(0, 0)), role: 'start' };
  assert.equal(skillAt(picture, picture.nodes[1]!), 'takeoff');
  assert.equal(skillAt(picture, start), 'm');
  assert.equal(skillAt(picture, { ...start, cluster: 'cluster_0' }), null, 'a watchdog is not its skill');
  assert.equal(skillAt(picture, { ...node('n4', 'set', at(0, 0)), role: 'step' }), null);
  assert.equal(skillAt({ ...picture, kind: 'calls', name: '' }, { ...node('n0', 'fly', at(0, 0)), role: 'basic' }), 'fly');
});

test('pictures are searched by labels', () => {
  assert.deepEqual(find(picture, 'LAND'), ['n2']);
  assert.deepEqual(find(picture, 'branch'), ['cluster_0']);
  assert.deepEqual(find(picture, ' '), []);
});

test('arrows walk to the nearest node that lies in their direction', () => {
  const box = (x: number, y: number) => ({ x, y, width: 20, height: 10 });
  const boxes = new Map([['a', box(0, 0)], ['b', box(0, 50)], ['c', box(60, 50)], ['d', box(0, 100)]]);
  assert.equal(neighbour(boxes, 'a', 'ArrowDown'), 'b');
  assert.equal(neighbour(boxes, 'b', 'ArrowDown'), 'd');
  assert.equal(neighbour(boxes, 'b', 'ArrowRight'), 'c');
  assert.equal(neighbour(boxes, 'a', 'ArrowUp'), null);
  assert.equal(neighbour(boxes, 'nobody', 'ArrowUp'), null);
});

test('the source is coloured, and nothing of it is lost', () => {
  const text = '(defskill a ; "no"\n  :action (go $x 1.5 "é;\\"") (if (a.status success) else))\r\n';
  const lines = highlight(text);
  assert.equal(lines.map((line) => line.map((token) => token.text).join('')).join('\n'), text.replace('\r', ''));
  const kinds = Object.fromEntries(lines.flat().map((token) => [token.text.trim(), token.kind]));
  assert.deepEqual(
    [kinds['defskill'], kinds['; "no"'], kinds[':action'], kinds['$x'], kinds['1.5'], kinds['"é;\\""'], kinds['else']],
    ['form', 'comment', 'keyword', 'parameter', 'number', 'string', 'form'],
  );
});
