package org.sami.crw.sim.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.OpenLinks;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;

/** A base on real sockets that counts what reaches it and how long boats take to answer. */
final class MeasuredBase implements BaseListener, Consumer<FleetEvent>, AutoCloseable {
    private final TcpBase base;
    private final AtomicLong poses = new AtomicLong();
    private final Map<String, BoatStatus> statuses = new ConcurrentHashMap<>();
    private final Map<String, Long> askedNanos = new ConcurrentHashMap<>();
    private final List<Double> answeredMs = new ArrayList<>(); // for the base's thread

    MeasuredBase(String clientId, double telemetryHz) {
        this(clientId, telemetryHz, new OpenLinks());
    }

    /** A base with links of some kind. */
    MeasuredBase(String clientId, double telemetryHz, LinkSecurity links) {
        ProxyConfig proxy = ProxyConfig.DEFAULT.withClientId(clientId).withTelemetryHz(telemetryHz);
        base = new TcpBase(TcpBaseConfig.of(proxy, 1).withSecurity(links), SteadyClock.ofThisMachine(), this);
    }

    /** Links all boats of a process. */
    void connect(FleetProcess fleet) {
        fleet.addresses().forEach(base::connect);
        int boats = fleet.addresses().size();
        await("all boats are linked", () -> linked() == boats);
    }

    private long linked() {
        return statuses.values().stream()
                .filter(status ->
                        status.link() == LinkState.LINKED && status.pose().isPresent())
                .count();
    }

    /** Poses received so far. */
    long poses() {
        return poses.get();
    }

    /** Has the base's thread give a boat a path. */
    void submit(String boat, FollowPath path) {
        base.query(boats -> {
                    boats.find(boat).orElseThrow().commands().submit(path);
                    return true;
                })
                .join();
    }

    /** Commands a boat and measures until its answer is back; nothing if it has not answered the last one yet. */
    void command(String boat, double multiplier) {
        if (askedNanos.putIfAbsent(boat, System.nanoTime()) == null) {
            base.executor()
                    .execute(() -> base.boats()
                            .find(boat)
                            .ifPresent(proxy -> proxy.settings().setVelocityMultiplier(multiplier)));
        }
    }

    /** The answers that came since the last time this was asked, in ms. */
    List<Double> takeAnswers() {
        return base.query(boats -> {
                    List<Double> taken = List.copyOf(answeredMs);
                    answeredMs.clear();
                    return taken;
                })
                .join();
    }

    /** Whether what a boat was sent last has been read back equal. */
    boolean isReadBack(String boat, String commandId) {
        return base.query(boats -> boats.find(boat)
                        .flatMap(proxy -> proxy.commands().upload())
                        .filter(upload -> upload.listId().startsWith(commandId + "#"))
                        .filter(upload -> upload.state() == Upload.State.READ_BACK_EQUAL)
                        .isPresent())
                .join();
    }

    static void await(String what, BooleanSupplier condition) {
        long end = System.nanoTime() + 60_000_000_000L;
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() > end) {
                throw new IllegalStateException("not within a minute: " + what);
            }
            LockSupport.parkNanos(500_000);
        }
    }

    @Override
    public Consumer<FleetEvent> found(String boatId) {
        return this;
    }

    @Override
    public void onFailure(String what, RuntimeException cause) {
        throw new IllegalStateException(what, cause);
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            onStatus(reported.status());
        } else if (event instanceof FleetEvent.LinkChanged link) {
            onLinkChange(link.status());
        } else if (event instanceof FleetEvent.SettingsReported settings) {
            onTuning(settings.boat());
        }
    }

    private void onStatus(BoatStatus status) {
        poses.incrementAndGet();
        statuses.put(status.boatId(), status);
    }

    private void onLinkChange(BoatStatus status) {
        statuses.put(status.boatId(), status);
    }

    private void onTuning(String boatId) {
        Long asked = askedNanos.remove(boatId);
        if (asked != null) {
            answeredMs.add((System.nanoTime() - asked) / 1e6);
        }
    }

    @Override
    public void close() {
        base.close();
    }
}
