package org.sami.boat.server.traffic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.NoGoEdge;
import org.sami.boat.link.NoGoEdges;
import org.sami.boat.server.vehicle.LocalFrame;

class NoGoBorderTest {
    private static final LocalFrame PLANE = new LocalFrame(45.7, 10.72);

    /** Of a square rock whose north-western corner is the plane's origin; inside to starboard. */
    private static NoGoBorder rock(double sideM, double keepM) {
        return NoGoBorder.of(
                new NoGoEdges(
                        keepM,
                        List.of(
                                edge(0, 0, sideM, 0),
                                edge(sideM, 0, sideM, -sideM),
                                edge(sideM, -sideM, 0, -sideM),
                                edge(0, -sideM, 0, 0))),
                PLANE);
    }

    private static NoGoEdge edge(double fromEastM, double fromNorthM, double toEastM, double toNorthM) {
        return new NoGoEdge(
                PLANE.latDeg(fromEastM, fromNorthM),
                PLANE.lonDeg(fromEastM, fromNorthM),
                PLANE.latDeg(toEastM, toNorthM),
                PLANE.lonDeg(toEastM, toNorthM));
    }

    @Test
    void aBoatOnTheCornerOfARockGoesAwayFromBothEdges() {
        NoGoBorder border = rock(10, 2);
        LineAhead lineToTheWest = new LineAhead(0, 3, 50, 50);

        border.measure(0, 0, Segment.between(0, 0, 0, 0), lineToTheWest, 5);

        assertThat(border.off())
                .hasValueSatisfying(off -> assertThat(off.courseRad()).isBetween(-Math.PI / 2 - 1e-6, 1e-6));
    }

    @Test
    void aBoatInsideARockGoesOutAcrossTheNearestEdge() {
        NoGoBorder border = rock(10, 2);
        LineAhead lineToTheWest = new LineAhead(0, 4, 50, 50);

        border.measure(1, -5, Segment.between(1, -5, 1, -5), lineToTheWest, 5);

        assertThat(border.off()).hasValueSatisfying(off -> {
            assertThat(off.courseRad() % (2 * Math.PI)).isCloseTo(1.5 * Math.PI, within(1e-6));
            assertThat(off.aheadM()).isCloseTo(1 + 2, within(1e-3));
        });
    }
}
