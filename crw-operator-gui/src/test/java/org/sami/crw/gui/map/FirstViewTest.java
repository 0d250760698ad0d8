package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.map.NamedArea;
import org.sami.crw.operator.map.ShownBoat;
import org.sami.crw.operator.map.ShownLayer;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.Layout;
import org.sami.ui.map.MapView;

class FirstViewTest {
    private static final GeoPoint AWAY = GeoPoint.of(25.38, 51.55);

    private boolean free = true;

    private static final GeoPoint QUAY = GeoPoint.of(25.36, 51.53);

    @Test
    void boatsAndAreasAreSeenLargeAlsoWhereTheMapGotItsSizeLater() {
        onEventThread(() -> {
            MapView view = new MapView();
            FirstView first = new FirstView(view, () -> free);
            Layout.layOut(view, 90, 70); // as before panels are arranged
            first.look(with(boat("anna", QUAY)));
            Layout.layOut(view, 800, 500);
            first.look(with(boat("anna", QUAY)));

            double across =
                    view.frame().px(GeoPoint.of(25.36, 51.533)) - view.frame().px(GeoPoint.of(25.36, 51.527));
            assertThat(across).as("the fence is seen large").isBetween(200.0, 800.0);
            return null;
        });
    }

    @Test
    void theProjectsWaterIsSeenBeforeTheFirstBoatIs() {
        onEventThread(() -> {
            MapView view = new MapView();
            FirstView first = new FirstView(view, () -> free);
            Layout.layOut(view, 800, 500);

            first.look(with());

            assertThat(view.frame().isShown(GeoPoint.of(25.358, 51.527))).isTrue();
            assertThat(view.frame().px(GeoPoint.of(25.36, 51.533))
                            - view.frame().px(GeoPoint.of(25.36, 51.527)))
                    .isGreaterThan(200.0);
            return null;
        });
    }

    @Test
    void aMapThatSomebodyMovedStaysWhereItIs() {
        onEventThread(() -> {
            MapView view = new MapView();
            FirstView first = new FirstView(view, () -> free);
            Layout.layOut(view, 800, 500);
            first.look(with(boat("anna", QUAY)));
            view.centre(GeoPoint.of(25.37, 51.54));

            first.look(with(boat("anna", QUAY), boat("bert", QUAY)));

            assertThat(view.frame().px(GeoPoint.of(25.37, 51.54))).isBetween(399.0, 401.0);
            return null;
        });
    }

    @Test
    void boatsThatMoveLeaveTheMapWhereItIsAsLongAsTheyStayInSight() {
        onEventThread(() -> {
            MapView view = new MapView();
            FirstView first = new FirstView(view, () -> free);
            Layout.layOut(view, 800, 500);
            first.look(with(boat("anna", QUAY)));
            double before = view.frame().px(QUAY);

            first.look(with(boat("anna", GeoPoint.of(25.359, 51.529))));
            assertThat(view.frame().px(QUAY)).isEqualTo(before);

            free = false;
            first.look(with(boat("anna", AWAY)));
            assertThat(view.frame().px(QUAY)).as("while somebody draws").isEqualTo(before);

            free = true;
            first.look(with(boat("anna", AWAY)));
            assertThat(view.frame().isShown(AWAY)).isTrue();
            assertThat(view.frame().isShown(GeoPoint.of(25.358, 51.527)))
                    .as("the fence")
                    .isTrue();
            return null;
        });
    }

    @Test
    void aMapThatBecameLargerStillFollowsBoatsThatLeaveIt() {
        onEventThread(() -> {
            MapView view = new MapView();
            FirstView first = new FirstView(view, () -> free);
            Layout.layOut(view, 800, 500);
            first.look(with(boat("anna", QUAY)));
            Layout.layOut(view, 900, 600);
            first.look(with(boat("anna", QUAY)));

            first.look(with(boat("anna", AWAY)));

            assertThat(view.frame().isShown(AWAY)).isTrue();
            return null;
        });
    }

    private static ShownBoat boat(String id, GeoPoint at) {
        return new ShownBoat(id, at, 0, 0, 0, 0, OptionalDouble.empty(), LinkState.LINKED, false);
    }

    private static MapSnapshot with(ShownBoat... boats) {
        List<GeoPoint> corners = List.of(
                GeoPoint.of(25.358, 51.527),
                GeoPoint.of(25.358, 51.533),
                GeoPoint.of(25.362, 51.533),
                GeoPoint.of(25.362, 51.527));
        NamedArea fence = new NamedArea(ShownLayer.FENCE, Ids.NONE, "@water", new GeoArea(corners, List.of()));
        MapSnapshot none = MapSnapshot.EMPTY;
        return new MapSnapshot(
                none.layers(),
                List.of(boats),
                none.tracks(),
                none.paths(),
                none.waysHome(),
                List.of(fence),
                none.places(),
                none.data(),
                none.channels(),
                Optional.empty(),
                "");
    }
}
