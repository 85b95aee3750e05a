// The program changes under an open trace: nothing moves unless the user moves it.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { closeBrowser, eventually, marked, openTrace, page, report, shot, view, workspace } from './browser.mjs';

after(closeBrowser);

describe('a program that is edited while its trace is open', () => {
  let files, file, building, served, it, steps;
  const name = 'doors_closed_when_moving';
  const step = async () => Number(await it.locator('.step.current .number').textContent());
  const scrolls = () => it.evaluate(() => ['.source-text', '.steps'].map((place) => document.querySelector(place).scrollTop));
  const edit = (path, change) => {
    const text = readFileSync(path, 'utf8');
    assert.notEqual(change(text), text);
    writeFileSync(path, change(text));
  };
  /** Resolves when the page has the program in this state; call it before writing the text. */
  const news = (state) => it.waitForResponse(async (response) => response.url().endsWith('/api/news')
    && (await response.json()).result.news.some(({ method, params }) => method === 'program' && params.state === state));
  const verified = () => news('done');
  /** Marks the rows of verdicts; `newRows` are those drawn since. */
  const markRows = () => it.evaluate(() => document.querySelectorAll('.verdict').forEach((row) => { row.isMarked = true; }));
  const newRows = () => it.evaluate(() => [...document.querySelectorAll('.verdict')].filter((row) => !row.isMarked).map((row) => row.dataset.name));
  before(async () => {
    files = workspace();
    [file, building] = ['bug', 'building'].map((it) => join(files.path, `lift/${it}.proskill`));
    ({ steps } = report(file).properties.find((found) => found.name === name).trace);
    served = await view(file);
    it = await page({ viewport: { width: 1440, height: 560 } });
    await openTrace(it, served.url);
    for (let i = 0; i < 4; ++i) await it.keyboard.press('ArrowUp');
    await eventually(async () => assert.equal(await step(), steps.length - 4));
  });
  after(async () => {
    assert.equal(await served.end(), 0);
    files.remove();
  });

  test('lines come in above: the step, what is in view and the keyboard stay; the mark goes with its text', async () => {
    const { location } = steps.at(-5);
    await it.locator('.source-text').evaluate((it) => { it.scrollTop = 137; });
    await it.locator('.steps').evaluate((it) => { it.scrollTop += 9; });
    const search = it.locator('.verdicts .search');
    await search.fill('door');
    const before = await scrolls();
    await markRows();
    const done = verified();
    edit(location.file, (text) => `\n\n\n${text}`);
    await done;
    await eventually(async () => assert.equal(await it.locator('.step.current .place').textContent(),
      `${location.file.split('/').at(-1)}:${location.begin.line + 3}`));
    assert.equal(await step(), steps.length - 4);
    assert.deepEqual(await scrolls(), before);
    assert.equal(await search.evaluate((it) => document.activeElement === it), true);
    assert.equal(await it.locator('.renewed').textContent(), '');
    assert.deepEqual(await newRows(), [], 'the list of verdicts is as it was');
    await it.locator('.step.current').click();
    await eventually(async () => assert.equal((await marked(it)).lines[0], location.begin.line + 3));
    await search.fill('');
  });

  test('the text has errors: the mark stays with its text', async () => {
    const { location } = steps.at(-5);
    const text = readFileSync(location.file, 'utf8');
    const broken = news('errors');
    writeFileSync(location.file, `; one\n(defskill half\n${text}`);
    await broken;
    await eventually(async () => assert.equal((await marked(it)).lines[0], location.begin.line + 5));
    const before = await step();
    await it.locator('.steps').press('ArrowDown');
    await it.locator('.steps').press('ArrowUp');
    await eventually(async () => assert.deepEqual([await step(), (await marked(it)).lines[0]], [before, location.begin.line + 5]));
    const done = verified();
    writeFileSync(location.file, text);
    await done;
    await eventually(async () => assert.equal((await marked(it)).lines[0], location.begin.line + 3));
  });

  test('the trace is another one: the step that does the same is shown, and it says so', async () => {
    const was = await it.locator('.step.current .words').textContent();
    const before = await scrolls();
    const done = verified();
    edit(building, (text) => text.replaceAll('go_up', 'rise'));
    await done;
    await it.locator('.renewed', { hasText: 'verified again: the same step' }).waitFor();
    assert.equal(await it.locator('.step.current .words').textContent(), was);
    assert.equal((await scrolls())[0], before[0]);
    await shot(it, 'lift_renewed');
  });

  test('the bug is repaired: the verdict takes the place of the trace', async () => {
    await markRows();
    const done = verified();
    edit(file, (text) => text.replace('(open_doors)', '(^ (cabin Idle) :effects (cabin Doors))\n        (open_doors)\n        (set (cabin Idle))'));
    await done;
    await it.locator('.trace-view .badge.holds:visible').waitFor();
    assert.equal(await it.locator('.step:visible').count(), 0);
    await eventually(async () => assert.deepEqual((await marked(it)).lines, []));
    await it.locator(`.verdict.good[data-name="${name}"]`).waitFor();
    assert.ok((await newRows()).includes(name));
    assert.ok((await newRows()).length < (await it.locator('.verdict').count()));
    await shot(it, 'lift_repaired');
  });

  test('the bug is back, and so is the step', async () => {
    const done = verified();
    edit(file, (text) => text.replace(/\(\^ [^\n]*\n\s*\(open_doors\)\n[^\n]*Idle\)\)/, '(open_doors)'));
    await done;
    await it.locator('.step.current:visible').waitFor();
    assert.equal(await step(), steps.length - 4);
  });

  test('it is violated from the start: there is no step, and all values are shown', async () => {
    const done = verified();
    edit(building, (text) => text.replace(`(defproperty ${name}`, `(defproperty ${name} (always (cabin Doors)))\n(defproperty as_before`));
    await done;
    await it.locator('.renewed', { hasText: `step ${steps.length - 4} is gone, there are no steps` }).waitFor();
    assert.equal(await it.locator('.steps-frame').textContent(), 'There are no steps: it is so from the start.');
    assert.ok((await it.locator('.values tbody tr', { hasText: /^cabin/ }).count()) > 0);
    await shot(it, 'lift_from_the_start');
    assert.deepEqual(it.complaints, []);
  });
});
