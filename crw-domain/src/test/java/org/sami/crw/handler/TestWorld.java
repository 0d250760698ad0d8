package org.sami.crw.handler;

import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerSession;
import org.sami.crw.decision.OperatorDesk;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyConfig;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.service.Geodesy;
import org.sami.spn.host.EngineFunction;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostClock;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;

/** The domain on a real host, with real proxies and boat servers, all on the test's thread and on time that the test lets pass. */
final class TestWorld implements HostClock {
    static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();
    static final GeoPoint HOME = GeoPoint.of(45.6, 10.68);
    private static final int TICK_MS = 100;

    final ProxyRegistry boats = new ProxyRegistry();
    final OperatorDesk desk = new OperatorDesk(Runnable::run);
    final EngineHost host;
    final CrwDomain domain;
    private final Map<String, TestHull> hulls = new LinkedHashMap<>();
    private final Map<String, BoatServer> servers = new LinkedHashMap<>();
    private final ArrayDeque<Runnable> tasks = new ArrayDeque<>();
    private long nowMs;
    private long wakeAtMs = Long.MAX_VALUE;
    private Runnable wake = () -> {};
    private boolean linkUp = true;

    TestWorld(EngineFunction engine) {
        host = EngineHost.builder(engine).clock(this).executor(tasks::add).build();
        domain = CrwDomain.install(host, boats, tasks::add, desk);
        host.addListener(desk);
    }

    /** A boat so many metres from home. */
    TestHull addBoat(String id, double eastM, double northM) {
        TestHull hull = new TestHull(Geodesy.offset(HOME, eastM, northM));
        BoatServer server = new BoatServer(
                ServerConfig.of(id, id + "-boot1").fullThrustSpeedMps(3).build(), hull);
        ServerSession[] session = new ServerSession[1];
        BoatProxy proxy = new BoatProxy(
                id,
                frame -> send(() -> session[0].receive(frame, nowMs)),
                domain.boatListener(),
                ProxyConfig.DEFAULT.withTelemetryHz(5));
        session[0] = server.connect(frame -> send(() -> proxy.receive(frame, nowMs)));
        boats.add(proxy);
        hulls.put(id, hull);
        servers.put(id, server);
        return hull;
    }

    private void send(Runnable delivery) {
        if (linkUp) {
            tasks.add(delivery);
        }
    }

    void cutLinks(boolean cut) {
        linkUp = !cut;
    }

    /** These effects happen now. */
    void happens(ScriptedEngine engine, Effect... effects) {
        engine.willDo(effects);
        host.post(List.of(new Input.TimeReached()));
        drain();
    }

    void run(double seconds) {
        for (int tick = 0; tick < Math.round(seconds * 1000 / TICK_MS); tick++) {
            nowMs += TICK_MS;
            if (nowMs >= wakeAtMs) {
                wakeAtMs = Long.MAX_VALUE;
                wake.run();
            }
            servers.values().forEach(server -> server.tick(nowMs));
            hulls.values().forEach(hull -> hull.step(TICK_MS / 1000.0));
            boats.tick(nowMs);
            drain();
        }
    }

    private void drain() {
        for (Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
            task.run();
        }
    }

    TestHull hull(String boat) {
        return hulls.get(boat);
    }

    @Override
    public long nowMillis() {
        return nowMs;
    }

    @Override
    public void wakeAt(long millis, Runnable action) {
        wakeAtMs = millis;
        wake = action;
    }
}
