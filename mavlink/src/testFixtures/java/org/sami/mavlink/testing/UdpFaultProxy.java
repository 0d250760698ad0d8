package org.sami.mavlink.testing;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.sami.mavlink.link.MessageReader;

/**
 * Stands between two that speak MAVLink over UDP on loopback: loses datagrams, doubles them, delays each for a time of its own so that they overtake each other,
 * cuts all, and holds all up from a message on. Safe for use by several threads.
 */
public final class UdpFaultProxy implements AutoCloseable {
    private static final int MAX_DATAGRAM = 2_048;

    private final DatagramSocket vehicleSide;
    private final DatagramSocket baseSide;
    private final SplittableRandom random;
    private final ScheduledExecutorService later = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread made = new Thread(work, "udp proxy sends");
        made.setDaemon(true);
        return made;
    });
    private Optional<SocketAddress> vehicle = Optional.empty();
    private Optional<SocketAddress> base = Optional.empty();
    private double loss;
    private double doubled;
    private int mostDelayMs;
    private boolean cut;
    private Predicate<Object> holdsAt = message -> false;
    private Consumer<Object> watches = message -> {};
    private boolean held;
    private final Deque<Runnable> waiting = new ArrayDeque<>(); // what is passed on once nothing is held up

    /** A proxy that passes everything on at once. */
    public UdpFaultProxy(long seed) throws IOException {
        random = new SplittableRandom(seed);
        vehicleSide = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
        baseSide = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
        start("udp proxy of the vehicle", vehicleSide, true);
        start("udp proxy of the base", baseSide, false);
    }

    private void start(String name, DatagramSocket from, boolean ofVehicle) {
        Thread thread = new Thread(() -> run(from, ofVehicle), name);
        thread.setDaemon(true);
        thread.start();
    }

    /** Where the vehicle sends to. */
    public int vehiclePort() {
        return vehicleSide.getLocalPort();
    }

    /** Where the base sends to. */
    public int basePort() {
        return baseSide.getLocalPort();
    }

    /** From now on loses and doubles these parts (0 to 1) in both directions, and delays each datagram by a time of its own up to so many milliseconds. */
    public synchronized void disturb(double lost, double twice, int delayMs) {
        loss = lost;
        doubled = twice;
        mostDelayMs = delayMs;
    }

    /** Passes nothing on from now on, or does again. */
    public synchronized void cut(boolean now) {
        cut = now;
    }

    /**
     * Has each message of the library be seen that comes from either end, also where it is lost then.
     *
     * @param who called in the order in which they come, by one thread at a time
     */
    public synchronized void watch(Consumer<Object> who) {
        watches = who;
    }

    /**
     * Passes on up to the first message of which this is true, then nothing in either direction until {@link #letOn}: what comes waits, in its order.
     *
     * @param last called with each message of the library that is passed on, in the order in which they come, by one thread at a time
     */
    public synchronized void holdAt(Predicate<Object> last) {
        holdsAt = last;
    }

    /** Whether all is held up. */
    public synchronized boolean isHeld() {
        return held;
    }

    /** Passes on what waits, or loses it where the link is cut, and holds nothing up any longer. */
    public synchronized void letOn() {
        holdsAt = message -> false;
        held = false;
        while (!waiting.isEmpty()) {
            waiting.removeFirst().run();
        }
    }

    private void run(DatagramSocket from, boolean ofVehicle) {
        byte[] buffer = new byte[MAX_DATAGRAM];
        while (!from.isClosed()) {
            DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
            try {
                from.receive(packet);
                came(packet, ofVehicle);
            } catch (IOException e) {
                // closed, or nobody listens at the other end yet
            }
        }
    }

    private synchronized void came(DatagramPacket packet, boolean ofVehicle) {
        if (ofVehicle) {
            vehicle = Optional.of(packet.getSocketAddress());
        } else {
            base = Optional.of(packet.getSocketAddress());
        }
        byte[] content = Arrays.copyOf(packet.getData(), packet.getLength());
        messages(content).forEach(watches);
        if (held) {
            waiting.addLast(() -> go(content, ofVehicle));
        } else {
            go(content, ofVehicle);
        }
    }

    private void go(byte[] content, boolean ofVehicle) {
        if (!cut && random.nextDouble() >= loss) {
            pass(content, ofVehicle);
            if (random.nextDouble() < doubled) {
                pass(content, ofVehicle);
            }
            held = messages(content).stream().filter(holdsAt).count() > 0; // each is seen
        }
    }

    private static List<Object> messages(byte[] datagram) {
        List<Object> messages = new ArrayList<>();
        MessageReader reader = new MessageReader(new ByteArrayInputStream(datagram), kind -> true);
        try {
            while (true) {
                messages.add(reader.message(reader.next()));
            }
        } catch (EOFException e) {
            return messages;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void pass(byte[] content, boolean ofVehicle) {
        int delayMs = mostDelayMs == 0 ? 0 : random.nextInt(mostDelayMs + 1);
        Optional<SocketAddress> to = ofVehicle ? base : vehicle;
        DatagramSocket by = ofVehicle ? baseSide : vehicleSide;
        try {
            if (to.isPresent()) {
                DatagramPacket packet = new DatagramPacket(content, content.length, to.get());
                var unused = later.schedule(
                        () -> {
                            by.send(packet);
                            return packet.getLength();
                        },
                        delayMs,
                        TimeUnit.MILLISECONDS);
            }
        } catch (RejectedExecutionException e) {
            // it is being closed
        }
    }

    @Override
    public void close() {
        vehicleSide.close();
        baseSide.close();
        later.shutdownNow();
    }
}
