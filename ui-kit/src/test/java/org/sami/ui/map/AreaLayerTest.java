package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

class AreaLayerTest {
    private static final String AREA = "rocks";

    private final MapView map = new MapView();
    private final AreaLayer areas = new AreaLayer("areas", "Areas");

    @BeforeEach
    void open() {
        map.layers().add(areas);
        MapScenes.size(map, 400, 300);
    }

    @AfterEach
    void close() {
        map.close();
    }

    private void show(ShownArea.Kind kind) {
        List<GeoPoint> outline = List.of(
                GeoPoint.of(45.7, 10.72),
                GeoPoint.of(45.7, 10.722),
                GeoPoint.of(45.702, 10.722),
                GeoPoint.of(45.702, 10.72));
        areas.show(List.of(new ShownArea(AREA, "Rocks", new GeoArea(outline, List.of()), kind)));
        map.fitAll();
    }

    private boolean isDimmedFor(String spokenOf) {
        int[] before = pixels();
        map.highlight(Set.of(spokenOf));
        int[] after = pixels();
        return !Arrays.equals(before, after);
    }

    private int[] pixels() {
        return MapScenes.paint(map).getRGB(0, 0, 400, 300, null, 0, 400);
    }

    @ParameterizedTest
    @EnumSource(names = {"NO_GO", "FENCE"})
    void whereNoneMayGoAndWhatNoneMayLeaveIsNotDimmedWhileBoatsAreSpokenOf(ShownArea.Kind kind) {
        show(kind);

        assertThat(isDimmedFor("anna")).isFalse();
    }

    @Test
    void whereSomethingIsToBeDoneIsDimmedWhileBoatsAreSpokenOf() {
        show(ShownArea.Kind.WORK);

        assertThat(isDimmedFor("anna")).isTrue();
        assertThat(isDimmedFor(AREA)).isTrue(); // from dimmed to bright again
    }
}
