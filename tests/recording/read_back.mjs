// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Are recordings what readers of others expect? See read_back.
// usage: node read_back.mjs LAYOUT RECORDING...
import assert from "node:assert/strict";
import { open, readFile } from "node:fs/promises";
import { createRequire } from "node:module";

import Ajv from "ajv";
import { McapIndexedReader, McapStreamReader, McapWriter } from "@mcap/core";

const foxglove = createRequire(import.meta.url)("@foxglove/schemas/jsonschema");
const FRAMES = new Set(["map", "site", "vehicle", "trailer"]);

/** Bytes as what the indexed reader reads from. */
const readable = (bytes) => ({
  size: async () => BigInt(bytes.length),
  read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
});

/** All messages by the index, sorted by time; every checksum that the index leads to is tested. */
async function readByIndex(bytes) {
  const reader = await McapIndexedReader.Initialize({ readable: readable(bytes) });
  const messages = [];
  for await (const message of reader.readMessages()) messages.push(message);
  return { reader, messages };
}

/** All records from the begin to the end. */
function readStream(bytes) {
  const reader = new McapStreamReader({ validateCrcs: true });
  reader.append(bytes);
  const records = [];
  for (let record; (record = reader.nextRecord()); ) records.push(record);
  assert.ok(reader.done(), "the stream ends too soon");
  return records;
}

/** What McapWriter writes of the same messages. */
async function written(records, library) {
  const pieces = [];
  let position = 0n;
  const writer = new McapWriter({
    writable: {
      position: () => position,
      write: async (piece) => {
        pieces.push(Buffer.from(piece));
        position += BigInt(piece.length);
      },
    },
  });
  await writer.start({ profile: "", library });
  const schemas = new Map();
  const channels = new Map();
  for (const record of records) {
    if (record.type === "Schema" && !schemas.has(record.id)) {
      schemas.set(record.id, await writer.registerSchema(record));
    } else if (record.type === "Channel" && !channels.has(record.id)) {
      channels.set(record.id, await writer.registerChannel({ ...record, schemaId: schemas.get(record.schemaId) }));
    } else if (record.type === "Message") {
      await writer.addMessage({ ...record, channelId: channels.get(record.channelId) });
    }
  }
  await writer.end();
  return Buffer.concat(pieces);
}

/** Times of all timestamps in a message [ns]. */
function* timestampsIn(value) {
  if (Array.isArray(value)) for (const item of value) yield* timestampsIn(item);
  else if (value !== null && typeof value === "object") {
    if (value.timestamp) yield BigInt(value.timestamp.sec) * 1_000_000_000n + BigInt(value.timestamp.nsec);
    for (const item of Object.values(value)) yield* timestampsIn(item);
  }
}

/** Frames that a message names. */
function* framesIn(value) {
  if (Array.isArray(value)) for (const item of value) yield* framesIn(item);
  else if (value !== null && typeof value === "object") {
    for (const [key, item] of Object.entries(value)) {
      if (key.endsWith("frame_id")) yield item;
      else yield* framesIn(item);
    }
  }
}

/** What our schema names is in theirs, with the same type. */
function expectPartOf(ours, theirs, where) {
  if (theirs.oneOf) return assert.equal(ours.type, "integer", where);
  assert.equal(ours.type, theirs.type, where);
  assert.equal(ours.contentEncoding, theirs.contentEncoding, where);
  if (ours.items) expectPartOf(ours.items, theirs.items, `${where}[]`);
  for (const [name, schema] of Object.entries(ours.properties ?? {})) {
    assert.ok(theirs.properties[name], `${where}.${name} is not Foxglove's`);
    expectPartOf(schema, theirs.properties[name], `${where}.${name}`);
  }
}

/** Tests schemas and messages; returns how many messages there are of each topic. */
function checkMessages(file, reader, messages) {
  const ajv = new Ajv({ strict: false });
  const decoder = new TextDecoder("utf-8", { fatal: true });
  const checks = new Map();
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    assert.equal(channel.messageEncoding, "json");
    assert.equal(schema.encoding, "jsonschema");
    const ours = JSON.parse(decoder.decode(schema.data));
    const [maker, name] = schema.name.split(".");
    if (maker === "foxglove") expectPartOf(ours, foxglove[name], schema.name);
    else assert.equal(maker, "vandplan");
    const all = [ours, ...(maker === "foxglove" ? [foxglove[name]] : [])];
    checks.set(channel.id, all.map((one) => ajv.compile(one)));
  }
  const counts = {};
  const sequences = new Map();
  for (const { channelId, sequence, logTime, publishTime, data } of messages) {
    const { topic } = reader.channelsById.get(channelId);
    counts[topic] = (counts[topic] ?? 0) + 1;
    assert.equal(sequence, sequences.get(channelId) ?? 0, "a message is missing");
    sequences.set(channelId, sequence + 1);
    assert.equal(publishTime, logTime);
    const json = JSON.parse(decoder.decode(data));
    for (const check of checks.get(channelId)) {
      assert.ok(check(json), `${file}: ${topic}: ${ajv.errorsText(check.errors)}`);
    }
    for (const time of timestampsIn(json)) assert.equal(time, logTime, topic);
    for (const frame of framesIn(json)) assert.ok(FRAMES.has(frame), `${topic}: ${frame}`);
  }
  return counts;
}

/** Damaged files are refused, each at its place. */
async function checkDamage(bytes, reader) {
  const chunk = reader.chunkIndexes[0];
  const places = {
    "in a chunk": Number(chunk.chunkStartOffset + chunk.chunkLength / 2n),
    "in the summary": Number(reader.footer.summaryStart) + 20,
    "in the magic bytes": bytes.length - 3,
  };
  for (const [where, place] of Object.entries(places)) {
    const damaged = Buffer.from(bytes);
    damaged[place] ^= 1;
    await assert.rejects(readByIndex(damaged), undefined, `a wrong bit ${where} is not seen`);
  }
  for (const size of [0, bytes.length >> 1, bytes.length - 1]) {
    await assert.rejects(readByIndex(bytes.subarray(0, size)), undefined, `${size} bytes are taken for a whole file`);
  }
}

async function check(file) {
  const bytes = await readFile(file);
  const { reader, messages } = await readByIndex(bytes);
  const counts = checkMessages(file, reader, messages);
  assert.match(reader.header.library, /^vandplan \d+\.\d+\.\d+$/);

  const { statistics, chunkIndexes } = reader;
  assert.equal(statistics.messageCount, BigInt(messages.length));
  assert.equal(statistics.chunkCount, chunkIndexes.length);
  assert.equal(statistics.messageStartTime, messages[0].logTime);
  assert.equal(statistics.messageEndTime, messages.at(-1).logTime);
  for (const [id, count] of statistics.channelMessageCounts) {
    assert.equal(count, BigInt(counts[reader.channelsById.get(id).topic]));
  }
  for (const index of chunkIndexes) assert.ok(index.messageIndexOffsets.size > 0);

  const records = readStream(bytes);
  assert.equal(records.filter(({ type }) => type === "Message").length, messages.length);
  const again = await written(records, reader.header.library);
  assert.ok(again.equals(bytes), `${file}: another writer writes other bytes of the same messages`);
  await checkDamage(bytes, reader);
  console.log(`${file}: ${messages.length} messages, ${chunkIndexes.length} chunks`);
  return counts;
}

/** Panels of a layout are there, and all of its topics are recorded. */
async function checkLayout(file, topics) {
  const layout = JSON.parse(await readFile(file, "utf-8"));
  const panelsIn = (node) => (typeof node === "string" ? [node] : [...panelsIn(node.first), ...panelsIn(node.second)]);
  assert.deepEqual(panelsIn(layout.layout).sort(), Object.keys(layout.configById).sort());
  const named = new Set();
  for (const panel of Object.values(layout.configById)) {
    for (const topic of Object.keys(panel.topics ?? {})) named.add(topic);
    for (const { value } of [...(panel.paths ?? []), ...(panel.xAxisPath ? [panel.xAxisPath] : [])]) named.add(value.split(".")[0]);
    if (panel.topicToRender) named.add(panel.topicToRender);
    if (panel.topicPath) named.add(panel.topicPath.split(".")[0]);
  }
  for (const topic of named) assert.ok(topics.has(topic), `${file}: no recording has ${topic}`);
  for (const topic of topics) {
    assert.ok(named.has(topic) || topic.startsWith("/tf/"), `${file}: ${topic} is not shown`);
  }
}

const [layout, ...files] = process.argv.slice(2);
const topics = new Set();
for (const file of files) for (const topic of Object.keys(await check(file))) topics.add(topic);
await checkLayout(layout, topics);
