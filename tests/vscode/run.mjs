// The extension in the real editor:  node run.mjs PROSKILL OUT [SCENARIO…]
// OUT gets the .vsix and a picture of each scenario. 77 says that it cannot run here, and why.
// VERBOSE=1 prints where failures are, and what takes longer than half a second.
// Scenarios that are named run in the order of the list, in a workspace that is trusted unless `untrusted` is among them.
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { bench, Missing } from './bench.mjs';
import { CodeServer } from './code_server.mjs';
import { Editor } from './editor.mjs';
import { scenarios } from './scenarios/scenarios.mjs';

const tree = resolve(import.meta.dirname, '../..');
const [proskill, out, ...only] = process.argv.slice(2);
const pictures = join(resolve(out), 'pictures');
const vsix = join(resolve(out), 'proskill-linux-x64.vsix');

function workspace() {
  const folder = mkdtempSync(join(tmpdir(), 'proskill-workspace-'));
  for (const name of ['drone', 'rover', 'lift', 'fiacre', 'gripper', 'patrol']) cpSync(join(tree, 'examples', name), join(folder, name), { recursive: true });
  cpSync(join(tree, 'docs/tour/dock.proskill'), join(folder, 'dock.proskill'));
  mkdirSync(join(folder, '.vscode'));
  writeFileSync(join(folder, '.vscode/settings.json'), '{}');
  return folder;
}

/** Playwright's first line reports the timeout, and a later one its reason. */
function whatWasWaitedFor({ message }) {
  const [first, ...rest] = message.replace(/\x1b\[[0-9;]*m/g, '').split('\n');
  return [first, rest.find((line) => /waiting for|locator\(/.test(line))?.trim()].filter(Boolean).join(' ');
}

/** Why it failed, or nothing; restores the editor for the next one. */
async function failureOf(world, name, scenario) {
  const begin = Date.now();
  const { taken } = world.editor;
  try {
    await scenario(world);
    console.log(`ok      ${name} (${((Date.now() - begin) / 1000).toFixed(1)} s)`);
    if (world.editor.taken === taken) await world.editor.picture(name);
    return undefined;
  } catch (error) {
    const reason = `${whatWasWaitedFor(error)} (${await world.editor.focus()})`;
    console.log(`FAILED  ${name}: ${reason}`);
    if (process.env.VERBOSE) console.log(error.stack);
    await world.editor.picture(`${name}.failed`);
    await world.editor.command('File: Revert File').catch(() => undefined);
    return reason;
  }
}

/** The editor, which prints the calls that take long. */
const slowPrinted = (editor) => new Proxy(editor, {
  get(target, name, self) {
    const found = Reflect.get(target, name, self);
    if (found?.constructor?.name !== 'AsyncFunction' && !['command', 'answer'].includes(name)) return found;
    return async (...args) => {
      const begin = Date.now();
      try {
        return await found.apply(target, args);
      } finally {
        if (Date.now() - begin > 500) console.log(`        ${name} ${args.join(' ')}: ${((Date.now() - begin) / 1000).toFixed(1)} s`);
      }
    };
  },
});

/** The scenarios to run. Nothing is verified before the workspace is trusted, so scenarios that are chosen from the list begin with that. */
function chosen() {
  const unknown = only.filter((name) => !scenarios[name]);
  if (unknown.length) throw new Error(`no such scenario: ${unknown.join(', ')}`);
  const trusts = only.length && !only.includes('untrusted') ? ['trusted'] : [];
  return Object.entries(scenarios).filter(([name]) => !only.length || [...trusts, ...only].includes(name));
}

/** The names of those that fail twice: the editor is a separate program, and sometimes slow on a busy machine. scripts/summary.py reports those that fail once. */
async function play(world) {
  const failures = [];
  for (const [name, scenario] of chosen()) {
    const reason = await failureOf(world, name, scenario);
    if (reason === undefined) continue;
    console.log(`again   ${name}`);
    if ((await failureOf(world, name, scenario)) !== undefined) failures.push(name);
    else console.log(`retried: ${name}: ${reason}\nCTEST_FULL_OUTPUT`); // else ctest cuts off the line
  }
  return failures;
}

/** Without animations: drawing them takes a fifth of the processor time. */
async function newPage(browser) {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce', permissions: ['clipboard-read', 'clipboard-write'] });
  page.setDefaultTimeout(90_000);
  return page;
}

/** Uses another window of the same server. */
async function withWindow(server, browser, path, use) {
  const page = await newPage(browser);
  const editor = new Editor(page, pictures);
  try {
    await editor.open(server.url, path);
    return await use({ editor, page });
  } catch (error) {
    await editor.picture('window.failed');
    throw error;
  } finally {
    await page.close();
  }
}

/** Uses an editor without the extension, on the same folder: what takes time there is not ours. */
async function withPlainEditor(folder, browser, root, use) {
  const server = await CodeServer.plain(folder);
  const page = await newPage(browser);
  try {
    const editor = new Editor(page, pictures);
    await editor.open(server.url, root);
    return await use(editor);
  } finally {
    await page.close();
    server.stop();
  }
}

async function main() {
  const { folder, browser: executablePath } = bench();
  mkdirSync(pictures, { recursive: true });
  const began = Date.now();
  try {
    execFileSync(process.execPath, [join(tree, 'vscode-extension/package.mjs'), resolve(proskill), vsix], { stdio: 'pipe', timeout: 300_000 });
  } catch (error) {
    const words = `${error.stdout ?? ''}${error.stderr ?? ''}`;
    if (/ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ETIMEDOUT/.test(words)) throw new Missing(`npm cannot install: ${words.trim().split('\n').pop()}`);
    throw new Error(`the .vsix cannot be built:\n${words}`);
  }
  console.log(`${vsix} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
  const { chromium } = createRequire(join(folder, 'package.json'))('playwright-core');
  const root = workspace();
  const server = await CodeServer.start(folder, vsix);
  const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-gpu'] });
  const page = await newPage(browser);
  const consoleLines = [];
  page.on('console', (message) => consoleLines.push(`${message.type()}: ${message.text()}`));
  try {
    const editor = process.env.VERBOSE ? slowPrinted(new Editor(page, pictures)) : new Editor(page, pictures);
    await editor.open(server.url, root);
    const plain = (use) => withPlainEditor(folder, browser, root, use);
    const window = (path, use) => withWindow(server, browser, path, use);
    const failures = await play({ window, editor, page, server, root, proskill: resolve(proskill), tree, out: resolve(out), plain });
    console.log(`${((Date.now() - began) / 1000).toFixed(0)} s in all; pictures in ${pictures}`);
    return failures.length ? 1 : 0;
  } finally {
    writeFileSync(join(resolve(out), 'console.log'), consoleLines.join('\n'));
    await browser.close();
    server.stop();
    rmSync(root, { recursive: true, force: true });
  }
}

try {
  process.exit(await main());
} catch (error) {
  if (!(error instanceof Missing)) throw error;
  console.log(`skipped: ${error.message}`);
  process.exit(77);
}
