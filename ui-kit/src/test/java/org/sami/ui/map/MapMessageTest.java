package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.ui.geo.MapFrame;

class MapMessageTest {
    private static final int HEIGHT = 400;
    private static final int HIGHEST_OF_SCALE = 48;

    private final MapMessage message = new MapMessage();

    private static MapPaint paint(int width) {
        return paint(width, HEIGHT);
    }

    private static MapPaint paint(int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        return new MapPaint(
                image.createGraphics(), new MapFrame(0.5, 0.5, 1e8, width, height), Set.of(), new MapLabels(), false);
    }

    @Test
    void whatIsSaidStandsBesideTheScaleWhereThereIsRoom() {
        message.say("boat3: 135 m, about 2 min, 4 % of a full charge", false);
        MapPaint paint = paint(900);

        Rectangle2D plate = message.plate(paint);

        assertThat(plate.getMinY()).isGreaterThan(HEIGHT - HIGHEST_OF_SCALE);
        assertThat(plate.getMaxY()).isLessThan(HEIGHT);
        assertThat(plate.getMinX()).isGreaterThan(MapScale.right(paint));
        assertThat(plate.getMaxX()).isLessThan(900);
    }

    @Test
    void aLowMapIsNotHiddenBelowWhatIsSaidOnIt() {
        message.say(
                "22 % of the area is outside the fence and will be left out · 3 boats: 1.7 km together; the longest"
                        + " way is anna's, 633 m, about 7 min, 18 % of a full charge",
                false);
        MapPaint low = paint(500, 200);

        assertThat(message.plate(low).getHeight()).isLessThanOrEqualTo(0.15 * 200);
        assertThat(message.lines(low, low.g().getFontMetrics()))
                .singleElement()
                .asString()
                .startsWith("22 % of the area is outside the fence")
                .endsWith("…");
        MapPaint high = paint(500, 800);
        assertThat(message.lines(high, high.g().getFontMetrics())).hasSizeGreaterThan(1);
    }

    @Test
    void whatHasNoRoomIsLeftOutFromAClauseOn() {
        message.say(
                "Click boats to choose them for the answer; Escape puts the pen down, and Alt+D takes it up", false);
        MapPaint low = paint(420, 200);

        assertThat(message.lines(low, low.g().getFontMetrics()))
                .containsExactly("Click boats to choose them for the answer …");
    }

    @Test
    void itStandsAtTheUpperEdgeWhileItWouldLieOnAVehicleBelow() {
        message.say("boat3: 135 m", false);
        MapPaint paint = paint(900);
        Rectangle2D below = message.plate(paint);

        message.avoid(List.of(new Rectangle2D.Double(below.getCenterX(), below.getCenterY(), 20, 20)));
        Rectangle2D above = message.plate(paint);
        assertThat(above.getMaxY()).isLessThan(HEIGHT / 4.0);

        message.avoid(List.of());
        assertThat(message.plate(paint)).as("it does not jump back").isEqualTo(above);

        message.avoid(List.of(new Rectangle2D.Double(above.getCenterX(), above.getCenterY(), 20, 20)));
        assertThat(message.plate(paint)).isEqualTo(below);
    }

    @Test
    void onANarrowMapAndBesideTheNameOfABaseMapItStandsAboveTheScale() {
        message.say("boat3: 135 m, about 2 min, 4 % of a full charge", false);
        assertThat(message.plate(paint(400)).getMaxY()).isLessThanOrEqualTo(HEIGHT - HIGHEST_OF_SCALE);

        message.setFree(false);
        assertThat(message.plate(paint(900)).getMaxY()).isLessThanOrEqualTo(HEIGHT - HIGHEST_OF_SCALE);
    }
}
