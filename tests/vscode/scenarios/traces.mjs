// What can be done with traces: from a lens, filtered, pinned, compared, saved, opened again.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { choose, openFromFile, saved } from '../panel.mjs';
import { failing, verified } from './verification.mjs';

const kDrone = 'drone/drone.proskill';
/** Waits in one long line, far below the skill's name. */
const kWide = `(defskill wide :body\n${'; not in view\n'.repeat(101)}  (${'(^ 1) '.repeat(60)}))\n`;
const kEndless = '(defskill m :body ((while true (^ 1))))';
/** A lens above the mission, which has ten bad properties. */
const lens = (page, text) => page.locator('.codelens-decoration', { hasText: '2 bad, 8 warnings' }).locator('a', { hasText: text });
const steps = (frame) => frame.locator('.step');
const count = (frame) => frame.locator('.count').textContent();

/** Clicks a lens until its panel is there: a click has no effect while the lenses are drawn again. */
const openBy = (editor, lenses, view) => expect(`${view}, opened by a lens`, async () => {
  await lenses.first().click({ timeout: 5000 });
  return editor.panel(view, 5000);
});

export const scenarios = {
  /** The lenses of the mission: verify it, open a trace of it, show its body. */
  async lenses({ editor, page }) {
    await editor.openFile(kDrone);
    await editor.goTo(161);
    await lens(page, 'verify').first().click();
    await page.locator('.notification-toast', { hasText: /ProSkill: 2 bad, 8 warnings, of 31\. uav_mission .*: violated/ }).first().waitFor();
    await editor.picture('lenses-verified');
    await editor.command('Notifications: Clear All Notifications');
    let frame = await openBy(editor, lens(page, /^✗ 2 bad/), '.trace-view');
    await frame.locator('.trace-head .badge.violated').waitFor();
    await editor.closeAll();
    await editor.openFile(kDrone);
    await editor.goTo(161);
    frame = await openBy(editor, lens(page, 'show automaton'), '.automaton-view');
    await frame.locator('.ring.selected').waitFor();
    equal('the picture', await frame.locator('select.pictures').inputValue(), 'body uav_mission');
    await editor.closeAll();
  },

  /** A step far to the right in a line that is not in view: the line is shown from its beginning. */
  async beginning({ editor, page, root }) {
    await editor.closeAll();
    writeFileSync(join(root, 'lift/wide.proskill'), kWide);
    await editor.openFile('lift/wide.proskill');
    await editor.statusSays(/\d+ of \d+ good/, 60_000);
    const frame = await editor.openTrace('wide.can_succeed');
    await frame.locator('.steps').press('End');
    await frame.locator('#step-61.current').waitFor();
    await frame.locator('.steps').press('ArrowUp');
    await frame.locator('#step-60.current').waitFor();
    const code = page.locator('.monaco-editor[data-uri$="wide.proskill"]');
    await code.locator('.line-numbers', { hasText: '103' }).waitFor();
    await expect('the mark of the step', async () => (await editor.markedLines('wide.proskill'))[0] === 103);
    equal('columns that are scrolled away', await code.evaluate((it) =>
      Math.round(it.querySelector('.editor-scrollable').getBoundingClientRect().left - it.querySelector('.lines-content').getBoundingClientRect().left)), 0);
    await editor.picture('beginning-shown');
    await editor.closeAll();
    rmSync(join(root, 'lift/wide.proskill'));
  },

  /** Filters by actor and by changes, pins a variable, searches, compares with another trace. */
  async filters({ editor, page, proskill, root }) {
    await editor.openFile(kDrone);
    await editor.statusSays(/\d+ bad, \d+ warnings?/);
    const frame = await editor.openTrace(failing);
    await steps(frame).first().waitFor();
    await expect('the keyboard in the list of steps', () => frame.evaluate(() => document.hasFocus() && document.activeElement.matches('.steps')));
    await editor.press('ArrowDown');
    await frame.locator('#step-1.current').waitFor();
    // a sentence about the violation, a reason for each step, and a key to show only relevant steps
    equal('the sentence above the steps', await frame.locator('.trace-summary').textContent(), verified({ proskill, root }, kDrone, failing).trace.summary.replaceAll('`', ''));
    await frame.locator('.row.why').first().waitFor();
    await editor.picture('filters-why');
    const aside = await frame.locator('.row.step.aside').count();
    if (aside) {
      await editor.press('m');
      await expect('only the steps that matter', async () => /shown/.test(await count(frame)) && !(await frame.locator('.row.step.aside').count()));
      await editor.picture('filters-matters');
      await editor.press('m');
    }
    equal('steps that do not matter', aside > 0, verified({ proskill, root }, kDrone, failing).trace.steps.some(({ relevant }) => !relevant));
    await choose(frame, 'Filter', 'start_drone', 'Only steps by');
    await expect('the steps of start_drone alone', async () => /\(2 shown\)/.test(await count(frame)));
    await choose(frame, 'Filter', 'All steps');
    await choose(frame, 'Filter', 'Only steps that change something');
    await expect('fewer steps', async () => /shown/.test(await count(frame)));
    await choose(frame, 'Filter', 'All steps');
    const values = frame.locator('.values tbody tr');
    const some = await values.count();
    await frame.locator('.values button[title^="Hide variables"]').click();
    await expect('all variables', async () => (await values.count()) > some);
    await values.filter({ hasText: 'battery' }).first().hover();
    await frame.locator('button[title="Pin battery to the top"]').click();
    await expect('battery at the top', async () => /^battery/.test(await values.first().textContent()));
    await frame.locator('.values button[title^="Hide variables"]').click();
    await frame.locator('.trace-view .search').fill('localization');
    await expect('what is found', async () => (await frame.locator('.step.found').count()) === 2);
    await editor.picture('filters-found');
    await page.keyboard.press('Escape');
    await choose(frame, 'Compare', 'takes at most 120 s');
    await frame.locator('.comparing', { hasText: /Compared with .* differ/ }).waitFor();
    await editor.picture('filters-compared');
    await frame.locator('button[title="End the comparison"]').click();
    for (const [theme, name] of [['Light Modern', 'light'], ['Dark High Contrast', 'contrast']]) {
      await editor.theme(theme);
      await frame.locator(`body.vscode-${name === 'light' ? 'light' : 'high-contrast'}`).waitFor();
      await expect('buttons that are on in the colour of the current step, where the list has not the keyboard', () => frame.evaluate(() => {
        document.activeElement.blur();
        const [on, step] = ['.button[aria-pressed="true"]', '.step.current'].map((it) => getComputedStyle(document.querySelector(it)).backgroundColor);
        return on === step;
      }));
      await editor.picture(`filters-${name}`);
    }
    await editor.theme('Dark Modern');
    await frame.locator('body.vscode-dark').waitFor();
  },

  /** Saves JSON, text and SVG; opens the JSON, and a trace saved by `proskill verify`. */
  async saves(world) {
    const { editor, root, proskill } = world;
    let frame = await editor.panel('.trace-view');
    const name = `${failing}.json`;
    const json = JSON.parse((await saved(world, frame, 'Export', 'Trace as JSON', name)).toString());
    equal('texts that the file is about', Object.keys(json.sources).length, 1);
    equal('steps in the file', json.steps.length, verified(world, kDrone, failing).trace.steps.length);
    equal('text', /start_drone/.test((await saved(world, frame, 'Export', 'Trace as text', `${failing}.txt`)).toString()), true);
    equal('SVG', /^<svg[^]*start_drone/.test((await saved(world, frame, 'Export', 'Lanes as SVG', `${failing}.svg`)).toString()), true);
    mkdirSync(join(root, 'traces'), { recursive: true });
    try {
      execFileSync(proskill, ['verify', '--save-traces', 'traces', kDrone], { cwd: root, stdio: 'ignore' });
    } catch {
      // the exit code is 1, since a property is violated
    }
    for (const file of [name, `traces/${name}`]) {
      await editor.closeAll();
      await openFromFile(world, file);
      frame = await editor.panel('.trace-view');
      await frame.locator('#step-0.current').waitFor();
      equal(`the words of ${file}`, (await frame.locator('.trace-head h2').textContent()).includes('takes at least 60 s'), true);
      equal(`steps of ${file}`, (await count(frame)).trim(), `1 of ${json.steps.length}`);
      await expect('the text of the first step, beside it', async () => (await editor.markedLines('drone.proskill'))[0] === 161);
    }
    await editor.picture('saves-opened');
    await editor.closeAll();
  },

  /** A recording in MCAP, stepped forth and back; of an hour and more, the bar leads to any time, also after a reload of the window. */
  async recordings({ editor, page, proskill, root }) {
    const record = (name, program, ...options) => spawnSync(proskill, ['run', ...options, '--record', join(root, name), join(root, program)], { stdio: 'ignore' });
    record('short.mcap', kDrone, '--seed', '3');
    writeFileSync(join(root, 'endless.proskill'), kEndless);
    record('long.mcap', 'endless.proskill', '--until', '12h');
    await openFromFile({ editor, root }, 'short.mcap');
    let frame = await editor.panel('.trace-view');
    await frame.locator('#step-0.current').waitFor();
    await editor.press('ArrowDown');
    await frame.locator('#step-1.current').waitFor();
    await editor.press('ArrowUp');
    await frame.locator('#step-0.current').waitFor();
    await expect('the text of the first step, beside it', async () => (await editor.markedLines('drone.proskill')).length > 0);
    await editor.picture('recordings-short');
    equal('a recording of this text', await frame.locator('.stale-mark').isVisible(), false);
    await editor.closeAll();
    const text = readFileSync(join(root, kDrone), 'utf8');
    writeFileSync(join(root, kDrone), `; tomorrow\n${text}`);
    await openFromFile({ editor, root }, 'short.mcap');
    frame = await editor.panel('.trace-view');
    await expect('that the text is another one now', () => frame.locator('.stale-mark').isVisible());
    await editor.picture('recordings-older');
    await editor.closeAll();
    writeFileSync(join(root, kDrone), text);
    await openFromFile({ editor, root }, 'long.mcap');
    frame = await editor.panel('.trace-view');
    await frame.locator('.row.step').first().waitFor();
    const part = () => frame.locator('.trace-head h2').textContent();
    const time = () => frame.locator('.seek-slider').getAttribute('aria-valuetext');
    await expect('the last part', async () => /to 43200 s of 43200 s/.test(await part()));
    await frame.locator('.seek-slider').focus();
    await editor.press('Home');
    await expect('the first part', async () => / 0 to .* of 43200 s/.test(await part()));
    await expect('its first step', async () => /^0 s of 12:00:00, step 1 of/.test(await time()));
    await editor.press('ArrowRight', 'ArrowRight', 'ArrowLeft');
    await frame.locator('#step-1.current').waitFor();
    await editor.press(...Array(10).fill('PageUp'));
    await expect('the middle of the recording', async () => !/ 0 to /.test(await part()) && /^(5:59:|6:00:)/.test(await time()));
    await editor.picture('recordings-long');
    const before = await part();
    await editor.command('Developer: Reload Window');
    await page.locator('.monaco-workbench .statusbar-item').first().waitFor({ timeout: 60_000 });
    frame = await editor.panel('.trace-view');
    await expect('the same part after a reload', async () => (await part()) === before && /^(5:59:|6:00:)/.test(await time()));
    await editor.closeAll();
  },
};
