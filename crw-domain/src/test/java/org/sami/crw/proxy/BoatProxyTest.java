package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Welcome;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Stop;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** The proxy against a boat whose every word the test says. */
class BoatProxyTest {
    private static final List<GeoPoint> POINTS = List.of(GeoPoint.of(45, 10), GeoPoint.of(45.01, 10.01));

    private final LinkCodec codec = new LinkCodec();
    private final List<LinkMessage> said = new ArrayList<>();
    private final List<String> heard = new ArrayList<>();
    private BoatProxy proxy;
    private long nowMs = 1000;
    private long sequence;

    @BeforeEach
    void makeProxy() {
        proxy = new BoatProxy("boat1", this::keep, new Recorder(), ProxyConfig.DEFAULT);
    }

    private void keep(byte[] frame) {
        try {
            said.add(codec.decode(frame).message());
        } catch (LinkException e) {
            throw new AssertionError(e);
        }
    }

    private void boatSays(LinkMessage message) {
        proxy.receive(codec.encode(sequence++, message), nowMs);
    }

    private void tick(double seconds) {
        for (int i = 0; i < Math.round(seconds * 10); i++) {
            nowMs += 100;
            proxy.tick(nowMs);
        }
    }

    /** Lets time pass while the boat says that it lives. */
    private void tickAlive(double seconds) {
        for (int i = 0; i < Math.round(seconds * 10); i++) {
            tick(0.1);
            boatSays(new Heartbeat(nowMs));
        }
    }

    private void link(String bootId) {
        boatSays(new Welcome("boat1", bootId, Role.COMMANDER, ""));
        boatSays(new Progress("", 0, false));
    }

    private <M extends LinkMessage> M last(Class<M> kind) {
        return said.stream()
                .filter(kind::isInstance)
                .map(kind::cast)
                .reduce((a, b) -> b)
                .orElseThrow();
    }

    private long count(Class<? extends LinkMessage> kind) {
        return said.stream().filter(kind::isInstance).count();
    }

    private void acknowledge(Class<? extends CommandMessage> kind) {
        boatSays(new Ack(last(kind).commandId()));
    }

    private void readBackEqual() {
        UploadWaypoints upload = last(UploadWaypoints.class);
        boatSays(new HeldWaypoints(last(ReadBack.class).commandId(), upload.listId(), upload.waypoints()));
    }

    private static FollowPath path(String id, long mission) {
        return FollowPath.of(id, mission, 1, POINTS, Priority.MEDIUM);
    }

    private void drive(FollowPath path) {
        proxy.commands().submit(path);
        acknowledge(UploadWaypoints.class);
        readBackEqual();
        acknowledge(StartWaypoints.class);
    }

    @Test
    void saysHelloEverySecondUntilItIsWelcome() {
        tick(3.1);
        assertThat(said).hasSize(4).allMatch(message -> message.type().equals("hello"));
        link("b1");
        tickAlive(3);

        assertThat(count(Heartbeat.class)).isEqualTo(3);
        assertThat(heard).containsExactly("link LINKED");
        assertThat(proxy.status().bootId()).isEqualTo("b1");
    }

    @Test
    void uploadsReadsBackStartsAndFollowsAPath() {
        link("b1");
        proxy.commands().submit(new FollowPath("c", 1, 1, POINTS, OptionalDouble.of(2.5), 1, Priority.HIGH, false));

        UploadWaypoints upload = last(UploadWaypoints.class);
        assertThat(upload.waypoints()).hasSize(2).allMatch(waypoint -> waypoint.speedMps() == 2.5);
        assertThat(count(ReadBack.class)).isZero();
        assertThat(proxy.explain().text()).contains("being uploaded");
        acknowledge(UploadWaypoints.class);
        assertThat(count(StartWaypoints.class)).isZero();
        assertThat(proxy.explain().text()).contains("being read back");
        readBackEqual();
        assertThat(last(StartWaypoints.class).index()).isEqualTo(1);
        assertThat(proxy.explain().shouldMove()).isFalse();
        acknowledge(StartWaypoints.class);
        assertThat(proxy.explain().shouldMove()).isTrue();
        boatSays(new Progress(upload.listId(), 2, true));

        assertThat(heard).containsExactly("link LINKED", "progress c 2", "completed c");
        tickAlive(3);
        assertThat(count(StopMotors.class)).isZero();
    }

    @Test
    void commandsWaitUntilTheBoatIsLinked() {
        proxy.commands().submit(path("c", 1));
        tick(2);
        assertThat(count(UploadWaypoints.class)).isZero();
        assertThat(proxy.explain().text())
                .isEqualTo("boat1 does not move: the boat has not answered yet; one command waits");

        link("b1");
        assertThat(count(UploadWaypoints.class)).isEqualTo(1);
    }

    @Test
    void sendsAgainUnderTheSameIdWhatStaysUnanswered() {
        link("b1");
        proxy.commands().submit(path("c", 1));
        tickAlive(3.5);

        List<String> ids = said.stream()
                .filter(UploadWaypoints.class::isInstance)
                .map(message -> ((UploadWaypoints) message).commandId())
                .toList();
        assertThat(ids).hasSize(4).containsOnly(ids.get(0));
        assertThat(proxy.explain().text()).contains("sent 4 times without an answer");
        acknowledge(UploadWaypoints.class);
        acknowledge(UploadWaypoints.class);
        assertThat(count(ReadBack.class)).isEqualTo(1);
    }

    @Test
    void givesUpACommandThatABoatNeverAnswersAndStopsTheBoat() {
        link("b1");
        proxy.commands().submit(path("c", 1));
        tickAlive(25);

        assertThat(heard).endsWith("failed c: the boat did not answer 20 requests");
        assertThat(count(UploadWaypoints.class)).isEqualTo(20);
        assertThat(count(StopMotors.class)).isGreaterThan(1);
        assertThat(proxy.commands().current()).isEmpty();
    }

    @Test
    void doesNotStartAPathThatIsNotReadBackEqual() {
        link("b1");
        proxy.commands().submit(path("c", 1));
        for (int i = 0; i < 3; i++) {
            UploadWaypoints upload = last(UploadWaypoints.class);
            acknowledge(UploadWaypoints.class);
            boatSays(new HeldWaypoints(
                    last(ReadBack.class).commandId(),
                    upload.listId(),
                    upload.waypoints().subList(0, 1)));
        }

        assertThat(count(StartWaypoints.class)).isZero();
        assertThat(count(UploadWaypoints.class)).isEqualTo(3);
        assertThat(heard).endsWith("failed c: the boat does not hold the path that was sent");
    }

    @Test
    void refusalThatNoRetryCanHelpFailsTheCommand() {
        link("b1");
        proxy.commands().submit(path("c", 1));
        proxy.commands().submit(path("next", 2));
        boatSays(new Nack(last(UploadWaypoints.class).commandId(), NackReason.TOO_LONG, "too long"));

        assertThat(heard).endsWith("failed c: the boat refused it: TOO_LONG, too long");
        assertThat(last(UploadWaypoints.class).listId()).startsWith("next#");
    }

    @Test
    void boatThatLostTheListGetsItAgain() {
        link("b1");
        proxy.commands().submit(path("c", 1));
        acknowledge(UploadWaypoints.class);
        readBackEqual();
        String first = last(UploadWaypoints.class).listId();
        boatSays(new Nack(last(StartWaypoints.class).commandId(), NackReason.UNKNOWN_LIST, "no list"));

        assertThat(last(UploadWaypoints.class).listId()).isNotEqualTo(first).startsWith("c#");
        assertThat(heard).containsExactly("link LINKED");
    }

    @Test
    void withdrawnCommandStopsTheBoatUntilItAnswers() {
        link("b1");
        drive(path("c", 1));
        assertThat(proxy.commands().withdraw(1)).containsExactly(path("c", 1));
        tickAlive(5);
        assertThat(count(StopMotors.class)).isEqualTo(6);
        acknowledge(StopMotors.class);
        tickAlive(5);

        assertThat(count(StopMotors.class)).isEqualTo(6);
        assertThat(heard).containsExactly("link LINKED");
    }

    @Test
    void interruptedPathReturnsAtItsFirstUnvisitedPoint() {
        link("b1");
        drive(path("c", 1));
        boatSays(new Progress(last(UploadWaypoints.class).listId(), 1, false));
        drive(FollowPath.goTo("now", 2, 2, POINTS.get(0), Priority.CRITICAL));
        assertThat(proxy.commands().waiting()).containsExactly(path("c", 1));
        boatSays(new Progress(last(UploadWaypoints.class).listId(), 1, true));
        acknowledge(UploadWaypoints.class);
        readBackEqual();

        assertThat(heard).containsExactly("link LINKED", "progress c 1", "progress now 1", "completed now");
        assertThat(last(StartWaypoints.class).index()).isEqualTo(1);
        assertThat(last(StartWaypoints.class).listId()).startsWith("c#");
        assertThat(proxy.commands().visitedCount("c")).contains(1);
    }

    @Test
    void continuesWithoutAnUploadWhenTheBoatStillHoldsTheList() {
        link("b1");
        drive(path("c", 1));
        String listId = last(UploadWaypoints.class).listId();
        tick(4);
        assertThat(heard).endsWith("link LOST");
        boatSays(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        assertThat(count(StartWaypoints.class)).isEqualTo(1);
        boatSays(new Progress(listId, 1, false));

        assertThat(count(UploadWaypoints.class)).isEqualTo(1);
        assertThat(count(StartWaypoints.class)).isEqualTo(2);
        assertThat(last(StartWaypoints.class).index()).isEqualTo(1);
    }

    @Test
    void completesWhatTheBoatFinishedWhileTheLinkWasLost() {
        link("b1");
        drive(path("c", 1));
        tick(4);
        boatSays(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boatSays(new Progress(last(UploadWaypoints.class).listId(), 2, true));

        assertThat(heard).endsWith("link LINKED", "progress c 2", "completed c");
        assertThat(count(StartWaypoints.class)).isEqualTo(1);
    }

    @Test
    void boatThatStartedAnewIsNotMovedBeforeSomebodyAllowsIt() {
        link("b1");
        drive(path("c", 1));
        boatSays(new Progress(last(UploadWaypoints.class).listId(), 1, false));
        tick(4);
        link("b2");
        tickAlive(10);

        assertThat(heard).endsWith("link LOST", "link LINKED", "restarted");
        assertThat(count(UploadWaypoints.class)).isEqualTo(1);
        assertThat(proxy.explain().text()).contains("nobody has allowed it to move again");
        proxy.confirmRestart();
        assertThat(count(UploadWaypoints.class)).isEqualTo(2);
        acknowledge(UploadWaypoints.class);
        readBackEqual();
        assertThat(last(StartWaypoints.class).index()).isEqualTo(1);
    }

    @Test
    void closedTransportIsALostLinkAtOnce() {
        link("b1");
        proxy.closed(nowMs);
        proxy.closed(nowMs);

        assertThat(heard).containsExactly("link LINKED", "link LOST");
    }

    @Test
    void observerWaitsForTheCommand() {
        boatSays(new Welcome("boat1", "b1", Role.OBSERVER, ""));
        boatSays(new Progress("", 0, false));
        proxy.commands().submit(path("c", 1));
        assertThat(proxy.explain().text()).contains("another client commands the boat");
        assertThat(count(UploadWaypoints.class)).isZero();

        link("b1");
        assertThat(count(UploadWaypoints.class)).isEqualTo(1);
    }

    @Test
    void wrongBoatIsExplained() {
        boatSays(new Goodbye("boat9", "this boat is boat9"));

        assertThat(proxy.explain().text()).contains("this boat is boat9");
        assertThat(proxy.status().link()).isEqualTo(LinkState.CONNECTING);
    }

    @Test
    void oldTelemetryIsDropped() {
        link("b1");
        byte[] older = codec.encode(50, telemetry(1.0, BoatMode.STOPPED));
        proxy.receive(codec.encode(51, telemetry(2.0, BoatMode.STOPPED)), nowMs);
        proxy.receive(older, nowMs);

        assertThat(proxy.status().pose().orElseThrow().speedMps()).isEqualTo(2.0);
    }

    @Test
    void statusHoldsTheBatteryWithItsClass() {
        link("b1");
        boatSays(new BatteryReport(29, BatteryLevel.LOW));
        boatSays(telemetry(0, BoatMode.STOPPED));

        assertThat(proxy.status().battery()).contains(new BatteryState(88, BatteryLevel.LOW));
        assertThat(heard).endsWith("battery LOW");
    }

    @Test
    void noiseIsCountedAndDoesNotKeepTheLinkAlive() {
        link("b1");
        for (int i = 0; i < 40; i++) {
            tick(0.1);
            proxy.receive(new byte[] {0, 0, 0, 1, 9}, nowMs);
        }

        assertThat(proxy.unreadableFrames()).isEqualTo(40);
        assertThat(proxy.status().link()).isEqualTo(LinkState.LOST);
    }

    @Test
    void listenerMaySubmitFromItsCall() {
        proxy = new BoatProxy(
                "boat1",
                this::keep,
                new Recorder() {
                    @Override
                    public void accept(FleetEvent event) {
                        super.accept(event);
                        if (event instanceof FleetEvent.CommandCompleted done
                                && done.command().commandId().equals("c")) {
                            proxy.commands().submit(path("next", 1).startingAt(2));
                            proxy.commands().submit(path("last", 1));
                        }
                    }
                },
                ProxyConfig.DEFAULT);
        link("b1");
        drive(path("c", 1));
        boatSays(new Progress(last(UploadWaypoints.class).listId(), 2, true));

        assertThat(heard).endsWith("completed c", "completed next");
        assertThat(last(UploadWaypoints.class).listId()).startsWith("last#");
    }

    @Test
    void laterStartOfTheBaseUsesOtherWireIds() {
        link("b1");
        proxy.commands().submit(path("c", 1));
        String before = last(UploadWaypoints.class).commandId();
        proxy = new BoatProxy("boat1", this::keep, new Recorder(), ProxyConfig.DEFAULT.withEpoch(1));
        link("b1");
        proxy.commands().submit(path("c", 1));

        assertThat(last(UploadWaypoints.class).commandId()).isNotEqualTo(before);
    }

    @Test
    void explainsWhyNothingMoves() {
        link("b1");
        assertThat(proxy.explain())
                .isEqualTo(new BoatExplanation(
                        false,
                        BoatExplanation.Cause.NO_COMMAND,
                        "boat1 does not move: no mission wants anything of it"));

        proxy.commands().submit(new Stop("s", 4, 1, Priority.LOW, true));
        proxy.commands().submit(path("c", 1));
        acknowledge(StopMotors.class);
        assertThat(proxy.explain().text()).contains("mission 4 keeps it where it is; one command waits");
        proxy.commands().withdraw(4);
        acknowledge(UploadWaypoints.class);
        readBackEqual();
        acknowledge(StartWaypoints.class);
        assertThat(proxy.explain())
                .isEqualTo(new BoatExplanation(
                        true,
                        BoatExplanation.Cause.UNDER_WAY,
                        "boat1 follows its path for mission 1: under way, 0 of 2 points visited"));
    }

    private static Telemetry telemetry(double speedMps, BoatMode mode) {
        return new Telemetry(45, 10, 0, speedMps, 88, mode, 1);
    }

    private class Recorder implements Consumer<FleetEvent> {
        @Override
        public void accept(FleetEvent event) {
            if (event instanceof FleetEvent.CommandCompleted done) {
                onCompleted(done.command());
            } else if (event instanceof FleetEvent.CommandFailed failed) {
                onFailed(failed.command(), failed.reason());
            } else if (event instanceof FleetEvent.Progressed progressed) {
                onProgress(progressed.command(), progressed.visited());
            } else if (event instanceof FleetEvent.LinkChanged link) {
                onLinkChange(link.status());
            } else if (event instanceof FleetEvent.BatteryReported battery) {
                onBattery(battery.battery());
            } else if (event instanceof FleetEvent.Restarted) {
                onRestarted();
            }
        }

        private void onCompleted(BoatCommand command) {
            heard.add("completed " + command.commandId());
        }

        private void onFailed(BoatCommand command, String reason) {
            heard.add("failed " + command.commandId() + ": " + reason);
        }

        private void onProgress(BoatCommand command, int visitedCount) {
            heard.add("progress " + command.commandId() + " " + visitedCount);
        }

        private void onLinkChange(BoatStatus status) {
            heard.add("link " + status.link());
        }

        private void onBattery(BatteryState battery) {
            heard.add("battery " + battery.level());
        }

        private void onRestarted() {
            heard.add("restarted");
        }
    }
}
