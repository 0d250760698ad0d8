package org.sami.crw.sim.boat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.log.LogLines;
import org.sami.boat.server.log.LoggedCommand;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Real boats on real ports of the loopback address, routers in between, and bases; all closed with it. */
final class TcpTestFleet implements AutoCloseable {
    static final GeoPoint PIER = GeoPoint.of(45.4, 10.9);

    private final Path logs;
    private final LongSupplier clockMs;
    private final TestLinks links;
    private final Map<InetSocketAddress, String> names = new ConcurrentHashMap<>();
    private final List<AutoCloseable> opened = new ArrayList<>();

    TcpTestFleet(Path logs) {
        this(logs, ProcessClock::ms);
    }

    /** A fleet whose boats and bases live on a clock of milliseconds. */
    TcpTestFleet(Path logs, LongSupplier clockMs) {
        this(logs, clockMs, TestLinks.plain());
    }

    /** A fleet with links of some kind. */
    TcpTestFleet(Path logs, TestLinks links) {
        this(logs, ProcessClock::ms, links);
    }

    TcpTestFleet(Path logs, LongSupplier clockMs, TestLinks links) {
        this.links = links;
        this.logs = logs;
        this.clockMs = clockMs;
    }

    static InetSocketAddress port(int port) {
        return new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
    }

    /** The links of this fleet. */
    TestLinks kindOfLinks() {
        return links;
    }

    BoatOnTcp boat(String name) throws IOException {
        return boat(name, 0, logs);
    }

    BoatOnTcp boat(String name, int port, Path logFolder) throws IOException {
        return boat(name, port, logFolder, clockMs);
    }

    /** A boat on a clock of its own. */
    BoatOnTcp boat(String name, LongSupplier ownClockMs) throws IOException {
        return boat(name, 0, logs, ownClockMs);
    }

    private BoatOnTcp boat(String name, int port, Path logFolder, LongSupplier ownClockMs) throws IOException {
        return launch(BoatSettings.of(name, port(port), PIER, 1).loggingTo(logFolder), ownClockMs);
    }

    private BoatOnTcp launch(BoatSettings settings, LongSupplier ownClockMs) throws IOException {
        String name = settings.name();
        BoatOnTcp boat =
                keep(new BoatOnTcp(settings, new SteadyClock(ownClockMs), TcpServerListener.NONE, links.ofBoat(name)));
        names.put(boat.address(), name);
        return boat;
    }

    /** A boat that lies somewhere else. */
    BoatOnTcp boat(String name, GeoPoint at) throws IOException {
        return launch(BoatSettings.of(name, port(0), at, 1).loggingTo(logs), clockMs);
    }

    DelayingRelay lateRelay(BoatOnTcp boat) throws IOException {
        return keep(new DelayingRelay(boat.address()));
    }

    TestRelay relay(BoatOnTcp boat) throws IOException {
        String name = Objects.requireNonNull(names.get(boat.address()), "not of this fleet");
        return keep(new TestRelay(boat.address(), links.ofPeer(name), links.ofBaseItself()));
    }

    RoughNetwork roughNetwork(BoatOnTcp boat) throws IOException {
        return keep(new RoughNetwork(boat.address()));
    }

    /** A base with links of another kind than those of this fleet. */
    Base base(String clientId, TestLinks ownLinks) {
        ProxyConfig proxy = ProxyConfig.DEFAULT.withClientId(clientId).withTelemetryHz(20);
        return keep(new Base(proxy, new SteadyClock(clockMs), ownLinks));
    }

    Base base(String clientId) {
        return base(clientId, clockMs);
    }

    Base base(String clientId, LongSupplier ownClockMs) {
        ProxyConfig proxy = ProxyConfig.DEFAULT.withClientId(clientId).withTelemetryHz(20);
        return keep(new Base(proxy, new SteadyClock(ownClockMs), links));
    }

    /** A base that sends again after so many ms what stays unanswered. */
    Base impatientBase(String clientId, long resendMs) {
        ProxyConfig proxy = new ProxyConfig(clientId, 0, 1.5, 20, 3500, resendMs, 20);
        return keep(new Base(proxy, new SteadyClock(clockMs), links));
    }

    private <C extends AutoCloseable> C keep(C closeable) {
        opened.add(closeable);
        return closeable;
    }

    /** What a boat has executed or refused, by its own log. */
    List<LoggedCommand> log(String name) throws IOException {
        List<LoggedCommand> entries = new ArrayList<>();
        LogLines.read(logs.resolve(name + ".log"), entries::add);
        return entries;
    }

    List<String> executedIds(String name) throws IOException {
        return log(name).stream().map(entry -> entry.command().commandId()).toList();
    }

    /** How many commands of a kind a boat has executed. */
    long executed(String name, String type) throws IOException {
        return log(name).stream()
                .filter(entry -> entry.command().type().equals(type))
                .count();
    }

    /** The same, for conditions. */
    long executedOf(String name, String type) {
        try {
            return executed(name, type);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A path of points so many metres north of the pier, and far away eastward if there are none. */
    static FollowPath path(String id, long mission, double... northM) {
        List<GeoPoint> points = new ArrayList<>();
        for (double north : northM) {
            points.add(GeoPoint.of(PIER.latDeg() + north / 111_132.0, PIER.lonDeg()));
        }
        if (points.isEmpty()) {
            points.add(GeoPoint.of(PIER.latDeg(), PIER.lonDeg() + 0.1));
        }
        return FollowPath.of(id, mission, 1, points, Priority.MEDIUM);
    }

    @Override
    public void close() throws Exception {
        for (int i = opened.size() - 1; i >= 0; i--) {
            opened.get(i).close();
        }
    }

    /** A base and all that it was told. */
    static final class Base implements AutoCloseable, BaseListener {
        final ConcurrentLinkedQueue<String> heard = new ConcurrentLinkedQueue<>();
        final ConcurrentLinkedQueue<LinkAlarm> alarms = new ConcurrentLinkedQueue<>();
        final ConcurrentLinkedQueue<String> failures = new ConcurrentLinkedQueue<>();
        final Map<String, BoatStatus> statuses = new ConcurrentHashMap<>();
        final TcpBase tcp;
        volatile boolean onlyWatches;

        Base(ProxyConfig proxy, SteadyClock clock, TestLinks links) {
            TcpBaseConfig plain = new TcpBaseConfig(proxy, 5, 50, 1000, 20, 200, 256, 1 << 20);
            tcp = new TcpBase(links.ofBase(plain), clock, this);
        }

        BoatProxy connect(InetSocketAddress address, String expected) {
            tcp.connect(address);
            linked(expected);
            return ask(expected, proxy -> proxy);
        }

        void linked(String boatId) {
            Await.until(boatId + " is linked", () -> status(boatId).link() == LinkState.LINKED);
        }

        BoatStatus status(String boatId) {
            return statuses.getOrDefault(boatId, BoatStatus.unknown(boatId));
        }

        Optional<BoatMode> mode(String boatId) {
            return status(boatId).mode();
        }

        void awaitMode(String boatId, BoatMode mode) {
            Await.until(boatId + " is at " + mode, () -> mode(boatId).equals(Optional.of(mode)));
        }

        <T> T ask(String boatId, Function<BoatProxy, T> question) {
            return tcp.query(proxies -> question.apply(proxies.find(boatId).orElseThrow()))
                    .join();
        }

        void submit(String boatId, BoatCommand command) {
            ask(boatId, proxy -> {
                proxy.commands().submit(command);
                return true;
            });
        }

        String explanation(String boatId) {
            return ask(boatId, proxy -> proxy.explain().text());
        }

        Optional<Upload> upload(String boatId) {
            return ask(boatId, proxy -> proxy.commands().upload());
        }

        Optional<String> heldListId(String boatId) {
            return ask(boatId, proxy -> proxy.commands().heldListId());
        }

        List<LinkReport> links() {
            return tcp.links().join();
        }

        long count(String line) {
            return heard.stream().filter(line::equals).count();
        }

        @Override
        public void close() {
            tcp.close();
        }

        @Override
        public Consumer<FleetEvent> found(String boatId) {
            return new Recorder();
        }

        @Override
        public void onBoat(BoatProxy proxy) {
            if (onlyWatches) {
                proxy.handOver().observe();
            }
        }

        @Override
        public void onMoved(String boatId, InetSocketAddress from, InetSocketAddress to) {
            heard.add(boatId + " moved to port " + to.getPort());
        }

        @Override
        public void onRemoved(String boatId) {
            heard.add(boatId + " removed");
        }

        @Override
        public void onAlarm(LinkAlarm alarm) {
            alarms.add(alarm);
        }

        @Override
        public void onFailure(String what, RuntimeException cause) {
            failures.add(what + ": " + cause);
        }

        /** Writes down what a proxy tells. */
        private final class Recorder implements Consumer<FleetEvent> {
            @Override
            public void accept(FleetEvent event) {
                if (event instanceof FleetEvent.StatusReported reported) {
                    onStatus(reported.status());
                } else if (event instanceof FleetEvent.LinkChanged link) {
                    onLinkChange(link.status());
                } else if (event instanceof FleetEvent.CommandCompleted done) {
                    onCompleted(done.boat(), done.command());
                } else if (event instanceof FleetEvent.CommandFailed failed) {
                    onFailed(failed.boat(), failed.command(), failed.reason());
                } else if (event instanceof FleetEvent.Restarted restarted) {
                    onRestarted(restarted.status());
                } else if (event instanceof FleetEvent.CommanderChanged commander) {
                    onCommanding(commander.boat(), commander.commands());
                } else if (event instanceof FleetEvent.CommandAsked asked) {
                    onCommandAsked(asked.boat(), asked.client());
                } else if (event instanceof FleetEvent.Refused refused) {
                    onRefused(refused.boat(), refused.reason());
                }
            }

            private void onStatus(BoatStatus status) {
                statuses.put(status.boatId(), status);
            }

            private void onLinkChange(BoatStatus status) {
                statuses.put(status.boatId(), status);
                heard.add(status.boatId() + " " + status.link());
            }

            private void onCompleted(String boatId, BoatCommand command) {
                heard.add(boatId + " completed " + command.commandId());
            }

            private void onFailed(String boatId, BoatCommand command, String reason) {
                heard.add(boatId + " failed " + command.commandId() + ": " + reason);
            }

            private void onRestarted(BoatStatus status) {
                heard.add(status.boatId() + " restarted");
            }

            private void onCommanding(String boatId, boolean commands) {
                heard.add(boatId + (commands ? " commanded" : " observed"));
            }

            private void onCommandAsked(String boatId, String clientId) {
                heard.add(boatId + " asked for by " + clientId);
            }

            private void onRefused(String boatId, String reason) {
                heard.add(boatId + " refused: " + reason);
            }
        }
    }
}
