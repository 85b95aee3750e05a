// A run that the user chooses, beside its program.
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { openFromFile } from '../panel.mjs';

const kFile = 'simulated/lamp.proskill';
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

const steps = (frame) => frame.locator('.row.step').count();

async function take(frame, text) {
  const before = await steps(frame);
  await frame.locator('.choice').filter({ hasText: text }).first().click();
  await expect(`a step more for "${text}"`, async () => (await steps(frame)) === before + 1);
}

export const scenarios = {
  /** Chooses steps in the list and the automaton, undoes them, saves the run as a test, replays it after edits, opens it again. */
  async chosen_run(world) {
    const { editor, root } = world;
    mkdirSync(join(root, 'simulated'), { recursive: true });
    writeFileSync(join(root, kFile), kProgram);
    await editor.closeAll();
    await editor.openFile(kFile);
    await editor.goTo(1);
    await editor.command('ProSkill: Simulate: Choose What Happens Next');
    let frame = await editor.panel('.simulation-view');
    await take(frame, 'starts');
    await take(frame, 'calls light');
    await take(frame, 'starts');
    await take(frame, 'fails with broken');
    await frame.locator('button').filter({ hasText: 'Undo' }).click();
    await expect('three steps', async () => (await steps(frame)) === 3);
    await take(frame, 'succeeds with lit');
    await frame.locator('.ring.offered').first().waitFor();
    await editor.picture('simulation-automaton');
    await frame.locator('g.node.offered, g.edge.offered').first().click();
    await expect('a step by the automaton', async () => (await steps(frame)) === 5);
    while (await frame.locator('.choice').count()) await take(frame, '');
    const all = await steps(frame);
    rmSync(join(root, 'mission.run.json'), { force: true });
    await frame.locator('button').filter({ hasText: 'Save as a test' }).click();
    await expect('the test on the disk', async () => {
      if (await editor.quickInput().count()) await editor.press('Enter');
      return existsSync(join(root, 'mission.run.json'));
    });
    equal('the lamp at the end', JSON.parse(readFileSync(join(root, 'mission.run.json'), 'utf8')).expect.lamp, 'On');
    // After an edit the run is taken again.
    await editor.openFile(kFile);
    await editor.goTo(5, 12);
    await editor.type('er');
    await frame.locator('.notice.stale').filter({ hasText: 'Step 4 of' }).waitFor();
    equal('the steps that are left', await steps(frame), 3);
    await editor.picture('simulation-missing');
    await editor.press('Backspace', 'Backspace');
    await expect('the whole run', async () => (await steps(frame)) === all);
    equal('the caret, which is the user\'s', await editor.caret(), 'Ln 5, Col 12');
    await editor.command('File: Revert File');
    await editor.closeAll();
    // The test in another session.
    await editor.openFile(kFile);
    await openFromFile(world, 'mission.run.json');
    frame = await editor.panel('.simulation-view');
    await frame.locator('.notice.passed').filter({ hasText: 'The test passes' }).waitFor();
    await editor.picture('simulation-passes');
    await editor.closeAll();
  },
};
