// Large traces and pictures: prints how long they take to open; asserts no times.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { choosePicture, closeBrowser, eventually, page, shot, view, workspace } from './browser.mjs';

after(closeBrowser);

/** A patrol: twenty skills and ten variables, 10,000 steps. */
function longTrace(count) {
  const seconds = (value) => ({ exact: String(value), seconds: value });
  const moment = (value) => ({ ...seconds(value), strict: false });
  const initial = Object.fromEntries([...Array.from({ length: 10 }, (_, i) => [`v${i}`, '0']), ...Array.from({ length: 20 }, (_, i) => [`s${i}.status`, 'no_status'])]);
  const now = { ...initial };
  const set = (variable, after) => {
    const before = now[variable];
    now[variable] = after;
    return { variable, before, after };
  };
  const steps = Array.from({ length: count }, (_, i) => {
    const actor = `s${(i >> 2) % 20}`;
    const description = ['starts', 'tests `(v0 Good)`: true', 'calls `other`', 'succeeds with `done`'][i % 4];
    const changes = i % 4 === 0 ? [set(`v${i % 10}`, String(i))] : i % 4 === 3 ? [set(`${actor}.status`, i % 80 === 79 ? 'failure' : 'success')] : [];
    const date = i / 4;
    return { actor, description, location: null, date: seconds(date), delay: seconds(0.25), earliest: moment(date), latest: moment(date + 1), changes, transitions: [`t${i}`] };
  });
  return { name: 'patrol', description: 'a long patrol', verdict: 'violated', initial, steps, loop: count - 400 };
}

test('a trace of 10,000 steps', async (context) => {
  const files = workspace();
  const path = join(files.path, 'long.json');
  writeFileSync(path, JSON.stringify(longTrace(10000)));
  const served = await view(join(files.path, 'lift/bug.proskill'));
  const it = await page();
  await it.goto(served.url);
  await it.locator('.trace-head h2').waitFor();
  const [chooser] = await Promise.all([it.waitForEvent('filechooser'), it.locator('.app-head button[title^="Open"]').click()]);
  // From when the page has the file to the frame that shows its last step.
  await it.evaluate(() => {
    const text = Blob.prototype.text;
    Blob.prototype.text = function () {
      globalThis.began = performance.now();
      return text.call(this);
    };
    const look = () => (document.querySelector('#step-9999') ? requestAnimationFrame(() => { globalThis.ended = performance.now(); }) : requestAnimationFrame(look));
    look();
  });
  await chooser.setFiles(path);
  await it.waitForFunction(() => globalThis.ended !== undefined);
  context.diagnostic(`10,000 steps open in ${await it.evaluate(() => Math.round(globalThis.ended - globalThis.began))} ms`);
  assert.ok((await it.locator('.steps .row').count()) < 200, 'only what is in view is drawn');
  assert.ok((await it.locator('.lanes svg *').count()) < 30000);
  assert.equal(await it.locator('.in-loop').count() > 0, true);
  await shot(it, 'long_trace');
  const time = await it.evaluate(async () => {
    const list = document.querySelector('.steps');
    list.focus();
    const began = performance.now();
    for (let i = 0; i < 50; ++i) {
      list.dispatchEvent(new KeyboardEvent('keydown', { key: 'PageUp' }));
      await new Promise((done) => requestAnimationFrame(done));
    }
    return (performance.now() - began) / 50;
  });
  context.diagnostic(`a page of steps in ${time.toFixed(1)} ms`);
  await it.keyboard.press('Home');
  await eventually(async () => assert.equal(await it.locator('.step.current .number').textContent(), '1'));
  assert.deepEqual(it.complaints, []);
  assert.equal(await served.end(), 0);
  files.remove();
});

async function openPicture(context, name, body, check) {
  const files = workspace();
  const path = join(files.path, 'large.proskill');
  writeFileSync(path, `(defsv a :states (x y) :init x)\n(defskill s :action (go) :success ok)\n(defskill m :body (${body}))\n`);
  const served = await view(path, '--time-limit', '1');
  const it = await page();
  await it.goto(served.url);
  await it.locator('#tab-automaton').click();
  await it.locator('.stage g.node').first().waitFor();
  await choosePicture(it, 'calls ');
  await eventually(async () => assert.ok((await it.locator('.stage g.node').count()) < 4));
  const began = Date.now();
  await it.locator('select.pictures').selectOption('body m');
  await it.waitForFunction(() => document.querySelectorAll('.stage g.node').length > 3);
  context.diagnostic(`${name}: the picture is there in ${Date.now() - began} ms`);
  await check(it);
  await shot(it, name);
  assert.deepEqual(it.complaints, []);
  assert.equal(await served.end(), 0);
  files.remove();
}

test('a body of 1,000 steps in a row', (context) =>
  openPicture(context, 'large_row', '(set (a y)) (s) '.repeat(500), async (it) => assert.ok((await it.locator('.stage g.node').count()) > 1000)));

test('a body of 1,000 steps in branches is folded, and says so', (context) =>
  openPicture(context, 'large_branches', `(// ${`(${'(set (a y)) (^ (a x)) '.repeat(25)})`.repeat(20)})`, async (it) => {
    assert.match(await it.locator('.notice').textContent(), /1,?00\d nodes: branches are folded/);
    assert.ok((await it.locator('.stage g.node').count()) < 450);
    const folded = await it.locator('.stage g.role-folded').count();
    await it.locator('.stage g.role-folded').first().dblclick();
    await eventually(async () => assert.equal(await it.locator('.stage g.role-folded').count(), folded - 1));
  }));
