package org.sami.crw.mavlink;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.spn.value.GeoArea;

/** A base on real links that records its events, for tests of vehicles. The gateway is found as programs find it. */
final class GatewayWorld implements AutoCloseable, BaseListener {
    static final double WAIT_S = 60;

    final List<FleetEvent> events = new CopyOnWriteArrayList<>();
    final List<String> alarms = new CopyOnWriteArrayList<>();
    final List<LinkAlarm> said = new CopyOnWriteArrayList<>();
    final List<String> faults = new CopyOnWriteArrayList<>();
    private final TcpBase base;

    GatewayWorld(Path folder) {
        this(folder, "base");
    }

    GatewayWorld(Path folder, String client) {
        System.setProperty("sami.vehicles", folder.toString());
        base = new TcpBase(
                TcpBaseConfig.of(ProxyConfig.DEFAULT.withClientId(client), 1), new SteadyClock(ProcessClock::ms), this);
    }

    @Override
    public Consumer<FleetEvent> found(String boatId) {
        return events::add;
    }

    @Override
    public void onAlarm(LinkAlarm alarm) {
        said.add(alarm);
        alarms.add(alarm.text());
    }

    @Override
    public void onFailure(String what, RuntimeException cause) {
        faults.add(what + ": " + cause);
    }

    void connect(String address) {
        base.connect(BoatAddress.parse(address).toSocketAddress());
    }

    /** Gives up a boat. */
    void remove(String boat) {
        base.remove(boat).join();
    }

    void keepTo(Optional<GeoArea> within, List<GeoArea> avoid) {
        base.keepTo(within, avoid, RobotKind.BOAT);
    }

    List<LinkReport> links() {
        return base.links().join();
    }

    void tell(String boat, Consumer<BoatProxy> what) {
        base.query(boats -> {
                    what.accept(boats.find(boat).orElseThrow());
                    return true;
                })
                .join();
    }

    boolean is(String boat, Predicate<BoatProxy> what) {
        return base.query(boats -> boats.find(boat).filter(what).isPresent()).join();
    }

    <T> T ask(String boat, Function<BoatProxy, T> question) {
        return base.query(boats -> question.apply(boats.find(boat).orElseThrow()))
                .join();
    }

    /** The id of the list that the boat holds. */
    String list(String boat) {
        return ask(boat, proxy -> proxy.commands().heldListId().orElseThrow());
    }

    /** Waits until the boat is so. */
    void until(String words, String boat, Predicate<BoatProxy> what) {
        Await.until(words, WAIT_S, () -> is(boat, what));
    }

    /** Waits until the boat takes commands and says where it is. */
    void untilReady(String boat) {
        until(
                boat + " is ready",
                boat,
                proxy -> proxy.isCommanding() && proxy.status().pose().isPresent());
    }

    <T extends FleetEvent> boolean has(Class<T> kind, Predicate<T> what) {
        return events.stream().filter(kind::isInstance).map(kind::cast).anyMatch(what);
    }

    static InetSocketAddress address(String text) {
        return BoatAddress.parse(text).toSocketAddress();
    }

    @Override
    public void close() {
        base.close();
    }
}
