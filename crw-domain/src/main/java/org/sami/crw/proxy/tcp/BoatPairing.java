package org.sami.crw.proxy.tcp;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
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
import org.sami.boat.link.security.Peer;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;
import org.sami.boat.link.security.WordSecret;

/** A base's part in pairing: it proves to a boat that it was told the boat's words, and keeps the key of the boat that proves the same. */
public final class BoatPairing {
    private static final int WITHIN_MS = 10_000;
    private static final int MOST_FRAMES = 100;

    private BoatPairing() {}

    /**
     * A boat that was paired.
     *
     * @param checkCode what the boat shows as well, unless somebody is in between
     */
    public record Result(Peer boat, String checkCode) {}

    /**
     * Pairs the boat at an address. Waits for it some seconds; nothing is kept if it fails.
     *
     * @param name under which the boat keeps the key of this base
     * @throws IOException with the reason, if the boat is not reached or does not agree
     */
    public static Result pair(InetSocketAddress address, WordSecret words, String name, KeyRing keys)
            throws IOException {
        try (Socket socket = new Socket()) {
            socket.setSoTimeout(WITHIN_MS);
            socket.connect(new InetSocketAddress(address.getHostString(), address.getPort()), WITHIN_MS);
            SecureLink link = TlsLinks.toPair(keys.identity()).connect(socket);
            Fingerprint base = keys.identity().fingerprint();
            Fingerprint boat = link.peer().orElseThrow();
            link.out().write(LinkCodec.STANDARD.encode(0, new Pair(name, words.proofOfBase(base, boat))));
            Paired paired = answer(link);
            if (!WordSecret.isEqual(words.proofOfBoat(base, boat), paired.proof())) {
                throw new LinkRefusedException(
                        "what answers there does not know the words: somebody may be in between");
            }
            Peer peer = new Peer(boat, paired.boatId(), Role.OBSERVER);
            keys.add(peer);
            return new Result(peer, WordSecret.checkCode(base, boat));
        } catch (LinkException e) {
            throw new LinkRefusedException("what answers there is no boat of this version: " + e.getMessage(), e);
        }
    }

    private static Paired answer(SecureLink link) throws IOException, LinkException {
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
                throw new LinkRefusedException(goodbye.boatId() + ": " + goodbye.reason());
            }
        }
        throw new LinkRefusedException("the boat has closed the link without an answer");
    }
}
