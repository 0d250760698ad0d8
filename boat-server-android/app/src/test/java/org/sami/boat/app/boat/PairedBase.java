package org.sami.boat.app.boat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.Optional;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Pair;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;
import org.sami.boat.link.security.WordSecret;

/** A base with a key of its own, which talks to one boat on loopback over TLS, a link for each talk. For one thread. */
public final class PairedBase {
    private static final int PATIENCE_MS = 50_000;

    private final Identity identity = Identity.generate();
    private final int port;
    private final String boat;

    /** A base that no boat knows yet. */
    public PairedBase(int port, String boat) {
        this.port = port;
        this.boat = boat;
    }

    /** Names its key. */
    public Fingerprint key() {
        return identity.fingerprint();
    }

    /** What the boat answers a hello. */
    public LinkMessage hello() throws IOException, LinkException {
        return ask(link -> new Hello(boat, "base", Role.COMMANDER, 10, ""));
    }

    /** What the boat answers a base that knows these words. */
    public LinkMessage pair(WordSecret words) throws IOException, LinkException {
        return ask(
                link -> new Pair("laptop", words.proofOfBase(key(), link.peer().orElseThrow())));
    }

    /** The check code that it shows. */
    public String checkCode(Fingerprint ofBoat) {
        return WordSecret.checkCode(key(), ofBoat);
    }

    /** What is said over a link that stands. */
    private interface Saying {
        LinkMessage over(SecureLink link);
    }

    private LinkMessage ask(Saying saying) throws IOException, LinkException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            socket.setSoTimeout(PATIENCE_MS);
            SecureLink link = TlsLinks.toPair(identity).connect(socket);
            LinkCodec codec = new LinkCodec();
            link.out().write(codec.encode(0, saying.over(link)));
            Optional<byte[]> frame = new FrameReader(link.in(), codec).next();
            return codec.decode(frame.orElseThrow(() -> new IOException("the boat has closed the link")))
                    .message();
        }
    }
}
