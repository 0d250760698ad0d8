package org.sami.crw.proxy.phone;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Pair;
import org.sami.boat.link.Paired;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.Peer;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;

/**
 * A base's part where a phone asks to be paired, over TLS: the phone proves that it has read the words of the code, and the base proves the same. It keeps no
 * key: a person compares the check code first. Words are valid for one phone, five tries and {@link #WORDS_MS}; then new ones are made. Safe for use by several
 * threads.
 */
final class PhoneResponder implements Closeable {
    /** How long the words are valid, in ms: enough to install the app. */
    static final long WORDS_MS = 15 * 60_000;

    private static final int MOST_WRONG = 5;
    private static final int MOST_AT_ONCE = 8;
    private static final int WITHIN_MS = 10_000;

    /** What happens; called on the responder's threads. */
    interface Listener {
        /** A phone has proved itself; it waits until somebody says {@link #next}. */
        void proved(Peer boat, String checkCode);

        /** A phone, or something else, was refused for a reason. */
        void refused(String why);
    }

    private final Identity identity;
    private final String baseName;
    private final Role wish;
    private final LongSupplier nowMs;
    private final Listener listener;
    private final ServerSocket server;
    private final Semaphore free = new Semaphore(MOST_AT_ONCE);
    private Optional<PairingSecret> words = Optional.empty();
    private long untilMs;
    private int wrong;

    /**
     * Listens from now on, without words.
     *
     * @param baseName under which the phone keeps this base's key
     * @param wish the most that the phone is to grant this base
     */
    PhoneResponder(
            InetAddress address, Identity identity, String baseName, Role wish, LongSupplier nowMs, Listener listener)
            throws IOException {
        this.identity = Objects.requireNonNull(identity, "identity");
        this.baseName = Objects.requireNonNull(baseName, "baseName");
        this.wish = Objects.requireNonNull(wish, "wish");
        this.nowMs = Objects.requireNonNull(nowMs, "nowMs");
        this.listener = Objects.requireNonNull(listener, "listener");
        server = new ServerSocket(0, MOST_AT_ONCE, address);
        Thread thread = new Thread(this::accept, "phone-pairing");
        thread.setDaemon(true);
        thread.start();
    }

    InetSocketAddress address() {
        return (InetSocketAddress) server.getLocalSocketAddress();
    }

    /** New words in place of those before. */
    synchronized PairingSecret next() {
        PairingSecret made = PairingSecret.random();
        words = Optional.of(made);
        untilMs = nowMs.getAsLong() + WORDS_MS;
        wrong = 0;
        return made;
    }

    /** Whether words count now. */
    synchronized boolean isOpen() {
        return words.isPresent() && nowMs.getAsLong() < untilMs;
    }

    private void accept() {
        while (!server.isClosed()) {
            try {
                Socket socket = server.accept();
                if (!free.tryAcquire()) {
                    socket.close();
                    continue;
                }
                Thread thread = new Thread(() -> serve(socket), "phone-pairing");
                thread.setDaemon(true);
                thread.start();
            } catch (IOException closed) {
                if (!server.isClosed()) {
                    listener.refused("no phone can be taken any more: " + closed.getMessage());
                }
                return;
            }
        }
    }

    private void serve(Socket socket) {
        try (socket) {
            socket.setSoTimeout(WITHIN_MS);
            CompletableFuture.delayedExecutor(2L * WITHIN_MS, TimeUnit.MILLISECONDS)
                    .execute(() -> end(socket)); // who sends a byte now and then keeps no place
            SecureLink link = TlsLinks.toPair(identity).accept(socket);
            LinkCodec codec = LinkCodec.STANDARD;
            Optional<byte[]> frame = new FrameReader(new BufferedInputStream(link.in()), codec).next();
            if (frame.isPresent()) {
                Answer answer =
                        answer(codec.decode(frame.get()).message(), link.peer().orElseThrow());
                link.out().write(codec.encode(0, answer.message()));
                link.out().flush();
                answer.then().run();
            }
        } catch (IOException | LinkException | IllegalArgumentException refused) {
            listener.refused("somebody at " + socket.getInetAddress().getHostAddress() + " was refused: "
                    + refused.getMessage());
        } finally {
            free.release();
        }
    }

    private static void end(Socket socket) {
        try {
            socket.close();
        } catch (IOException closed) {
            // it is closed already
        }
    }

    /** What is answered, and what follows once the answer has gone. */
    private record Answer(LinkMessage message, Runnable then) {}

    private synchronized Answer answer(LinkMessage asked, Fingerprint boat) {
        if (!(asked instanceof Pair pair)) {
            return refuse("this is a base that pairs phones, no boat");
        }
        if (!isOpen()) {
            return refuse("the code counts no longer: scan the one that the base shows now");
        }
        PairingSecret secret = words.orElseThrow();
        Fingerprint base = identity.fingerprint();
        if (!PairingSecret.isEqual(secret.proofOfBoat(base, boat), pair.proof())) {
            wrong++;
            if (wrong == MOST_WRONG) {
                words = Optional.empty();
            }
            return refuse("the words are not those of the code, or somebody is in between");
        }
        words = Optional.empty();
        Peer peer = new Peer(boat, pair.clientId(), pair.role());
        return new Answer(
                new Paired(baseName, secret.proofOfBase(base, boat), wish),
                () -> listener.proved(peer, PairingSecret.checkCode(base, boat)));
    }

    private Answer refuse(String why) {
        return new Answer(new Goodbye(baseName, why), () -> listener.refused(why));
    }

    @Override
    public void close() throws IOException {
        synchronized (this) {
            words = Optional.empty(); // a phone that is connected already is not paired any more
        }
        server.close();
    }
}
