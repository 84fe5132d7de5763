// Writes src/gen/types.ts: TypeScript types of the service's calls (openapi.json) and of the files it speaks (../schema).
import {mkdirSync, readFileSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const read = (file) => JSON.parse(readFileSync(join(web, file), "utf8"));
const capital = (name) => name[0].toUpperCase() + name.slice(1);
const files = {"scene.schema.json": "Scene", "layout.schema.json": "Layout"};

// The name of what a $ref points to; each schema file's definitions carry its name in front.
const ref_name = (ref, self) => {
  const [file, pointer] = ref.split("#");
  const last = pointer.split("/").at(-1);
  if (pointer.startsWith("/components/")) return last;
  return files[file || self] + capital(last);
};

function object_type(schema, self) {
  const required = new Set(schema.required ?? []);
  const members = Object.entries(schema.properties ?? {}).map(
    ([name, value]) => `${JSON.stringify(name)}${required.has(name) ? "" : "?"}: ${type_of(value, self)};`,
  );
  const extra = schema.additionalProperties;
  if (typeof extra === "object") members.push(`[name: string]: ${type_of(extra, self)};`);
  if (members.length === 0) return "Record<string, unknown>";
  return `{ ${members.join(" ")} }`;
}

function array_type(schema, self) {
  if (Array.isArray(schema.items)) return `[${schema.items.map((item) => type_of(item, self)).join(", ")}]`;
  const item = type_of(schema.items ?? {}, self);
  const few = schema.minItems === schema.maxItems && schema.minItems >= 2 && schema.minItems <= 4;
  return few ? `[${Array(schema.minItems).fill(item).join(", ")}]` : `(${item})[]`;
}

function type_of(schema, self) {
  if (schema === true || schema === undefined) return "unknown";
  if (schema.$ref) return ref_name(schema.$ref, self);
  if ("const" in schema) return JSON.stringify(schema.const);
  if (schema.enum) return schema.enum.map((value) => JSON.stringify(value)).join(" | ");
  const choice = schema.oneOf ?? schema.anyOf;
  if (choice) return choice.map((one) => `(${type_of(one, self)})`).join(" | ");
  if (Array.isArray(schema.type)) return schema.type.map((type) => type_of({...schema, type}, self)).join(" | ");
  switch (schema.type) {
    case "object": return object_type(schema, self);
    case "array": return array_type(schema, self);
    case "integer": case "number": return "number";
    case "string": return "string";
    case "boolean": return "boolean";
    case "null": return "null";
    default: return "unknown";
  }
}

const api = read("openapi.json");
const out = ["// Made by tools/types.mjs from openapi.json and ../schema; not to be edited.", ""];
for (const [file, name] of Object.entries(files)) {
  const schema = read(join("../schema", file));
  out.push(`export type ${name} = ${type_of(schema, file)};`);
  for (const [part, value] of Object.entries(schema.definitions ?? {})) {
    out.push(`export type ${name}${capital(part)} = ${type_of(value, file)};`);
  }
}
for (const [name, schema] of Object.entries(api.components.schemas)) {
  if (!Object.values(files).includes(name)) out.push(`export type ${name} = ${type_of(schema, "")};`);
}
for (const methods of Object.values(api.paths)) {
  for (const call of Object.values(methods)) {
    const body = call.requestBody?.content["application/json"]?.schema;
    const done = Object.entries(call.responses).find(([status]) => status.startsWith("2"));
    const answer = done?.[1].content?.["application/json"]?.schema;
    const name = capital(call.operationId);
    if (body) out.push(`export type ${name}Request = ${type_of(body, "")};`);
    if (answer && !answer.format) out.push(`export type ${name}Answer = ${type_of(answer, "")};`);
  }
}
mkdirSync(join(web, "src/gen"), {recursive: true});
writeFileSync(join(web, "src/gen/types.ts"), `${out.join("\n")}\n`);
