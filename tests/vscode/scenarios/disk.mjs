// Files that disappear from the disk, and files that a command changes although no editor shows them.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { kLamp } from './folders.mjs';
import { row } from './verification.mjs';

const kFolder = 'disk';
const kMain = 'night.proskill';
const kPart = 'lamp.proskill';
const kText = `(include "${kPart}")
(defskill mission
  :success done
  :body
    ((light)
     (success done)))
(defproperty dark (always (lamp Off)))
`;
const kCurrent = /1 bad(?!.*outdated)/;

const path = ({ root }, name) => join(root, kFolder, name);
const textOf = (page, name) => page.locator(`.monaco-editor[data-uri$="/${kFolder}/${name}"]`);
const inTesting = (page, name) => row(page, `${name} (`);

async function show({ editor, page }, name) {
  await editor.pick('Control+p', `${kFolder}/${name}`, name, ' ');
  await textOf(page, name).locator('.view-line').first().waitFor();
}

async function begin(world) {
  mkdirSync(join(world.root, kFolder), { recursive: true });
  writeFileSync(path(world, kMain), kText);
  writeFileSync(path(world, kPart), kLamp);
  await world.editor.closeAll();
  await show(world, kMain);
  await world.editor.statusSays(kCurrent, 60_000);
}

async function end({ editor, root }) {
  await editor.closeAll();
  rmSync(join(root, kFolder), { recursive: true });
}

const failed = (page) => inTesting(page, kMain).locator('.codicon-testing-failed-icon');

async function beginInTesting(world) {
  await begin(world);
  await world.editor.command('Testing: Focus on Test Explorer View');
  await failed(world.page).waitFor();
}

/** Neither the Testing view nor the list of problems has anything of the program. */
async function nothingIsLeft({ editor, page }) {
  await inTesting(page, kMain).waitFor({ state: 'detached', timeout: 15_000 });
  const problems = (await editor.problems()).filter({ hasText: kMain });
  await expect('no problems of it', async () => (await problems.count()) === 0, 15_000);
  equal('the status', /bad|errors/.test(await editor.status().textContent()), false);
}

export const scenarios = {
  /** A program that is not open disappears with its results, which are not those of a later file of its name. */
  async deleted(world) {
    const { editor, page } = world;
    await beginInTesting(world);
    await editor.closeAll();
    await failed(page).waitFor();
    rmSync(path(world, kMain));
    await nothingIsLeft(world);
    writeFileSync(path(world, kMain), kText.replace('(lamp Off)', '(lamp On)'));
    await editor.command('Testing: Focus on Test Explorer View');
    await inTesting(page, kMain).waitFor();
    await editor.picture('deleted');
    equal('current results', await inTesting(page, kMain).locator('.codicon-testing-failed-icon:not(.retired)').count(), 0);
    await end(world);
  },

  /** The text of a program that is open when its file disappears counts until it is closed. Then nothing is left of it. */
  async deleted_open(world) {
    const { editor, page } = world;
    await beginInTesting(world);
    rmSync(path(world, kMain));
    await page.locator('.tab .strikethrough').filter({ hasText: kMain }).first().waitFor();
    await editor.statusSays(kCurrent);
    await failed(page).waitFor();
    await editor.picture('deleted_open');
    await editor.closeAll();
    await nothingIsLeft(world);
    await end(world);
  },

  /** A program reports an included file that disappears, also if that was open: then when it is closed. */
  async deleted_include(world) {
    const { editor, page } = world;
    const reported = async () => {
      await editor.statusSays(/errors/);
      await textOf(page, kMain).locator('.squiggly-error').first().waitFor();
    };
    await begin(world);
    rmSync(path(world, kPart));
    await reported();
    await editor.picture('deleted_include');
    writeFileSync(path(world, kPart), kLamp);
    await editor.statusSays(kCurrent);
    await show(world, kPart);
    rmSync(path(world, kPart));
    await page.locator('.tab .strikethrough').filter({ hasText: kPart }).first().waitFor();
    await editor.statusSays(kCurrent);
    await editor.command('View: Close Editor');
    await reported();
    await end(world);
  },

  /** A name is changed in files that no editor shows: the verdicts are current again without another edit. */
  async renamed_elsewhere(world) {
    const { editor, page } = world;
    await begin(world);
    await editor.goTo(kText.split('\n').findIndex((it) => it.startsWith('(defproperty')) + 1, 30);
    await editor.press('F2');
    const input = page.locator('.rename-box input');
    await input.waitFor();
    await input.fill('bulb');
    await editor.press('Enter');
    await textOf(page, kMain).locator('.view-line', { hasText: 'bulb' }).first().waitFor();
    await expect('the new name in the other file', () => readFileSync(path(world, kPart), 'utf8').includes('(bulb On)'));
    await editor.statusSays(kCurrent, 30_000);
    await editor.picture('renamed_elsewhere');
    await end(world);
  },
};
