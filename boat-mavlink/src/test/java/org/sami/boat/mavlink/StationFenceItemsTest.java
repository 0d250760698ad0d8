package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.mavlink.mission.MissionItem;

/** Which items are a fence. */
class StationFenceItemsTest {
    private static final List<MissionItem> SQUARE = FencePart.list(FencePart.square(FencePart.INCLUSION, 45, 10, 0.01));

    @ParameterizedTest
    @CsvSource({
        "5000, 45, 10, 0, ''",
        "5001, 45, 10, 3, ''",
        "5001, 45, 10, 2, fence item 0 is of a polygon of 2 corners",
        "5002, 45, 10, 3.5, fence item 0 is of a polygon of 3.5 corners",
        "5002, 45, 10, NaN, fence item 0 is of a polygon of NaN corners",
        "5002, 45, 10, 501, fence item 0 is of a polygon of 501 corners",
        "5001, 0, 0, 3, 'fence item 0 is at 0, 0'",
        "5001, -86, 10, 3, 'fence item 0 is at -86.0 degrees north, too near to a pole'",
        "5003, 45, 10, 20, ''",
        "5003, 45, 10, 0, fence item 0 is a circle with the radius 0.0",
        "5004, 45, 10, NaN, fence item 0 is a circle with the radius NaN",
        "5004, 45, 10, Infinity, fence item 0 is a circle with the radius Infinity",
        "5005, 45, 10, 20, fence item 0: a boat of SAMI has no command 5005",
        "16, 45, 10, 0, fence item 0: a boat of SAMI has no nav waypoint"
    })
    void eachItemIsJudgedByItself(int command, double lat, double lon, double param1, String why) {
        assertThat(StationFenceItems.whyNot(FencePart.item(command, lat, lon, param1, 0))
                        .orElse(""))
                .isEqualTo(why);
    }

    @Test
    void polygonsHaveAsManyCornersAsTheySay() {
        assertThat(StationFenceItems.whyNotWhole(SQUARE)).isEmpty();
        assertThat(StationFenceItems.whyNotWhole(SQUARE.subList(0, 3)))
                .contains("fence items 0 to 3 should be one polygon of 4 corners, and 3 are");
        List<MissionItem> other = FencePart.square(FencePart.EXCLUSION, 45, 10, 0.001);
        assertThat(StationFenceItems.whyNotWhole(FencePart.list(SQUARE, SQUARE.subList(0, 2), other)))
                .contains("fence items 4 to 7 should be one polygon of 4 corners, and 2 are");
        assertThat(StationFenceItems.whyNotWhole(
                        FencePart.list(SQUARE, FencePart.circle(FencePart.CIRCLE_EXCLUSION, 45, 10, 5), other)))
                .isEmpty();
    }

    @Test
    void polygonsDoNotCrossThemselvesAndHaveAnArea() {
        assertThat(StationFenceItems.whyNotWhole(FencePart.polygon(
                        FencePart.INCLUSION, new double[][] {{45, 10}, {45.01, 10.01}, {45.01, 10}, {45, 10.01}})))
                .contains("fence items 0 to 3: edges of the polygon cross");
        assertThat(StationFenceItems.whyNotWhole(FencePart.polygon(
                        FencePart.INCLUSION, new double[][] {{45, 10}, {45.01, 10.01}, {45.02, 10.02}})))
                .contains("fence items 0 to 2: the polygon has no area");
        assertThat(StationFenceItems.whyNotWhole(FencePart.polygon(
                        FencePart.INCLUSION, new double[][] {{45, 10}, {45.01, 10}, {45.01, 10.01}, {45, 10}})))
                .isEmpty(); // its first corner comes again at the end
    }
}
