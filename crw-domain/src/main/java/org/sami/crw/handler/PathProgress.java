package org.sami.crw.handler;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.Value;

/**
 * How far boats are along paths, kept per mission, path and boat in the engine's journalled memory (DESIGN, Commands and
 * missions). A path is known by its points alone: the same points in another variable or activation are the same path.
 */
final class PathProgress {
    private static final int DIGEST_BYTES = 12;

    private PathProgress() {}

    /** The key in the mission's memory. */
    static String key(String boat, GeoPath path) {
        ByteBuffer bytes = ByteBuffer.allocate(path.points().size() * 2 * Double.BYTES);
        for (GeoPoint point : path.points()) {
            bytes.putDouble(point.latDeg()).putDouble(point.lonDeg());
        }
        byte[] digest = sha256().digest(bytes.array());
        return "path/" + boat + "/" + HexFormat.of().formatHex(digest, 0, DIGEST_BYTES);
    }

    /** Number of points that are behind the boat. */
    static int visited(HandlerContext context, long mission, String key, int size) {
        Value remembered = context.query(view -> view.memory(mission, key)).orElse(new IntegerValue(0));
        long visited = remembered instanceof IntegerValue number ? number.value() : 0;
        return (int) Math.max(0, Math.min(visited, size));
    }

    static Input remember(long mission, String key, int visited) {
        return new Input.Remember(mission, key, new IntegerValue(visited));
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("Every Java platform has SHA-256", e);
        }
    }
}
