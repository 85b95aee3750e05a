// The TextMate grammar colours as the queries of tree-sitter do:
//   node grammar.mjs HIGHLIGHT_CAPTURES FILE…
// Each character of each file is compared: the class of colour that its scope stands for with the
// class that its capture stands for.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { tree } from './extension.mjs';
import { grammarOf, scopesOf } from './textmate.mjs';

const [captures, ...files] = process.argv.slice(2);

/** The scopes allowed for a capture, by their prefixes. */
const kScopes = {
  comment: 'comment', string: 'string.quoted', 'string.escape': 'constant.character.escape', number: 'constant.numeric',
  boolean: 'constant.language.boolean', 'constant.builtin': 'constant.language', 'variable.parameter': 'variable.parameter',
  property: 'entity.other.attribute-name', error: 'invalid.illegal', 'punctuation.bracket': 'punctuation.section',
  'punctuation.delimiter': 'punctuation.separator', keyword: 'keyword.', 'keyword.import': 'keyword.control.import',
  variable: 'variable.other', type: 'entity.name.type', function: 'entity.name.function', label: 'entity.name.label',
  constant: 'variable.other.enummember', 'variable.member': 'variable.other.member', 'keyword.conditional': 'keyword.control.conditional',
  'keyword.repeat': 'keyword.control.loop', operator: 'keyword.', 'keyword.return': 'keyword.control.return',
  'keyword.coroutine': 'keyword.control.parallel', 'function.builtin': 'support.function',
  'function.call': 'entity.name.function.call', 'keyword.operator': 'keyword.operator',
};

const grammar = await grammarOf('proskill');

/** The capture of each byte: smaller nodes override larger ones, later patterns earlier ones. */
function capturesOf(file, size) {
  const found = execFileSync(captures, [join(tree, 'tree-sitter-proskill/queries/highlights.scm'), file], { encoding: 'utf8', maxBuffer: 1 << 26 })
    .trim().split('\n').map((line) => line.split(' ')).filter(([, , , name]) => name !== 'spell')
    .map(([begin, end, pattern, name]) => ({ begin: Number(begin), end: Number(end), pattern: Number(pattern), name }))
    .sort((a, b) => (b.end - b.begin) - (a.end - a.begin) || a.pattern - b.pattern);
  const names = new Array(size).fill('');
  for (const { begin, end, name } of found) names.fill(name, begin, end);
  return names;
}

let compared = 0;
const complaints = [];
for (const file of files) {
  const bytes = readFileSync(file);
  const text = bytes.toString('utf8');
  const scopes = scopesOf(grammar, text);
  const names = capturesOf(file, bytes.length);
  let before = '';
  for (let at = 0; at < bytes.length; ++at) {
    if (!names[at] || /\s/.test(String.fromCharCode(bytes[at]))) continue;
    ++compared;
    const wanted = kScopes[names[at]];
    if (wanted && scopes[at]?.startsWith(wanted)) continue;
    const line = bytes.subarray(0, at).toString().split('\n').length;
    const complaint = `${file}:${line}: ${names[at]} is ${scopes[at] || 'nothing'}`;
    if (complaint !== before) complaints.push(`${complaint}: ${text.split('\n')[line - 1].trim()}`);
    before = complaint;
  }
}
for (const complaint of complaints.slice(0, 40)) console.log(complaint);
console.log(`${files.length} files, ${compared} coloured characters, ${complaints.length} complaints`);
process.exit(complaints.length ? 1 : 0);
