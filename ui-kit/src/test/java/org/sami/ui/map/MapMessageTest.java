package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.ui.geo.MapFrame;

class MapMessageTest {
    private static final int HEIGHT = 400;
    private static final int HIGHEST_OF_SCALE = 48;

    private final MapMessage message = new MapMessage();

    private static MapPaint paint(int width) {
        BufferedImage image = new BufferedImage(width, HEIGHT, BufferedImage.TYPE_INT_RGB);
        return new MapPaint(
                image.createGraphics(), new MapFrame(0.5, 0.5, 1e8, width, HEIGHT), Set.of(), new MapLabels(), false);
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
    void onANarrowMapAndBesideTheNameOfABaseMapItStandsAboveTheScale() {
        message.say("boat3: 135 m, about 2 min, 4 % of a full charge", false);
        assertThat(message.plate(paint(400)).getMaxY()).isLessThanOrEqualTo(HEIGHT - HIGHEST_OF_SCALE);

        message.setFree(false);
        assertThat(message.plate(paint(900)).getMaxY()).isLessThanOrEqualTo(HEIGHT - HIGHEST_OF_SCALE);
    }
}
