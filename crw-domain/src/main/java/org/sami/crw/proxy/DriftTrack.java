package org.sami.crw.proxy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.BoatMode;
import org.sami.crw.proxy.status.Drift;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.value.GeoPoint;

/**
 * Estimates how a boat that rests or holds its place is carried over ground (docs/operator-models.md). A boat's own speed is that through the water along its heading: it is
 * zero while a current takes the boat away.
 *
 * <p>Positions of the last {@link #WINDOW_MS} are compared with those half the window later; of these displacements the median counts, east and north each, so that no
 * jump of the receiver moves it. A drift is reported only where that displacement is beyond the noise of the boat's position.
 */
final class DriftTrack {
    static final long WINDOW_MS = 120_000;

    private static final long SHORTEST_MS = 40_000;
    private static final long SPACING_MS = 900; // one of each second; more would be the same error again
    private static final int PLACED_BY =
            9; // so many positions, by their median, say where the boat was left, and where it is
    private static final double LEAST_M = 2;

    /** A receiver's error is nearly the same a second later, so that a median of half a window has nearly the deviation of one position: exceeded once in many hours. */
    private static final double DEVIATIONS = 4;

    private final List<Sample> samples = new ArrayList<>();
    private Kind kind = Kind.MOVES;
    private @Nullable LocalPlane plane; // around where the boat was first seen at rest
    private double[] leftAt = {};
    private int placed; // by so many positions
    private Optional<Drift> estimated = Optional.empty();
    private boolean changed;

    private enum Kind {
        MOVES,
        RESTS,
        HOLDS;

        static Kind of(BoatMode mode) {
            return switch (mode) {
                case STOPPED, FLEET_STOP -> RESTS;
                case HOLD -> HOLDS;
                default -> MOVES;
            };
        }
    }

    private record Sample(long atMs, double eastM, double northM) {}

    /** The boat has said where it is, and what it does. */
    void says(GeoPoint position, BoatMode mode, long boatTimeMs) {
        Kind now = Kind.of(mode);
        boolean restarted = !samples.isEmpty() && boatTimeMs < last().atMs; // the boat's server, and with it its clock
        if (now != kind || restarted) {
            samples.clear();
            placed = 0;
            kind = now;
            estimated = Optional.empty();
            changed = false;
        }
        if (kind == Kind.MOVES || (!samples.isEmpty() && boatTimeMs - last().atMs < SPACING_MS)) {
            return;
        }
        LocalPlane around = plane;
        if (around == null || (samples.isEmpty() && placed == 0)) {
            around = new LocalPlane(position);
            plane = around;
        }
        samples.add(new Sample(boatTimeMs, around.x(position), around.y(position)));
        while (boatTimeMs - samples.get(0).atMs > WINDOW_MS) {
            samples.remove(0);
        }
        if (placed < PLACED_BY) {
            placed++;
            leftAt = median(samples);
        }
        changed = true;
    }

    private Sample last() {
        return samples.get(samples.size() - 1);
    }

    /**
     * How the boat is carried; empty for one that drives, or has not said where it is.
     *
     * @param positionM standard deviation of the position that the boat knows; empty where that is not known
     */
    Optional<Drift> drift(OptionalDouble positionM) {
        if (changed && plane != null) {
            changed = false;
            estimated = Optional.of(estimate(plane, positionM.orElse(CrossTrackError.FIELD.positionM())));
        }
        return estimated;
    }

    private Drift estimate(LocalPlane around, double positionM) {
        double[] here = median(samples.subList(Math.max(0, samples.size() - PLACED_BY), samples.size()));
        GeoPoint left = around.point(leftAt[0], leftAt[1]);
        double awayM = Math.hypot(here[0] - leftAt[0], here[1] - leftAt[1]);
        int half = samples.size() / 2;
        long spanMs = last().atMs - samples.get(0).atMs;
        if (spanMs < SHORTEST_MS) {
            return new Drift(0, 0, left, awayM);
        }
        double[] east = new double[samples.size() - half];
        double[] north = new double[east.length];
        for (int i = 0; i < east.length; i++) {
            Sample from = samples.get(i);
            Sample to = samples.get(i + half);
            double seconds = (to.atMs - from.atMs) / 1000.0;
            east[i] = (to.eastM - from.eastM) / seconds;
            north[i] = (to.northM - from.northM) / seconds;
        }
        double eastMps = median(east);
        double northMps = median(north);
        double speedMps = Math.hypot(eastMps, northMps);
        boolean beyondNoise = speedMps * spanMs / 2000 >= Math.max(LEAST_M, DEVIATIONS * positionM);
        return beyondNoise
                ? new Drift(speedMps, Math.atan2(eastMps, northMps), left, awayM)
                : new Drift(0, 0, left, awayM);
    }

    private static double[] median(List<Sample> of) {
        return new double[] {
            median(of.stream().mapToDouble(Sample::eastM).toArray()),
            median(of.stream().mapToDouble(Sample::northM).toArray())
        };
    }

    private static double median(double[] values) {
        Arrays.sort(values);
        int middle = values.length / 2;
        return values.length % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
    }
}
