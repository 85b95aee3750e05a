// Each snippet of the extension, as it is inserted, is part of a program that parses:
//   node snippets.mjs PROSKILL
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { read } from './extension.mjs';

const [proskill] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'proskill-snippets-'));

/** The text with every placeholder's default, and with each choice in turn. */
function expand(body) {
  const values = new Map();
  let text = body.join('\n');
  text = text.replace(/\$\{(\d+)\|([^|]*)\|\}/g, (_, id, choices) => (values.set(id, choices.split(',')[0]), values.get(id)));
  text = text.replace(/\$\{(\d+):([^}]*)\}/g, (_, id, value) => (values.set(id, value), value));
  return text.replace(/(?<!\\)\$(\d+)/g, (_, id) => values.get(id) ?? '').replace(/\\\$/g, '$');
}

/** Its context: at the top, in a skill's body, or in an environment's. */
function program(name, text) {
  if (/^\((def|include)/.test(text)) return text;
  const body = /choose|emit/.test(text)
    ? `(defenvironment world :body (${text}))` : `(defskill mission :success done :failure gave_up :body ((label again) ${text}))`;
  return body;
}

const complaints = [];
const snippets = Object.entries(JSON.parse(read('snippets/proskill.json')));
for (const [name, { prefix, body, description }] of snippets) {
  const file = join(folder, 'main.proskill');
  writeFileSync(file, program(name, expand(body)));
  const { stdout, stderr } = spawnSync(proskill, ['check', '--format', 'json', file], { encoding: 'utf8' });
  const { diagnostics } = JSON.parse(stdout || '{"diagnostics": null}');
  if (!diagnostics) complaints.push(`${name}: ${stderr}`);
  // PS01 are errors of form; names belong to the user
  for (const { code, message } of diagnostics ?? [])
    if (/^PS01/.test(code)) complaints.push(`${name}: ${code} ${message}`);
  if (!prefix || !description) complaints.push(`${name}: no prefix, or no description`);
}
rmSync(folder, { recursive: true });
for (const complaint of complaints) console.log(complaint);
console.log(`${snippets.length} snippets, ${complaints.length} complaints`);
process.exit(complaints.length ? 1 : 0);
