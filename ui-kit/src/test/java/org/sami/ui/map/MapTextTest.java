package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.palette.Theme;
import org.sami.ui.check.TextFit;
import org.sami.ui.geo.CoordinateNotation;
import org.sami.ui.look.Look;

/** The texts around a map, in every theme; the theme is the whole process's. */
@Isolated
class MapTextTest {
    @AfterEach
    void light() {
        Look.apply(Theme.LIGHT, 100);
    }

    @Test
    void noTextIsCutOrOverlappedWideOrNarrow() {
        for (Theme theme : Theme.values()) {
            for (int percent : List.of(100, 150)) {
                for (int width : List.of(460, 1200)) {
                    Look.apply(theme, percent);
                    try (MapView map = MapScenes.fleet(3, 50)) {
                        for (CoordinateNotation notation : CoordinateNotation.values()) {
                            map.setNotation(notation);
                            MapScenes.size(map, width * percent / 100, 400);

                            assertThat(TextFit.faults(map))
                                    .as("%s %s %s %s", theme, percent, width, notation)
                                    .isEmpty();
                        }
                    }
                }
            }
        }
    }
}
