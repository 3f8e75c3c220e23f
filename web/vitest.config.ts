// Tests run in Node; those that need a document say so in their first line.
import { defineConfig } from "vitest/config";

// the schema and the examples of the program lie beside web/
export default defineConfig({
  test: { include: ["tests/**/*.test.ts"], environment: "node" },
  server: { fs: { allow: [".."] } },
});
