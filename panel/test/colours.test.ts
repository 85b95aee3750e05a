import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { ActorColours, hues } from '../src/model/colours.ts';
import { trace } from './traces.ts';

test('actors of a trace have colours of their own, as long as there are enough', () => {
  const names = Array.from({ length: hues }, (_, i) => `skill_${i}`);
  const found = new ActorColours().of(trace({ n: '0' }, names.map((name) => `${name}: starts @0`)));
  assert.equal(new Set(found.values()).size, hues);
  const fewer = new ActorColours().of(trace({ n: '0' }, ['skill_0: starts @0']));
  assert.equal(fewer.get('skill_0'), found.get('skill_0'), 'the first one has the colour that it has alone');
});

test('a skill has the colour of its program in every trace and in the automata', () => {
  const colours = new ActorColours();
  const names = ['patrol', 'charge', 'go', 'look'];
  colours.setProgram({ pictures: names.map((name) => ({ kind: 'skill', name, title: name })) });
  const [one, other] = [['go: starts @0', 'gust: occurs @1'], ['alarm: occurs @0', 'look: starts @0', 'go: starts @1']].map((lines) => colours.of(trace({ n: '0' }, lines)));
  assert.equal(one!.get('go'), colours.ofSkill('go'));
  assert.equal(other!.get('go'), colours.ofSkill('go'));
  assert.equal(other!.get('look'), colours.ofSkill('look'));
  assert.equal(new Set(names.map((name) => colours.ofSkill(name))).size, names.length);
  assert.equal(new Set(other!.values()).size, 3, 'other actors get other colours');
  colours.setProgram({ pictures: [] });
  assert.equal(colours.ofSkill('go'), one!.get('go'), 'a text with errors changes none');
});

test('possible steps change no colour of the steps before', () => {
  const taken = trace({ n: '0' }, ['b: occurs @0', 'd: occurs @1']);
  const [before, after] = [new ActorColours().of(taken), new ActorColours().of(taken, trace({ n: '0' }, ['a: occurs @2', 'c: occurs @2']).steps)];
  for (const [name, at] of before) assert.equal(after.get(name), at);
  assert.equal(new Set(after.values()).size, 4);
});

/** A colour as seen without one kind of cones, in linear light (Machado, Oliveira and Fernandes, 2009). */
const sights = {
  all: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
};

/** CIE L*a*b* of a colour as it is seen. */
function lab(colour: string, sight: number[][]): number[] {
  const linear = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  const [r, g, b] = sight.map((row) => Math.min(Math.max(row.reduce((sum, k, i) => sum + k * linear[i]!, 0), 0), 1)) as [number, number, number];
  const f = (t: number): number => (t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116);
  const [x, y, z] = [f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505), f(0.2126 * r + 0.7152 * g + 0.0722 * b), f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089)];
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

test('the colours of actors can be told apart, by the colour-blind too', () => {
  const css = readFileSync(new URL('../../src/style/base.css', import.meta.url), 'utf8');
  const all = [...css.matchAll(/--hue-\d: (#[0-9a-f]{6})/g)].map((found) => found[1]!);
  assert.equal(all.length, 2 * hues);
  for (const palette of [all.slice(0, hues), all.slice(hues)])
    for (const [name, sight] of Object.entries(sights))
      palette.forEach((one, at) => palette.slice(at + 1).forEach((other) => {
        const [left, right] = [lab(one, sight), lab(other, sight)];
        const distance = Math.hypot(...left.map((value, i) => value - right[i]!));
        assert.ok(distance > 18, `${one} and ${other} with ${name}: ${distance.toFixed(1)}`);
      }));
});
