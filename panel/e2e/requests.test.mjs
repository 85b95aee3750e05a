// What the panel of VS Code requests until it shows something, since each request delays that; what it does with keys meanwhile, and with changes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { closeBrowser, eventually, page } from './browser.mjs';

after(closeBrowser);

const program = {
  program: 'file:///p', label: 'p', main: 'm', state: 'done', stale: false, message: '', progress: null, verdicts: [], exploration: null, files: [],
  pictures: [['body', 'm'], ['sv', 'door'], ['calls', '']].map(([kind, name]) => ({ kind, name, title: name })),
};
const answers = {
  trace: { name: 't', description: 't', verdict: 'violated', initial: {}, steps: [] },
  picture: { kind: 'sv', name: 'door', title: 'door', note: '', content: '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"/>', errors: false, nodes: [], edges: [], clusters: [], pictures: [] },
};

/** A host that notes the requests, and answers at once, but those of the method `held` when `release` is called, and after `hold` again. Counts the elements made of a class. */
const host = ({ hello, answers, held }) => {
  window.requests = [];
  window.made = {};
  const { setAttribute } = Element.prototype;
  Element.prototype.setAttribute = function (name, value) {
    if (name === 'class') for (const it of String(value).split(' ')) window.made[it] = (window.made[it] ?? 0) + 1;
    return setAttribute.call(this, name, value);
  };
  let released;
  window.hold = () => { released = new Promise((done) => { window.release = done; }); };
  window.hold();
  window.acquireVsCodeApi = () => ({ postMessage: async ({ type, id, method, params }) => {
    if (type !== 'request') return;
    window.requests.push([method, params.name].filter(Boolean).join(' '));
    if (method === held) await released;
    setTimeout(() => window.postMessage({ type: 'reply', id, result: method === 'hello' ? hello : answers[method] }));
  } });
};

async function opened(layout, more, held) {
  const it = await page();
  const hello = { contract: 1, layout, can: { source: false, save: true, open: true, verify: true, simulate: false, follow: false }, program, ...more };
  await it.goto('about:blank');
  await it.setContent('<div id="panel"></div>');
  await it.evaluate(host, { hello, answers, held });
  await it.addScriptTag({ content: readFileSync(new URL('../dist/panel.js', import.meta.url), 'utf8') });
  return it;
}

async function requested(layout, show, shown) {
  const it = await opened(layout, { show });
  await eventually(async () => assert.ok(await it.locator(shown).count()));
  assert.deepEqual(it.complaints, []);
  return it.evaluate(() => window.requests);
}

const moment = { exact: '0', seconds: 0, strict: false };
const steps = Array.from({ length: 5 }, (_, i) => ({
  actor: 'm', description: `does ${i}`, location: null, date: moment, delay: moment, earliest: moment, latest: moment, changes: [], transitions: [] }));
const verdict = (name, more = {}) => ({
  name, kind: 'property', subject: 'm', description: name, verdict: 'violated', good: false, severity: 'error', location: null, reason: '', steps: 5, ...more });

test('a trace comes without an automaton', async () => {
  assert.deepEqual(await requested('trace', { trace: 't' }, '.badge.violated'), ['hello', 'trace t']);
});

test('an automaton comes without another before it', async () => {
  assert.deepEqual(await requested('automaton', { picture: { kind: 'sv', name: 'door' } }, '.stage[data-picture="sv door"]'), ['hello', 'picture door']);
});

for (const held of ['hello', 'trace'])
  test(`keys that are pressed before the answer to "${held}" step through the trace when it is there`, async () => {
    answers.trace.steps = steps;
    const it = await opened('trace', { show: { trace: 't', step: 0 } }, held);
    await it.waitForFunction((name) => window.requests.some((it) => it.startsWith(name)), held);
    await it.evaluate(() => {
      window.left = [];
      addEventListener('keydown', ({ key }) => { window.left.push(key); }); // as VS Code does
    });
    for (const key of ['ArrowDown', 'ArrowDown', 'ArrowUp', 'ArrowDown']) await it.keyboard.press(key);
    await it.evaluate(() => window.release());
    await it.locator('#step-2.current').waitFor();
    await it.keyboard.press('ArrowDown');
    await it.locator('#step-3.current').waitFor();
    assert.equal(await it.evaluate(() => window.left.length), 5, 'VS Code gets each key once');
    assert.deepEqual(it.complaints, []);
  });

test('a trace alone makes no list of verdicts, and compares with those that have changed', async () => {
  const verdicts = ['p', 'q', 'r'].map((name) => verdict(name, { steps: name === 'r' ? null : 5 }));
  const it = await opened('trace', { show: { trace: 't', step: 0 }, program: { ...program, verdicts } });
  await it.locator('.badge.violated').waitFor();
  const compared = async () => {
    await it.locator('button[title^="Compare"]').click();
    const found = await it.locator('.menu-list:visible .menu-item').allTextContents();
    await it.keyboard.press('Escape');
    return found.map((words) => words.replace(/^\W+/, '').trim());
  };
  const before = await compared();
  const { verdicts: _, ...rest } = { ...program, verdicts };
  await it.evaluate((params) => window.postMessage({ type: 'news', method: 'program', params }), { ...rest, changed: [verdict('r', { description: 'r, changed' })] });
  await eventually(async () => assert.equal((await compared()).length, before.length + 1));
  assert.equal(await it.evaluate(() => window.made.verdict ?? 0), 0);
  assert.deepEqual(it.complaints, []);
});

test('a trace that comes after the text has changed again is for an older text', async () => {
  answers.trace.steps = steps;
  const it = await opened('trace', { show: { trace: 't', step: 0 }, program: { ...program, verdicts: [verdict('t')] } }, 'trace');
  const news = (more) => it.evaluate((params) => window.postMessage({ type: 'news', method: 'program', params }), { ...program, ...more });
  await it.evaluate(() => window.release());
  await it.locator('#step-0.current').waitFor();
  await it.evaluate(() => window.hold());
  const verdicts = [verdict('t', { description: 'again' })];
  await news({ verdicts });
  await it.waitForFunction(() => window.requests.filter((name) => name === 'trace t').length === 2);
  await news({ verdicts, state: 'errors', stale: true });
  await it.locator('.trace-body.stale').waitFor();
  await it.evaluate(() => window.release());
  await it.evaluate(() => new Promise((done) => setTimeout(done, 100)));
  assert.equal(await it.locator('.trace-body.stale').count(), 1);
  assert.deepEqual(it.complaints, []);
});

test('news that come while somebody types into a field do not move the keyboard', async () => {
  answers.trace.steps = steps;
  const verdicts = [verdict('t')];
  const it = await opened('all', { program: { ...program, verdicts } }, 'trace');
  await it.waitForFunction(() => window.requests.includes('trace t'));
  await it.locator('.verdicts .search').focus();
  await it.keyboard.type('en');
  await it.evaluate((params) => window.postMessage({ type: 'news', method: 'program', params }), { ...program, verdicts });
  await it.waitForFunction(() => window.requests.filter((name) => name === 'trace t').length === 2);
  await it.evaluate(() => window.release());
  await it.locator('.step.current').waitFor();
  await it.keyboard.type('ergy');
  assert.equal(await it.locator('.verdicts .search').inputValue(), 'energy');
});
