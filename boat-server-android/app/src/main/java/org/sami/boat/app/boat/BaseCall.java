package org.sami.boat.app.boat;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
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
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.LinkRefusedException;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.Peer;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;

/**
 * The phone's part in a pairing for which a base shows the code ({@code crw phone}): it calls the base, goes on only with the key that the code names, proves that
 * it has read the words, and has the base prove the same. It keeps nothing. Blocks for some seconds, so it is for no main thread.
 */
final class BaseCall {
    private static final int WITHIN_MS = 10_000;

    private final PairingCode code;
    private final Identity identity;
    private final String boatName;

    /** A call of the base that a code names. */
    BaseCall(PairingCode code, Identity identity, String boatName) {
        this.code = Objects.requireNonNull(code, "code");
        this.identity = Objects.requireNonNull(identity, "identity");
        this.boatName = Objects.requireNonNull(boatName, "boatName");
    }

    /**
     * Has both sides prove that they know the words.
     *
     * @param granted the most that the base may do; it may wish for less
     * @return the base, with what it may do
     * @throws IOException with the reason as one sentence
     */
    Peer prove(Role granted) throws IOException {
        try (Socket socket = new Socket()) {
            connect(socket);
            socket.setSoTimeout(WITHIN_MS);
            return prove(TlsLinks.toPair(identity).connect(socket), granted);
        } catch (LinkException | IllegalArgumentException e) {
            throw new LinkRefusedException("what answers there is no base of this version: " + e.getMessage(), e);
        } catch (SocketTimeoutException e) {
            throw new LinkRefusedException(code.address() + " has not answered within " + WITHIN_MS / 1000 + " s", e);
        }
    }

    private void connect(Socket socket) throws IOException {
        int colon = code.address().lastIndexOf(':');
        try {
            String host = code.address().substring(0, Math.max(0, colon)).replaceAll("[\\[\\]]", "");
            int port = Integer.parseInt(code.address().substring(colon + 1));
            socket.connect(new InetSocketAddress(host, port), WITHIN_MS);
        } catch (IllegalArgumentException e) {
            throw new LinkRefusedException("the code has no address of a base: '" + code.address() + "'", e);
        } catch (SocketTimeoutException e) {
            throw e;
        } catch (IOException e) {
            throw new LinkRefusedException(
                    "no base answers at " + code.address()
                            + ": is this phone in its network, and does it show the code?",
                    e);
        }
    }

    private Peer prove(SecureLink link, Role granted) throws IOException, LinkException {
        Fingerprint boat = identity.fingerprint();
        Fingerprint base = link.peer().orElseThrow(() -> new LinkRefusedException("the base shows no key"));
        if (!base.equals(code.key())) {
            throw new LinkRefusedException(
                    "the base there has the key " + base.shortText() + ", the code is of one with "
                            + code.key().shortText() + ": it is another base, maybe of another fleet");
        }
        Pair asked = new Pair(boatName, code.words().proofOfBoat(base, boat), granted);
        link.out().write(LinkCodec.STANDARD.encode(0, asked));
        Paired answer = answer(link);
        if (!PairingSecret.isEqual(code.words().proofOfBase(base, boat), answer.proof())) {
            throw new LinkRefusedException("what answers there does not know the words: somebody may be in between");
        }
        boolean watches = granted == Role.OBSERVER || answer.role() == Role.OBSERVER;
        return new Peer(base, answer.boatId(), watches ? Role.OBSERVER : Role.COMMANDER);
    }

    private static Paired answer(SecureLink link) throws IOException, LinkException {
        FrameReader frames = new FrameReader(new BufferedInputStream(link.in()), LinkCodec.STANDARD);
        Optional<byte[]> frame = frames.next();
        if (!frame.isPresent()) {
            throw new LinkRefusedException("the base has closed the link without an answer");
        }
        LinkMessage message = LinkCodec.STANDARD.decode(frame.get()).message();
        if (message instanceof Goodbye) {
            Goodbye goodbye = (Goodbye) message;
            throw new LinkRefusedException(goodbye.boatId() + ": " + goodbye.reason());
        }
        if (!(message instanceof Paired)) {
            throw new LinkRefusedException("the base answers something else");
        }
        return (Paired) message;
    }
}
