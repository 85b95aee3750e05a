import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { chooseFrom, choosePicture, closeBrowser, downloaded, eventually, marked, openTrace, page, report, shot, view, workspace } from './browser.mjs';

after(closeBrowser);

describe('the lift, in which two skills want the doors', () => {
  let files, served, it, property;
  before(async () => {
    files = workspace();
    const file = join(files.path, 'lift/bug.proskill');
    property = report(file).properties.find((found) => found.name === 'doors_closed_when_moving');
    served = await view(file);
    it = await page();
    await openTrace(it, served.url);
  });
  after(async () => {
    assert.equal(await served.end(), 0);
    files.remove();
  });

  test('the first violated property is open at the step that it is about', async () => {
    assert.equal(await it.locator('.trace-head .badge').textContent(), 'violated');
    assert.match(await it.locator('.trace-head h2').textContent(), /running go_up/);
    assert.equal(await it.locator('.step.current .number').textContent(), String(property.trace.steps.length));
    assert.equal(await it.locator('.verdict[aria-selected="true"]').getAttribute('data-name'), property.name);
    await shot(it, 'lift');
  });

  test('the arrow keys go through the steps, and the source goes with them', async () => {
    await it.locator('.steps').focus();
    await it.keyboard.press('Home');
    const { steps } = property.trace;
    for (const [index, step] of steps.entries()) {
      if (index > 0) await it.keyboard.press('ArrowDown');
      assert.equal(await it.locator('.step.current .number').textContent(), String(index + 1));
      await eventually(async () => {
        const shown = await marked(it);
        assert.equal(shown.file, step.location.file);
        const [first, last] = [step.location.begin.line, step.location.end.line];
        assert.deepEqual(shown.lines, Array.from({ length: last - first + 1 }, (_, i) => first + i));
        const text = readFileSync(step.location.file).subarray(...step.location.bytes).toString();
        assert.equal(shown.text.replace(/\s+/g, ''), text.replace(/\s+/g, ''));
      });
    }
  });

  test('the values are those after the step, with what changed marked', async () => {
    await it.locator('.steps').focus();
    await it.keyboard.press('End');
    const doors = it.locator('.values tr', { has: it.getByRole('button', { name: 'doors', exact: true }) });
    assert.match(await doors.textContent(), /doorsClosed→Open/);
    assert.equal(await doors.getAttribute('class'), 'changed');
    await it.keyboard.press('Home');
    assert.match(await doors.textContent(), /doorsOpen$/);
  });

  test('a folded group opens when a key goes to one of its steps', async () => {
    await it.locator('.steps').focus();
    await it.keyboard.press('End');
    await it.locator('.row.head').last().click();
    await it.locator('.step.current').waitFor({ state: 'detached' });
    await it.locator('.steps').focus();
    await it.keyboard.press('ArrowUp');
    await it.keyboard.press('ArrowDown');
    assert.equal(await it.locator('.step.current .number').textContent(), String(property.trace.steps.length));
  });

  test('a variable is pinned to the top', async () => {
    await it.locator('.values tr', { hasText: 'cabin' }).hover();
    await it.getByRole('button', { name: 'Pin cabin to the top' }).click();
    assert.match(await it.locator('.values tr').first().textContent(), /^cabin/);
  });

  test('a watch is a condition with a value at each step, until it is taken away', async () => {
    const change = property.trace.steps.flatMap((step) => step.changes).find((found) => !found.variable.includes('.'));
    const text = `(${change.variable} ${change.after})`;
    const field = it.getByRole('textbox', { name: /^Watch/ });
    await field.fill(`(no${change.variable} ${change.after})`);
    await field.press('Enter');
    assert.equal(await it.getByRole('alert').textContent(), `there is no variable no${change.variable} in this trace`);
    await field.fill(text);
    await field.press('Enter');
    assert.equal(await field.inputValue(), '');
    const row = it.locator('.values tr').first();
    assert.match(await row.textContent(), new RegExp(`^${text.replace(/[()]/g, '\\$&')}.*(true|false)$`));
    await it.locator(`.lane[data-lane="${text}"] .lane-bar`).nth(1).waitFor({ state: 'attached' });
    await shot(it, 'lift_watched');
    await it.getByRole('button', { name: `Watch ${text} no longer` }).click();
    await it.locator(`.lane[data-lane="${text}"]`).waitFor({ state: 'detached' });
  });

  test('there is a lane for each who acts and each variable that changes, and a click on one goes to its step', async () => {
    const lanes = await it.locator('.lanes .lane').evaluateAll((all) => all.map((lane) => lane.dataset.lane));
    const actors = new Set(property.trace.steps.map((step) => step.actor));
    const changed = new Set(property.trace.steps.flatMap((step) => step.changes.map((change) => change.variable)).filter((name) => !/\.(status|res)$/.test(name)));
    assert.deepEqual(new Set(lanes), new Set([...actors, ...changed]));
    assert.ok((await it.locator('.lane[data-lane="open_doors"] .lane-bar').count()) > 0);
    const box = await it.locator('.lane[data-lane="close_doors"] .lane-bar').boundingBox();
    await it.mouse.click(box.x + box.width - 3, box.y + box.height / 2);
    const step = property.trace.steps.findIndex((found) => found.actor === 'close_doors' && found.description.startsWith('succeeds'));
    assert.equal(await it.locator('.step.current .number').textContent(), String(step + 1));
  });

  test('lanes are zoomed and fit again', async () => {
    const ticks = () => it.locator('.lanes .tick-label').allTextContents();
    const before = await ticks();
    assert.equal(before[0], '0 s');
    await it.locator('.lanes .scroll').focus();
    await it.keyboard.press('+');
    await it.keyboard.press('+');
    await eventually(async () => assert.notEqual((await ticks())[0], '0 s'));
    await it.keyboard.press('0');
    await eventually(async () => assert.deepEqual(await ticks(), before));
  });

  test('a filter leaves the steps of one actor, in the list and in the lanes', async () => {
    await chooseFrom(it, 'Filter', 'serve_call');
    await it.keyboard.press('Escape');
    const expected = property.trace.steps.flatMap((step, index) => (step.actor === 'serve_call' ? [String(index + 1)] : []));
    await eventually(async () => assert.deepEqual(await it.locator('.step .number').allTextContents(), expected));
    assert.match(await it.locator('.count').textContent(), new RegExp(`${expected.length} shown`));
    await shot(it, 'lift_filtered');
    await chooseFrom(it, 'Filter', 'All steps');
    assert.doesNotMatch(await it.locator('.count').textContent(), /shown/);
  });

  test('the search finds steps by their words', async () => {
    await it.keyboard.press('/');
    await it.locator('.trace-view .search').fill('open_pressed');
    const at = property.trace.steps.findIndex((step) => step.actor === 'open_pressed');
    await eventually(async () => assert.equal(await it.locator('.step.current .number').textContent(), String(at + 1)));
    assert.equal(await it.locator('.step.found').count(), 1);
    await it.keyboard.press('Escape');
  });

  test('two traces are compared', async () => {
    await chooseFrom(it, 'Compare', 'is never refused');
    await it.locator('.comparing').waitFor();
    assert.match(await it.locator('.comparing').textContent(), /Compared with .* differ/);
    assert.ok((await it.locator('.only-left, .only-right').count()) > 0);
    await shot(it, 'lift_compared');
    await it.getByRole('button', { name: 'End the comparison' }).click();
  });

  test('a trace is exported as JSON, text and SVG, and opened again from its file', async () => {
    const json = await downloaded(it, 'Export', 'Trace as JSON');
    assert.equal(json.name, 'doors_closed_when_moving.json');
    assert.equal(JSON.parse(readFileSync(json.path, 'utf8')).steps.length, property.trace.steps.length);
    const text = await downloaded(it, 'Export', 'Trace as text');
    assert.match(readFileSync(text.path, 'utf8'), /open_pressed: occurs/);
    const svg = await downloaded(it, 'Export', 'Lanes as SVG');
    const picture = readFileSync(svg.path, 'utf8');
    assert.match(picture, /^<svg[^>]*>.*serve_call.*<\/svg>\s*$/s);
    assert.doesNotMatch(picture, /class=|var\(/);
    await it.locator('.verdict', { hasText: 'can run' }).first().click();
    await eventually(async () => assert.notEqual(await it.locator('.trace-head .badge').textContent(), 'violated'));
    const [chooser] = await Promise.all([it.waitForEvent('filechooser'), it.locator('.app-head button[title^="Open"]').click()]);
    await chooser.setFiles(json.path);
    await eventually(async () => assert.equal(await it.locator('.trace-head .badge').textContent(), 'violated'));
    const again = await view(json.path);
    const other = await page();
    await openTrace(other, again.url);
    await other.keyboard.press('Home');
    await eventually(async () => assert.equal((await marked(other)).lines[0], property.trace.steps[0].location.begin.line));
    assert.deepEqual(other.complaints, []);
    assert.equal(await again.end(), 0);
  });

  test('a node of the automaton leads to its source, and a place in the source to its node', async () => {
    await it.locator('#tab-automaton').click();
    await choosePicture(it, 'body run_lift');
    const node = it.locator('.stage g.node', { hasText: 'serve_call' });
    await node.click();
    await eventually(async () => assert.equal((await marked(it)).text, '(serve_call)'));
    await it.locator('.stage .ring.selected').waitFor();
    await eventually(() => it.locator('.source .line', { hasText: '(mode Off)' }).locator('.code').first().scrollIntoViewIfNeeded());
    const test = it.locator('.source .line', { hasText: '(if (mode Off)' }).locator('.code');
    await test.click({ position: { x: 50, y: 8 } });
    const ring = await it.locator('.stage .ring.caret').boundingBox();
    const hexagon = await it.locator('.stage g.node.role-test').boundingBox();
    assert.ok(Math.abs(ring.x + ring.width / 2 - hexagon.x - hexagon.width / 2) < 3, 'the test is marked');
    await shot(it, 'lift_automaton');
  });

  test('the keyboard alone walks through an automaton', async () => {
    await it.locator('.stage').focus();
    await it.keyboard.press('Escape');
    await it.keyboard.press('ArrowDown');
    await it.keyboard.press('ArrowDown');
    await it.keyboard.press('ArrowDown');
    assert.match(await it.locator('.part-words').textContent(), /^wait: until/);
    await eventually(async () => assert.match((await marked(it)).text, /wanted floor/));
    const before = await it.locator('.stage svg').getAttribute('viewBox');
    await it.keyboard.press('+');
    await eventually(async () => assert.notEqual(await it.locator('.stage svg').getAttribute('viewBox'), before));
    await it.keyboard.press('0');
    await eventually(async () => assert.equal(await it.locator('.stage svg').getAttribute('viewBox'), before));
  });

  test('pictures are saved as SVG, PNG and DOT', async () => {
    const svg = await downloaded(it, 'Save and copy', 'SVG');
    assert.match(readFileSync(svg.path, 'utf8'), /<svg[^]*serve_call/);
    const png = await downloaded(it, 'Save and copy', 'PNG');
    assert.equal(readFileSync(png.path).subarray(1, 4).toString(), 'PNG');
    const dot = await downloaded(it, 'Save and copy', 'DOT');
    assert.match(readFileSync(dot.path, 'utf8'), /^digraph/);
    assert.equal(dot.name, 'body_run_lift.dot');
  });

  test('while the text is broken the last valid picture stays, marked; mended, everything is new', async () => {
    const path = join(files.path, 'lift/building.proskill');
    const text = readFileSync(path, 'utf8');
    const nodes = await it.locator('.stage g.node').count();
    const places = () => it.locator('.stage g.node').evaluateAll((all) => all.map((node) => JSON.stringify(node.getBoundingClientRect())));
    const before = await places();
    writeFileSync(path, text.replace('(serve_call)', '(serve_cal)'));
    await it.locator('.notice', { hasText: 'last valid picture' }).waitFor();
    await eventually(async () => assert.match(await it.locator('.state').textContent(), /^building\.proskill:\d+: unknown skill `serve_cal`/));
    assert.equal(await it.locator('.stage g.node').count(), nodes);
    assert.deepEqual(await places(), before, 'no node has moved');
    await shot(it, 'lift_broken');
    writeFileSync(path, text);
    await it.locator('.notice').waitFor({ state: 'hidden' });
    assert.deepEqual(await places(), before, 'nor when the text is whole again');
    await eventually(async () => assert.match(await it.locator('.state').textContent(), /classes in/));
  });

  test('nothing in the page complains, and nothing leaves this machine', () => {
    assert.deepEqual(it.complaints, []);
    for (const url of it.requests) assert.match(url, /^(http:\/\/127\.0\.0\.1:|blob:|data:)/);
  });
});

test('branches of the drone are folded into one node and opened again', async () => {
  const files = workspace();
  const served = await view(join(files.path, 'drone/drone.proskill'));
  const it = await page({ colorScheme: 'dark' });
  await it.goto(served.url);
  await it.locator('.trace-head h2').waitFor();
  await it.locator('#tab-automaton').click();
  await it.locator('.stage g.node').first().waitFor();
  const count = () => it.locator('.stage g.node').count();
  const open = await count();
  await chooseFrom(it, 'Fold', 'Fold all');
  const folded = it.locator('.stage g.role-folded', { hasText: 'branch 2' });
  await folded.waitFor();
  assert.ok((await count()) < open);
  await shot(it, 'drone_folded');
  await folded.dblclick();
  await folded.waitFor({ state: 'detached' });
  assert.ok((await it.locator('.stage g.role-folded').count()) > 0, 'the others stay folded');
  await chooseFrom(it, 'Fold', 'Open all');
  await eventually(async () => assert.equal(await count(), open));
  await it.locator('.stage').focus();
  await it.keyboard.press('/');
  await it.keyboard.type('landing');
  await eventually(async () => assert.equal(await it.locator('.stage g.node.found').count(), 2));
  await shot(it, 'drone_search');
  assert.deepEqual(it.complaints, []);
  assert.equal(await served.end(), 0);
  files.remove();
});
