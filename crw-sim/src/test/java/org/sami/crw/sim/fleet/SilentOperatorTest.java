package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerSession;
import org.sami.boat.server.vehicle.Camera;
import org.sami.boat.server.vehicle.CameraShot;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** A boat that was restarted, and an operator who answers nothing: it does not turn its motors on, whatever it was asked before. */
class SilentOperatorTest {
    private static final GeoPoint THERE = GeoPoint.of(45.001, 10);

    private final Drifting vehicle = new Drifting();
    private final Queue<Runnable> onTheWay = new ArrayDeque<>();
    private final List<CommandMessage> commands = new ArrayList<>();
    private final List<LinkMessage> answers = new ArrayList<>();
    private final List<String> told = new ArrayList<>();
    private final BoatProxy proxy = new BoatProxy("anna", this::toBoat, new Told(), ProxyConfig.DEFAULT);
    private Optional<ServerSession> session = Optional.empty();
    private BoatServer server;
    private long nowMs;

    static Stream<Arguments> whatWasWantedAndIsSetForALostLink() {
        List<BoatCommand> wanted = List.of(
                FollowPath.of("path", 1, 1, List.of(THERE), Priority.MEDIUM),
                new KeepStation("station", 1, 1, THERE, 5, Priority.CRITICAL, true),
                new Panorama("pictures", 1, 1, 8, Priority.MEDIUM));
        return wanted.stream()
                .flatMap(command -> Stream.of(LostLinkAction.values())
                        .flatMap(action -> Stream.of(true, false).map(log -> Arguments.of(command, action, log))));
    }

    @ParameterizedTest
    @MethodSource("whatWasWantedAndIsSetForALostLink")
    void boatRestsForAsLongAsNobodyAnswers(BoatCommand wanted, LostLinkAction action, boolean withLog) {
        start("boot1", action, false);
        open();
        proxy.commands().submit(wanted);
        run(20);
        assertThat(vehicle.wasDriven).isTrue();
        close();
        start("boot2", action, withLog);
        vehicle.wasDriven = false;
        open();
        run(600);
        close();
        run(60); // it has done what is set for a lost link, if anything
        open();
        run(600);
        session = Optional.empty(); // what is sent goes nowhere, and no socket is closed
        run(60);
        open();
        run(60);

        assertThat(server.mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(vehicle.wasDriven).isFalse();
        assertThat(told).contains("restarted");
        proxy.confirmRestart();
        run(20);
        assertThat(vehicle.wasDriven).as("once it may").isTrue();
    }

    private void start(String bootId, LostLinkAction action, boolean withLog) {
        server = new BoatServer(
                ServerConfig.of("anna", bootId).lostLinkAction(action).build(),
                vehicle,
                (ms, client, command, answer) -> {
                    commands.add(command);
                    answers.add(answer);
                });
        for (int i = 0; withLog && i < commands.size(); i++) {
            server.restore("base", commands.get(i), answers.get(i));
        }
    }

    private void open() {
        session = Optional.of(server.connect(frame -> onTheWay.add(() -> proxy.receive(frame, nowMs))));
        proxy.opened(nowMs);
    }

    private void close() {
        onTheWay.clear();
        session.orElseThrow().closed(nowMs);
        session = Optional.empty();
        proxy.closed(nowMs);
    }

    private void toBoat(byte[] frame) {
        session.ifPresent(open -> onTheWay.add(() -> open.receive(frame, nowMs)));
    }

    private void run(int seconds) {
        for (int i = 0; i < 10 * seconds; i++) {
            nowMs += 100;
            server.tick(nowMs);
            proxy.tick(nowMs);
            for (Runnable next = onTheWay.poll(); next != null; next = onTheWay.poll()) {
                next.run();
            }
            vehicle.eastM += 0.02;
        }
    }

    /** Hears that the boat was restarted. */
    private final class Told implements Consumer<FleetEvent> {
        @Override
        public void accept(FleetEvent event) {
            if (event instanceof FleetEvent.Restarted) {
                told.add("restarted");
            }
        }
    }

    /** A boat in a current, whatever its motors do. */
    private static final class Drifting implements Vehicle {
        private static final LocalFrame FRAME = new LocalFrame(45, 10);
        private double eastM;
        private boolean wasDriven;

        @Override
        public double latDeg() {
            return FRAME.latDeg(eastM, 0);
        }

        @Override
        public double lonDeg() {
            return FRAME.lonDeg(eastM, 0);
        }

        @Override
        public double headingRad() {
            return 0;
        }

        @Override
        public double speedMps() {
            return 0.2;
        }

        @Override
        public double batteryPercent() {
            return 100;
        }

        @Override
        public Optional<Camera> camera() {
            return Optional.of(CameraShot::withoutFile);
        }

        @Override
        public void setMotors(double port, double starboard) {
            wasDriven |= port != 0 || starboard != 0;
        }
    }
}
