package org.sami.mavlink.base;

import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.Semaphore;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.link.LinkEnd;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.link.MavlinkLink;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.link.ReceivedMessage;
import org.sami.mavlink.vehicle.RadioSignals;

/** The links of a base: receives on all of them, sends on one. Safe for use by several threads. */
final class BaseLinks implements AutoCloseable {
    private static final int LINK_IDS = 256; // of signatures
    private static final long MARKS = 1L << 32;
    private static final int UNHANDLED = 2_000; // messages that may wait; a link that brings more waits itself

    private final long mark; // in this base's heartbeats, where ground stations have no mode
    private final Executor owner;
    private final BiConsumer<MavlinkAddress, ReceivedMessage> handle;
    private final Semaphore room = new Semaphore(UNHANDLED);
    private final List<MavlinkLink> links = new CopyOnWriteArrayList<>();
    private final List<MavlinkLink> leaving = new CopyOnWriteArrayList<>(); // that are being closed
    private int made;
    private final Optional<LinkSigning> signing;

    /**
     * Links that are not open yet.
     *
     * @param addresses of which each gets one link
     * @param owner runs work on the base's thread
     * @param handle receives each message on that thread
     */
    BaseLinks(
            List<MavlinkAddress> addresses,
            MavlinkBaseOptions options,
            Executor owner,
            BiConsumer<MavlinkAddress, ReceivedMessage> handle) {
        this.owner = owner;
        this.handle = handle;
        signing = options.signing();
        mark = options.marks().nextLong(1, MARKS);
        for (MavlinkAddress address : addresses) {
            links.removeIf(link ->
                    !link.address().equals(address) && link.address().place().equals(address.place()));
            add(address);
        }
    }

    private Optional<MavlinkLink> add(MavlinkAddress address) {
        if (addresses().contains(address)) {
            return Optional.empty();
        }
        LinkEnd end = LinkEnd.ground(made++ % LINK_IDS, signing);
        MavlinkLink link = new MavlinkLink(address, this::received, end, ReadMessages.KINDS::contains);
        links.add(link);
        return Optional.of(link);
    }

    private Optional<MavlinkLink> at(String place) {
        return links.stream()
                .filter(link -> link.address().place().equals(place))
                .findFirst();
    }

    /**
     * Begins to open one more, if its address is another than theirs; in place of one at the same place with another speed, which is closed before. For one thread at a time.
     *
     * @param replaced receives the address of that one, once nothing more comes from it and before anything comes from the new one
     */
    void open(MavlinkAddress address, Consumer<MavlinkAddress> replaced) {
        Optional<MavlinkLink> before =
                at(address.place()).filter(link -> !link.address().equals(address));
        before.ifPresent(link -> {
            leaving.add(link);
            links.remove(link);
        });
        Optional<MavlinkLink> added = add(address);
        before.ifPresent(link -> replaced.accept(link.address()));
        if (before.isPresent() || isLeaving(address)) {
            release(() -> added.ifPresent(MavlinkLink::start));
        } else {
            added.ifPresent(MavlinkLink::start);
        }
    }

    private boolean isLeaving(MavlinkAddress address) {
        return leaving.stream().anyMatch(link -> link.address().place().equals(address.place()));
    }

    /** Closes the link of an address, if there is one; it may be opened again. For one thread at a time. */
    void close(MavlinkAddress address) {
        List<MavlinkLink> closed =
                links.stream().filter(link -> link.address().equals(address)).toList();
        leaving.addAll(closed);
        links.removeAll(closed);
        release(() -> {});
    }

    /** Waits for links that are being closed, which may take seconds, on a thread of its own. */
    private void release(Runnable after) {
        List<MavlinkLink> closed = List.copyOf(leaving);
        Thread thread = new Thread(
                () -> {
                    closed.forEach(MavlinkLink::close);
                    leaving.removeAll(closed);
                    after.run();
                },
                "mavlink closes a link");
        thread.setDaemon(true);
        thread.start();
    }

    /** The radios that report themselves. */
    RadioSignals radios() {
        return new RadioSignals(reports().stream()
                .filter(MavlinkLinkReport::hasRadio)
                .collect(Collectors.toMap(
                        MavlinkLinkReport::address,
                        report -> Stream.of(report.rssi(), report.remoteRssi())
                                .flatMap(Optional::stream)
                                .mapToInt(Integer::intValue)
                                .min())));
    }

    /** Begins to open them; returns at once. */
    void start() {
        links.forEach(MavlinkLink::start);
    }

    /** What is known of each, in the order of the addresses. */
    List<MavlinkLinkReport> reports() {
        return links.stream().map(MavlinkLink::report).toList();
    }

    /** Their addresses, each once. */
    List<MavlinkAddress> addresses() {
        return links.stream().map(MavlinkLink::address).toList();
    }

    /** On a link's thread: waits where too much is not handled yet, so that the sender is slowed and memory is not filled. */
    private void received(MavlinkAddress from, List<ReceivedMessage> messages) {
        room.acquireUninterruptibly(messages.size());
        try {
            owner.execute(() -> {
                room.release(messages.size());
                if (addresses().contains(from)) { // else it was closed meanwhile
                    messages.forEach(message -> BaseThread.run(() -> handle.accept(from, message)));
                }
            });
        } catch (RejectedExecutionException closed) {
            room.release(messages.size());
        }
    }

    /** Sends a system a message on the link of an address; does nothing where there is none. */
    void send(MavlinkAddress address, int system, Object message) {
        links.stream()
                .filter(link -> link.address().equals(address))
                .findFirst()
                .ifPresent(link -> link.send(system, message));
    }

    /** Sends on each link that this ground station is there. */
    void sendHeartbeat() {
        Heartbeat heartbeat = Heartbeat.builder()
                .type(MavType.MAV_TYPE_GCS)
                .autopilot(MavAutopilot.MAV_AUTOPILOT_INVALID)
                .systemStatus(MavState.MAV_STATE_ACTIVE)
                .mavlinkVersion(3)
                .customMode(mark)
                .build();
        links.forEach(link -> link.send(heartbeat));
    }

    /** Whether a message is this base's own heartbeat, which vehicles and routers may pass on to another of its links. Another station may have the same ids. */
    boolean isOwnHeartbeat(Object payload) {
        return payload instanceof Heartbeat beat
                && beat.type().entry() == MavType.MAV_TYPE_GCS
                && beat.customMode() == mark;
    }

    @Override
    public void close() {
        links.forEach(MavlinkLink::close);
        leaving.forEach(MavlinkLink::close);
    }
}
