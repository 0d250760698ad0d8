package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.Welcome;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.TrafficRelay;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.spn.protocol.Priority;

/**
 * The links of a base, and the boat that each carries. When a boat answers at a second address, the first link keeps it while frames arrive there,
 * and the second is refused with an alarm. When the first is silent, the boat has moved. For the base's thread.
 */
final class LinkTable {
    private static final long STOP_WITHIN_MS = 2000;

    private final TcpBaseConfig config;
    private final BaseListener listener;
    private final Function<BoatLink, BoatConnection> connections;
    private final BiConsumer<String, Runnable> guarded;
    private final List<BoatLink> links = new ArrayList<>();
    private final List<Leaving> leaving = new ArrayList<>();
    private final ProxyRegistry proxies = new ProxyRegistry();
    private final TrafficRelay traffic = new TrafficRelay();
    private final Map<String, BoatLink> carriers = new LinkedHashMap<>();
    // by the boat that was there, until it is known who answers
    private final Map<BoatLink, String> left = new HashMap<>();
    private final Map<InetSocketAddress, InetSocketAddress> joined =
            new LinkedHashMap<>(); // second links to vehicles, with the addresses of these
    private final Map<String, BoatProxy> removed = new HashMap<>(); // each remembers which ids it has used
    private final Set<LinkAlarm> alarmed = new LinkedHashSet<>();
    private long made;
    private long nowMs;

    /**
     * A table without links.
     *
     * @param connections makes a connection of a link
     * @param guarded runs work that is named in words, and reports what it throws
     */
    LinkTable(
            TcpBaseConfig config,
            BaseListener listener,
            Function<BoatLink, BoatConnection> connections,
            BiConsumer<String, Runnable> guarded) {
        this.guarded = guarded;
        this.config = config;
        this.listener = listener;
        this.connections = connections;
    }

    ProxyRegistry proxies() {
        return proxies;
    }

    List<LinkReport> reports() {
        List<LinkReport> reports = new ArrayList<>();
        for (BoatLink link : links) {
            LinkReport report = link.report(nowMs);
            reports.add(report);
            joined.forEach((second, vehicle) -> {
                if (vehicle.equals(link.address())) {
                    reports.add(report.at(second));
                }
            });
        }
        return reports;
    }

    /** Every connection that stands or is tried. */
    List<BoatConnection> connections() {
        List<BoatConnection> all = new ArrayList<>();
        links.forEach(link -> link.connection().ifPresent(all::add));
        leaving.forEach(one -> one.link.connection().ifPresent(all::add));
        return all;
    }

    void add(InetSocketAddress address, long atMs) {
        nowMs = atMs;
        joined.remove(address);
        boolean known = links.stream().anyMatch(link -> link.address().equals(address));
        if (!known) {
            BoatLink link = new BoatLink(address, config, new Hand(), config.seed() + made++);
            links.add(link);
            link.tick(nowMs);
        }
    }

    /** An address has led to a boat that has an address of its own, as it stands for several or is a second link; it is not looked at any longer itself. */
    void found(InetSocketAddress several, InetSocketAddress boat, long atMs) {
        add(boat, atMs);
        links.stream()
                .filter(link -> link.address().equals(several))
                .findFirst()
                .ifPresent(this::drop);
        if (!BoatAddress.of(several).leadsTo(BoatAddress.of(boat))) {
            joined.put(several, boat);
            tell("a second link to a vehicle", () -> listener.onJoined(several, boat));
        }
    }

    /** The boat behind a link says something to the operator. */
    void said(BoatLink link, Priority priority, String text) {
        LinkAlarm alarm =
                new LinkAlarm(LinkAlarm.Kind.SAID_BY_BOAT, link.boatId().orElse(""), link.address(), text, priority);
        tell("a message", () -> listener.onAlarm(alarm));
    }

    /** A boat of that name is known to be somewhere: its proxy takes commands, which wait until an address leads to the boat. */
    void expect(String boatId) {
        if (proxies.find(boatId).isEmpty()) {
            make(boatId);
        }
    }

    private BoatProxy make(String boatId) {
        BoatProxy proxy = Optional.ofNullable(removed.remove(boatId))
                .orElseGet(() -> new BoatProxy(boatId, new Carried(boatId), listener.found(boatId), config.proxy()));
        proxies.add(proxy);
        tell("a boat that was found", () -> listener.onBoat(proxy));
        return proxy;
    }

    /** Gives up an address, and the boat that it carries. Returns whether it was known. */
    boolean remove(InetSocketAddress address, long atMs) {
        nowMs = atMs;
        Optional<BoatLink> found =
                links.stream().filter(link -> link.address().equals(address)).findFirst();
        found.ifPresent(link -> link.boatId().ifPresentOrElse(this::remove, () -> drop(link)));
        return joined.remove(address) != null || found.isPresent();
    }

    /** Gives up a boat and its address. Returns whether it was known. */
    boolean remove(String boatId, long atMs) {
        nowMs = atMs;
        boolean known = proxies.find(boatId).isPresent();
        if (known) {
            remove(boatId);
        }
        return known;
    }

    private void remove(String boatId) {
        BoatProxy proxy = proxies.find(boatId).orElseThrow();
        proxies.remove(boatId);
        removed.put(boatId, proxy);
        Optional.ofNullable(carriers.remove(boatId)).ifPresent(link -> {
            links.remove(link);
            joined.values().removeIf(link.address()::equals);
            leaving.add(new Leaving(link, proxy, nowMs + STOP_WITHIN_MS));
        });
        forgetAlarms(boatId);
        proxy.retire("the boat has been removed");
        tell("a boat that was removed", () -> listener.onRemoved(boatId));
    }

    private void drop(BoatLink link) {
        links.remove(link);
        left.remove(link);
        link.release("the address is given up", nowMs);
    }

    /** Lets time pass for all links, so that none suffers from another. */
    void tick(long atMs) {
        nowMs = atMs;
        for (BoatLink link : List.copyOf(links)) {
            guarded.accept("a tick of a link", () -> link.tick(atMs));
        }
        guarded.accept("telling boats of each other", () -> traffic.tick(proxies.all(), atMs));
        leaving.forEach(one -> guarded.accept("a tick of a link", () -> one.proxy.tick(atMs)));
        letGo(one -> !one.proxy.isBeingStopped() || atMs >= one.untilMs);
    }

    private void letGo(Predicate<Leaving> which) {
        for (Leaving one : List.copyOf(leaving)) {
            if (which.test(one)) {
                one.link.release("the boat has been removed", nowMs);
                leaving.remove(one);
            }
        }
    }

    /** Tells the listener something; what it throws must not keep a boat from its link. */
    private void tell(String what, Runnable news) {
        guarded.accept("the listener, told of " + what, news);
    }

    private void forgetAlarms(String boatId) {
        alarmed.removeIf(alarm -> alarm.boatId().equals(boatId));
    }

    /** A boat that was removed, until it has stopped. */
    private record Leaving(BoatLink link, BoatProxy proxy, long untilMs) {}

    /** Decides which link carries a boat. */
    private final class Hand implements BoatLink.Base {
        @Override
        public BoatConnection connection(BoatLink link) {
            return connections.apply(link);
        }

        @Override
        public BoatLink.Claim claimed(BoatLink link, BoatLink.Found found) {
            String boatId = found.welcome().boatId();
            BoatLink carrier = carriers.get(boatId);
            if (carrier == null && isNew(boatId) && !link.takesNewBoat(nowMs)) {
                tooMany(link);
                return BoatLink.Claim.TOO_MANY;
            } else if (carrier == null) {
                adopt(link, boatId);
                warnOfBefore(link, found.welcome());
            } else if (carrier.isOpen() && carrier.lastHeardMs() > found.sinceMs()) {
                alarm(carrier, link, found.welcome());
                return BoatLink.Claim.REFUSED;
            } else if (!hasGone(carrier, found.welcome())) {
                return BoatLink.Claim.WAITS;
            } else {
                move(carrier, link, found.welcome());
            }
            return BoatLink.Claim.CARRIES;
        }

        @Override
        public void leftBy(BoatLink link, String boatId) {
            carriers.remove(boatId, link);
            left.put(link, boatId);
            link.release("another boat answers where " + boatId + " was", nowMs);
        }

        @Override
        public void speaksVersion(BoatLink link, int version) {
            String boatId = link.boatId().orElse("");
            String text = "what answers at " + words(link) + " speaks link version " + version + ", this base version "
                    + LinkCodec.VERSION + "; it gets no command until both are of the same version";
            tell(new LinkAlarm(LinkAlarm.Kind.OTHER_VERSION, boatId, link.address(), text));
        }

        private void adopt(BoatLink link, String boatId) {
            letGo(one -> one.proxy.boatId().equals(boatId));
            alarmed.removeIf(alarm -> alarm.kind() == LinkAlarm.Kind.OTHER_VERSION
                    && alarm.address().equals(link.address()));
            String before = Optional.ofNullable(left.remove(link)).orElse(boatId);
            if (!before.equals(boatId)) {
                String text = boatId + " answers at " + words(link) + ", where " + before + " was";
                tell(new LinkAlarm(LinkAlarm.Kind.ANOTHER_BOAT, boatId, link.address(), text));
            }
            BoatProxy proxy = proxies.find(boatId).orElseGet(() -> make(boatId));
            carriers.put(boatId, link);
            LinkTable.this.tell("a boat that is reached", () -> listener.onReached(boatId, link.address()));
            link.carry(proxy, nowMs);
        }

        private void warnOfBefore(BoatLink link, Welcome welcome) {
            if (welcome.epoch().isEmpty()) {
                String text =
                        welcome.boatId() + " at " + words(link) + " speaks the link of before: it obeys bases that"
                                + " were replaced. Bring it to this base's version";
                tell(new LinkAlarm(LinkAlarm.Kind.LINK_OF_BEFORE, welcome.boatId(), link.address(), text));
            }
        }

        /** The same start of the same boat can be at one place only; another boat of its name must not take its place so soon. */
        private boolean hasGone(BoatLink carrier, Welcome welcome) {
            boolean same = isSameStart(welcome);
            return !carrier.isOpen()
                    && (same || nowMs - carrier.lastHeardMs() > config.proxy().lostAfterMs());
        }

        private boolean isSameStart(Welcome welcome) {
            return proxies.find(welcome.boatId())
                    .filter(known -> known.status().bootId().equals(welcome.bootId()))
                    .isPresent();
        }

        private void move(BoatLink from, BoatLink to, Welcome welcome) {
            String boatId = welcome.boatId();
            if (isSameStart(welcome)) {
                drop(from); // a boat of that name may still be elsewhere, and must be noticed then
            } else {
                from.release("the boat is reached elsewhere", nowMs);
            }
            carriers.put(boatId, to);
            left.remove(to);
            forgetAlarms(boatId);
            LinkTable.this.tell("a boat that moved", () -> listener.onMoved(boatId, from.address(), to.address()));
            LinkTable.this.tell("a boat that is reached", () -> listener.onReached(boatId, to.address()));
            to.carry(proxies.find(boatId).orElseThrow(), nowMs);
        }

        private void alarm(BoatLink carrier, BoatLink link, Welcome welcome) {
            String both = words(carrier) + " and " + words(link);
            LinkAlarm alarm = isSameStart(welcome)
                    ? new LinkAlarm(
                            LinkAlarm.Kind.ONE_BOAT_AT_TWO_ADDRESSES,
                            welcome.boatId(),
                            link.address(),
                            welcome.boatId() + " is one boat at " + both + "; the second link is refused")
                    : new LinkAlarm(
                            LinkAlarm.Kind.TWO_BOATS_WITH_ONE_ID,
                            welcome.boatId(),
                            link.address(),
                            "two boats are named " + welcome.boatId() + ", at " + both + "; the second is refused");
            tell(alarm);
        }

        private boolean isNew(String boatId) {
            return proxies.find(boatId).isEmpty() && !removed.containsKey(boatId);
        }

        /** Told of the first, and whenever they have become twice as many. */
        private void tooMany(BoatLink link) {
            long refused = link.refusedBoats();
            if (Long.bitCount(refused) == 1) {
                String text = "boats answer at " + words(link) + " under ever new names; " + refused
                        + (refused == 1 ? " was" : " were") + " not taken";
                LinkTable.this.tell(
                        "an alarm",
                        () -> listener.onAlarm(new LinkAlarm(LinkAlarm.Kind.EVER_NEW_BOATS, "", link.address(), text)));
            }
        }

        private void tell(LinkAlarm alarm) {
            if (alarmed.add(alarm)) {
                LinkTable.this.tell("an alarm", () -> listener.onAlarm(alarm));
            }
        }

        private static String words(BoatLink link) {
            return BoatAddress.of(link.address()).toString();
        }
    }

    /** The way of a proxy's frames: over the link that carries the boat now. */
    private final class Carried implements FrameSink {
        private final String boatId;

        Carried(String boatId) {
            this.boatId = boatId;
        }

        @Override
        public void send(byte[] frame) {
            BoatLink carrier = carriers.get(boatId);
            if (carrier != null) {
                carrier.send(frame);
            } else {
                leaving.stream()
                        .filter(one -> one.proxy.boatId().equals(boatId))
                        .forEach(one -> one.link.send(frame));
            }
        }
    }
}
