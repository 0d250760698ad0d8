package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;

class ChangeMomentTest {
    private static final LocalFrame FRAME = new LocalFrame(45.7, 10.72);
    private static final int ROW = 50;
    private static final int STOP = 300;

    /** Rows to and fro of 50 places, 3 m apart, at 1 m/s: a leg takes 3 s. */
    private static final List<Waypoint> ROWS =
            path(i -> i / ROW % 2 == 0 ? i % ROW : ROW - 1 - i % ROW, i -> i / ROW * 4);

    private static final List<Waypoint> STRAIGHT = path(i -> i, i -> i % 2 * 0.3);

    private final ChangeMoment moment = new ChangeMoment();

    private interface Place {
        double of(int index);
    }

    private static List<Waypoint> path(Place east, Place north) {
        return IntStream.range(0, 400)
                .mapToObj(i -> new Waypoint(
                        FRAME.latDeg(3 * east.of(i), 3 * north.of(i)),
                        FRAME.lonDeg(3 * east.of(i), 3 * north.of(i)),
                        1))
                .toList();
    }

    @Test
    void waitsForTheNextTurn() {
        for (int next = 101; next < 150; next++) {
            assertThat(moment.isNow(ROWS, next, STOP, next * 3_000L))
                    .as("to %d", next)
                    .isEqualTo(next == 101);
        }
        assertThat(moment.isNow(ROWS, 150, STOP, 450_000)).isTrue();
    }

    @Test
    void isOverOnceTheVehicleHasTurned() {
        assertThat(moment.isNow(ROWS, 150, STOP, 1_000)).isTrue();
        assertThat(moment.isNow(ROWS, 150, STOP, 1_500)).isTrue();
        assertThat(moment.isNow(ROWS, 150, STOP, 1_600)).isFalse();
    }

    @Test
    void doesNotWaitWhereNoTurnComes() {
        assertThat(moment.isNow(STRAIGHT, 120, STOP, 1_000)).isTrue();
        assertThat(moment.isNow(STRAIGHT, 120, STOP, 60_000)).isTrue();
    }

    @Test
    void doesNotWaitForATurnThatLeavesTooLittleTime() {
        assertThat(moment.isNow(ROWS, 252, 335, 0))
                .as("the turn at 299 leaves 114 s")
                .isFalse();
        assertThat(moment.isNow(ROWS, 253, 320, 60_000)).isTrue();
        assertThat(moment.isNow(ROWS, STOP, STOP, 120_000)).as("where it stops").isTrue();
    }
}
