// Two folders in one window, with programs of the same name; names that URIs escape, line ends of Windows, and a file that is not to be changed.
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';
import { choose } from '../panel.mjs';
import { expand, row } from './verification.mjs';

const kNorth = 'north #1 100% Süd';
const kSouth = 'south';
const kMain = 'main.proskill';

const kParts = 'Teile ä #2 50%.proskill';

export const kLamp = `(defsv lamp :states (On Off) :init Off :transitions :all)
(defskill light
  :time_interval [1,2]
  :action (light)
  :success lit
    (:effects (lamp On)))
`;
/** It includes the lamp, and the trace goes from one file to the other. Both have line ends of Windows. */
const kText = `(include "${kParts}")

(defskill mission
  :success done
  :body
    ((light)
     (success done)))

(defproperty dark (always (lamp Off)))
`.replaceAll('\n', '\r\n');
/** The other program of this name, in which a finding is switched off. */
const kOther = `(defsv never_used :states (A B) :init A)
(defskill mission :success done :body ((^ 1) (success done)))
`;

/** The end of the URI of a text, as the editor writes it. */
const uriEnd = (...names) => names.map((name) => `/${encodeURIComponent(name)}`).join('');
const textOf = (page, ...names) => page.locator(`.monaco-editor[data-uri$="${uriEnd(...names)}"]`);

function writeFolders() {
  const home = mkdtempSync(join(tmpdir(), 'proskill-folders-'));
  for (const name of [kNorth, kSouth]) mkdirSync(join(home, name));
  writeFileSync(join(home, kNorth, kMain), kText);
  writeFileSync(join(home, kNorth, kParts), kLamp.replaceAll('\n', '\r\n'));
  writeFileSync(join(home, kSouth, kMain), kOther);
  writeFileSync(join(home, kSouth, '.proskill.json'), JSON.stringify({ severity: { PS0612: 'error' } }));
  return home;
}

function writeWorkspace(home, names) {
  const path = join(home, 'both.code-workspace');
  writeFileSync(path, JSON.stringify({ folders: names.map((name) => ({ path: name })), settings: { 'files.readonlyFromPermissions': true } }));
  return path;
}

/** The list still changes while the editor looks for files, and a click may hit the other file of this name. */
const open = (editor, page, folder) => expect(`${folder}/${kMain} in an editor`, async () => {
  await editor.pick('Control+p', kMain, `${kMain} ${folder}`, '');
  await textOf(page, folder, kMain).locator('.view-line').first().waitFor({ timeout: 10_000 });
  return true;
}, 90_000);

/** The editor sometimes misses the folders of a workspace while it starts. */
const folders = (page) => expect('the folders', async () => {
  if (await page.locator(`.explorer-folders-view .monaco-list-row[aria-label^="${kSouth}"]`).count()) return true;
  const none = page.getByText('You have not yet added a folder');
  if (await none.count()) await page.reload({ waitUntil: 'domcontentloaded' });
  await page.locator('.explorer-folders-view .monaco-list-row').first().waitFor({ timeout: 10_000 });
  return false;
});

/** Another window is another browser, which does not know what was trusted. */
export async function trust(editor, page) {
  await editor.statusSays('syntax and static checks', 60_000);
  await editor.command('Workspaces: Manage Workspace Trust');
  await page.locator('.workspace-trust-editor .monaco-button', { hasText: /^Trust$/ }).first().click();
  await editor.statusSays(/bad|good/, 60_000);
  await editor.command('View: Close Editor');
}

/** Adds a folder by the editor's dialog, which first reads its folder, and then replaces typed text by the folder's name. */
async function addFolder(editor, path) {
  await editor.command('Workspaces: Add Folder to Workspace...');
  const dialog = editor.quickInput();
  await dialog.locator('.monaco-list-row[aria-label=".."]').waitFor();
  await expect('the dialog to take it', async () => {
    if (!(await dialog.count())) return true;
    await dialog.locator('input.input').fill(`${path}/`, { timeout: 1000 });
    await dialog.locator('.monaco-button', { hasText: 'Add' }).click({ timeout: 1000 });
    await dialog.waitFor({ state: 'hidden', timeout: 3000 });
    return true;
  });
}

const programs = (page) => page.locator('.test-explorer .monaco-list-row[aria-level="1"]').evaluateAll((all) => all.map((it) => it.getAttribute('aria-label').replace(/ \(.*/, '')).sort());

export const scenarios = {
  /** The trace of one program, with steps in a file whose name URIs escape, stays while the folder of the other goes and comes back. */
  async folders(world) {
    const home = writeFolders();
    await world.window(writeWorkspace(home, [kNorth, kSouth]), async ({ editor, page }) => {
      await folders(page);
      await open(editor, page, kSouth);
      await trust(editor, page);
      await editor.statusSays(/good/, 60_000);
      await editor.picture('folders-south');
      await textOf(page, kSouth, kMain).locator('.squiggly-error').waitFor({ timeout: 10_000 }); // by the settings of its folder
      await editor.picture('folders-south');
      await editor.command('View: Close Editor'); // a text that is open is verified wherever it is
      await open(editor, page, kNorth);
      await editor.statusSays(/1 bad/, 60_000);
      await textOf(page, kNorth, kMain).locator('.squiggly-error').first().waitFor(); // the editor asks for findings after the status has changed
      equal('errors in the other folder', await textOf(page, kNorth, kMain).locator('.squiggly-error').count(), 1);
      await editor.command('Testing: Focus on Test Explorer View');
      await expect('both programs, told apart', async () => JSON.stringify(await programs(page)) === JSON.stringify([`${kNorth}/${kMain}`, `${kSouth}/${kMain}`]));
      const frame = await editor.openTrace('dark');
      await editor.press('End');
      const place = await expect('the last step', async () => /^(.*):(\d+)$/.exec(await frame.locator('.step.current .place').textContent()));
      equal('its file', place[1], kParts);
      await expect('its mark', async () => (await editor.markedLines(uriEnd(kNorth, kParts)))[0] === Number(place[2]));
      await editor.picture('folders-trace');

      const step = await frame.locator('.step.current').getAttribute('id');
      await editor.command('Workspaces: Remove Folder from Workspace...');
      await editor.answer(kSouth);
      await expect('the programs of one folder', async () => JSON.stringify(await programs(page)) === JSON.stringify([kMain]), 15_000);
      await editor.picture('folders-one');
      await addFolder(editor, join(home, kSouth));
      await expect('both programs again', async () => (await programs(page)).length === 2);
      equal('the step', await frame.locator('.step.current').getAttribute('id'), step);
      await editor.picture('folders-both');

      chmodSync(join(home, kNorth, kParts), 0o444);
      await open(editor, page, kNorth);
      await editor.goTo(2);
      await editor.type('; typed');
      await editor.press('Enter');
      await editor.save();
      equal('line ends', readFileSync(join(home, kNorth, kMain), 'utf8'), kText.replace('\r\n', '\r\n; typed\r\n'));
      await frame.locator('.stale-mark').waitFor({ state: 'hidden' });
      equal('the step after the edit', await frame.locator('.step.current').getAttribute('id'), step);
      await frame.locator('.steps').press('ArrowUp');
      await expect('the mark in the file that cannot be written', async () => (await editor.markedLines(uriEnd(kNorth, kParts)))[0] === 2);
      await editor.picture('folders-edited');
    });
    rmSync(home, { recursive: true });
  },
};
