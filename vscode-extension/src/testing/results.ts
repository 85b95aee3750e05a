import { createHash } from 'node:crypto';
import * as vscode from 'vscode';
import type * as protocol from '../protocol';
import type { panel } from '../protocol';

/** The verdicts of a program that the Testing view showed last, and the texts they are for. */
export interface SavedResults {
  seconds: number;
  verdicts: Pick<panel.Verdict, 'name' | 'verdict' | 'good' | 'severity'>[];
  /** URI and hash of each text */
  texts: [string, string][];
}

const kKey = 'results';
/** With more programs, the oldest are forgotten. */
const kMost = 50;

/** Results that survive a reload of the window, so that unchanged programs are not verified again. */
export class Results {
  constructor(private readonly memory: vscode.Memento) {}

  programs(): string[] {
    return Object.keys(this.all());
  }

  /** If the texts are still those that were verified. */
  async of(program: string): Promise<SavedResults | undefined> {
    const saved = this.all()[program];
    if (!saved) return undefined;
    const now = await Promise.all(saved.texts.map(async ([uri]) => hashOf(vscode.Uri.parse(uri))));
    return now.every((hash, i) => hash !== null && hash === saved.texts[i]![1]) ? saved : undefined;
  }

  async save(program: string, verdicts: panel.Verdict[], texts: protocol.TextVersion[], seconds: number): Promise<void> {
    const hashes = await Promise.all(texts.map(async ({ uri }) => [uri, await hashOf(vscode.Uri.parse(uri))] as const));
    if (hashes.some(([, hash]) => hash === null)) return;
    const { [program]: former, ...others } = this.all();
    const isSame = former && JSON.stringify(former.texts) === JSON.stringify(hashes);
    const known = new Map(isSame ? former.verdicts.map((verdict) => [verdict.name, verdict]) : []);
    for (const { name, verdict, good, severity } of verdicts) known.set(name, { name, verdict, good, severity });
    const kept = Object.entries(others).slice(-(kMost - 1));
    await this.memory.update(kKey, Object.fromEntries([...kept, [program, { seconds, verdicts: [...known.values()], texts: hashes }]]));
  }

  private all(): { [program: string]: SavedResults } {
    return this.memory.get(kKey, {});
  }
}

/** The text in the editor or on the disk; null if there is none. */
async function hashOf(uri: vscode.Uri): Promise<string | null> {
  const open = vscode.workspace.textDocuments.find((document) => document.uri.toString() === uri.toString());
  try {
    const text = open ? Buffer.from(open.getText()) : await vscode.workspace.fs.readFile(uri);
    return createHash('sha256').update(text).digest('base64');
  } catch {
    return null;
  }
}
