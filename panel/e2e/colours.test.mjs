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

/** The least contrast between text of dimmed steps and its ground. */
const contrastOfDimmed = () => {
  const channels = (colour) => colour.match(/[\d.]+/g).slice(0, 3).map(Number);
  const luminance = (rgb) => rgb.map((it) => it / 255).map((it) => (it <= 0.04045 ? it / 12.92 : ((it + 0.055) / 1.055) ** 2.4))
    .reduce((sum, it, i) => sum + it * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = channels(getComputedStyle(document.body).backgroundColor);
  return Math.min(...[...document.querySelectorAll('.row.aside:not(.current, .of-current) > *')].map((it) => {
    const { color, opacity } = getComputedStyle(it);
    const seen = channels(color).map((channel, i) => Number(opacity) * channel + (1 - Number(opacity)) * ground[i]);
    const [low, high] = [luminance(seen), luminance(ground)].sort((a, b) => a - b);
    return (high + 0.05) / (low + 0.05);
  }));
};

test('dimmed steps can be read in high contrast', async () => {
  const files = workspace();
  const served = await view(join(files.path, 'drone/drone.proskill'));
  const it = await page();
  await openTrace(it, served.url);
  await it.locator('.verdict', { hasText: 'takes at least 60' }).first().click();
  await it.locator('.steps').press('Home');
  await it.locator('.row.aside').first().waitFor();
  await themes['high contrast'](it);
  for (const colorScheme of ['light', 'dark']) {
    await it.emulateMedia({ colorScheme });
    const contrast = await it.evaluate(contrastOfDimmed);
    assert.ok(contrast >= 4.5, `${contrast} in ${colorScheme}`);
  }
  assert.equal(await served.end(), 0);
  files.remove();
});

test('the text of a step is marked in forced colours', async () => {
  const files = workspace();
  const served = await view(join(files.path, 'drone/drone.proskill'));
  const it = await page();
  await openTrace(it, served.url);
  await it.emulateMedia({ forcedColors: 'active' });
  await it.locator('.source .marked').first().waitFor();
  assert.equal(await it.locator('.source .marked').first().evaluate((mark) => getComputedStyle(mark).outlineStyle), 'solid');
  assert.equal(await served.end(), 0);
  files.remove();
});

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
