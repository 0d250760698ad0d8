package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;
import org.sami.ui.check.Layout;
import org.sami.ui.map.MapView;

class PlacesOnMapTest {
    private static final GeoPoint QUAY = GeoPoint.of(45, 10);
    private static final GeoPoint TURN = GeoPoint.of(45.3, 9.8);
    private static final GeoPoint AIM = GeoPoint.of(45.1, 10.2);

    @Test
    void pathOfARobotBeginsWhereItIs() {
        MapView map = new MapView();
        PlacesOnMap places = new PlacesOnMap(map, "option", robot -> new IdentityMark(0), (robot, path, found) -> {
            if (robot.equals("anna")) {
                found.accept(List.of(QUAY, AIM));
            }
        });

        Layout.layOut(map, 400, 300);

        places.show(List.of(paths("anna")));
        map.fitAll();
        assertThat(map.frame().isShown(QUAY)).isTrue();

        places.show(List.of(paths("bert")));
        map.fitAll();
        assertThat(map.frame().isShown(AIM)).isTrue();
        assertThat(map.frame().isShown(QUAY)).as("nobody knows where bert is").isFalse();
    }

    @Test
    void wayThatIsFoundLaterIsDrawnUnlessSomethingElseIsShownByThen() {
        MapView map = new MapView();
        List<Consumer<List<GeoPoint>>> later = new ArrayList<>();
        PlacesOnMap places =
                new PlacesOnMap(map, "option", robot -> new IdentityMark(0), (robot, path, found) -> later.add(found));
        Layout.layOut(map, 400, 300);

        places.show(List.of(paths("anna")));
        later.get(0).accept(List.of(QUAY, TURN, AIM));
        map.fitAll();
        assertThat(map.frame().isShown(TURN)).isTrue();

        places.show(List.of(paths("bert")));
        later.get(0).accept(List.of(QUAY, TURN, AIM));
        map.fitAll();
        assertThat(map.frame().isShown(TURN)).as("anna is shown no more").isFalse();
    }

    private static Value paths(String robot) {
        return new MapValue(Map.of(new ProxyValue(robot), new GeoPath(List.of(AIM))));
    }
}
