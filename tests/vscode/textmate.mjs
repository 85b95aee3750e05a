// VS Code's TextMate engine with the grammars of the extension.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { extension, need, read } from './extension.mjs';

const [textmate, oniguruma] = need('vscode-textmate', 'vscode-oniguruma');

/** The grammar of `source.LANGUAGE`. */
export async function grammarOf(language) {
  const wasm = createRequire(join(extension, 'package.json')).resolve('vscode-oniguruma').replace(/main\.js$/, 'onig.wasm');
  await oniguruma.loadWASM(readFileSync(wasm));
  const name = `${language}.tmLanguage.json`;
  const registry = new textmate.Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => textmate.parseRawGrammar(read('syntaxes', name), name),
  });
  return registry.loadGrammar(`source.${language}`);
}

/** The innermost scope of each byte. */
export function scopesOf(grammar, text) {
  const scopes = [];
  let stack = textmate.INITIAL;
  for (const line of text.split('\n')) {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, stack);
    stack = ruleStack;
    for (const { startIndex, endIndex, scopes: found } of tokens) {
      const bytes = Buffer.byteLength(line.slice(startIndex, endIndex));
      for (let i = 0; i < bytes; ++i) scopes.push(found.at(-1));
    }
    scopes.push('');
  }
  return scopes;
}
