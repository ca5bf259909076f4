// Reads an MCAP file with the reader of its inventors and decodes every message by the schema that lies in the file alone.
// Says what it found as JSON: counts and samples, for the test to hold against the mission.
import { open } from "node:fs/promises";
import { createRequire } from "node:module";

const require = createRequire(process.argv[3] + "/");
const { McapIndexedReader } = require("@mcap/core");
const { decompress } = require("fzstd");
const protobuf = require("protobufjs");
require("protobufjs/ext/descriptor");

const file = await open(process.argv[2]);
const readable = {
  size: async () => BigInt((await file.stat()).size),
  read: async (offset, length) => {
    const bytes = new Uint8Array(Number(length));
    await file.read(bytes, 0, Number(length), Number(offset));
    return bytes;
  },
};
const reader = await McapIndexedReader.Initialize({
  readable,
  decompressHandlers: { zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))) },
});

const typeOf = new Map();
for (const [id, schema] of reader.schemasById) {
  const set = protobuf.Root.fromDescriptor(schema.data);
  set.resolveAll();
  typeOf.set(id, set.lookupType(schema.name));
}

const topics = {};
let inOrder = true;
let last = 0n;
for await (const message of reader.readMessages()) {
  inOrder &&= message.logTime >= last;
  last = message.logTime;
  const channel = reader.channelsById.get(message.channelId);
  const type = typeOf.get(channel.schemaId);
  const decoded = type.toObject(type.decode(message.data), { longs: Number, enums: String });
  const topic = (topics[channel.topic] ??= { schema: type.fullName.slice(1), count: 0 });
  topic.count += 1;
  topic.last = decoded;
  if (decoded.data) {
    topic.last = { ...decoded, data: undefined, points: decoded.data.length / decoded.point_stride };
    const view = new DataView(decoded.data.buffer, decoded.data.byteOffset, decoded.data.length);
    if (decoded.data.length > 0) topic.last.firstPoint = [0, 4, 8].map((at) => view.getFloat32(at, true));
  }
}
const attachments = [];
for await (const each of reader.readAttachments()) {
  attachments.push({ name: each.name, text: new TextDecoder().decode(each.data) });
}
const metadata = {};
for await (const each of reader.readMetadata()) metadata[each.name] = Object.fromEntries(each.metadata);
console.log(
  JSON.stringify({
    topics,
    inOrder,
    attachments,
    metadata,
    statistics: { messages: Number(reader.statistics.messageCount), chunks: reader.chunkIndexes.length },
  }),
);
