// An actor has one colour, in steps, lanes and automata, in every theme.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { choosePicture, closeBrowser, eventually, openTrace, page, shot, view, workspace } from './browser.mjs';

after(closeBrowser);

/** What is painted for each actor: the dots of steps, the first bars of lanes, the dots of the automaton. */
const painted = () => {
  const of = (selector, actor, colour) => Object.fromEntries([...document.querySelectorAll(selector)].map((it) => [actor(it), colour(it)]));
  const hue = (it) => { // as the browser writes colours
    const probe = document.body.appendChild(document.createElement('span'));
    probe.style.cssText = `forced-color-adjust: none; color: ${getComputedStyle(it).getPropertyValue('--hue')}`;
    const { color } = getComputedStyle(probe);
    probe.remove();
    return color;
  };
  return {
    steps: of('.row.head', (it) => it.querySelector('.actor').textContent, (it) => getComputedStyle(it.querySelector('.dot')).backgroundColor),
    lanes: of('.lane', (it) => it.dataset.lane, hue),
    automaton: of('.actor-dot', (it) => it.dataset.actor, (it) => getComputedStyle(it).fill),
  };
};

const themes = {
  light: async (it) => it.emulateMedia({ colorScheme: 'light' }),
  dark: async (it) => it.emulateMedia({ colorScheme: 'dark' }),
  'high contrast': async (it) => it.evaluate(() => {
    document.body.classList.add('vscode-high-contrast');
    document.body.dataset.vscodeThemeKind = 'vscode-high-contrast';
  }),
  'forced colours': async (it) => it.emulateMedia({ forcedColors: 'active' }),
};

test('a skill has the same colour in steps, lanes and automata, in light, dark and high contrast', async () => {
  const files = workspace();
  const served = await view(join(files.path, 'rover/bug.proskill'));
  const it = await page();
  await openTrace(it, served.url);
  await it.locator('#tab-automaton').click();
  await choosePicture(it, { label: 'Who calls whom' });
  const seen = new Map();
  for (const [theme, choose] of Object.entries(themes)) {
    await choose(it);
    await it.locator('#tab-trace').click();
    await it.locator('.steps').focus();
    await it.keyboard.press('Home');
    await eventually(async () => {
      const { steps, lanes, automaton } = await it.evaluate(painted);
      const shared = Object.keys(steps).filter((actor) => actor in automaton);
      assert.ok(shared.length >= 2, `skills that act, in ${theme}: ${shared}`);
      for (const actor of shared) assert.deepEqual([lanes[actor], automaton[actor]], [steps[actor], steps[actor]], `${actor} in ${theme}`);
      assert.equal(new Set(Object.values(steps)).size, Object.keys(steps).length, `distinct in ${theme}`);
      seen.set(theme, steps[shared[0]]);
    });
    await it.locator('#tab-automaton').click();
    await shot(it, `colours_${theme.replace(' ', '_')}`);
  }
  assert.notEqual(seen.get('light'), seen.get('dark'), 'each ground has its palette');
  assert.deepEqual(it.complaints, []);
  assert.equal(await served.end(), 0);
  files.remove();
});
