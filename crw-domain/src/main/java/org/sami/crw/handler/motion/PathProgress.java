package org.sami.crw.handler.motion;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.Value;

/**
 * How far boats are along paths, kept per mission, path and boat in the engine's journalled memory (docs/services.md). A path is known by its
 * points alone: the same points in another variable or activation are the same path. At other altitudes an aircraft's path is another one.
 */
public final class PathProgress {
    private static final int DIGEST_BYTES = 12;

    private PathProgress() {}

    /**
     * Where a command's progress is remembered.
     *
     * @param key in the mission's memory
     * @param behind points that were visited before the first one of the command
     */
    public record Along(String key, int behind) {

        /** So many points of the command are visited. */
        Input remember(long mission, int visited) {
            return new Input.Remember(mission, key, new IntegerValue(behind + visited));
        }
    }

    /** The key in the mission's memory. */
    public static String key(String boat, GeoPath path) {
        return "path/" + boat + "/" + digest(path.points());
    }

    /** The same for an aircraft's path: the points have the altitudes at which the plan wants them. */
    public static String flightKey(String aircraft, GeoPath path) {
        ByteBuffer altitudes = ByteBuffer.allocate(path.points().size() * Double.BYTES);
        path.points().forEach(point -> altitudes.putDouble(point.altM()));
        return "flight/" + aircraft + "/" + digest(path.points()) + "/" + digest(altitudes.array());
    }

    /** The key of a list that a boat goes through one by one. */
    static String listKey(String boat, List<GeoPoint> locations) {
        return "list/" + boat + "/" + digest(locations);
    }

    private static String digest(List<GeoPoint> points) {
        ByteBuffer bytes = ByteBuffer.allocate(points.size() * 2 * Double.BYTES);
        for (GeoPoint point : points) {
            bytes.putDouble(point.latDeg()).putDouble(point.lonDeg());
        }
        return digest(bytes.array());
    }

    private static String digest(byte[] bytes) {
        return HexFormat.of().formatHex(sha256().digest(bytes), 0, DIGEST_BYTES);
    }

    /**
     * The number of visited points, as known by the mission, its parents and its sub-missions. Sibling missions do not count: a sub-mission that
     * starts again begins its path again.
     */
    public static int visited(HandlerContext context, long mission, String key, int size) {
        long visited = context.query(view -> line(view, mission)
                .map(one -> number(view.memory(one, key)))
                .max()
                .orElse(0));
        return (int) Math.max(0, Math.min(visited, size));
    }

    private static long number(Optional<Value> remembered) {
        return remembered.orElse(null) instanceof IntegerValue number ? number.value() : 0;
    }

    /** The mission, those that run it, and those that it runs. */
    private static LongStream line(EngineView view, long mission) {
        LongStream descendants = view.missions().stream()
                .mapToLong(MissionView::id)
                .filter(other -> other != mission && runs(view, mission, other));
        LongStream upwards = LongStream.iterate(mission, one -> one != Ids.NONE, one -> parent(view, one));
        return LongStream.concat(upwards, descendants);
    }

    private static boolean runs(EngineView view, long mission, long other) {
        return LongStream.iterate(other, one -> one != Ids.NONE, one -> parent(view, one))
                .anyMatch(one -> one == mission);
    }

    private static long parent(EngineView view, long mission) {
        return view.mission(mission).map(MissionView::parent).orElse(Ids.NONE);
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("Every Java platform has SHA-256", e);
        }
    }
}
