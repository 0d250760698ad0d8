package org.sami.crw.sim.boat;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * A way to a boat on which bytes take their time, and come through to their end even after the one who sent them has hung up: as over
 * a satellite, or through a router with deep buffers.
 */
final class DelayingRelay implements AutoCloseable {
    private final InetSocketAddress boat;
    private final ServerSocket socket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final Set<Socket> open = ConcurrentHashMap.newKeySet();
    private volatile long delayMs;
    private final AtomicLong delivered = new AtomicLong();

    /** Bytes and when they are to come out; without any, the end of the connection. */
    private record Late(Optional<byte[]> bytes, long dueNanos) {}

    DelayingRelay(InetSocketAddress boat) throws IOException {
        this.boat = boat;
        start(this::accept);
    }

    InetSocketAddress address() {
        return (InetSocketAddress) socket.getLocalSocketAddress();
    }

    /** From now on what is sent comes so many ms later; what is on its way comes when it would have. */
    void setDelayMs(long ms) {
        delayMs = ms;
    }

    /** How often bytes have come out more than a second late. */
    long deliveredLate() {
        return delivered.get();
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "late-relay");
        thread.setDaemon(true);
        thread.start();
    }

    private void accept() {
        while (!socket.isClosed()) {
            try {
                Socket base = socket.accept();
                Socket there = new Socket();
                open.add(base);
                open.add(there);
                there.connect(boat);
                carry(base, there);
                carry(there, base);
            } catch (IOException e) {
                return; // closed
            }
        }
    }

    private void carry(Socket from, Socket to) {
        BlockingQueue<Late> onTheWay = new LinkedBlockingQueue<>();
        start(() -> read(from, onTheWay));
        start(() -> deliver(onTheWay, to));
    }

    private void read(Socket from, BlockingQueue<Late> onTheWay) {
        try {
            InputStream in = from.getInputStream();
            byte[] buffer = new byte[8192];
            for (int read = in.read(buffer); read > 0; read = in.read(buffer)) {
                onTheWay.add(new Late(Optional.of(Arrays.copyOf(buffer, read)), due()));
            }
        } catch (IOException e) {
            // it has hung up
        }
        onTheWay.add(new Late(Optional.empty(), due()));
    }

    private long due() {
        return System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(delayMs);
    }

    private void deliver(BlockingQueue<Late> onTheWay, Socket to) {
        try (to) {
            for (Late next = onTheWay.take(); next.bytes().isPresent(); next = onTheWay.take()) {
                long began = System.nanoTime();
                while (next.dueNanos() > System.nanoTime()) {
                    LockSupport.parkNanos(next.dueNanos() - System.nanoTime());
                }
                to.getOutputStream().write(next.bytes().get());
                if (System.nanoTime() - began > TimeUnit.SECONDS.toNanos(1)) {
                    delivered.incrementAndGet(); // of what comes together the first is counted
                }
            }
        } catch (IOException | InterruptedException e) {
            // nobody is there to take it
        } finally {
            open.remove(to);
        }
    }

    @Override
    public void close() throws IOException {
        socket.close();
        for (Socket each : open) {
            each.close();
        }
    }
}
