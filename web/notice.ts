// The libraries' licences, which must stand in every copy of what is built.
import { readFileSync } from "node:fs";

const LIBRARIES = ["three", "uplot"];

const read = (name: string): string =>
  `${name}\n\n${readFileSync(new URL(`node_modules/${name}/LICENSE`, import.meta.url), "utf-8").trim()}`;

/** A comment for the head of a script: whose libraries are in it, and under which licences. */
export const notice = `/*!\nThis file holds groundslab's own code and these libraries:\n\n${LIBRARIES.map(read).join("\n\n")}\n*/`;
