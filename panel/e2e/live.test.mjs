// A run while it happens: `proskill run --view`.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { choosePicture, closeBrowser, eventually, page, run, shot, workspace } from './browser.mjs';

after(closeBrowser);

const signal = (it, name) => it.locator(`.signal[data-signal="${name}"]`);
const value = (it, name) => it.locator('.values tr', { has: it.locator('th', { hasText: new RegExp(`^${name}$`) }) }).locator('.after').last();
const words = (it) => it.locator('.step .words').allTextContents();
const state = (it) => it.locator('.run-bar').getAttribute('data-state');
const current = async (it) => Number(await it.locator('.step.current .number').textContent());
const activeNodes = (it) => it.locator('.stage g.node.active').evaluateAll((all) => all.map((node) => node.getAttribute('aria-label')));
const activeLines = (it) => it.locator('.active-line .code').allTextContents();
const verdict = (it, name) => it.locator(`.property[data-property="${name}"]`).getAttribute('data-verdict');
const button = (it, name) => it.locator('.run-bar').getByRole('button', { name, exact: true });

describe('a drone in real time', () => {
  let files, running, it, second, recording;
  before(async () => {
    files = workspace();
    recording = join(files.path, 'flight.json');
    const file = join(files.path, 'drone/drone.proskill');
    const platform = join(files.path, 'calm.json');
    const events = [...readFileSync(file, 'utf8').matchAll(/\(defevent (\S+)/g)].map(([, name]) => [name, null]);
    // Long enough for a person, and for a slow machine: what the test does ends each of them.
    writeFileSync(platform, JSON.stringify({ kind: 'simulated', events: Object.fromEntries(events), actions: {
      start_drone: { duration: [1, 1], results: { ready: 1 } }, takeoff: { duration: [1, 1], results: { at_altitude: 1 } },
      goto_waypoint: { duration: [600, 600] }, camera_survey: { duration: [600, 600] }, landing: { duration: [600, 600], results: { landed: 1 } } } }));
    running = await run(file, '--clock', 'real', '--platform', platform, '--record', recording);
    it = await page({ viewport: { width: 1720, height: 980 } });
    await it.goto(running.url);
    second = await page();
    for (const each of [it, second]) each.setDefaultTimeout(20000);
    await second.goto(running.url);
  });
  after(() => files.remove());

  test('steps arrive by themselves, and current states shine in the automaton and in the text', async () => {
    await eventually(async () => assert.ok((await activeLines(it)).some((line) => line.includes('(localization_status Valid)'))));
    assert.deepEqual((await activeNodes(it)).length, 1);
    assert.match((await activeNodes(it))[0], /^wait: until/);
    assert.equal(await value(it, 'flight_status').textContent(), 'OnGround');
  });

  test('a pause stops the time of the run, and single steps go on from there', async () => {
    await button(it, 'Pause').click();
    await eventually(async () => assert.equal(await state(it), 'paused'));
    await eventually(async () => assert.equal(await state(second), 'paused'));
    await signal(it, 'localization_status_to_valid').click();
    await it.locator('.run-waiting', { hasText: '1 signal waits' }).waitFor();
    const clock = it.locator('.run-clock');
    const stopped = await clock.textContent();
    for (let steps = await current(it); !(await activeLines(it)).some((line) => line.includes('(takeoff $height')); steps = await current(it)) {
      await button(it, 'Step').click();
      await eventually(async () => assert.ok(await current(it) > steps));
    }
    assert.equal(await value(it, 'localization_status').textContent(), 'Valid');
    assert.equal(await clock.textContent(), stopped);
  });

  test('an event that is sent by a click in one browser moves the mission on in both', async () => {
    await signal(second, 'flight_status_to_in_air').click();
    await button(second, 'Continue').click();
    await eventually(async () => assert.equal(await state(it), 'running'));
    for (const each of [it, second]) await eventually(async () => assert.equal(await value(each, 'flight_status').textContent(), 'InAir'));
  });

  test('branches shine side by side, and the picture of a skill shows that its action runs', async () => {
    await eventually(async () => assert.ok((await activeNodes(it)).length >= 2));
    await shot(it, 'live_flight');
    await choosePicture(it, 'skill camera_survey');
    await eventually(async () => assert.match((await activeNodes(it)).join(), /^action: run/));
    await choosePicture(it, 'sv battery');
    await eventually(async () => assert.deepEqual(await activeNodes(it), ['state: Good']));
    await choosePicture(it, 'body monitor_battery_critical');
  });

  test('a step back ends the following, and nothing moves until it is asked for', async () => {
    const last = await current(it);
    await it.locator('.steps').focus();
    await it.keyboard.press('ArrowUp');
    assert.equal(await it.locator('.follow-run').getAttribute('aria-pressed'), 'false');
    await signal(it, 'battery_to_low').click();
    await eventually(async () => assert.ok((await it.locator('.trace-view .count').first().textContent()).endsWith(` of ${last + 1}`)));
    assert.equal(await current(it), last - 1);
    await it.locator('.follow-run').click();
    await eventually(async () => assert.equal(await current(it), last + 1));
    assert.equal(await value(it, 'battery').textContent(), 'Low');
  });

  test('the emergency: monitors interrupt what runs, and the message stands at its `printf`', async () => {
    await signal(it, 'battery_to_critical').click();
    await eventually(async () => assert.deepEqual(await activeNodes(it), ['call: landing']));
    await it.locator('.source-text').evaluate((text) => { text.scrollTop = 174 * 20; });
    await it.locator('.line .message', { hasText: 'Battery critical: landing now' }).waitFor();
    await shot(it, 'live_emergency');
    await eventually(async () => assert.ok((await words(it)).includes('fails with mission_failed')));
  });

  test('after its end the run can be stepped through, and the recording says the same', async () => {
    await button(it, 'End').click();
    await eventually(async () => assert.equal(await state(it), 'ended'));
    assert.match(await it.locator('.run-state').textContent(), /stopped|ended/);
    assert.equal(await signal(it, 'battery_to_good').isDisabled(), true);
    await it.locator('.steps').focus();
    await it.keyboard.press('Home');
    await eventually(async () => assert.equal(await current(it), 1));
    const { steps } = JSON.parse(readFileSync(recording, 'utf8'));
    assert.equal(await it.locator('.trace-view .count').first().textContent(), `1 of ${steps.length}`);
    assert.ok(steps.some(({ actor, remark }) => actor === 'battery_to_critical' && remark === undefined));
    assert.deepEqual([...it.complaints, ...second.complaints], []);
    await button(it, 'End').click();
    assert.equal(await running.ended, 1);
    await it.locator('.state', { hasText: 'proskill has ended' }).waitFor();
    assert.equal(await current(it), 1);
  });
});

/** A mission that waits for a person. */
const program = `(defsv door :states (Open Closed) :init Open :transitions :all)
(defevent door_closes :effects (door Closed))
(defskill drive :interruptible t :time_interval [1,900] :action (drive) :success there)
(defskill mission :success done :body ((printf "close the door: %s" door) (^ (door Closed)) (drive) (success done)))
(defproperty arrives (present (ended mission success)))
(defproperty opens_again (infinitelyoften (door Open)))
`;

describe('a mission in simulated time', () => {
  let files, file;
  before(() => {
    files = workspace();
    file = join(files.path, 'door.proskill');
    writeFileSync(file, program);
    writeFileSync(join(files.path, 'quiet.json'), '{"signals": []}');
  });
  after(() => files.remove());

  test('it begins paused, and takes the steps, the event and the interrupt that a person sends', async () => {
    const running = await run(file, '--script', join(files.path, 'quiet.json'));
    const it = await page();
    await it.goto(running.url);
    await eventually(async () => assert.equal(await state(it), 'paused'));
    assert.equal(await it.locator('.step').count(), 0);
    await button(it, 'Step').click();
    await button(it, 'Step').click();
    await it.locator('.line .message', { hasText: 'close the door: Open' }).waitFor();
    for (const name of ['arrives', 'opens_again']) assert.equal(await verdict(it, name), 'not yet');
    await signal(it, 'door_closes').click();
    await it.locator('.run-waiting', { hasText: '1 signal waits' }).waitFor();
    assert.equal(await signal(it, 'drive').isDisabled(), true);
    for (let taken = 2; await signal(it, 'drive').isDisabled(); ++taken) {
      await button(it, 'Step').click();
      await eventually(async () => assert.ok(await current(it) > taken));
    }
    await shot(it, 'live_simulated');
    await signal(it, 'drive').click();
    await button(it, 'Continue').click();
    await eventually(async () => assert.equal(await state(it), 'ended'));
    assert.equal(await verdict(it, 'arrives'), 'true');
    assert.equal(await verdict(it, 'opens_again'), 'not yet');
    await it.locator('.property[data-property="arrives"]').click();
    await eventually(async () => assert.match(await it.locator('.step.current').textContent(), /holds/));
    await shot(it, 'live_properties');
    const texts = await words(it);
    assert.ok(texts.includes('is interrupted from outside'), texts.join('\n'));
    assert.deepEqual(it.complaints, []);
    running.end();
    assert.equal(await running.ended, 0);
    assert.match(running.output, /mission: success/);
  });

  test('with `--no-controls` nobody can influence it, by the page or by its requests', async () => {
    const running = await run(file, '--script', join(files.path, 'quiet.json'), '--no-controls', '--until', '5');
    const it = await page();
    await it.goto(running.url);
    await eventually(async () => assert.equal(await state(it), 'ended'));
    running.end();
    assert.equal(await running.ended, 3);
    const waiting = await run(file, '--clock', 'real', '--until', '500', '--no-controls', '--platform', calm(files));
    const other = await page();
    await other.goto(waiting.url);
    await eventually(async () => assert.equal(await state(other), 'running'));
    for (const name of ['Pause', 'End']) assert.equal(await button(other, name).isDisabled(), true);
    assert.equal(await signal(other, 'door_closes').isDisabled(), true);
    for (const body of [{ do: 'pause' }, { do: 'send', signal: 'door_closes' }, { do: 'end' }]) {
      const answer = await other.request.post(`${waiting.url}api/control`, { data: body });
      assert.match((await answer.json()).error, /--no-controls/);
    }
    waiting.end();
    await eventually(async () => assert.equal(await state(other), 'ended'));
    waiting.end();
    assert.equal(await waiting.ended, 3);
  });
});

/** Events that do not come while the test lasts. */
function calm(files) {
  const path = join(files.path, 'calm.json');
  writeFileSync(path, JSON.stringify({ kind: 'simulated', events: { door_closes: [400, 400] } }));
  return path;
}
