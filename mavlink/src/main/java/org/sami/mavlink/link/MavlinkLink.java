package org.sami.mavlink.link;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.common.RadioStatus;
import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.io.IOException;
import java.io.InputStream;
import java.lang.System.Logger.Level;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * One link: opened, read and written by two threads of its own, opened again when it breaks, after a wait that grows. What is sent while it is broken is lost, as on any radio:
 * whoever sends expects an answer and sends again. Safe for use by several threads.
 *
 * <p>A connection of a ground station on which messages came, and then nothing for {@link #SILENCE}, is closed and opened again: where a cable was pulled nobody says that it has ended.
 * One on which no message came is left as it is: what answers there may be no vehicle, and may lock out who connects again and again.
 */
public final class MavlinkLink implements AutoCloseable {
    /** The system id with which ground stations speak. */
    public static final int GROUND_SYSTEM = 255;

    /** The component id with which ground stations speak. */
    public static final int GROUND_COMPONENT = 190;

    /** Fifteen heartbeats of a vehicle: longer than radios behind a router lose all of them in range, and than an autopilot takes to start again. */
    static final Duration SILENCE = Duration.ofSeconds(15);

    private static final System.Logger LOG = System.getLogger(MavlinkLink.class.getName());
    private static final long FIRST_WAIT_MS = 250;
    private static final long LONGEST_WAIT_MS = 5_000;
    private static final int UNSENT = 500;
    private static final int NOT_KNOWN = 255; // of a radio's strength
    private static final int TOGETHER = 100; // messages that are handed over at once, at most
    private static final int UNREAD_TOGETHER =
            10; // messages that nobody reads wait for so many, or for one that is read
    private static final long STRANGE_BYTES = 600; // two of the longest messages: by then one should have been read

    private final MavlinkAddress address;
    private final MavlinkLinkListener listener;
    private final LinkEnd end;
    private final Predicate<Class<?>> isRead;
    private final Duration silence;
    private final CountDownLatch closing = new CountDownLatch(1);
    private final BlockingQueue<Outgoing> outgoing = new ArrayBlockingQueue<>(UNSENT);
    private final Thread reader;
    private final Thread writer;
    private final SequenceCount count = new SequenceCount();
    private MavlinkLinkState state = MavlinkLinkState.OPENING;
    private Optional<String> fault = Optional.empty();
    private Optional<Connected> connected = Optional.empty();
    private final Map<SignatureFault, Long> refused = new EnumMap<>(SignatureFault.class);
    private Optional<String> silent = Optional.empty(); // why it was opened again, until something comes
    private Optional<String> notMavlink = Optional.empty(); // what has answered there before the last break
    private boolean hasRadio;
    private Optional<Integer> rssi = Optional.empty();
    private Optional<Integer> remoteRssi = Optional.empty();
    private long earlierBytes;
    private final LinkSenders senders = new LinkSenders();

    /** A message that waits to be sent, and the system that it is for. */
    private record Outgoing(int system, Object payload) {}

    /** An open way with its codec. */
    private record Connected(LinkStreams streams, MessageReader in, MavlinkConnection codec) {}

    /**
     * A link that is not begun yet.
     *
     * @param isRead of which of the library's classes messages are read; of others the listener only hears that they came
     */
    public MavlinkLink(MavlinkAddress address, MavlinkLinkListener listener, LinkEnd end, Predicate<Class<?>> isRead) {
        this(address, listener, end, isRead, SILENCE);
    }

    /** A link that takes another time without a message for the end of a connection. */
    MavlinkLink(
            MavlinkAddress address,
            MavlinkLinkListener listener,
            LinkEnd end,
            Predicate<Class<?>> isRead,
            Duration silence) {
        this.silence = Objects.requireNonNull(silence, "silence");
        this.end = Objects.requireNonNull(end, "end");
        this.isRead = Objects.requireNonNull(isRead, "isRead");
        this.address = Objects.requireNonNull(address, "address");
        this.listener = Objects.requireNonNull(listener, "listener");
        reader = new Thread(this::run, "mavlink " + address);
        reader.setDaemon(true);
        writer = new Thread(this::write, "mavlink " + address + " writes");
        writer.setDaemon(true);
    }

    /** Begins, if it is not closed already; returns at once. */
    public synchronized void start() {
        if (closing.getCount() > 0) {
            reader.start();
            writer.start();
        }
    }

    /** Where it leads. */
    public MavlinkAddress address() {
        return address;
    }

    /**
     * Sends a message for all, soon: a thread of the link's own writes, so that a vehicle that takes nothing keeps nobody waiting.
     *
     * @param payload a message of the library
     * @return whether it will be sent; a link that is broken, or whose other end takes nothing, sends nothing
     */
    public boolean send(Object payload) {
        return send(LinkSigning.EVERYBODY, payload);
    }

    /** The same for one system, signed with the key with which that one signs. */
    public boolean send(int system, Object payload) {
        synchronized (this) {
            if (connected.isEmpty()) {
                return false;
            }
        }
        return outgoing.offer(new Outgoing(system, payload));
    }

    private void write() {
        try {
            while (true) {
                Outgoing message = outgoing.take();
                Optional<Connected> now;
                synchronized (this) {
                    now = connected;
                }
                now.ifPresent(open -> write(open, message));
            }
        } catch (InterruptedException e) {
            // only closing interrupts it
        }
    }

    private void write(Connected open, Outgoing message) {
        try {
            if (end.signing().isPresent()) {
                LinkSigning signing = end.signing().get();
                for (SigningKey key : signing.keysTo(message.system())) {
                    open.codec()
                            .send2(
                                    end.system(),
                                    end.component(),
                                    message.payload(),
                                    end.linkId(),
                                    signing.nextTime(),
                                    key.secret());
                }
            } else {
                open.codec().send2(end.system(), end.component(), message.payload());
            }
            open.streams().out().flush();
        } catch (IOException e) {
            close(open.streams()); // the reading thread finds out, and opens it again
        }
    }

    /** What is known of it now. */
    public synchronized MavlinkLinkReport report() {
        long bytes = earlierBytes + connected.map(now -> now.in().bytes()).orElse(0L);
        Optional<String> wrong = fault.or(() -> silent);
        if (wrong.isEmpty() && state == MavlinkLinkState.OPEN && count.messages() == 0) {
            Optional<String> noise =
                    Optional.of(NonMavlinkPeer.NOISE).filter(words -> refused.isEmpty() && bytes > STRANGE_BYTES);
            wrong = connected
                    .flatMap(now -> NonMavlinkPeer.of(now.in().first()))
                    .or(() -> notMavlink)
                    .or(() -> noise);
        } else if (wrong.isEmpty()) {
            wrong = senders.fault();
        }
        return new MavlinkLinkReport(
                address,
                state,
                wrong,
                senders.faults(end.signing().isPresent()),
                bytes,
                count.messages(),
                count.lost(),
                refused,
                hasRadio,
                rssi,
                remoteRssi);
    }

    private void run() {
        long waitMs = FIRST_WAIT_MS;
        while (closing.getCount() > 0) {
            String why;
            try (LinkStreams streams = LinkOpener.open(address)) {
                waitMs = FIRST_WAIT_MS;
                why = read(streams);
            } catch (IOException e) {
                why = Objects.requireNonNullElse(e.getMessage(), e.toString());
            }
            broken(why);
            try {
                if (closing.await(waitMs, TimeUnit.MILLISECONDS)) {
                    return;
                }
            } catch (InterruptedException e) {
                return; // only closing interrupts it
            }
            waitMs = Math.min(LONGEST_WAIT_MS, 2 * waitMs);
        }
    }

    /** Messages that came and are not handed over yet: that happens before the link waits for more, whatever comes behind them. */
    private final class Taken {
        private final List<ReceivedMessage> messages = new ArrayList<>();
        private boolean news; // something that is read

        void add(ReceivedMessage message) {
            messages.add(message);
            news |= message.payload() != ReceivedMessage.UNREAD;
            if (messages.size() >= TOGETHER) {
                handOver();
            }
        }

        void beforeWaiting() {
            if (news || messages.size() >= UNREAD_TOGETHER) {
                handOver();
            }
        }

        private void handOver() {
            listener.onMessages(address, List.copyOf(messages));
            messages.clear();
            news = false;
        }
    }

    /** Reads until the link ends; why it ended. */
    private String read(LinkStreams streams) {
        Taken taken = new Taken();
        MessageReader in = new MessageReader(
                streams.in(),
                kind -> kind == RadioStatus.class || isRead.test(kind),
                this::isExpected,
                taken::beforeWaiting);
        MavlinkConnection codec = MavlinkConnection.builder(InputStream.nullInputStream(), streams.out())
                .build(); // writes
        opened(new Connected(streams, in, codec));
        try {
            MavlinkPacket packet = in.next();
            if (end.isOfBase()) {
                streams.failWhenSilent(silence);
            }
            while (true) {
                if (isTaken(packet)) {
                    taken.add(message(packet, in.message(packet)));
                }
                packet = in.next();
            }
        } catch (SocketTimeoutException e) {
            return fellSilent();
        } catch (IOException e) {
            synchronized (this) {
                return NonMavlinkPeer.ended(e, in.first(), count.messages());
            }
        }
    }

    /** Whether a message of a kind that is not known here is the next of a sender: it is not missing then. */
    private synchronized boolean isExpected(MavlinkPacket packet) {
        return count.isNext(packet.getSystemId(), packet.getComponentId(), packet.getSequence());
    }

    private String fellSilent() {
        String why = "nothing has come for " + silence.toSeconds()
                + " s, where vehicles send every second: is it on and in range, and is the way to it whole? The link is opened again";
        LOG.log(Level.INFO, () -> address + ": " + why);
        synchronized (this) {
            silent = Optional.of(why);
        }
        return why;
    }

    private ReceivedMessage message(MavlinkPacket packet, Object payload) {
        if (payload instanceof RadioStatus radio) {
            strengths(radio);
        }
        return new ReceivedMessage(
                packet.getSystemId(),
                packet.getComponentId(),
                packet.getSequence(),
                end.signing().map(signing -> signing.isOurs(packet)).orElseGet(() -> LinkSigning.isSigned(packet)),
                payload);
    }

    private synchronized void opened(Connected now) {
        connected = Optional.of(now);
        state = MavlinkLinkState.OPEN;
        fault = Optional.empty();
        if (closing.getCount() == 0) {
            close(now.streams());
        }
    }

    /** Counts a message; whether it is one to be read. */
    private synchronized boolean isTaken(MavlinkPacket packet) {
        silent = Optional.empty();
        Optional<SignatureFault> wrong = end.signing().flatMap(signing -> signing.fault(packet));
        wrong.ifPresent(why -> refused.merge(why, 1L, Long::sum));
        if (wrong.isEmpty()) {
            count.came(packet.getSystemId(), packet.getComponentId(), packet.getSequence());
            senders.came(packet);
        } else {
            senders.refused();
        }
        return wrong.isEmpty();
    }

    private synchronized void strengths(RadioStatus radio) {
        hasRadio = true;
        rssi = strength(radio.rssi());
        remoteRssi = strength(radio.remrssi());
    }

    private static Optional<Integer> strength(int value) {
        return value == NOT_KNOWN ? Optional.empty() : Optional.of(value);
    }

    private synchronized void broken(String why) {
        earlierBytes += connected.map(now -> now.in().bytes()).orElse(0L);
        notMavlink =
                connected.flatMap(now -> NonMavlinkPeer.of(now.in().first())).or(() -> notMavlink);
        connected = Optional.empty();
        state = MavlinkLinkState.BROKEN;
        fault = Optional.of(why);
    }

    private static void close(LinkStreams streams) {
        try {
            streams.close();
        } catch (IOException e) {
            // it is closed for us all the same
        }
    }

    /** Closes it and waits until its threads have ended. */
    @Override
    public void close() {
        synchronized (this) {
            closing.countDown();
            connected.ifPresent(now -> close(now.streams()));
        }
        reader.interrupt();
        writer.interrupt();
        try {
            reader.join(TimeUnit.SECONDS.toMillis(5));
            writer.join(TimeUnit.SECONDS.toMillis(5));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
