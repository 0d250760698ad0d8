package org.sami.crw.sim.boat;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.EnumSet;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A bad network between base and boat as TCP shows it: a lost packet comes later, and all behind it with it; a direction stands still while the other goes
 * on; a connection is reset in the middle of whatever it carries. No byte is missing in between: TCP leaves none out. It looks into nothing, so that it is
 * the same for plain and protected links.
 */
final class RoughNetwork implements AutoCloseable {
    private static final int PACKET_BYTES = 1400;
    private static final long NEVER = Long.MAX_VALUE;

    /** One of the two ways of a connection. */
    enum Way {
        TO_BOAT,
        TO_BASE
    }

    private final InetSocketAddress boat;
    private final ServerSocket socket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final Set<Socket> open = ConcurrentHashMap.newKeySet();
    private final SplittableRandom random = new SplittableRandom(34);
    private final CountDownLatch closing = new CountDownLatch(1);
    private final AtomicLong late = new AtomicLong();
    private final AtomicLong resets = new AtomicLong();
    private final Map<Way, AtomicLong> untilReset =
            Map.of(Way.TO_BOAT, new AtomicLong(NEVER), Way.TO_BASE, new AtomicLong(NEVER));
    private final Set<Way> still = EnumSet.noneOf(Way.class); // guarded by this
    private volatile double lost;
    private volatile long resentAfterMs;

    RoughNetwork(InetSocketAddress boat) throws IOException {
        this.boat = boat;
        start(this::accept);
    }

    InetSocketAddress address() {
        return (InetSocketAddress) socket.getLocalSocketAddress();
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "rough-network");
        thread.setDaemon(true);
        thread.start();
    }

    /** From now on a part of the packets is lost, and sent again after a time. */
    void lose(double part, long againAfterMs) {
        resentAfterMs = againAfterMs;
        lost = part;
    }

    /** How many packets came late. */
    long late() {
        return late.get();
    }

    /** Resets the connection once so many further bytes have gone that way. */
    void resetAfter(Way way, long bytes) {
        bytesUntilReset(way).set(bytes);
    }

    private AtomicLong bytesUntilReset(Way way) {
        return Objects.requireNonNull(untilReset.get(way));
    }

    /** How often a connection was reset. */
    long resets() {
        return resets.get();
    }

    /** From now on nothing goes that way, on no connection, until it goes on; nothing is left out. */
    synchronized void setStill(Way way, boolean stands) {
        if (stands) {
            still.add(way);
        } else {
            still.remove(way);
        }
        notifyAll();
    }

    private synchronized void awaitMotion(Way way) throws InterruptedException {
        while (still.contains(way) && closing.getCount() > 0) {
            wait();
        }
    }

    private synchronized int packetBytes() {
        return random.nextInt(1, PACKET_BYTES);
    }

    private synchronized boolean loses() {
        return random.nextDouble() < lost;
    }

    private void accept() {
        while (!socket.isClosed()) {
            try {
                Socket base = socket.accept();
                Socket there = new Socket();
                open.add(base);
                open.add(there);
                base.setTcpNoDelay(true);
                there.setTcpNoDelay(true);
                there.connect(boat);
                start(() -> carry(Way.TO_BOAT, base, there));
                start(() -> carry(Way.TO_BASE, there, base));
            } catch (IOException e) {
                return; // closed
            }
        }
    }

    private void carry(Way way, Socket from, Socket to) {
        byte[] packet = new byte[PACKET_BYTES];
        try (from;
                to) {
            InputStream in = from.getInputStream();
            OutputStream out = to.getOutputStream();
            for (int read = in.read(packet, 0, packetBytes()); read > 0; read = in.read(packet, 0, packetBytes())) {
                if (loses()) {
                    late.incrementAndGet();
                    closing.await(resentAfterMs, TimeUnit.MILLISECONDS);
                }
                awaitMotion(way);
                long left = bytesUntilReset(way).addAndGet(-read);
                if (left <= 0) {
                    bytesUntilReset(way).set(NEVER);
                    out.write(packet, 0, (int) (read + left));
                    reset(from);
                    reset(to);
                    resets.incrementAndGet();
                    return;
                }
                out.write(packet, 0, read);
            }
        } catch (IOException | InterruptedException e) {
            // one end has gone: so does the other
        } finally {
            open.remove(from);
            open.remove(to);
        }
    }

    /** Closes so that the other side is told of a reset, not of an end. */
    private static void reset(Socket socket) throws IOException {
        socket.setSoLinger(true, 0);
        socket.close();
    }

    @Override
    public void close() throws IOException {
        closing.countDown();
        synchronized (this) {
            notifyAll();
        }
        socket.close();
        for (Socket each : open) {
            each.close();
        }
    }
}
