// The schema of the case file as the program writes it.
import text from "../../../docs/groundslab.schema.json?raw";
import type { Table } from "../../src/workbench/model/paths";
import { Schema } from "../../src/workbench/model/schema";

export const schema = new Schema(JSON.parse(text) as Table);
