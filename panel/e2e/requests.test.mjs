// What the panel of VS Code requests until it shows something; each request delays that.
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

/** A host that answers at once, and notes the requests. */
const host = ({ hello, answers }) => {
  window.requests = [];
  window.acquireVsCodeApi = () => ({ postMessage: ({ type, id, method, params }) => {
    if (type !== 'request') return;
    window.requests.push([method, params.name].filter(Boolean).join(' '));
    setTimeout(() => window.postMessage({ type: 'reply', id, result: method === 'hello' ? hello : answers[method] }));
  } });
};

async function requested(layout, show, shown) {
  const it = await page();
  const hello = { contract: 1, layout, can: { source: false, save: true, open: true, verify: true, simulate: false, follow: false }, program, show };
  await it.goto('about:blank');
  await it.setContent('<div id="panel"></div>');
  await it.evaluate(host, { hello, answers });
  await it.addScriptTag({ content: readFileSync(new URL('../dist/panel.js', import.meta.url), 'utf8') });
  await eventually(async () => assert.ok(await it.locator(shown).count()));
  assert.deepEqual(it.complaints, []);
  return it.evaluate(() => window.requests);
}

test('a trace comes without an automaton', async () => {
  assert.deepEqual(await requested('trace', { trace: 't' }, '.badge.violated'), ['hello', 'trace t']);
});

test('an automaton comes without another before it', async () => {
  assert.deepEqual(await requested('automaton', { picture: { kind: 'sv', name: 'door' } }, '.stage[data-picture="sv door"]'), ['hello', 'picture door']);
});
