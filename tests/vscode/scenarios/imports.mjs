// Programs of other languages: the command, the lamp, and a file that is dropped.
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, expect } from '../expect.mjs';

const kProgram = 'gripper/gripper.proskill';

/** Drops a file into the editor of a program, as the explorer does, with Shift held. */
const drop = (page, name, file) => page.evaluate(([end, uri]) => {
  const target = [...document.querySelectorAll('.monaco-editor[data-uri]')].find((it) => it.dataset.uri.endsWith(end)).querySelector('.view-lines');
  const { left, top } = target.getBoundingClientRect();
  const dataTransfer = new DataTransfer();
  dataTransfer.setData('text/uri-list', uri);
  for (const type of ['dragenter', 'dragover', 'drop'])
    target.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, composed: true, dataTransfer, shiftKey: true, clientX: left + 5, clientY: top + 5 }));
}, [name, file]);

export const scenarios = {
  /** A component is imported, edited, and imported again. */
  async imported({ editor, page, root, tree }) {
    rmSync(join(root, kProgram));
    await editor.openFile('gripper/gripper.gen');
    await editor.command('ProSkill: Import');
    await editor.tab('gripper.proskill').waitFor();
    const wanted = readFileSync(join(tree, 'examples', kProgram), 'utf8');
    equal('the program', readFileSync(join(root, kProgram), 'utf8') === wanted, true);
    await page.locator('.notification-list-item', { hasText: 'verdicts are exact' }).waitFor();
    await editor.picture('imported');
    await editor.command('Notifications: Clear All Notifications');

    await editor.openFile('gripper/gripper.gen');
    await editor.command('ProSkill: Import');
    await page.locator('.monaco-dialog-box', { hasText: 'these changes are lost' }).locator('.monaco-button', { hasText: 'Cancel' }).click();
    equal('the program that was there', readFileSync(join(root, kProgram), 'utf8') === wanted, true);

    writeFileSync(join(root, kProgram), wanted.replace('(defskill', '; mine\n(defskill'));
    await editor.command('ProSkill: Import');
    await page.locator('.monaco-dialog-box', { hasText: 'these changes are lost' }).locator('.monaco-button', { hasText: 'Replace' }).click();
    await expect('the program without the change', async () => readFileSync(join(root, kProgram), 'utf8') === wanted, 10_000);
    await editor.closeAll();
  },

  /** The lamp of a behavior tree with an error: the error is marked at its place, and nothing is written. */
  async import_fails({ editor, page, root }) {
    writeFileSync(join(root, 'gripper/wrong.xml'), '<root BTCPP_format="4">\n  <BehaviorTree ID="A">\n    <Sequence/>\n  </BehaviorTree>\n</root>\n');
    await editor.openFile('gripper/wrong.xml');
    await editor.goTo(3, 6);
    await editor.command('Refactor...');
    await page.locator('.action-widget').getByText('Import as a ProSkill program').waitFor();
    await editor.press('Enter');
    await page.locator('.notification-list-item', { hasText: 'must have at least 1 child' }).waitFor();
    await editor.squiggles().first().waitFor();
    await editor.picture('import_fails');
    await editor.command('Notifications: Clear All Notifications');
    await editor.closeAll();
  },

  /** A dropped component is inserted as its services. */
  async dropped({ editor, page, root }) {
    writeFileSync(join(root, 'gripper/all.proskill'), '\n');
    await editor.openFile('gripper/all.proskill');
    await drop(page, 'gripper/all.proskill', `vscode-remote://${new URL(page.url()).host}${join(root, 'gripper/gripper.gen')}`);
    await expect('the services in the program', async () => (await page.locator('.monaco-editor[data-uri$="all.proskill"] .view-line', { hasText: 'calibrate_done' }).count()) > 0, 10_000);
    await editor.command('File: Revert File');
    await editor.closeAll();
  },
};
