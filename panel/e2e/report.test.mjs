import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { chooseFrom, choosePicture, closeBrowser, eventually, marked, page, proskill, report, shot, workspace } from './browser.mjs';

after(closeBrowser);

function write(file, directory) {
  try {
    execFileSync(proskill, ['verify', '--report', directory, file]);
  } catch (error) {
    assert.equal(error.status, 1); // a property is violated
  }
  return pathToFileURL(join(directory, 'index.html')).href;
}

for (const [scheme, example, name] of [['light', 'rover', 'energy.no_forbidden_transition'], ['dark', 'arm', 'one_in_the_zone']])
  test(`the report on the ${example} is a page by itself, ${scheme}`, async () => {
    const files = workspace();
    const file = join(files.path, example, 'bug.proskill');
    const url = write(file, join(files.path, 'report'));
    const it = await page({ colorScheme: scheme, offline: true });
    await it.goto(url);
    await it.locator(`.verdict[data-name="${name}"]`).click();
    const { trace } = report(file).properties.find((property) => property.name === name);
    await it.locator(`.trace-head h2[title="${name}"]`).waitFor();
    await it.locator('.steps').focus();
    for (const key of ['Home', 'ArrowDown', 'ArrowDown', 'PageDown', 'End', 'ArrowUp']) {
      await it.keyboard.press(key);
      const at = Number(await it.locator('.step.current .number').textContent()) - 1;
      await eventually(async () => assert.equal((await marked(it)).lines[0], trace.steps[at].location.begin.line));
    }
    assert.equal(Number(await it.locator('.step.current .number').textContent()), trace.steps.length - 1);
    assert.ok((await it.locator('.lane-bar').count()) > 4);
    await shot(it, `report_${example}_${scheme}`);
    await it.locator('#tab-automaton').click();
    await it.locator('.stage g.node').first().waitFor();
    const pictures = await it.locator('select.pictures option').count();
    for (let i = 0; i < pictures; ++i) await choosePicture(it, { index: i });
    await choosePicture(it, { index: 1 });
    await it.locator('.stage g.node a').nth(1).click();
    await it.locator('.stage .ring.selected').waitFor();
    await shot(it, `report_${example}_automaton_${scheme}`);
    assert.deepEqual(it.requests.filter((request) => !/^(file|data|blob):/.test(request)), []);
    assert.deepEqual(it.complaints, []);
    files.remove();
  });

test('a report switches between light and dark, pictures too', async () => {
  const files = workspace();
  const it = await page();
  await it.goto(write(join(files.path, 'arm/bug.proskill'), join(files.path, 'report')));
  await it.locator('#tab-automaton').click();
  await it.locator('.stage g.node').first().waitFor();
  const ink = () => it.locator('.stage svg text').first().getAttribute('fill');
  const before = await ink();
  await it.getByRole('button', { name: 'Light or dark' }).click();
  await eventually(async () => assert.notEqual(await ink(), before));
  assert.equal(await it.evaluate(() => document.documentElement.dataset.theme), 'dark');
  await chooseFrom(it, 'Fold', 'Fold all');
  await it.locator('.stage g.role-folded').first().waitFor();
  assert.deepEqual(it.complaints, []);
  files.remove();
});
