import * as vscode from 'vscode';

/** Options that the server receives at its start. */
export function initializationOptions(): object {
  const { live, delay, seconds, megabytes, requestSeconds, requestMegabytes } =
    vscode.workspace.getConfiguration('proskill').get<Record<string, unknown>>('verify', {});
  return {
    trusted: vscode.workspace.isTrusted,
    verify: { live, delay, seconds, megabytes, requestSeconds, requestMegabytes },
  };
}
