// The libraries' licences, which must stand in every copy of what is built.
import { readFileSync } from "node:fs";

const read = (name: string): string =>
  `${name}\n\n${readFileSync(new URL(`node_modules/${name}/LICENSE`, import.meta.url), "utf-8").trim()}`;

/** Return a comment for the head of a script: whose libraries are in it, and under which licences. */
export const notice = (...libraries: string[]): string =>
  `/*!\nThis file holds groundslab's own code and these libraries:\n\n${libraries.map(read).join("\n\n")}\n*/`;
