import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { closeBrowser, openTrace, page, proskill, shot, view, workspace } from './browser.mjs';

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
