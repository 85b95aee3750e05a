// "Run Mission": a run beside its program.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';

const kFile = 'mission/flight.proskill';
const kProgram = `(defsv battery :states (Good Critical) :init Good :transitions :all)
(defsv flights :min 0 :max 9 :init 0)
(defevent battery_fails :effects (battery Critical))
(defskill fly
  :time_interval [0,...[
  :action (fly)
  :interrupt ()
  :success there
  :failure lost)
(defskill mission
  :success done
  :failure empty
  :body
    ((set ((flights 1)))
     (printf "flight %d begins" flights)
     (// ((fly)) ((^ (battery Critical)) (fly.interrupt)))
     (failure empty)))
(defproperty stays_good (always (battery Good)))
(defproperty takes_off (present (running fly)))
`;
/** A flight ends by an interrupt only. */
const kPlatform = { kind: 'simulated', events: { battery_fails: null }, interrupts: {}, actions: { fly: { duration: [900, 900], stops: [0, 0] } } };

export const scenarios = {
  /** The run of a program with its platform: lines shine, messages are shown at their `printf`, an event is sent by a click; caret and focus stay. */
  async mission({ editor, page, root }) {
    mkdirSync(join(root, 'mission'), { recursive: true });
    writeFileSync(join(root, kFile), kProgram);
    writeFileSync(join(root, 'mission/platform.json'), JSON.stringify(kPlatform));
    writeFileSync(join(root, '.vscode/settings.json'), JSON.stringify({ 'proskill.run.platform': 'mission/platform.json' }));
    await editor.closeAll();
    await editor.openFile(kFile);
    await editor.goTo(4, 3);
    await editor.command('ProSkill: Run Mission');
    const frame = await editor.panel('.run-bar');
    await frame.locator('.run-bar[data-state="running"]').waitFor();
    await frame.locator('.property[data-property="takes_off"][data-verdict="true"]').waitFor();
    await expect('the message at its line, with its value', async () => (await editor.inlineValues('flight.proskill')).some((it) => it.includes('flight 1 begins')));
    await expect('lines that shine', async () => (await frame.locator('.stage g.active').count()) > 0);
    equal('the caret during the run', await editor.caret(), 'Ln 4, Col 3');
    await editor.picture('mission-flies');
    await frame.locator('.run-bar button', { hasText: 'Pause' }).click();
    await frame.locator('.run-bar[data-state="paused"]').waitFor();
    await frame.locator('.signal[data-signal="battery_fails"]').click();
    await frame.locator('.run-waiting', { hasText: '1 signal waits' }).waitFor();
    await frame.locator('.run-bar button', { hasText: 'Continue' }).click();
    await frame.locator('.run-bar[data-state="ended"]').waitFor();
    await frame.locator('.property[data-property="stays_good"][data-verdict="false"]').waitFor();
    await page.locator('.tab').filter({ hasText: 'flight.proskill' }).first().click(); // the clicks were in the panel
    equal('the caret at the end', await editor.caret(), 'Ln 4, Col 3');
    await editor.picture('mission-ended');
    const notice = page.locator('.notification-toast', { hasText: 'the mission has ended, failure' });
    await notice.locator('.monaco-button', { hasText: 'Open as a Trace' }).click();
    const trace = await editor.panel('.layout-trace .trace-view');
    await expect('the recording as a trace', async () => (await trace.locator('.row.step').count()) > 5);
    await trace.locator('.seek-slider').focus();
    await editor.press('End');
    await expect('the last step', async () => /step (\d+) of \1$/.test(await trace.locator('.seek-slider').getAttribute('aria-valuetext')));
    await editor.press('ArrowLeft');
    await expect('a step back', async () => {
      const [, step, all] = /(\d+) of (\d+)/.exec(await trace.locator('.count').textContent());
      return Number(step) === Number(all) - 1;
    });
    await expect('the text of a step', async () => (await editor.markedLines('flight.proskill')).length > 0);
    await editor.picture('mission-recording');
    await editor.closeAll();
    writeFileSync(join(root, '.vscode/settings.json'), '{}');
  },
};
