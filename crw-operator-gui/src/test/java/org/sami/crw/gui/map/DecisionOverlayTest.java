package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.SessionWays;
import org.sami.crw.service.Geodesy;
import org.sami.palette.ProxyMarks;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;
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
                return overlay(world);
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

    @Test
    void whatIsToBeApprovedIsDrawnUntilItIsAnswered() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT, "anna")) {
            onEventThread(() -> {
                Layout.layOut(map, 400, 300);
                DecisionOverlay overlay = overlay(world);
                overlay.show(approving(new GeoPath(List.of(SessionWorld.PIER, TURN))), List.of());
                assertThat(isTurnOnTheMap()).isTrue();

                overlay.clear();
                assertThat(isTurnOnTheMap()).isFalse();
                return null;
            });
        }
    }

    private static DecisionPresentation approving(Value path) {
        DecisionPresentation plain = DecisionPresenter.plain(new Decision(
                1,
                1,
                1,
                "ApprovePaths",
                "Are they to fly these paths?",
                new Question.Approve(),
                Optional.empty(),
                OptionalLong.empty(),
                Priority.MEDIUM,
                List.of()));
        return new DecisionPresentation(
                plain.decision(),
                plain.asker(),
                List.of("anna"),
                plain.description(),
                plain.options(),
                plain.format(),
                plain.autonomy(),
                plain.attention(),
                plain.proposedLocation(),
                plain.map(),
                List.of(new MapValue(Map.of(new ProxyValue("anna"), path))));
    }

    private DecisionOverlay overlay(SessionWorld world) {
        return new DecisionOverlay(
                map,
                new ProxyMarks(),
                new SessionWays(world.context),
                new MapPen(map, () -> false, boat -> Optional.empty(), UnaryOperator.identity()),
                map::fitAll,
                UnaryOperator.identity());
    }

    private boolean isTurnOnTheMap() {
        GeoPoint pier = SessionWorld.PIER;
        GeoBounds.of(List.of(pier, Geodesy.offset(pier, 10, 10))).ifPresent(map::fit);
        map.fitAll();
        return map.frame().isShown(TURN);
    }
}
