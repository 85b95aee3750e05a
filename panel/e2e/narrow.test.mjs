// Small panels and paper: everything is present and usable.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { choosePicture, closeBrowser, eventually, openTrace, page, run, shot, view, workspace } from './browser.mjs';

after(closeBrowser);

async function rover(size, body) {
  const files = workspace();
  const file = join(files.path, 'rover/bug.proskill');
  const served = await view(file);
  const it = await page({ viewport: size });
  await openTrace(it, served.url);
  await body(it, file);
  assert.deepEqual(it.complaints, []);
  assert.equal(await served.end(), 0);
  files.remove();
}

/** The essential parts: each has room within the width, and is reached by scrolling. */
async function usable(it, places) {
  const { width } = it.viewportSize();
  for (const [place, least] of Object.entries(places)) {
    const part = it.locator(place).first();
    await part.scrollIntoViewIfNeeded();
    const box = await part.boundingBox();
    assert.ok(box, place);
    assert.ok(box.height >= least, `${place} is ${box.height} high`);
    assert.ok(box.x >= -1 && box.x + box.width <= width + 1, `${place} from ${box.x} to ${box.x + box.width}`);
    assert.ok(box.width > 100, `${place} is ${box.width} wide`);
  }
}

for (const [width, height] of [[380, 760], [520, 420], [720, 500]])
  test(`all parts at ${width} by ${height}`, () => rover({ width, height }, async (it) => {
    await usable(it, { '.verdicts': 90, '.trace-view .steps': 150, '.values .scroll': 60, '.lanes .scroll': 90, '.source-text': 90 });
    await it.locator('.steps').focus();
    await it.keyboard.press('Home');
    await eventually(async () => assert.equal(await it.locator('.step.current .number').textContent(), '1'));
    await shot(it, `narrow_${width}`);
    assert.ok(await it.locator('.step.current .words').evaluate((words) => words.scrollWidth <= words.clientWidth + 1), 'the words of the step are whole');
    const lane = await it.locator('.lanes-rows .base').first().boundingBox();
    assert.ok(lane.width > width * 0.4, `a lane is ${lane.width} wide`);
    await it.locator('#tab-automaton').click();
    await choosePicture(it, { index: 1 });
    await usable(it, { '.stage': 150 });
    await shot(it, `narrow_${width}_automaton`);
  }));

/** Whether a part is within the window, and no other part is above it. */
const inView = (part) => {
  const { left, top, bottom, height } = part.getBoundingClientRect();
  const isOnTop = (y) => part.contains(document.elementFromPoint(left + 60, y));
  return height > 15 && top >= 0 && bottom <= innerHeight + 1 && isOnTop(top + 3) && isOnTop(bottom - 3);
};

for (const width of [380, 480, 800])
  test(`the current step is in view at ${width} by 500`, () => rover({ width, height: 500 }, async (it) => {
    for (const key of ['', 'Home', 'ArrowDown', 'End', 'PageUp']) {
      if (key) await it.keyboard.press(key);
      await eventually(async () => assert.ok(await it.locator('.step.current').evaluate(inView), `after ${key || 'opening'}`));
    }
    await shot(it, `narrow_low_${width}`);
  }));

test('the source is below the trace where three columns would be too narrow', () => rover({ width: 800, height: 900 }, async (it) => {
  const [verdicts, trace, source] = await Promise.all(['.verdicts', '.trace-view', '.source'].map((place) => it.locator(place).boundingBox()));
  assert.ok(trace.width > 600 && source.width > 600, `${trace.width} and ${source.width} wide`);
  assert.ok(verdicts.height > 800 && source.y >= trace.y + trace.height && source.y + source.height <= 900);
  for (const place of ['.step.current', '.source .marked-line']) assert.ok(await it.locator(place).first().evaluate(inView), place);
}));

for (const [width, height] of [[380, 800], [520, 830]])
  test(`a run beside a program shows its last step and the automaton without scrolling at ${width} by ${height}`, async () => {
    const files = workspace();
    const running = await run(join(files.path, 'drone/drone.proskill'), '--clock', 'simulated');
    const it = await page({ viewport: { width, height } });
    await it.goto(running.url);
    await it.locator('.stage g.node').first().waitFor();
    await it.locator('.run-bar').getByRole('button', { name: 'Continue', exact: true }).click();
    await eventually(async () => assert.ok(Number(await it.locator('.step.current .number').textContent()) > 12));
    await it.locator('.run-bar[data-state="ended"]').waitFor();
    const [steps, automaton] = await Promise.all(['.steps', '.automaton-view'].map((place) => it.locator(place).boundingBox()));
    assert.ok(Math.min(steps.y + steps.height, automaton.y) - steps.y > 170, `steps from ${steps.y}, and the automaton from ${automaton.y}`);
    for (const place of ['.step.current', '.stage']) {
      const box = await it.locator(place).first().boundingBox();
      assert.ok(box.y > 0 && box.height > 15 && box.y + box.height <= height, `${place} from ${box.y} to ${box.y + box.height}`);
      assert.ok(await it.locator(place).first().evaluate((part) => {
        const box = part.getBoundingClientRect();
        return part.contains(document.elementFromPoint(box.left + 60, box.bottom - 4));
      }), `${place} is not hidden by another part`);
    }
    await usable(it, { '.trace-view .steps': 150, '.values .scroll': 60, '.lanes .scroll': 90 });
    await shot(it, `narrow_run_${width}`);
    running.end();
    files.remove();
  });

/** Its run ends with a forbidden move. */
const kForbidden = `(defsv energy :min 0 :max 10 :init 1)
(defskill use :action (use) :success ok (:effects (energy (- energy 2))))
(defskill mission :success done :body ((use) (success done)))
`;
/** What is added to the end of a run with many steps and a fault of its model. */
const kMore = ' (a failure that is told in a sentence of its own); 12 steps came too fast to be shown; the first 40000 steps are no longer kept';

for (const width of [380, 520, 900])
  test(`the end of a run is readable at ${width} pixels`, async () => {
    const files = workspace();
    writeFileSync(join(files.path, 'forbidden.proskill'), kForbidden);
    const running = await run(join(files.path, 'forbidden.proskill'), '--clock', 'simulated');
    const it = await page({ viewport: { width, height: 830 } });
    await it.goto(running.url);
    const bar = it.locator('.run-bar');
    await bar.getByRole('button', { name: 'Continue', exact: true }).click();
    await it.locator('.run-bar[data-state="ended"]').waitFor();
    const words = bar.locator('.run-state .words');
    assert.equal(await words.textContent(), 'the mission has ended: success; 1 thing should not have happened');
    for (const more of ['', kMore]) {
      await words.evaluate((part, text) => part.append(text), more);
      const [state, text, end] = await Promise.all([bar.locator('.run-state'), words, bar.getByRole('button', { name: 'End', exact: true })].map((part) => part.boundingBox()));
      assert.ok(text.x >= state.x && text.x + text.width <= state.x + state.width + 1, 'no word is cut off');
      assert.ok(text.y >= state.y - 1 && text.y + text.height <= state.y + state.height + 1, 'no line is cut off');
      for (const box of [state, end]) assert.ok(box.x >= 0 && box.x + box.width <= width, `from ${box.x} to ${box.x + box.width}`);
      await shot(it, `narrow_end_${width}${more && '_long'}`);
    }
    running.end();
    files.remove();
  });

/** Of each test step that is drawn: its result, and whether all of it is within the list. */
const results = (frame) => {
  const list = frame.getBoundingClientRect();
  return [...frame.querySelectorAll('.result')].map((it) => {
    const box = it.getBoundingClientRect();
    return { words: it.textContent, whole: it.scrollWidth <= it.clientWidth + 1 && box.left >= list.left && box.right <= list.left + frame.clientWidth };
  });
};

for (const [words, press] of [['by actor', []], ['by step', ['By actor']]])
  test(`the results of tests are whole at 380 pixels, ${words}`, () => rover({ width: 380, height: 760 }, async (it) => {
    for (const name of press) await it.getByRole('button', { name }).click();
    const count = Number((await it.locator('.count').textContent()).match(/of (\d+)/)[1]);
    await it.locator('.steps').focus();
    await it.keyboard.press('Home');
    const seen = new Set();
    for (let step = 1; step <= count; ++step) {
      await eventually(async () => assert.equal(await it.locator('.step.current .number').textContent(), String(step)));
      for (const result of await it.locator('.steps').evaluate(results)) {
        assert.match(result.words, /^: (true|false)$/);
        assert.ok(result.whole, `${result.words} near step ${step}`);
        seen.add(result.words);
      }
      await it.keyboard.press('ArrowDown');
    }
    assert.ok(seen.size > 0, 'there are tests');
    assert.ok(await it.locator('.step .words').evaluateAll((all) => all.some((words) => words.scrollWidth > words.clientWidth)), 'some conditions are longer than their lines');
    await shot(it, `narrow_results_${words.replace(' ', '_')}`);
  }));

test('so are those of possible steps', async () => {
  const folder = workspace();
  const file = join(folder.path, 'long.proskill');
  writeFileSync(file, `(defsv lamp :states (On Off) :init Off :transitions :all)
(defskill mission :body ((if (or ${'(lamp On) '.repeat(12)}) (set (lamp Off)))))
`);
  const served = await view(file);
  const it = await page({ viewport: { width: 380, height: 760 } });
  await it.goto(served.url);
  await it.locator('#tab-simulation').click();
  await it.locator('.choice', { hasText: 'starts' }).click();
  await it.locator('.choice .result').waitFor();
  assert.deepEqual(await it.locator('.choice-list').evaluate(results), [{ words: ': false', whole: true }]);
  await shot(it, 'narrow_choice');
  assert.deepEqual(it.complaints, []);
  assert.equal(await served.end(), 0);
  folder.remove();
});

/** Of each test in a picture: its words, and whether all of them are within its shape. */
const tests = (all) => all.map((node) => {
  const shape = node.querySelector('polygon').getBBox();
  const lines = [...node.querySelectorAll('text')];
  return {
    words: lines.map((line) => line.textContent).join(' '),
    whole: lines.map((line) => line.getBBox()).every(({ x, y, width, height }) =>
      x >= shape.x && y >= shape.y && x + width <= shape.x + shape.width && y + height <= shape.y + shape.height),
  };
});

test('the words of a test are whole in its automaton', async () => {
  const folder = workspace();
  const file = join(folder.path, 'long.proskill');
  const condition = `(or ${'(lamp On) '.repeat(12)}(and true (lamp Off) (not false)))`;
  writeFileSync(file, `(defsv lamp :states (On Off) :init Off :transitions :all)
(defskill mission :body ((if ${condition} (set (lamp On)))))
`);
  const served = await view(file);
  const it = await page({ viewport: { width: 380, height: 760 } });
  await it.goto(served.url);
  await it.locator('#tab-automaton').click();
  await choosePicture(it, 'body mission');
  assert.deepEqual(await it.locator('.stage g.role-test').evaluateAll(tests), [{ words: condition, whole: true }]);
  await shot(it, 'narrow_test');
  assert.deepEqual(it.complaints, []);
  assert.equal(await served.end(), 0);
  folder.remove();
});

test('the layout goes by the width of the panel, not by that of the window', () => rover({ width: 1200, height: 800 }, async (it) => {
  await it.locator('#panel').evaluate((panel) => { panel.style.width = '400px'; });
  await eventually(async () => {
    const [steps, values] = await Promise.all(['.steps', '.values'].map((place) => it.locator(place).boundingBox()));
    assert.ok(values.y >= steps.y + steps.height, 'values stand below the steps');
    assert.ok(steps.width > 340, `steps are ${steps.width} wide`);
  });
}));

for (const width of [380, 480, 600])
  test(`while the text has errors, nothing moves at ${width} pixels`, () => rover({ width, height: 760 }, async (it, file) => {
    const places = () => it.locator('.trace-head > *, .steps, .values, .lanes').evaluateAll((all) => all.map((part) => JSON.stringify(part.getBoundingClientRect())));
    const text = readFileSync(file, 'utf8');
    const before = await places();
    writeFileSync(file, `${text}\n(defskill`);
    await it.locator('.stale-mark:visible').waitFor();
    assert.deepEqual(await places(), before);
    await shot(it, `narrow_stale_${width}`);
    writeFileSync(file, text);
    await it.locator('.stale-mark').waitFor({ state: 'hidden' });
    assert.deepEqual(await places(), before);
  }));

test('all that takes the keyboard has a name, and shows that it has it', () => rover({ width: 1200, height: 800 }, async (it) => {
  for (const tab of ['trace', 'automaton', 'simulation']) {
    await it.locator(`#tab-${tab}`).click();
    if (tab === 'automaton') await choosePicture(it, { index: 1 });
    if (tab === 'simulation') await it.locator('.choice').first().waitFor();
    await it.locator(`#tab-${tab}`).focus();
    const names = [];
    do {
      await it.keyboard.press('Tab');
      const { name, isMarked } = await it.evaluate(() => {
        const part = document.activeElement;
        const { outlineStyle } = getComputedStyle(part);
        const frame = getComputedStyle(part.closest('.search-frame') ?? part);
        const accent = Object.assign(document.body.appendChild(document.createElement('i')), { style: 'color: var(--accent)' });
        const isMarked = outlineStyle !== 'none' || frame.borderTopColor === getComputedStyle(accent).color;
        accent.remove();
        return { name: part === document.body ? '' : part.getAttribute('aria-label') ?? part.textContent, isMarked };
      });
      assert.ok(name.trim(), `${names.at(-1)} is followed by something without a name`);
      assert.ok(isMarked, `${name} does not show that it has the keyboard`);
      names.push(name);
    } while (names.at(-1) !== 'Source text');
    assert.ok(names.length > 10, names.join(', '));
  }
}));

test('paper is light, whatever the screen is', () => rover({ width: 1000, height: 500 }, async (it) => {
  await it.emulateMedia({ colorScheme: 'dark' });
  await it.locator('#tab-automaton').click();
  await choosePicture(it, { index: 1 });
  const ground = () => it.evaluate(() => getComputedStyle(document.body).backgroundColor);
  await eventually(async () => assert.notEqual(await ground(), 'rgb(255, 255, 255)'));
  await it.emulateMedia({ colorScheme: 'dark', media: 'print' });
  assert.equal(await ground(), 'rgb(255, 255, 255)');
  const filters = await it.locator('.stage g.node, .stage .dots').evaluateAll((all) => all.map((part) => [part.matches('.dots'), getComputedStyle(part).filter]));
  assert.ok(filters.length > 3);
  for (const [isDots, filter] of filters) assert.equal(filter.startsWith('invert(1)'), !isDots, 'the dark picture is turned, the dots of the actors are not');
}));

test('on paper all steps are there, one below the other', () => rover({ width: 1000, height: 500 }, async (it) => {
  const count = Number((await it.locator('.count').textContent()).match(/of (\d+)/)[1]);
  assert.ok((await it.locator('.step').count()) < count, 'on the screen only what is in view');
  await it.emulateMedia({ media: 'print' });
  await it.evaluate(() => dispatchEvent(new Event('beforeprint')));
  const tops = await it.locator('.step').evaluateAll((all) => all.map((row) => row.getBoundingClientRect()).map(({ top, bottom }) => [top, bottom]));
  assert.equal(tops.length, count);
  tops.slice(1).forEach(([top], at) => assert.ok(top >= tops[at][1] - 1, `step ${at + 2} is below step ${at + 1}`));
  const { end, height } = await it.evaluate(() => ({ end: document.querySelector('.lanes').getBoundingClientRect().bottom, height: document.documentElement.scrollHeight }));
  assert.ok(end <= height + 1 && end > tops.at(-1)[1], 'the lanes come after them, on the page');
  assert.equal(await it.locator('.toolbar:visible, .button:visible').count(), 0);
  await it.screenshot({ path: join(process.env.SCREENSHOTS, 'print.png'), fullPage: true });
  await it.evaluate(() => dispatchEvent(new Event('afterprint')));
  await it.emulateMedia({ media: 'screen' });
  await eventually(async () => assert.ok((await it.locator('.step').count()) < count));
}));
