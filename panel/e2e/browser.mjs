// What every browser test needs: a served program or the file of a page, and a page without errors.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { cpSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

const { PROSKILL, CHROMIUM, SCREENSHOTS, EXAMPLES } = process.env;
export const proskill = PROSKILL;

/** A copy of the examples, for tests that change them. */
export function workspace() {
  const path = mkdtempSync(join(tmpdir(), 'proskill-panel-'));
  cpSync(EXAMPLES, path, { recursive: true });
  return { path, remove: () => rmSync(path, { recursive: true, force: true }) };
}

export function report(...words) {
  try {
    return JSON.parse(execFileSync(PROSKILL, ['verify', '--format', 'json', '--traces', 'all', ...words], { maxBuffer: 1 << 28 }));
  } catch (error) {
    if (error.status !== 1) throw error; // 1: a property is violated
    return JSON.parse(error.stdout);
  }
}

const children = new Set();

/** Runs `proskill view` on a file; `end` ends it as Ctrl-C does, and returns the exit code. */
export async function view(file, ...more) {
  const child = spawn(PROSKILL, ['view', '--no-open', ...more, file], { stdio: ['ignore', 'pipe', 'inherit'] });
  children.add(child);
  const ended = new Promise((done) => child.on('exit', (code) => { children.delete(child); done(code); }));
  const url = await new Promise((done, failed) => {
    child.stdout.on('data', (bytes) => done(String(bytes).trim()));
    child.on('exit', (code) => failed(new Error(`proskill view ended with ${code}`)));
  });
  return { url, end: () => { child.kill('SIGINT'); return ended; } };
}

/** Runs `proskill run --view`; `end` sends Ctrl-C, `ended` is the exit code, and `output` what it has printed so far. */
export async function run(file, ...more) {
  const child = spawn(PROSKILL, ['run', '--view', '--no-open', ...more, file], { stdio: ['ignore', 'pipe', 'pipe'] });
  children.add(child);
  const it = { output: '', end: () => child.kill('SIGINT') };
  it.ended = new Promise((done) => child.on('close', (code) => { children.delete(child); done(code); }));
  child.stdout.on('data', (bytes) => { it.output += bytes; });
  let errors = '';
  it.url = await new Promise((done, failed) => {
    child.stderr.on('data', (bytes) => {
      errors += bytes;
      const found = /http:\S+/.exec(errors);
      if (found) done(found[0]);
    });
    child.on('exit', (code) => failed(new Error(`proskill run ended with ${code}: ${errors}`)));
  });
  return it;
}

let browser = null;
export async function page(options = {}) {
  browser ??= await chromium.launch({ executablePath: CHROMIUM, args: ['--no-sandbox'] });
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, acceptDownloads: true, ...options });
  const it = await context.newPage();
  it.complaints = [];
  it.requests = [];
  it.on('console', (message) => message.type() === 'error' && it.complaints.push(message.text()));
  it.on('pageerror', (error) => it.complaints.push(error.message));
  it.on('request', (request) => it.requests.push(request.url()));
  it.setDefaultTimeout(60000);
  return it;
}
/** Ends what a failed test has left. */
export async function closeBrowser() {
  for (const child of children) child.kill('SIGKILL');
  await browser?.close();
}

export async function shot(it, name) {
  await it.screenshot({ path: join(SCREENSHOTS, `${name}.png`) });
}

/** The marked lines in the source, from 1, and the name of the file. */
export async function marked(it) {
  return it.evaluate(() => ({
    file: document.querySelector('.source .files').value,
    lines: [...document.querySelectorAll('.source .marked-line')].map((line) => Number(line.dataset.line) + 1),
    text: [...document.querySelectorAll('.source .marked')].map((part) => part.textContent).join(''),
  }));
}

/** Repeats a check for as long as a page may take. */
export async function eventually(check) {
  const end = Date.now() + 30000;
  for (;;) {
    try {
      return await check();
    } catch (error) {
      if (Date.now() > end) throw error;
      await new Promise((done) => setTimeout(done, 25));
    }
  }
}

/** Opens an address, and waits for a trace; before, its list takes no key. */
export async function openTrace(it, url) {
  await it.goto(url);
  await it.locator('.step.current').waitFor();
  await it.locator('.steps').focus();
}

/**
 * Delays the answers to requests of the page for whose parameters `isHeld` is true. `arrived` resolves when one is delayed; `release` sends all of
 * them, and delays no more.
 */
export async function hold(it, method, isHeld = () => true) {
  let arrive, release;
  const arrived = new Promise((done) => { arrive = done; });
  const released = new Promise((done) => { release = done; });
  await it.route(`**/api/${method}`, async (route) => {
    if (isHeld(route.request().postDataJSON())) {
      arrive();
      await released;
    }
    await route.continue();
  });
  return { arrived, release };
}

/** Chooses a picture, and waits until it is shown. */
export async function choosePicture(it, option) {
  const [value] = await it.locator('select.pictures').selectOption(option);
  await it.locator(`.stage[data-picture="${value}"] g.node`).first().waitFor();
}

export async function chooseFrom(it, opener, label) {
  await it.locator(`button[title^="${opener}"]:visible`).click();
  await it.locator('.menu-list:visible .menu-item', { hasText: label }).first().click();
}

export async function downloaded(it, opener, label) {
  const [download] = await Promise.all([it.waitForEvent('download'), chooseFrom(it, opener, label)]);
  const path = await download.path();
  assert.ok(path);
  return { name: download.suggestedFilename(), path };
}
