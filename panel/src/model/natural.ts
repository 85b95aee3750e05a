const collator = new Intl.Collator('en', { numeric: true });

/** The order in which people look for names: s2 comes before s10. */
export const byName = (a: string, b: string): number => collator.compare(a, b);
