package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.boat.BoatWords;
import org.sami.crw.operator.MapModel;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.map.ShownLayer;
import org.sami.crw.operator.map.ShownPlace;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.map.MapView;
import org.sami.ui.map.PointLayer.MapPoint;
import org.sami.ui.map.VehicleLayer;

@Timeout(900)
class MapFeedTest {
    private static final GeoPoint NOW = GeoPoint.of(45.401, 10.9);
    private static final GeoPoint LATER = GeoPoint.of(45.402, 10.9);

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

    @Test
    void ageOfABoatThatIsOutOfReachIsThatOfTheLists() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            MapView view = onEventThread(MapView::new);
            MapFeed feed = onEventThread(() -> new MapFeed(world.context, view.layers()));
            SessionWorld.until(
                    "anna is on the map",
                    () -> !world.context.models().map().snapshot().boats().isEmpty());
            SessionWorld.get(world.session.fleet().ask(boats -> {
                boats.find("anna").ifPresent(BoatProxy::disconnect);
                return true;
            }));
            SessionWorld.until(
                    "the link is lost and old",
                    () -> world.context.models().fleet().snapshot().stream()
                            .anyMatch(boat -> boat.link() == LinkState.LOST
                                    && BoatWords.isStale(boat, world.context.nowMillis())));
            SessionWorld.until("map and lists say the same", () -> {
                feed.show(world.context.models().map().snapshot());
                String age = ((VehicleLayer) view.layers().find("boats").orElseThrow())
                        .vehicles()
                        .get(0)
                        .age();
                return BoatWords.link(
                                world.context.models().fleet().boat("anna").orElseThrow(), world.context.nowMillis())
                        .equals("lost " + age);
            });
        }
    }

    @Test
    void whatALayerHoldsIsOnTheMapOnlyWhileTheLayerIsOn() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            MapView view = onEventThread(MapView::new);
            MapFeed feed = onEventThread(() -> new MapFeed(world.context, view.layers()));
            SessionWorld.get(world.session.fleet().ask(boats -> {
                boats.find("anna").ifPresent(anna -> {
                    anna.commands().submit(FollowPath.goTo("now", 1, 1, NOW, Priority.HIGH));
                    anna.commands().submit(FollowPath.goTo("later", 2, 2, LATER, Priority.LOW));
                });
                return true;
            }));
            shownWith(
                    world,
                    feed,
                    ShownLayer.BOATS,
                    true,
                    map -> map.paths().size() == 2 && map.boats().size() == 1);
            assertThat(northmost(view)).isEqualTo(NOW.latDeg());
            assertThat(boats(view)).isEqualTo(1);

            shownWith(world, feed, ShownLayer.FUTURE_PATHS, true, map -> true);
            assertThat(northmost(view)).isEqualTo(LATER.latDeg());

            shownWith(world, feed, ShownLayer.BOATS, false, map -> true);
            assertThat(boats(view)).isZero();
        }
    }

    /** Puts a layer on or off, and shows the map that has it so. */
    private static void shownWith(
            SessionWorld world, MapFeed feed, ShownLayer layer, boolean on, Predicate<MapSnapshot> wanted) {
        MapModel map = world.context.models().map();
        map.show(layer, Optional.of(on));
        SessionWorld.until(layer + " is " + on, () -> {
            MapSnapshot now = map.snapshot();
            feed.show(now);
            return now.layer(layer).on() == on && wanted.test(now);
        });
    }

    private static double northmost(MapView view) {
        return onEventThread(() -> view.layers()
                .find("paths")
                .orElseThrow()
                .bounds()
                .map(GeoBounds::northDeg)
                .orElseThrow());
    }

    private static int boats(MapView view) {
        return onEventThread(() -> ((VehicleLayer) view.layers().find("boats").orElseThrow())
                .vehicles()
                .size());
    }
}
