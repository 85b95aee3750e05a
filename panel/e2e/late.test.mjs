// Late answers: what the user has done meanwhile counts.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { closeBrowser, eventually, hold, marked, openTrace, page, report, view, workspace } from './browser.mjs';

after(closeBrowser);

describe('answers that come late', () => {
  let files, file, served, traced;
  before(async () => {
    files = workspace();
    file = join(files.path, 'rover/bug.proskill');
    traced = report(file).properties.filter((it) => it.trace);
    served = await view(file);
  });
  after(async () => {
    assert.equal(await served.end(), 0);
    files.remove();
  });

  const click = (it, { name }) => it.locator(`.verdict[data-name="${name}"]`).click();
  const shown = async (it) => it.locator('.trace-head h2').getAttribute('title');

  /** Verifies again, until the page knows the verdicts. */
  const verifyAgain = async (it) => it.evaluate(() => new Promise((done) => {
    const button = document.querySelector('button[title="Verify again"]');
    let begun = false;
    new MutationObserver((changes) => {
      begun ||= changes.some(({ attributeName }) => attributeName === 'disabled');
      if (begun && !button.disabled) done();
    }).observe(button, { attributes: true });
    button.click();
  }));

  test('the trace that was asked for last is the one that is shown', async () => {
    const it = await page();
    await openTrace(it, served.url);
    const [slow, fast] = traced.slice(-2);
    const held = await hold(it, 'trace', ({ name }) => name === slow.name);
    await click(it, slow);
    await held.arrived;
    await click(it, fast);
    await eventually(async () => assert.equal(await shown(it), fast.name));
    const answered = it.waitForResponse((response) => response.url().endsWith('/api/trace'));
    held.release();
    await (await answered).finished();
    await it.evaluate(() => new Promise((done) => setTimeout(done)));
    assert.equal(await shown(it), fast.name);
    assert.equal(await it.locator('.verdict[aria-selected="true"]').getAttribute('data-name'), fast.name);
  });

  test('keys that are pressed after a click step through the trace that was asked for', async () => {
    const it = await page();
    await openTrace(it, served.url);
    const [slow] = traced.slice(-1);
    const held = await hold(it, 'trace', ({ name }) => name === slow.name);
    await click(it, slow);
    await held.arrived;
    const before = await it.locator('.step.current').getAttribute('id');
    for (const key of ['Home', 'ArrowDown']) await it.locator('.steps').press(key);
    assert.equal(await it.locator('.step.current').getAttribute('id'), before);
    held.release();
    await eventually(async () => assert.equal(await shown(it), slow.name));
    await it.locator('#step-1.current').waitFor();
  });

  test('keys step through the trace that is shown if the other one is long in coming', async () => {
    const it = await page();
    await openTrace(it, served.url);
    await it.locator('.steps').press('Home');
    const [slow] = traced.slice(-1);
    const held = await hold(it, 'trace', ({ name }) => name === slow.name);
    await click(it, slow);
    await held.arrived;
    await it.evaluate(() => {
      const now = performance.now.bind(performance);
      performance.now = () => now() + 6000;
    });
    await it.locator('.steps').press('ArrowDown');
    await it.locator('#step-1.current').waitFor();
    held.release();
    await eventually(async () => assert.equal(await shown(it), slow.name));
  });

  test('a verification that ends meanwhile does not undo a click', async () => {
    const it = await page();
    await openTrace(it, served.url);
    await it.locator('.steps').press('Home');
    for (const slow of [traced.at(-1), traced.find(({ name }) => name !== traced.at(-1).name)]) {
      const held = await hold(it, 'trace', ({ name }) => name === slow.name);
      await click(it, slow);
      await held.arrived;
      await verifyAgain(it);
      held.release();
      const step = () => it.locator('.step.current .number').textContent();
      await eventually(async () => assert.deepEqual([await shown(it), await step()], [slow.name, String(slow.trace.steps.length)]));
    }
  });

  test('the first trace does not take the keyboard from the field in which somebody types', async () => {
    const it = await page();
    const held = await hold(it, 'trace');
    await it.goto(served.url);
    await held.arrived;
    await it.locator('.verdicts .search').focus();
    await it.keyboard.type('en');
    held.release();
    await it.locator('.step.current').waitFor();
    await it.keyboard.type('ergy');
    assert.equal(await it.locator('.verdicts .search').inputValue(), 'energy');
  });

  test('the text of the current step is shown, whichever text comes last', async () => {
    const it = await page();
    const found = traced.find(({ trace }) => new Set(trace.steps.map((step) => step.location?.file)).size > 1);
    const { steps } = found.trace;
    const last = steps.findLastIndex((step, at) => at > 0 && step.location && steps[at - 1].location && step.location.file !== steps[at - 1].location.file);
    const { location } = steps[last];
    const earlier = steps[last - 1].location.file;
    await openTrace(it, served.url);
    // The click below opens the trace at its last step, however late.
    await it.locator('.steps').press('Home');
    const step = () => it.locator('.step.current .number').textContent();
    await eventually(async () => assert.equal(await step(), '1'));
    // What is delayed has not been read before: the program is sent again, and texts are read again.
    const held = await hold(it, 'source', ({ uri }) => uri === earlier);
    await it.locator('button[title="Verify again"]').click();
    await click(it, found);
    await eventually(async () => assert.deepEqual([await shown(it), await step()], [found.name, String(steps.length)]));
    await it.locator('.steps').focus();
    await it.keyboard.press('Home');
    for (let i = 0; i < last; ++i) await it.keyboard.press('ArrowDown');
    await held.arrived;
    assert.equal(await step(), String(last + 1));
    held.release();
    await eventually(async () => {
      const now = await marked(it);
      assert.equal(now.file, location.file);
      assert.equal(now.lines[0], location.begin.line);
    });
  });
});
