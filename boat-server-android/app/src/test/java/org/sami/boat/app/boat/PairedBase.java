package org.sami.boat.app.boat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.Optional;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Pair;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;

/** A base with a key of its own, which talks to one boat on loopback over TLS, a link for each talk. For one thread. */
public final class PairedBase {
    private static final int PATIENCE_MS = 50_000;

    private final Identity identity;
    private final int port;
    private final String boat;

    /** A base that no boat knows yet. */
    public PairedBase(int port, String boat) {
        this(Identity.generate(), port, boat);
    }

    /** A base with a key that the boat may know. */
    public PairedBase(Identity identity, int port, String boat) {
        this.identity = identity;
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
    public LinkMessage pair(PairingSecret words) throws IOException, LinkException {
        return ask(
                link -> new Pair("laptop", words.proofOfBase(key(), link.peer().orElseThrow())));
    }

    /** Takes the boat, gives a command, and waits for what the boat answers with, of a kind. */
    public <M extends LinkMessage> M command(CommandMessage command, Class<M> answer)
            throws IOException, LinkException {
        try (Socket socket = connected()) {
            SecureLink link = TlsLinks.toPair(identity).connect(socket);
            LinkCodec codec = new LinkCodec();
            FrameReader frames = new FrameReader(link.in(), codec);
            link.out().write(codec.encode(0, new Hello(boat, "base", Role.COMMANDER, 10, "")));
            String term = await(frames, codec, Welcome.class).term();
            link.out().write(codec.encode(new Frame(1, term, command)));
            return await(frames, codec, answer);
        }
    }

    private static <M extends LinkMessage> M await(FrameReader frames, LinkCodec codec, Class<M> kind)
            throws IOException, LinkException {
        while (true) {
            LinkMessage message = codec.decode(
                            frames.next().orElseThrow(() -> new IOException("the boat has closed the link")))
                    .message();
            if (kind.isInstance(message)) {
                return kind.cast(message);
            }
        }
    }

    private Socket connected() throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(PATIENCE_MS);
        return socket;
    }

    /** The check code that it shows. */
    public String checkCode(Fingerprint ofBoat) {
        return PairingSecret.checkCode(key(), ofBoat);
    }

    /** What is said over a link that stands. */
    private interface Saying {
        LinkMessage over(SecureLink link);
    }

    private LinkMessage ask(Saying saying) throws IOException, LinkException {
        try (Socket socket = connected()) {
            SecureLink link = TlsLinks.toPair(identity).connect(socket);
            LinkCodec codec = new LinkCodec();
            link.out().write(codec.encode(0, saying.over(link)));
            Optional<byte[]> frame = new FrameReader(link.in(), codec).next();
            return codec.decode(frame.orElseThrow(() -> new IOException("the boat has closed the link")))
                    .message();
        }
    }
}
