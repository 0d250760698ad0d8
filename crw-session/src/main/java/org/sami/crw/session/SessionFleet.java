package org.sami.crw.session;

import java.io.Closeable;
import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.fleet.publishing.FleetEvents;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SessionTelemetry;

/** The boats of a session: the connector to them, what is known of them, and the watches that look at them every second. */
final class SessionFleet implements Closeable {
    private final SessionThreads threads;
    private final SessionTelemetry telemetry;
    private final FleetConnector connector;
    private final FleetHistory history = new FleetHistory();
    private final Optional<RememberedBoats> remembered;
    private final SettingReplies settings;
    private final FleetEvents events;
    private final FleetListener listener;
    private final BoatWatches watches;
    private final Optional<FleetPictures> pictures;

    /** Opens the connector: boats can be connected from now on. */
    SessionFleet(
            SessionSetup setup,
            SessionThreads threads,
            SessionEngine engine,
            SessionTelemetry telemetry,
            OperatorModels models,
            SessionMessages messages,
            RobotKind robots,
            ThreadGuard guard) {
        this.threads = threads;
        this.telemetry = telemetry;
        remembered = threads.isRealTime() ? Optional.of(new RememberedBoats(engine.host())) : Optional.empty();
        connector = connector(setup.runtime());
        events = new FleetEvents(threads.slowMillis());
        listener = new FleetListener(events, history, telemetry, messages, remembered, threads::nowMs, guard);
        watches = new BoatWatches(setup, connector, history, remembered, telemetry, models, messages, threads::nowMs);
        events.subscribe(watches::take);
        KindWatch kinds = new KindWatch(robots, connector::boats, messages, threads::nowMs);
        listener.onEachBoat(kinds::found);
        events.subscribe(kinds::take);
        settings = new SettingReplies(engine.replies());
        events.subscribe(settings::happened);
        connector.open(listener);
        pictures = FleetPictures.folder(setup)
                .map(folder -> new FleetPictures(folder, threads, connector, events, telemetry, messages));
    }

    private FleetConnector connector(SessionRuntime runtime) {
        if (runtime instanceof SessionRuntime.OneThread one) {
            return one.fleet();
        }
        SessionRuntime.RealTime real = (SessionRuntime.RealTime) runtime;
        Optional<SimulatedBoats> simulated =
                real.simulatedBoats().map(boats -> new RememberedSimulation(boats, remembered.orElseThrow()));
        return new TcpFleet(real.links(), real.clock(), simulated);
    }

    FleetConnector connector() {
        return connector;
    }

    FleetHistory history() {
        return history;
    }

    /** The boats that later processes find again; empty where a session is resumed by running its world again. */
    Optional<RememberedBoats> remembered() {
        return remembered;
    }

    SettingReplies settings() {
        return settings;
    }

    FleetEvents events() {
        return events;
    }

    FleetListener listener() {
        return listener;
    }

    BoatWatches watches() {
        return watches;
    }

    /** The pictures of the boats; empty where none are kept. */
    Optional<FleetPictures> pictures() {
        return pictures;
    }

    /** Looks at boats and pictures; once a second on the fleet's thread. */
    void look() {
        watches.look();
        pictures.ifPresent(FleetPictures::look);
    }

    /** Asks the proxies and waits; not for the fleet's thread. */
    <T> T onFleet(Function<ProxyRegistry, T> question) {
        return CompletableFuture.supplyAsync(() -> question.apply(connector.boats()), connector.executor())
                .join();
    }

    /** Gives the engine's thread the boats that have commands. */
    void boatsWithWork(Consumer<Set<String>> then) {
        connector.executor().execute(() -> {
            Set<String> wanted = connector.boats().all().stream()
                    .filter(boat -> !boat.isAtRest())
                    .map(BoatProxy::boatId)
                    .collect(Collectors.toSet());
            threads.engine().execute(() -> then.accept(wanted));
        });
    }

    /** What becomes of links now is the session's own doing, and is not recorded. */
    void listenNoLonger() {
        listener.close();
        watches.close();
        connector.executor().execute(() -> pictures.ifPresent(FleetPictures::listenNoLonger));
    }

    @Override
    public void close() throws IOException {
        onFleet(ProxyRegistry::boatIds); // what the operator did last has been written down
        connector.close();
        telemetry.flush();
        if (pictures.isPresent()) {
            pictures.get().close();
        }
    }
}
