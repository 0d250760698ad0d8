package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.palette.Contrast;
import org.sami.palette.Theme;
import org.sami.ui.look.Look;

/** Names of places that are not spoken of. */
@Isolated("the look is one for all windows of a process")
class DimmedNamesTest {
    @AfterEach
    void light() {
        Look.apply(Theme.LIGHT, 100);
    }

    @Test
    void theNameOfADimmedPlaceIsStillReadInTheSun() {
        Look.apply(Theme.SUN, 100);
        MapView map = new MapView();
        map.setGrid(false);
        PointLayer points = map.layers().add(new PointLayer("points", "Points"));
        points.show(List.of(new PointLayer.MapPoint("home", "MMMMMM", MapScenes.LAKE)));
        MapScenes.size(map, 400, 300);
        map.fitAll();
        map.highlight(Set.of("anna"));
        int besideTheCross = (int) map.frame().px(MapScenes.LAKE) + 14;

        Color name = darkest(MapScenes.paint(map).getSubimage(besideTheCross, 0, 60, 200));

        map.close();
        assertThat(Contrast.of(name, Color.WHITE)).isGreaterThanOrEqualTo(4.5);
    }

    private static Color darkest(BufferedImage picture) {
        return IntStream.range(0, picture.getWidth() * picture.getHeight())
                .mapToObj(i -> new Color(picture.getRGB(i % picture.getWidth(), i / picture.getWidth())))
                .max(Comparator.comparingDouble(color -> Contrast.of(color, Color.WHITE)))
                .orElseThrow();
    }
}
