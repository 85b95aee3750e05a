// The TextMate grammar of Fiacre sees what Fiacre's lexer sees:
//   node fiacre_grammar.mjs FIACRE_TOKENS FILE…
// Every reserved word is coloured as one, alone and after whatever may precede it; and each character of
// each file has a colour of what the lexer takes it for.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { read } from './extension.mjs';
import { grammarOf, scopesOf } from './textmate.mjs';

const [tokens, ...files] = process.argv.slice(2);
const grammar = await grammarOf('fiacre');

/** The scopes allowed for a token, by their prefixes; the file's own scope is not a colour. */
const kScopes = {
  comment: /^comment\./, string: /^string\.quoted/, number: /^constant\.numeric/,
  reserved: /^(keyword|storage\.type|constant\.language)\./, name: /^(source\.fiacre$|entity\.name|variable\.other)/,
  symbol: /^(source\.fiacre$|keyword\.operator|entity\.name\.tag)/,
};

const complaints = [];
const run = (...args) => execFileSync(tokens, args, { encoding: 'utf8', maxBuffer: 1 << 26 }).trim().split('\n');

/** A keyword is one everywhere; a name that begins or ends with it is not. */
const words = run();
for (const word of words) {
  for (const before of ['', 'x ', '(', ', ', 'state ', 'a := ']) {
    const scope = scopesOf(grammar, `${before}${word} x`)[before.length];
    if (!kScopes.reserved.test(scope)) complaints.push(`\`${before}${word}\` is ${scope}`);
  }
  for (const name of [`${word}_1`, `my_${word}`, `${word}s2`]) {
    const scope = scopesOf(grammar, `x ${name}`)[2];
    if (!words.includes(name) && !kScopes.name.test(scope)) complaints.push(`\`${name}\` is ${scope}`);
  }
}

/** And no others are: the grammar's keywords are the lexer's reserved words. */
const listed = (read('syntaxes/fiacre.tmLanguage.json').match(/\(\?:[a-z|]+\)/g) ?? []).flatMap((list) => list.match(/[a-z]+/g));
if (listed.length < words.length / 2) complaints.push('the lists of words of the grammar are not found');
for (const word of listed) if (!words.includes(word)) complaints.push(`\`${word}\` is no reserved word of Fiacre`);

let compared = 0;
for (const file of files) {
  const bytes = readFileSync(file);
  const scopes = scopesOf(grammar, bytes.toString('utf8'));
  for (const [begin, end, kind] of run(file).map((line) => line.split(' '))) {
    for (let at = Number(begin); at < Number(end); ++at) {
      if (/\s/.test(String.fromCharCode(bytes[at]))) continue;
      ++compared;
      if (kScopes[kind].test(scopes[at])) continue;
      const line = bytes.subarray(0, at).toString().split('\n').length;
      complaints.push(`${file}:${line}: ${kind} \`${bytes.subarray(Number(begin), Number(end))}\` is ${scopes[at] || 'nothing'}`);
      break;
    }
  }
}
for (const complaint of complaints.slice(0, 40)) console.log(complaint);
console.log(`${words.length} words, ${files.length} files, ${compared} characters compared, ${complaints.length} complaints`);
process.exit(complaints.length ? 1 : 0);
