package citrine_spy;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

import citrine_lcm.octree_t;

/** How high the highest occupied cell of the map is above each cell of the ground, from MAP_OCTREE. */
final class OctreeHeights {
  /** A square of the ground, by its lower corner in cells of the octree. */
  record Cell(int x, int y) {}

  private static final int DEPTH = 16;  // of OctoMap's trees: 2^16 leaves along an edge, the middle at zero
  private static final int MOST_CHUNKS = 1 << 14;
  private static final int LARGEST_PRUNED = 64;  // cells along the edge of an occupied leaf that is believed

  private byte[][] chunks = {};
  private long version = -1;
  private byte[] bytes;
  private int at;
  private Map<Cell, Integer> found;

  /** Gathers chunks. @return the heights in cells, once a whole octree is there, else null */
  Map<Cell, Integer> add(octree_t message) {
    if (message.num_chunks < 1 || message.num_chunks > MOST_CHUNKS || message.chunk < 0
        || message.chunk >= message.num_chunks) {
      return null;
    }
    if (message.map_version != version || message.num_chunks != chunks.length) {
      version = message.map_version;
      chunks = new byte[message.num_chunks][];
    }
    chunks[message.chunk] = message.data;
    ByteArrayOutputStream whole = new ByteArrayOutputStream();
    for (byte[] chunk : chunks) {
      if (chunk == null) return null;
      whole.writeBytes(chunk);
    }
    return parse(whole.toByteArray());
  }

  /** OctoMap's .bt: a header of text, then for each inner node two bits a child, depth first. */
  private Map<Cell, Integer> parse(byte[] stream) {
    String head = new String(stream, 0, Math.min(stream.length, 400), StandardCharsets.ISO_8859_1);
    int data = head.indexOf("\ndata\n");
    if (data < 0) return null;
    bytes = stream;
    at = data + 6;
    found = new HashMap<>();
    try {
      if (at < bytes.length) readNode(-(1 << DEPTH - 1), -(1 << DEPTH - 1), -(1 << DEPTH - 1), 1 << DEPTH);
    } catch (ArrayIndexOutOfBoundsException cutShort) {
      return null;
    }
    return found;
  }

  private void readNode(int x, int y, int z, int size) {
    int low = bytes[at++] & 0xff, high = bytes[at++] & 0xff, half = size / 2;
    for (int child = 0; child < 8; child++) {
      int bits = (child < 4 ? low >> 2 * child : high >> 2 * (child - 4)) & 3;
      int cx = x + (child & 1) * half, cy = y + (child >> 1 & 1) * half, cz = z + (child >> 2 & 1) * half;
      if (bits == 3 && half > 1) {
        readNode(cx, cy, cz, half);
      } else if (bits == 2 && half <= LARGEST_PRUNED) {
        occupy(cx, cy, cz + half, half);
      }
    }
  }

  private void occupy(int x, int y, int top, int size) {
    for (int dy = 0; dy < size; dy++)
      for (int dx = 0; dx < size; dx++) found.merge(new Cell(x + dx, y + dy), top, Math::max);
  }
}
