package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.map.MapView;

@Timeout(900)
class SimulatedBoatAdderTest {
    private static final double APART_M = 8;
    private static final double ABOUT_A_METRE_DEG = 1e-5;

    @Test
    void boatsAreAddedInTheMiddleOfTheMapUnderNamesThatNobodyHas() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "sim-1")) {
            MapPanel panel = laidOut(() -> new MapPanel(world.context));
            until(
                    "it is known where sim-1 is, to whom the map turns",
                    () -> position(world, "sim-1").isPresent());
            MapView map = SessionWorld.find(panel, "map", MapView.class);
            GeoPoint middle = onEventThread(() -> {
                map.centre(GeoPoint.of(45.5, 10.8));
                MapFrame frame = map.frame();
                return frame.point(frame.width() / 2.0, frame.height() / 2.0);
            });

            world.run("boat-add-simulated");
            world.run("boat-add-simulated");

            until(
                    "both have joined",
                    () -> position(world, "sim-2").isPresent()
                            && position(world, "sim-3").isPresent());
            assertThat(position(world, "sim-2").orElseThrow().latDeg())
                    .isCloseTo(middle.latDeg(), within(ABOUT_A_METRE_DEG));
            assertThat(position(world, "sim-2").orElseThrow().lonDeg())
                    .isCloseTo(middle.lonDeg(), within(ABOUT_A_METRE_DEG));
            assertThat(Geodesy.distanceM(
                            position(world, "sim-2").orElseThrow(),
                            position(world, "sim-3").orElseThrow()))
                    .isGreaterThan(APART_M);
            onEventThread(() -> {
                panel.close();
                return null;
            });
        }
    }

    @Test
    void aPlaceThatABoatHasLeftIsFreeAgain() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            MapPanel panel = laidOut(() -> new MapPanel(world.context));
            until(
                    "anna is known, to whom the map turns",
                    () -> position(world, "anna").isPresent());
            MapView map = SessionWorld.find(panel, "map", MapView.class);
            onEventThread(() -> {
                map.centre(GeoPoint.of(45.5, 10.8));
                return null;
            });
            world.run("boat-add-simulated");
            until("the first has joined", () -> position(world, "sim-1").isPresent());
            GeoPoint middle = position(world, "sim-1").orElseThrow();
            SessionWorld.get(world.session.fleet().disconnect("sim-1"));
            until("it is gone", () -> position(world, "sim-1").isEmpty());

            world.run("boat-add-simulated");

            until("the second has joined", () -> position(world, "sim-2").isPresent());
            assertThat(Geodesy.distanceM(position(world, "sim-2").orElseThrow(), middle))
                    .isLessThan(APART_M);
            onEventThread(() -> {
                panel.close();
                return null;
            });
        }
    }

    private static Optional<GeoPoint> position(SessionWorld world, String boat) {
        return world.context
                .models()
                .fleet()
                .boat(boat)
                .flatMap(BoatSnapshot::pose)
                .map(pose -> pose.position());
    }
}
