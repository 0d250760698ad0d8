package org.sami.crw.proxy.execution;

import java.util.Optional;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoPoint;

/**
 * Whether a boat that should follow its path comes nearer to its next point. One that does not is aground, caught in weeds, or
 * weaker than the wind: nothing that the boat itself notices.
 */
public final class ProgressMonitor {
    /** After so long the operator sees it. */
    static final long SHOWN_AFTER_MS = CommandDefaults.NO_PROGRESS_SHOWN_AFTER_MS;

    /** After so long the path counts as one that cannot be followed. */
    static final long FAILED_AFTER_MS = CommandDefaults.NO_PROGRESS_FAILED_AFTER_MS;

    private static final double LEAST_M = 2; // what the noise of positions does not feign again and again

    private Optional<LocalPlane> around = Optional.empty(); // the next point
    private double nearestM = Double.POSITIVE_INFINITY;
    private int next = -1;
    private long sinceMs;
    private long nowMs;

    /** Counts from this time. */
    ProgressMonitor(long nowMs) {
        sinceMs = nowMs;
        this.nowMs = nowMs;
    }

    /** Counts from zero again: the boat has no reason to come nearer now. */
    void pause(long atMs) {
        sinceMs = atMs;
        nowMs = atMs;
    }

    /** The boat is at a position, on its way to the point with this index. */
    void at(GeoPoint position, int index, GeoPoint point, long atMs) {
        if (index != next || around.isEmpty()) {
            around = Optional.of(new LocalPlane(point));
        }
        double leftM = around.get().distanceM(position);
        if (index != next || leftM < nearestM - LEAST_M) {
            next = index;
            nearestM = leftM;
            sinceMs = atMs;
        }
        nowMs = atMs;
    }

    /** For how long the boat has come no nearer, in ms, as of the last position. */
    long noneForMs() {
        return nowMs - sinceMs;
    }

    /** Whether the boat has made no headway for long enough to notify the operator. */
    public boolean isShown() {
        return noneForMs() >= SHOWN_AFTER_MS;
    }

    boolean isHopeless() {
        return noneForMs() >= FAILED_AFTER_MS;
    }

    /** The same in words. */
    public String words() {
        return "it has come no nearer to point " + (next + 1) + " for " + noneForMs() / 1000 + " s";
    }
}
