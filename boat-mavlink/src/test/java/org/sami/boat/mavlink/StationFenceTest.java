package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.mavlink.mission.MissionItem;

/** Where a fence lets a boat be, and which ways lead out of it. */
class StationFenceTest {
    /** A square of 2 by 2 hundredths of a degree with a square hole in its middle. */
    private static final StationFence RING = StationFenceItems.fence(FencePart.list(
            FencePart.square(FencePart.INCLUSION, 45, 10, 0.01), FencePart.square(FencePart.EXCLUSION, 45, 10, 0.002)));

    private static Position at(double north, double east) {
        return new Position(45 + north, 10 + east);
    }

    @ParameterizedTest
    @CsvSource({
        "0.005, 0.005, true",
        "0, 0, false", // in the hole
        "0.011, 0, false",
        "0, -0.011, false",
        "0.0099, 0.0099, true"
    })
    void aPlaceIsInsideOfTheInclusionAndOutsideOfTheExclusion(double north, double east, boolean inside) {
        assertThat(RING.isInside(at(north, east))).isEqualTo(inside);
    }

    @ParameterizedTest
    @CsvSource({
        "0.005, -0.005, 0.005, 0.005, false",
        "0, -0.005, 0, 0.005, true", // through the hole
        "-0.0041, 0, 0, 0.0041, false", // past its corner
        "-0.0039, 0, 0, 0.0039, true", // over its corner
        "0.005, 0, 0.02, 0, true",
        "0.02, 0, 0.005, 0, false", // from outside in
        "0.02, 0, 0.03, 0, true",
        "0, 0, 0, 0.005, false", // out of the hole
        "0.02, 0, -0.005, 0, true", // in, and then through the hole
        "0.005, 0.005, 0.005, 0.005, false"
    })
    void aWayLeadsOutWhereItEndsOutsideOrLeavesTheFence(
            double north, double east, double toNorth, double toEast, boolean leadsOut) {
        assertThat(RING.leadsOut(at(north, east), at(toNorth, toEast))).isEqualTo(leadsOut);
    }

    @Test
    void aCircleIsAsWideAsItsRadius() {
        StationFence fence = StationFenceItems.fence(FencePart.circle(FencePart.CIRCLE_INCLUSION, 60, 10, 1_000));
        double north = 1_000 / 111_412.0; // metres of a degree of latitude there
        double east = 1_000 / 55_800.0; // and of longitude

        assertThat(fence.isInside(new Position(60 + north * 0.998, 10))).isTrue();
        assertThat(fence.isInside(new Position(60 + north * 1.002, 10))).isFalse();
        assertThat(fence.isInside(new Position(60, 10 + east * 0.998))).isTrue();
        assertThat(fence.isInside(new Position(60, 10 + east * 1.002))).isFalse();
    }

    @Test
    void aWayThroughAnExcludedCircleLeadsOut() {
        StationFence fence = StationFenceItems.fence(FencePart.circle(FencePart.CIRCLE_EXCLUSION, 45, 10, 100));

        assertThat(fence.leadsOut(at(0, -0.01), at(0, 0.01))).isTrue();
        assertThat(fence.leadsOut(at(0.00091, -0.01), at(0.00091, 0.01))).isFalse();
        assertThat(fence.leadsOut(at(0.00089, -0.01), at(0.00089, 0.01))).isTrue();
    }

    @Test
    void aBoatIsInAllZonesOfOneGroup() {
        MissionItem west = FencePart.item(FencePart.CIRCLE_INCLUSION, 45, 9.999, 100, 0);
        MissionItem east = FencePart.item(FencePart.CIRCLE_INCLUSION, 45, 10.001, 100, 0);
        MissionItem eastOfOtherGroup = FencePart.item(FencePart.CIRCLE_INCLUSION, 45, 10.001, 100, 1);
        StationFence both = StationFenceItems.fence(List.of(west, east));
        StationFence either = StationFenceItems.fence(List.of(west, eastOfOtherGroup));

        assertThat(both.isInside(at(0, 0))).isTrue();
        assertThat(both.isInside(at(0, 0.001))).isFalse();
        assertThat(either.isInside(at(0, 0.001))).isTrue();
        assertThat(either.leadsOut(at(0, -0.001), at(0, 0.001))).isFalse(); // from the one into the other
        assertThat(either.isInside(at(0, 0.003))).isFalse();
    }

    @Test
    void aFenceMayCrossTheDateLine() {
        StationFence fence = StationFenceItems.fence(FencePart.polygon(
                FencePart.INCLUSION, new double[][] {{-17, 179.9}, {-16.8, 179.9}, {-16.8, -179.9}, {-17, -179.9}}));

        assertThat(fence.isInside(new Position(-16.9, 179.95))).isTrue();
        assertThat(fence.isInside(new Position(-16.9, -179.95))).isTrue();
        assertThat(fence.isInside(new Position(-16.9, 179.85))).isFalse();
        assertThat(fence.leadsOut(new Position(-16.9, 179.95), new Position(-16.9, -179.95)))
                .isFalse();
        assertThat(fence.leadsOut(new Position(-16.9, -179.95), new Position(-16.9, -179.85)))
                .isTrue();
    }

    @Test
    void withoutAFenceABoatMayBeEverywhere() {
        assertThat(StationFence.NONE.isInside(at(0, 0))).isTrue();
        assertThat(StationFence.NONE.leadsOut(at(0, 0), at(1, 1))).isFalse();
    }
}
