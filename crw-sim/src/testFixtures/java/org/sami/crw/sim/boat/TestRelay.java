package org.sami.crw.sim.boat;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;

/** A router between base and boat: carries frames, and cuts, swallows or holds back as a test says. */
public final class TestRelay implements Closeable {

    /** Where in a frame the link is cut. */
    public enum Where {
        BEFORE,
        MIDDLE,
        AFTER
    }

    /** Cuts the link, once, at the next message of a kind that comes through, in either direction. */
    public record Cut(Class<? extends LinkMessage> at, Where where) {}

    private static final int TLS_HANDSHAKE = 0x16;

    private final InetSocketAddress boat;
    private final ServerSocket socket;
    private final LinkCodec codec = new LinkCodec();
    private final Set<Socket> open = ConcurrentHashMap.newKeySet();
    private final AtomicReference<Optional<Cut>> armed = new AtomicReference<>(Optional.empty());
    private final SplittableRandom random = new SplittableRandom(64);
    private final Queue<CommandMessage> carried = new ConcurrentLinkedQueue<>();
    private final AtomicLong bent = new AtomicLong();
    private volatile double lossProbability;
    private volatile double bentProbability;
    private volatile boolean swallows;

    public TestRelay(InetSocketAddress boat) throws IOException {
        this.boat = boat;
        socket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        start("accepts", this::accept);
    }

    public InetSocketAddress address() {
        return (InetSocketAddress) socket.getLocalSocketAddress();
    }

    /** From now on nothing gets through, either way, and no connection is closed: as a router that is off. */
    public void setSwallows(boolean value) {
        swallows = value;
    }

    /** From now on a part of the frames is lost, either way. */
    public void setLoss(double probability) {
        lossProbability = probability;
    }

    private synchronized boolean loses() {
        return random.nextDouble() < lossProbability;
    }

    /** From now on bits are flipped in a part of the frames, either way; not in their lengths, so that the link stands. */
    void setBent(double probability) {
        bentProbability = probability;
    }

    /** How many frames were bent. */
    long bent() {
        return bent.get();
    }

    /** Every command that came from bases. */
    List<CommandMessage> carried() {
        return List.copyOf(carried);
    }

    private void keep(byte[] frame) throws LinkException {
        if (codec.decode(frame).message() instanceof CommandMessage command) {
            carried.add(command);
        }
    }

    private synchronized byte[] bend(byte[] frame) {
        if (random.nextDouble() >= bentProbability) {
            return frame;
        }
        bent.incrementAndGet();
        byte[] bending = frame.clone();
        for (int flips = random.nextInt(1, 5); flips > 0; flips--) {
            bending[LinkCodec.LENGTH_BYTES + random.nextInt(frame.length - LinkCodec.LENGTH_BYTES)] ^=
                    (byte) (1 << random.nextInt(8));
        }
        return bending;
    }

    public void arm(Cut cut) {
        armed.set(Optional.of(cut));
    }

    public boolean isArmed() {
        return armed.get().isPresent();
    }

    /** Closes every connection that stands. */
    public void cut() {
        for (Socket each : open) {
            closeQuietly(each);
        }
    }

    @Override
    public void close() throws IOException {
        socket.close();
        cut();
    }

    private void accept() {
        while (!socket.isClosed()) {
            try {
                Socket base = socket.accept();
                open.add(base);
                if (swallows) {
                    continue; // it stands, and leads nowhere
                }
                Socket there = new Socket();
                open.add(there);
                there.connect(boat);
                start("to-boat", () -> pump(base, there));
                start("to-base", () -> pump(there, base));
            } catch (IOException e) {
                cut(); // the boat is not there
            }
        }
    }

    private static void start(String what, Runnable work) {
        Thread thread = new Thread(work, "relay-" + what);
        thread.setDaemon(true);
        thread.start();
    }

    private void pump(Socket from, Socket to) {
        try (from;
                to) {
            BufferedInputStream in = new BufferedInputStream(from.getInputStream());
            OutputStream out = to.getOutputStream();
            if (isProtected(in)) {
                pass(in, out);
                return;
            }
            FrameReader frames = new FrameReader(in, codec);
            for (Optional<byte[]> next = frames.next(); next.isPresent(); next = frames.next()) {
                keep(next.get());
                if (!swallows && !loses() && !carry(bend(next.get()), out)) {
                    return;
                }
            }
        } catch (IOException | LinkException e) {
            // one end has gone: so does the other
        } finally {
            open.remove(from);
            open.remove(to);
        }
    }

    /** Whether what comes is TLS, in which a router sees no frames. */
    private static boolean isProtected(BufferedInputStream in) throws IOException {
        in.mark(1);
        int first = in.read();
        in.reset();
        return first == TLS_HANDSHAKE;
    }

    private void pass(InputStream in, OutputStream out) throws IOException {
        byte[] bytes = new byte[8192];
        for (int read = in.read(bytes); read > 0; read = in.read(bytes)) {
            if (!swallows) {
                out.write(bytes, 0, read);
            }
        }
    }

    /** Returns whether the link stands afterwards. */
    private boolean carry(byte[] frame, OutputStream out) throws IOException, LinkException {
        Optional<Cut> cut = armed.get();
        boolean here = cut.isPresent()
                && cut.get().at().isInstance(codec.decode(frame).message())
                && armed.compareAndSet(cut, Optional.empty());
        if (!here) {
            out.write(frame);
            return true;
        }
        switch (cut.get().where()) {
            case BEFORE -> {}
            case MIDDLE -> out.write(Arrays.copyOf(frame, frame.length / 2));
            case AFTER -> out.write(frame);
        }
        return false;
    }

    private static void closeQuietly(Socket socket) {
        try {
            socket.close();
        } catch (IOException e) {
            // it is gone all the same
        }
    }
}
