// What the tests without an editor need of the extension.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { install } from '../../vscode-extension/install.mjs';

export const tree = resolve(import.meta.dirname, '../..');
export const extension = join(tree, 'vscode-extension');
export const read = (...path) => readFileSync(join(extension, ...path), 'utf8');

/** A package of the extension; skips the test if npm cannot install it. */
export function need(...names) {
  try {
    install();
  } catch (error) {
    console.log(`skipped: npm cannot install: ${String(error.stderr ?? error).trim().split('\n').pop()}`);
    process.exit(77);
  }
  const require = createRequire(join(extension, 'package.json'));
  return names.map((name) => require(name));
}
