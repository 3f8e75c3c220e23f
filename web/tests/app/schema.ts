// The schema of the case file as the program writes it.
import text from "../../../docs/groundslab.schema.json?raw";
import { Schema } from "../../src/app/form/schema";
import type { Table } from "../../src/app/paths";

export const schema = new Schema(JSON.parse(text) as Table);
