package org.sami.crw.proxy.tcp;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Pair;
import org.sami.boat.link.Paired;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.LinkRefusedException;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.Peer;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;

/**
 * A base's part in pairing: it proves to a boat that it knows the boat's words, and the boat proves the same. One use; waits some seconds for the boat, and may
 * be cancelled by another thread meanwhile.
 */
public final class BoatPairing {
    private static final int WITHIN_MS = 10_000;
    private static final int MOST_FRAMES = 100;

    private final Request request;
    private final KeyRing keys;
    private final Socket socket = new Socket();
    private volatile boolean cancelled;

    /**
     * What is to be paired.
     *
     * @param address of the boat's server
     * @param words that the boat shows
     * @param expected the key that the boat's QR code has named; empty where the words were typed
     * @param role the most that the boat is to grant this base
     * @param name under which the boat keeps the key of this base
     */
    public record Request(
            InetSocketAddress address, PairingSecret words, Optional<Fingerprint> expected, Role role, String name) {
        public Request {
            Objects.requireNonNull(address, "address");
            Objects.requireNonNull(words, "words");
            Objects.requireNonNull(expected, "expected");
            Objects.requireNonNull(role, "role");
            Objects.requireNonNull(name, "name");
        }
    }

    /**
     * A boat that was paired.
     *
     * @param boat its key and name, and what it grants this base
     * @param checkCode what the boat shows as well, unless somebody is in between
     * @param again whether this base had its key before
     */
    public record Result(Peer boat, String checkCode, boolean again) {}

    /** A pairing with the keys of this base. */
    public BoatPairing(Request request, KeyRing keys) {
        this.request = Objects.requireNonNull(request, "request");
        this.keys = Objects.requireNonNull(keys, "keys");
    }

    /**
     * Has both sides prove that they know the words. The boat keeps this base's key then; this base keeps the boat's with {@link #keep}.
     *
     * @throws IOException with the reason as one sentence, if the boat is not reached, does not agree, or this was cancelled
     */
    public Result prove() throws IOException {
        InetSocketAddress at = request.address();
        try (socket) {
            socket.setSoTimeout(WITHIN_MS);
            connect();
            SecureLink link = TlsLinks.toPair(keys.identity()).connect(socket);
            return prove(link);
        } catch (LinkException e) {
            throw new LinkRefusedException("what answers there is no boat of this version: " + e.getMessage(), e);
        } catch (LinkRefusedException e) {
            throw cancelled ? new LinkRefusedException("cancelled", e) : e;
        } catch (SocketTimeoutException e) {
            throw new LinkRefusedException(
                    at.getHostString() + ":" + at.getPort() + " has not answered within " + WITHIN_MS / 1000 + " s", e);
        } catch (IOException e) {
            throw new LinkRefusedException(cancelled ? "cancelled" : "the link broke: " + e.getMessage(), e);
        }
    }

    private void connect() throws IOException {
        InetSocketAddress at = request.address();
        String where = at.getHostString() + ":" + at.getPort();
        try {
            socket.connect(new InetSocketAddress(at.getHostString(), at.getPort()), WITHIN_MS);
        } catch (UnknownHostException e) {
            throw new LinkRefusedException("there is no host " + at.getHostString(), e);
        } catch (SocketTimeoutException e) {
            throw e;
        } catch (IOException e) {
            throw new LinkRefusedException("no boat answers at " + where + " (" + e.getMessage() + ")", e);
        }
    }

    private Result prove(SecureLink link) throws IOException, LinkException {
        Fingerprint base = keys.identity().fingerprint();
        Fingerprint boat = link.peer().orElseThrow();
        if (request.expected().filter(key -> !key.equals(boat)).isPresent()) {
            throw new LinkRefusedException("the boat there has the key " + boat.shortText()
                    + ", the QR code is of a boat with "
                    + request.expected().orElseThrow().shortText() + ": it is another boat, maybe of another fleet");
        }
        Optional<Peer> before = keys.find(boat);
        Pair asked = new Pair(request.name(), request.words().proofOfBase(base, boat), request.role());
        link.out().write(LinkCodec.STANDARD.encode(0, asked));
        Paired paired = answer(link, before);
        if (!PairingSecret.isEqual(request.words().proofOfBoat(base, boat), paired.proof())) {
            throw new LinkRefusedException("what answers there does not know the words: somebody may be in between");
        }
        Peer peer = new Peer(boat, paired.boatId(), paired.role());
        return new Result(peer, PairingSecret.checkCode(base, boat), before.isPresent());
    }

    /**
     * Keeps the key of a boat that has proved itself.
     *
     * @throws IOException if it cannot be kept
     */
    public void keep(Result proved) throws IOException {
        keys.add(proved.boat());
    }

    /** Ends the waiting; {@link #prove} fails then. */
    public void cancel() {
        cancelled = true;
        try {
            socket.close();
        } catch (IOException e) {
            // it is closed all the same
        }
    }

    private static Paired answer(SecureLink link, Optional<Peer> before) throws IOException, LinkException {
        FrameReader frames = new FrameReader(new BufferedInputStream(link.in()), LinkCodec.STANDARD);
        for (int i = 0; i < MOST_FRAMES; i++) {
            Optional<byte[]> frame = frames.next();
            if (frame.isEmpty()) {
                break;
            }
            LinkMessage message = LinkCodec.STANDARD.decode(frame.get()).message();
            if (message instanceof Paired paired) {
                return paired;
            } else if (message instanceof Goodbye goodbye) {
                throw new LinkRefusedException(goodbye.boatId() + ": " + goodbye.reason()
                        + before.map(peer -> " (this base is paired with " + peer.name() + " already)")
                                .orElse(""));
            }
        }
        throw new LinkRefusedException("the boat has closed the link without an answer");
    }
}
