// What several scenarios do in the panel.
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { expect } from './expect.mjs';

/** Chooses a line of a menu of the panel, by the beginning of its title, in a section. */
export async function choose(frame, menu, item, section = '') {
  const opener = frame.locator(`.menu > button[title^="${menu}"]`);
  await opener.click();
  const list = frame.locator('.menu-list:not([hidden])');
  const lines = section ? list.locator(`.menu-title:has-text("${section}") ~ .menu-item`) : list.locator('.menu-item');
  await lines.filter({ hasText: item }).first().click();
  // What can be checked leaves the menu open.
  if (await list.count()) await list.press('Escape');
}

/** Saves with the editor's dialog, and returns the file's bytes. */
export async function saved({ editor, root }, frame, menu, format, name) {
  const file = join(root, name);
  rmSync(file, { force: true });
  await choose(frame, menu, format, 'Save');
  const input = editor.quickInput().locator('input.input');
  await expect(`the dialog to propose ${name}`, async () => (await input.inputValue()).endsWith(name));
  await expect(`${name} on the disk`, async () => {
    if (await editor.quickInput().count()) await editor.press('Enter');
    return existsSync(file) && readFileSync(file).length > 0;
  });
  return readFileSync(file);
}

/** Opens a trace or a run with the editor's dialog. The dialog first reads its folder, and then replaces typed text by the folder's name. */
export async function openFromFile({ editor, root }, name) {
  const path = join(root, name);
  await editor.command('ProSkill: Open Trace or Run from File');
  const input = editor.quickInput().locator('input.input');
  await expect('the dialog in a folder', async () => (await input.inputValue()).startsWith(root));
  await editor.quickInput().locator('.monaco-list-row[aria-label=".."]').waitFor();
  await expect('the dialog to take it', async () => {
    if (!(await editor.quickInput().count())) return true;
    if ((await input.inputValue({ timeout: 1000 })) === path) await editor.press('Enter');
    else await input.fill(path, { timeout: 1000 });
    return false;
  });
}
