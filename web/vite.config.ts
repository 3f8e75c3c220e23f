// The workbench: a folder of files that groundslab's server hands out.
import { defineConfig } from "vite";

import { notice } from "./notice.ts";

export default defineConfig({
  root: "src/workbench",
  base: "./",
  build: {
    outDir: "../../../src/groundslab/workbench/static",
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0,
    rolldownOptions: {
      output: {
        postBanner: notice("smol-toml", "three", "uplot"),
        entryFileNames: "[name].js",
        chunkFileNames: "[name].js",
        assetFileNames: "[name][extname]",
      },
    },
  },
});
