package org.sami.crw.sim.boat;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.IOException;
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
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.link.security.SecureLink;

/**
 * A router between base and boat: carries frames, and cuts, swallows or bends them as a test says. On protected links it has the keys of both sides, so that
 * it sees frames there as well: each of its two links is a whole one.
 */
public final class TestRelay implements Closeable {

    /** Where in a frame the link is cut. */
    public enum Where {
        BEFORE,
        MIDDLE,
        AFTER
    }

    /** Cuts the link, once, at the next message of a kind that comes through, in either direction. */
    public record Cut(Class<? extends LinkMessage> at, Where where) {}

    private final InetSocketAddress boat;
    private final LinkSecurity toBase;
    private final LinkSecurity toBoat;
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

    /** A router in front of a boat with plain links. */
    public TestRelay(InetSocketAddress boat) throws IOException {
        this(boat, new OpenLinks(), new OpenLinks());
    }

    /** A router that is the boat to a base, and the base to a boat. */
    TestRelay(InetSocketAddress boat, LinkSecurity toBase, LinkSecurity toBoat) throws IOException {
        this.boat = boat;
        this.toBase = toBase;
        this.toBoat = toBoat;
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
                start("to-boat", () -> link(base, there));
            } catch (IOException e) {
                cut(); // the boat is not there
            }
        }
    }

    private void link(Socket base, Socket there) {
        try {
            SecureLink ofBase = toBase.accept(base);
            SecureLink ofBoat = toBoat.connect(there);
            start("to-base", () -> pump(ofBoat, ofBase, there, base));
            pump(ofBase, ofBoat, base, there);
        } catch (IOException e) {
            closeQuietly(base);
            closeQuietly(there);
        } finally {
            open.remove(base);
            open.remove(there);
        }
    }

    private static void start(String what, Runnable work) {
        Thread thread = new Thread(work, "relay-" + what);
        thread.setDaemon(true);
        thread.start();
    }

    private void pump(SecureLink from, SecureLink to, Socket source, Socket sink) {
        try (source;
                sink) {
            FrameReader frames = new FrameReader(new BufferedInputStream(from.in()), codec);
            for (Optional<byte[]> next = frames.next(); next.isPresent(); next = frames.next()) {
                keep(next.get());
                if (!swallows && !loses() && !carry(bend(next.get()), to.out())) {
                    return;
                }
            }
        } catch (IOException | LinkException e) {
            // one end has gone: so does the other
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
