package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.map.ShownPlace;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.map.PointLayer.MapPoint;

class MapFeedTest {
    @Test
    void eachPointOfAListIsOnTheMapWithItsNumber() {
        List<MapPoint> points = MapFeed.points(List.of(
                new ShownPlace(0, "@home", GeoPoint.of(45, 10)),
                new ShownPlace(1, "@locations", GeoPoint.of(45.1, 10)),
                new ShownPlace(1, "@locations", GeoPoint.of(45.2, 10)),
                new ShownPlace(2, "@locations", GeoPoint.of(45.3, 10))));

        assertThat(points).extracting(MapPoint::id).doesNotHaveDuplicates();
        assertThat(points).extracting(MapPoint::name).containsExactly("@home", "@locations", "2", "@locations");
    }
}
