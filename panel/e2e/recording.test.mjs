import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { closeBrowser, eventually, openTrace, page, proskill, shot, view, workspace } from './browser.mjs';

after(closeBrowser);

/** Records a run of the drone and opens it; no click is needed. */
async function recorded(name, actions) {
  const files = workspace();
  const [script, recording] = ['script.json', `${name}.json`].map((file) => join(files.path, file));
  writeFileSync(script, JSON.stringify({ actions, signals: [] }));
  const done = spawnSync(proskill, ['run', '--until', '30', '--script', script, '--record', recording, join(files.path, 'drone/drone.proskill')]);
  assert.notEqual(done.status, 2, String(done.stderr));
  const served = await view(recording);
  const it = await page();
  await openTrace(it, served.url);
  await shot(it, name);
  const seen = {
    badge: await it.locator('.trace-head .badge').textContent(),
    isGood: await it.locator('.verdict.good').count() === 1,
    texts: await it.locator('.step .words').allTextContents(),
    complaints: [...it.complaints], // errors of the page; the end of the server is not one
  };
  assert.equal(await served.end(), 0);
  files.remove();
  return seen;
}

test('a recorded run opens by itself, and is good where all went as the program says', async () => {
  const { badge, isGood, complaints } = await recorded('recording', {});
  assert.deepEqual([badge, isGood, complaints], ['recorded', true, []]);
});

test('a recorded run in which something went wrong is marked, and says what at its step', async () => {
  const { badge, isGood, texts } = await recorded('recording_of_fault', { start_drone: [{ result: 'ready', after: 0.5 }] });
  assert.deepEqual([badge, isGood], ['recorded', false]);
  assert.ok(texts.some((text) => text.includes('undershoot: took less time than its interval says')), texts.join('\n'));
});

const slider = (it) => it.locator('.seek-slider');
const valueText = (it) => slider(it).getAttribute('aria-valuetext');
const current = async (it) => Number(await it.locator('.step.current .number').textContent());
const press = (it, ...keys) => keys.reduce((before, key) => before.then(() => it.keyboard.press(key)), Promise.resolve());

/** Clicks on the bar, at a fraction of the time. */
async function clickAt(it, fraction) {
  const { x, y, width, height } = await slider(it).boundingBox();
  await it.mouse.click(x + 6 + (width - 12) * fraction, y + height / 2);
}

test('the bar goes through the time of a run, by keys and by the mouse, among the steps that are shown', async () => {
  const files = workspace();
  const [script, recording] = ['script.json', 'fault.json'].map((file) => join(files.path, file));
  writeFileSync(script, JSON.stringify({ actions: { start_drone: [{ result: 'ready', after: 0.5 }] }, signals: [] }));
  spawnSync(proskill, ['run', '--until', '30', '--script', script, '--record', recording, join(files.path, 'drone/drone.proskill')], { stdio: 'ignore' });
  const { steps } = JSON.parse(readFileSync(recording, 'utf8'));
  const dates = steps.map(({ date }) => date.seconds);
  const served = await view(recording);
  const it = await page();
  await openTrace(it, served.url);
  await slider(it).focus();
  await press(it, 'Home');
  await eventually(async () => assert.equal(await current(it), 1));
  await press(it, 'ArrowRight', 'ArrowRight');
  await eventually(async () => assert.equal(await current(it), 3));
  await press(it, 'ArrowLeft');
  await eventually(async () => assert.equal(await current(it), 2));
  await press(it, 'End');
  await eventually(async () => assert.equal(await current(it), steps.length));
  assert.match(await valueText(it), new RegExp(`, step ${steps.length} of ${steps.length}$`));
  await clickAt(it, 0.5);
  await eventually(async () => {
    const step = await current(it) - 1;
    assert.ok(dates[step] < dates.at(-1) * 0.51 && dates[step + 1] > dates.at(-1) * 0.49, `step ${step + 1} of ${dates}`);
  });
  assert.equal(await it.locator('.seek-bad').count(), 1); // the undershoot
  await shot(it, 'seek_bar');
  await it.locator('.values .name', { hasText: /^flight_status$/ }).click();
  await slider(it).focus();
  await press(it, 'Home');
  const changing = steps.findIndex(({ changes }) => changes?.some(({ variable }) => variable === 'flight_status'));
  await eventually(async () => assert.equal(await current(it), changing + 1));
  assert.deepEqual(it.complaints, []);
  assert.equal(await served.end(), 0);
  files.remove();
});

test('the bar of a long recording spans all of it: other parts are read when somebody goes there', async (context) => {
  const files = workspace();
  const [program, recording] = ['endless.proskill', 'long.mcap'].map((file) => join(files.path, file));
  writeFileSync(program, '(defskill m :body ((while true (^ 1))))');
  spawnSync(proskill, ['run', '--until', '24h', '--record', recording, program], { stdio: 'ignore' });
  const served = await view(recording);
  const it = await page();
  const began = Date.now();
  await openTrace(it, served.url);
  context.diagnostic(`${statSync(recording).size >> 20} MiB open in ${Date.now() - began} ms`);
  const end = 24 * 3600;
  const head = () => it.locator('.trace-head').textContent();
  const dateOfStep = async () => Number((await it.locator('.step.current .date').getAttribute('title')).match(/at ([\d.]+) s/)[1]);
  assert.match(await valueText(it), /of 24:00:00/);
  await slider(it).focus();
  await press(it, 'Home');
  await eventually(async () => assert.match(await head(), /: 0 to /));
  assert.doesNotMatch(await it.locator('.verdict').textContent(), / to /); // it is about the whole run
  await eventually(async () => assert.ok(await dateOfStep() === 0));
  const asked = Date.now();
  await clickAt(it, 0.5);
  await eventually(async () => assert.ok(Math.abs(await dateOfStep() - end / 2) < end / 100));
  context.diagnostic(`another part after ${Date.now() - asked} ms`);
  await shot(it, 'seek_bar_part');
  await press(it, 'PageUp');
  await eventually(async () => assert.ok(Math.abs(await dateOfStep() - end * 0.55) < end / 100));
  await press(it, 'End');
  await eventually(async () => assert.ok(end - await dateOfStep() < 2));
  assert.deepEqual(it.complaints, []);
  assert.equal(await served.end(), 0);
  files.remove();
});
