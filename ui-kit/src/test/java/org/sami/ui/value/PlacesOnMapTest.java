package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;
import org.sami.ui.check.Layout;
import org.sami.ui.look.IdentityMark;
import org.sami.ui.map.MapView;

class PlacesOnMapTest {
    private static final GeoPoint QUAY = GeoPoint.of(45, 10);
    private static final GeoPoint AIM = GeoPoint.of(45.1, 10.2);

    @Test
    void pathOfARobotBeginsWhereItIs() {
        MapView map = new MapView();
        PlacesOnMap places = new PlacesOnMap(
                map,
                "option",
                robot -> new IdentityMark(0),
                robot -> Optional.of(QUAY).filter(at -> robot.equals("anna")));

        Layout.layOut(map, 400, 300);

        places.show(List.of(paths("anna")));
        map.fitAll();
        assertThat(map.frame().isShown(QUAY)).isTrue();

        places.show(List.of(paths("bert")));
        map.fitAll();
        assertThat(map.frame().isShown(AIM)).isTrue();
        assertThat(map.frame().isShown(QUAY)).as("nobody knows where bert is").isFalse();
    }

    private static Value paths(String robot) {
        return new MapValue(Map.of(new ProxyValue(robot), new GeoPath(List.of(AIM))));
    }
}
