package org.sami.boat.app.boat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;

/** A base that commands one boat on loopback, for one thread. */
final class LoopbackBase implements AutoCloseable {
    private static final int PATIENCE_MS = 60_000;

    private final Socket socket;
    private final LinkCodec codec = new LinkCodec();
    private final FrameReader frames;
    private final Welcome welcome;
    private String term = "";
    private long sequence;

    LoopbackBase(int port, String boat) throws IOException, LinkException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setTcpNoDelay(true);
        socket.setSoTimeout(PATIENCE_MS);
        frames = new FrameReader(socket.getInputStream(), codec);
        say(new Hello(boat, "base", Role.COMMANDER, 10, ""));
        welcome = await(Welcome.class);
    }

    Welcome welcome() {
        return welcome;
    }

    void say(LinkMessage message) throws IOException {
        socket.getOutputStream().write(codec.encode(new Frame(sequence++, term, message)));
    }

    /** Gives a command, and waits for what the boat answers with, of a kind. */
    <M extends LinkMessage> M command(CommandMessage command, Class<M> answer) throws IOException, LinkException {
        say(command);
        return await(answer);
    }

    <M extends LinkMessage> M await(Class<M> kind) throws IOException, LinkException {
        while (true) {
            LinkMessage message = codec.decode(
                            frames.next().orElseThrow(() -> new IOException("the boat has closed the link")))
                    .message();
            if (message instanceof Welcome said) {
                term = said.term();
            }
            if (kind.isInstance(message)) {
                return kind.cast(message);
            }
        }
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
