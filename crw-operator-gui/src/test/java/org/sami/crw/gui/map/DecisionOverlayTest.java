package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.SessionWays;
import org.sami.crw.service.Geodesy;
import org.sami.palette.ProxyMarks;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.Layout;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.map.MapView;

/** What the map shows of a question about a way, in a session with a boat that is sent too far. */
@Timeout(900)
class DecisionOverlayTest {
    private static final GeoPoint TURN = Geodesy.offset(SessionWorld.PIER, 3_000, 100);
    private static final Project PROJECT = SessionWorld.project("""
        {'formatVersion': 1, 'id': 'p', 'name': 'p', 'domain': 'crw', 'plans': [{'id': 'far', 'name': 'Far', 'places': [
           {'id': 'go', 'name': 'Go there', 'start': true, 'outputs': [{'id': 'way', 'type': 'ProxyExecutePath',
            'fields': {'paths': {'value': {'anna': [{'lat': %s, 'lon': %s}, {'lat': 45.46, 'lon': 10.9}]}}}}]},
           {'id': 'there', 'name': 'There', 'end': true}],
          'transitions': [{'id': 't', 'inputs': [{'id': 'i', 'type': 'ProxyPathCompleted'}]}],
          'inEdges': [{'id': 'a', 'place': 'go', 'transition': 't', 'requirements': [{'match': 'all', 'kind': 'relevant'}]}],
          'outEdges': [{'id': 'b', 'transition': 't', 'place': 'there',
           'requirements': [{'action': 'take', 'n': 'all', 'kind': 'relevant'}]}]}]}\
        """.formatted(TURN.latDeg(), TURN.lonDeg()));

    private final MapView map = new MapView();

    @Test
    void theWayThatIsAskedAboutIsDrawnUntilItIsAnswered() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT, "anna")) {
            DecisionOverlay overlay = onEventThread(() -> {
                Layout.layOut(map, 400, 300);
                return new DecisionOverlay(
                        map,
                        new ProxyMarks(),
                        new SessionWays(world.context),
                        new MapPen(map, () -> false, boat -> Optional.empty(), UnaryOperator.identity()),
                        UnaryOperator.identity());
            });
            world.start("far");
            until(
                    "it is asked",
                    () -> !world.context.models().decisions().snapshot().isEmpty());
            DecisionPresentation asked = onEventThread(
                    () -> world.context.models().decisions().snapshot().get(0).presentation());
            assertThat(asked.decision().type()).isEqualTo("DoubtfulWay");

            onEventThread(() -> {
                overlay.show(asked, List.of());
                return null;
            });

            until("the way is drawn", this::isTurnOnTheMap);
            onEventThread(() -> {
                overlay.clear();
                assertThat(isTurnOnTheMap()).isFalse();
                return null;
            });
        }
    }

    private boolean isTurnOnTheMap() {
        GeoPoint pier = SessionWorld.PIER;
        GeoBounds.of(List.of(pier, Geodesy.offset(pier, 10, 10))).ifPresent(map::fit);
        map.fitAll();
        return map.frame().isShown(TURN);
    }
}
