package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.window.Notices.Notice;

/** What becomes of a boat that is sent by hand, in a session with a simulated boat behind a socket, in still water. */
@Tag("long")
@Timeout(900)
class GuidedModeTest {
    private static final GeoArea ROCK = area(at(-4, 5), at(4, 5), at(4, 8), at(-4, 8));
    private static final GeoPoint BEHIND = at(0, 12);

    /** Walls around a pool. */
    private static final List<GeoArea> REEF = List.of(
            area(at(20, 20), at(60, 20), at(60, 25), at(20, 25)),
            area(at(20, 55), at(60, 55), at(60, 60), at(20, 60)),
            area(at(20, 20), at(25, 20), at(25, 60), at(20, 60)),
            area(at(55, 20), at(60, 20), at(60, 60), at(55, 60)));

    private static final GeoPoint POOL = at(40, 40);

    private final List<Notice> notices = new ArrayList<>();
    private SessionWorld world;
    private GuidedMode guided;

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(SessionWorld.PIER, eastM, northM);
    }

    private static GeoArea area(GeoPoint... corners) {
        return new GeoArea(List.of(corners), List.of());
    }

    private static String json(List<GeoArea> areas) {
        return areas.stream()
                .map(one -> one.outline().stream()
                        .map(point -> String.format(
                                Locale.ROOT, "{'lat': %.7f, 'lon': %.7f}", point.latDeg(), point.lonDeg()))
                        .collect(Collectors.joining(", ", "{'outline': [", "]}")))
                .collect(Collectors.joining(", ", "[", "]"));
    }

    /** A project that avoids some areas; the one plan's boats avoid others and wait for the operator. */
    private void open(List<GeoArea> ofProject, List<GeoArea> ofPlan) throws Exception {
        world = new SessionWorld(SessionWorld.project("""
            {'formatVersion': 1, 'id': 'p', 'name': 'p', 'domain': 'crw',
             'globals': [{'name': '@noGo', 'type': 'list<area>', 'initial': %s}],
             'plans': [{'id': 'wait', 'name': 'Wait', 'places': [
              {'id': 'a', 'start': true, 'outputs': [
               {'id': 'l', 'type': 'AssembleLocationRequest', 'fields': {'location': {'value': {'lat': 45.4, 'lon': 10.9}},
                'spacing': {'value': 5}, 'avoid': {'value': %s}}},
               {'id': 'q', 'type': 'OperatorApprove', 'fields': {'question': {'value': 'Go on?'}}}]},
              {'id': 'b', 'end': true}],
             'transitions': [{'id': 't', 'inputs': [{'id': 'y', 'type': 'YesOption'}]}],
             'inEdges': [{'id': 'e1', 'place': 'a', 'transition': 't',
              'requirements': [{'kind': 'generic', 'match': 'at-least', 'n': 1}]}],
             'outEdges': [{'id': 'e2', 'transition': 't', 'place': 'b',
              'requirements': [{'kind': 'generic', 'action': 'take', 'n': 'all'}]}]}]}
            """.formatted(json(ofProject), json(ofPlan))), "anna");
        SessionWorld.until("anna says where it is", () -> anna().pose().isPresent());
        onEventThread(() -> {
            world.context.notices().addListener(notices::add);
            world.context.boats().select(List.of("anna"));
            guided = new GuidedMode(world.context);
            return null;
        });
    }

    @AfterEach
    void close() throws Exception {
        world.close();
    }

    private BoatSnapshot anna() {
        return world.context.models().fleet().boat("anna").orElseThrow();
    }

    private Notice goTo(GeoPoint point) {
        int before = notices.size();
        onEventThread(() -> {
            guided.goTo(point);
            return null;
        });
        SessionWorld.until("what came of it is told", () -> notices.size() > before);
        return onEventThread(() -> notices.get(notices.size() - 1));
    }

    private Optional<BoatCommand> command() throws Exception {
        return SessionWorld.get(world.session
                .fleet()
                .ask(boats -> boats.find("anna").orElseThrow().commands().current()));
    }

    @Test
    void boatThatIsSentBehindARockDrivesAroundIt() throws Exception {
        open(List.of(ROCK), List.of());
        List<GeoPoint> driven = new ArrayList<>();

        Notice told = goTo(BEHIND);

        assertThat(told.refused()).isFalse();
        assertThat(told.text())
                .startsWith("anna goes where the operator sent it, ")
                .contains("around what is to be avoided");
        SessionWorld.until("anna is there", () -> {
            GeoPoint here = anna().pose().map(BoatPose::position).orElseThrow();
            driven.add(here);
            return Geodesy.distanceM(here, BEHIND) < 2;
        });
        assertThat(Water.of(SessionWorld.PIER, List.of(ROCK), Optional.empty()).clearanceM(driven))
                .isPositive();
    }

    @Test
    void boatThatIsStoppedIsSaidNotToMoveBeforeTheRelease() throws Exception {
        open(List.of(), List.of());
        SessionWorld.get(world.session.fleet().stopAll());
        SessionWorld.until(
                "anna is stopped",
                () -> world.context.models().fleetStop().snapshot().here().contains("anna"));
        assertThat(onEventThread(guided::consequence))
                .isEqualTo("anna: stopped; nothing moves before the release; no mission wants anything of it now");

        Notice told = goTo(BEHIND);

        assertThat(told.text())
                .startsWith("anna is to go where the operator sent it, 12 m")
                .endsWith("; it is stopped, and nothing moves before the release");
        SessionWorld.until(
                "the command waits",
                () -> anna().why()
                        .text()
                        .equals("anna does not move: it is stopped until it is released; one command waits"));
        SessionWorld.get(world.session.fleet().releaseAll());
        SessionWorld.until(
                "the same words as in the notice",
                () -> anna().why().text().startsWith("anna goes where the operator sent it"));
    }

    @Test
    void placeInWhatIsToBeAvoidedIsRefusedAndNothingIsSent() throws Exception {
        open(List.of(ROCK), List.of());

        Notice told = goTo(at(0, 6));

        assertThat(told.refused()).isTrue();
        assertThat(told.text()).startsWith("anna is not sent").endsWith("lies 1.0 m inside what is to be avoided");
        assertThat(command()).isEmpty();
    }

    @Test
    void placeToWhichThereIsNoWayIsRefusedAndNothingIsSent() throws Exception {
        open(REEF, List.of());

        Notice told = goTo(POOL);

        assertThat(told.refused()).isTrue();
        assertThat(told.text()).startsWith("anna is not sent").contains("there is no way to");
        assertThat(command()).isEmpty();
    }

    @Test
    void whatAMissionAvoidsIsAvoidedByItsBoats() throws Exception {
        open(List.of(), List.of(ROCK));
        assertThat(goTo(at(0, 6)).refused()).isFalse();
        world.start("wait");

        assertThat(goTo(at(0, 6)).text()).contains("inside what is to be avoided");
    }

    @Test
    void placeOutsideOfTheFenceIsComeToAndThatIsSaid() throws Exception {
        open(List.of(), List.of());
        SessionWorld.get(world.session
                .fence()
                .set(new GeoArea(Arrays.asList(at(-20, -20), at(20, -20), at(20, 10), at(-20, 10)), List.of())));

        Notice told = goTo(BEHIND);

        assertThat(told.refused()).isFalse();
        assertThat(told.text()).endsWith("see the message about its way");
        assertThat(command()).isPresent();
        SessionWorld.until(
                "a message says it",
                () -> world.context.models().messages().messages().stream()
                        .anyMatch(message -> message.text().startsWith("anna is sent to ")
                                && message.text().endsWith("which lies outside of the fence")));
    }
}
