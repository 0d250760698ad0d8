package org.sami.crw.session;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.file.BoatFileFetch;
import org.sami.crw.proxy.file.BoatFileLink;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.file.FileNews;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.crw.service.Geodesy;
import org.sami.crw.session.picture.PictureAccess;
import org.sami.spn.value.GeoPoint;

/** Boats behind TCP. Knows which address leads to which boat, and who waits for an address to lead to one. */
final class TcpFleet implements FleetConnector {
    private static final double SPACING_M = 5; // between simulated boats that are added together, west to east

    private final TcpBaseConfig config;
    private final SteadyClock clock;
    private final Optional<SimulatedBoats> simulated;
    private final Map<InetSocketAddress, String> boatAt = new HashMap<>(); // this and the next: for the fleet's thread
    private final Map<InetSocketAddress, List<Consumer<String>>> awaited = new HashMap<>();
    private volatile @Nullable TcpBase base; // null until it is open

    TcpFleet(TcpBaseConfig config, SteadyClock clock, Optional<SimulatedBoats> simulated) {
        this.config = config;
        this.clock = clock;
        this.simulated = simulated;
    }

    @Override
    public void open(BaseListener listener) {
        base = new TcpBase(config, clock, new Relay(listener));
    }

    private TcpBase base() {
        return Objects.requireNonNull(base, "the fleet is not open");
    }

    @Override
    public Executor executor() {
        return base().executor();
    }

    @Override
    public ProxyRegistry boats() {
        return base().boats();
    }

    @Override
    public void connect(Request request, Consumer<String> found) {
        InetSocketAddress address = BoatAddress.parse(request.server()).toSocketAddress();
        String known = boatAt.get(address);
        if (known != null) {
            found.accept(known);
        } else {
            awaited.computeIfAbsent(address, unknown -> new ArrayList<>()).add(found);
            base().connect(address);
        }
    }

    @Override
    public List<String> create(String name, String color, GeoPoint start, int count) {
        List<String> created = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            String boat = unused(count == 1 ? name : name.strip() + (i + 1));
            relaunch(boat, Geodesy.offset(start, i * SPACING_M, 0)); // boats on one spot are in each other's way
            created.add(boat);
        }
        return created;
    }

    @Override
    public void relaunch(String boat, GeoPoint at) {
        SimulatedBoats launcher = simulated.orElseThrow(
                () -> new IllegalStateException("this session has nobody who makes simulated boats"));
        try {
            InetSocketAddress address = launcher.launch(boat, at).toSocketAddress();
            base().expect(boat); // its name is taken from now on
            base().connect(address);
        } catch (IOException noPort) {
            throw new IllegalStateException(boat + " cannot be launched: " + noPort.getMessage(), noPort);
        }
    }

    private String unused(String wanted) {
        String name = wanted.isBlank() ? "boat" : wanted.strip();
        String id = name;
        for (int i = 2; boats().find(id).isPresent(); i++) {
            id = name + "-" + i;
        }
        return id;
    }

    @Override
    public void expect(String boat) {
        base().expect(boat);
    }

    @Override
    public CompletionStage<Boolean> disconnect(String boat) {
        return base().remove(boat);
    }

    @Override
    public CompletionStage<Boolean> disconnect(BoatAddress address) {
        awaited.remove(address.toSocketAddress());
        return base().disconnect(address.toSocketAddress());
    }

    @Override
    public CompletionStage<List<LinkReport>> links() {
        return base().links();
    }

    @Override
    public List<LinkReport> linkReports() {
        return base().linkReports();
    }

    @Override
    public void keepTo(OperatingArea area, RobotKind robots) {
        base().keepTo(area.fence(), area.noGo(), robots);
    }

    @Override
    public BoatFileSource files(BoatAddress boat) {
        return new BoatFileLink(boat.toSocketAddress(), config.security());
    }

    @Override
    public Optional<PictureAccess> pictures(String boat) {
        return boatAt.entrySet().stream()
                .filter(one -> one.getValue().equals(boat))
                .findFirst()
                .map(one -> new Pictures(boat, new BoatFileFetch(one.getKey(), config.security(), FileNews.NONE)));
    }

    /** A boat's pictures, over a link of their own. */
    private record Pictures(String boat, BoatFileFetch link) implements PictureAccess {
        @Override
        public void fetch(List<String> names, Path folder, BoatFileFetch.NamedFiles result) throws IOException {
            link.fetch(boat, KeptFile.PICTURE, names, folder, result);
        }

        @Override
        public void cancel() {
            link.cancel();
        }
    }

    @Override
    public void close() {
        base().close();
        simulated.ifPresent(SimulatedBoats::close);
    }

    /** Passes everything on, and keeps where boats are. */
    private final class Relay implements BaseListener {
        private final BaseListener listener;

        Relay(BaseListener listener) {
            this.listener = listener;
        }

        @Override
        public Consumer<FleetEvent> found(String boatId) {
            return listener.found(boatId);
        }

        @Override
        public void onBoat(BoatProxy proxy) {
            listener.onBoat(proxy);
        }

        @Override
        public void onReached(String boatId, InetSocketAddress at) {
            boatAt.values().remove(boatId);
            boatAt.put(at, boatId);
            listener.onReached(boatId, at);
            BoatAddress reached = BoatAddress.of(at);
            List<InetSocketAddress> meant = awaited.keySet().stream()
                    .filter(each -> BoatAddress.of(each).leadsTo(reached))
                    .toList();
            meant.forEach(each -> awaited.remove(each).forEach(found -> found.accept(boatId)));
        }

        @Override
        public void onJoined(InetSocketAddress joined, InetSocketAddress vehicle) {
            List<Consumer<String>> waiting =
                    Optional.ofNullable(awaited.remove(joined)).orElse(List.of());
            String known = boatAt.get(vehicle);
            if (known != null) {
                waiting.forEach(found -> found.accept(known));
            } else if (!waiting.isEmpty()) {
                awaited.computeIfAbsent(vehicle, unknown -> new ArrayList<>()).addAll(waiting);
            }
            listener.onJoined(joined, vehicle);
        }

        @Override
        public void onMoved(String boatId, InetSocketAddress from, InetSocketAddress to) {
            listener.onMoved(boatId, from, to);
        }

        @Override
        public void onRemoved(String boatId) {
            boatAt.values().remove(boatId);
            listener.onRemoved(boatId);
        }

        @Override
        public void onAlarm(LinkAlarm alarm) {
            listener.onAlarm(alarm);
        }

        @Override
        public void onFailure(String what, RuntimeException cause) {
            listener.onFailure(what, cause);
        }
    }
}
