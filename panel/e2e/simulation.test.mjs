// A simulation as a user does it: by the list, the automaton and the keyboard; and its replay after edits.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { closeBrowser, eventually, page, proskill, shot, view } from './browser.mjs';

after(closeBrowser);

const kProgram = `(defsv lamp :states (On Off) :init Off :transitions :all)
(defskill light
  :time_interval [2,5]
  :action (a)
  :success lit (:effects (lamp On))
  :failure broken)
(defskill mission
  :success done
  :failure dark
  :body
    ((light)
     (if (lamp On)
        (success done))
     (failure dark)))
`;

describe('a run that the user chooses', () => {
  let folder, file, served, it;
  const sim = (selector) => it.locator(`.simulation-view ${selector}`);
  const steps = () => sim('.row.step').count();
  const places = () => sim('.choices, .stage').evaluateAll((all) => all.map((part) => JSON.stringify([part.getBoundingClientRect().x, part.getBoundingClientRect().y])));
  const choice = (text) => sim('.choice').filter({ hasText: text });
  const take = async (text) => {
    const before = await steps();
    await choice(text).click();
    await eventually(async () => assert.equal(await steps(), before + 1));
  };
  before(async () => {
    folder = mkdtempSync(join(tmpdir(), 'proskill-simulation-'));
    file = join(folder, 'lamp.proskill');
    writeFileSync(file, kProgram);
    served = await view(file);
    it = await page({ viewport: { width: 1440, height: 860 } });
    await it.goto(served.url);
    await it.locator('#tab-simulation').click();
    await choice('starts').first().waitFor();
  });
  after(async () => {
    assert.deepEqual(it.complaints, []);
    assert.equal(await served.end(), 0);
    rmSync(folder, { recursive: true, force: true });
  });

  test('a choice of the list is taken, and taken back', async () => {
    await take('starts');
    await take('calls light');
    await take('starts');
    assert.equal(await choice('succeeds with lit').count(), 1);
    assert.match(await choice('fails with broken').textContent(), /\[2, 5\] s/);
    await shot(it, 'simulation_list');
    await take('fails with broken');
    await sim('button').filter({ hasText: 'Undo' }).click();
    await eventually(async () => assert.equal(await steps(), 3));
    await it.keyboard.press('Backspace');
    await eventually(async () => assert.equal(await steps(), 2));
    await take('starts');
  });

  test('a step comes as late as it may', async () => {
    await choice('succeeds with lit').locator('.late').click();
    await eventually(async () => assert.equal(await steps(), 4));
    assert.match(await sim('.row.step').last().textContent(), /5/);
    await it.keyboard.press('Backspace');
    await eventually(async () => assert.equal(await steps(), 3));
  });

  test('a part of the automaton that stands for a choice is framed, and a click on it takes the choice', async () => {
    await take('succeeds with lit');
    await sim('.ring.offered').first().waitFor();
    const before = await steps();
    await sim('g.node.offered, g.edge.offered').first().click();
    await eventually(async () => assert.equal(await steps(), before + 1));
    await shot(it, 'simulation_automaton');
  });

  test('to the end, saved as a test, and replayed by the command line', async () => {
    while (await sim('.choice').count()) {
      const before = await steps();
      await sim('.choice').first().click();
      await eventually(async () => assert.equal(await steps(), before + 1));
    }
    await sim('.choice-list .nothing').waitFor();
    const [download] = await Promise.all([it.waitForEvent('download'), sim('button').filter({ hasText: 'Save as a test' }).click()]);
    assert.equal(download.suggestedFilename(), 'mission.run.json');
    const saved = join(folder, 'mission.run.json');
    await download.saveAs(saved);
    const run = JSON.parse(readFileSync(saved, 'utf8'));
    assert.equal(run.expect.lamp, 'On');
    assert.equal(run.expect['mission.status'], 'success');
    assert.match(execFileSync(proskill, ['replay', file, saved], { encoding: 'utf8' }), /^passed /);
  });

  test('after an edit the run is taken again: the step that is missing is named, and the run is whole when the text is', async () => {
    const all = await steps();
    const before = await places();
    writeFileSync(file, kProgram.replace(':success lit', ':success shines'));
    await sim('.notice.stale').filter({ hasText: 'Step 4 of' }).waitFor();
    assert.deepEqual(await places(), before, 'no part has moved');
    assert.match(await it.locator('.simulation-view > .foot .notice').textContent(), /is not possible any more.*light.*succeeds with lit; now light/);
    assert.equal(await steps(), 3);
    await shot(it, 'simulation_missing');
    writeFileSync(file, `; a line above\n${kProgram}`);
    await eventually(async () => assert.equal(await steps(), all));
    assert.equal(await it.locator('.simulation-view > .foot .notice:visible').count(), 0);
  });

  test('a text with errors leaves the run as it was', async () => {
    const all = await steps();
    writeFileSync(file, kProgram.replace('(lamp On))', '(lamp Nowhere))'));
    await sim('.notice.stale').filter({ hasText: 'the program has errors' }).waitFor();
    assert.equal(await steps(), all);
    writeFileSync(file, kProgram);
    await eventually(async () => assert.equal(await sim('.notice.stale:visible').count(), 0));
  });

  test('a test is opened, passes, and fails where the value is another one', async () => {
    const open = async (run) => {
      const path = join(folder, 'opened.run.json');
      writeFileSync(path, JSON.stringify(run));
      const [chooser] = await Promise.all([it.waitForEvent('filechooser'), sim('button').filter({ hasText: 'Open a run' }).click()]);
      await chooser.setFiles(path);
    };
    const run = JSON.parse(readFileSync(join(folder, 'mission.run.json'), 'utf8'));
    await open(run);
    await sim('.notice.passed').filter({ hasText: 'The test passes' }).waitFor();
    await shot(it, 'simulation_passes');
    await open({ ...run, expect: { lamp: 'Off' } });
    await sim('.notice.stale').filter({ hasText: 'lamp is On, expected Off' }).waitFor();
  });

  test('by keys alone, and in a narrow window', async () => {
    await sim('button').filter({ hasText: 'Start' }).first().click();
    await eventually(async () => assert.equal(await steps(), 0));
    await it.keyboard.press('1');
    await eventually(async () => assert.equal(await steps(), 1));
    await it.keyboard.press('Enter');
    await eventually(async () => assert.equal(await steps(), 2));
    await it.setViewportSize({ width: 760, height: 860 });
    await shot(it, 'simulation_narrow');
  });
});
