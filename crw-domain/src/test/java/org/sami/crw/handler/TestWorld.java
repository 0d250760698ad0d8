package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerSession;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.handler.planning.ServiceThreads;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.service.Geodesy;
import org.sami.spn.host.EngineFunction;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The domain on a real host, with real proxies and boat servers, all on the test's thread and on time that the test lets pass;
 * the engine too, unless it is given a thread of its own.
 */
final class TestWorld implements HostClock {
    static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();
    static final GeoPoint HOME = GeoPoint.of(45.6, 10.68);
    static final String NOWHERE = "nowhere:0";
    private static final int TICK_MS = 100;

    final ProxyRegistry boats = new ProxyRegistry();
    final OperatorModels operator;
    final EngineHost host;
    final CrwDomain domain;
    private final Map<String, TestHull> hulls = new LinkedHashMap<>();
    private final Map<String, BoatServer> servers = new LinkedHashMap<>();
    private final Map<String, ServerSession> sessions = new LinkedHashMap<>();
    private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();
    private final AtomicLong clock = new AtomicLong();
    private volatile Wake wake = Wake.NEVER;
    private final Set<String> cut = new HashSet<>();
    private boolean linkUp = true;

    TestWorld(EngineFunction engine) {
        this(engine, Optional.empty());
    }

    /** A world whose services compute off the fleet's thread, as in a session in real time. */
    TestWorld(EngineFunction engine, CrwServices services, ServiceThreads threads) {
        host = EngineHostBuilder.of(engine).clock(this).executor(tasks::add).build();
        operator = new OperatorModels(Runnable::run, clock::get);
        domain = CrwDomain.installInRealTime(host, boats, tasks::add, operator, services, threads);
        host.addListener(operator);
        domain.events().subscribe(operator.fleetListener(boats));
    }

    TestWorld(EngineFunction engine, Optional<Executor> enginesOwn) {
        host = EngineHostBuilder.of(engine)
                .clock(this)
                .executor(enginesOwn.orElse(tasks::add))
                .build();
        operator = new OperatorModels(enginesOwn.isPresent() ? tasks::add : Runnable::run, clock::get);
        domain = CrwDomain.install(host, boats, tasks::add, operator, CrwServices.STANDARD, new TestBoatConnector());
        host.addListener(operator);
        domain.events().subscribe(operator.fleetListener(boats));
    }

    /** A boat lies behind every address but one; made boats lie where they are wanted. */
    private final class TestBoatConnector implements BoatConnector {
        @Override
        public void connect(Request request, Consumer<String> found) {
            if (request.server().equals(NOWHERE)) {
                throw new IllegalArgumentException("nobody can be at " + NOWHERE);
            }
            String id = request.name() + " at " + request.server();
            if (boats.find(id).isEmpty()) {
                addBoat(id, 0, 10 * hulls.size());
            }
            found.accept(id);
        }

        @Override
        public List<String> create(String name, String color, GeoPoint start, int count) {
            List<String> made = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                made.add(name + i);
                addBoat(name + i, 5 * i, 0);
            }
            return made;
        }
    }

    /** A boat so many metres from home. */
    TestHull addBoat(String id, double eastM, double northM) {
        return addBoat(id, eastM, northM, hull -> {});
    }

    /** A boat that is fitted out before its server starts. */
    TestHull addBoat(String id, double eastM, double northM, Consumer<TestHull> outfit) {
        TestHull hull = new TestHull(Geodesy.offset(HOME, eastM, northM));
        outfit.accept(hull);
        hulls.put(id, hull);
        boats.add(new BoatProxy(
                id,
                frame -> send(id, () -> sessions.get(id).receive(frame, nowMillis())),
                domain.events()::publish,
                ProxyConfig.DEFAULT.withTelemetryHz(5)));
        startServer(id, id + "-boot1");
        return hull;
    }

    /** The boat's server starts, with nothing of what an earlier one knew. */
    void startServer(String id, String bootId) {
        BoatProxy proxy = boats.find(id).orElseThrow();
        ServerConfig.Builder config = ServerConfig.of(id, bootId).fullThrustSpeedMps(3);
        config.performance(hulls.get(id).performance);
        hulls.get(id).error.ifPresent(config::trackingError);
        BoatServer server = new BoatServer(config.build(), hulls.get(id));
        servers.put(id, server);
        sessions.put(id, server.connect(frame -> send(id, () -> proxy.receive(frame, nowMillis()))));
        proxy.closed(nowMillis());
        proxy.opened(nowMillis());
    }

    private void send(String boat, Runnable delivery) {
        if (linkUp && !cut.contains(boat)) {
            tasks.add(delivery);
        }
    }

    void cutLinks(boolean cut) {
        linkUp = !cut;
    }

    /** Cuts one boat's link, as when it is out of the radio's range, or mends it. */
    void cutLink(String boat, boolean isCut) {
        if (isCut) {
            cut.add(boat);
        } else {
            cut.remove(boat);
        }
    }

    /** These effects happen now. */
    void happens(ScriptedEngine engine, Effect... effects) {
        engine.willDo(effects);
        host.post(List.of(new Input.TimeReached()));
        drain();
    }

    void run(double seconds) {
        for (int tick = 0; tick < Math.round(seconds * 1000 / TICK_MS); tick++) {
            long nowMs = clock.addAndGet(TICK_MS);
            Wake due = wake;
            if (nowMs >= due.atMillis()) {
                due.action().run();
            }
            servers.values().forEach(server -> server.tick(nowMs));
            hulls.values().forEach(hull -> hull.step(TICK_MS / 1000.0));
            boats.tick(nowMs);
            operator.look();
            drain();
        }
    }

    /** What is to be done at this moment is done. */
    void drain() {
        for (Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
            task.run();
        }
    }

    TestHull hull(String boat) {
        return hulls.get(boat);
    }

    @Override
    public long nowMillis() {
        return clock.get();
    }

    @Override
    public void wakeAt(long millis, Runnable action) {
        wake = new Wake(millis, action);
    }

    /** What the host wants to be called for; calling it twice changes nothing. */
    private record Wake(long atMillis, Runnable action) {
        static final Wake NEVER = new Wake(Long.MAX_VALUE, () -> {});
    }
}
