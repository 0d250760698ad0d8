package org.sami.crw.sim.boat;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;

/** A boat whose server knows no files: it welcomes a client, and refuses what comes then as its codec does. */
final class BoatOfBefore implements Closeable {
    private final ServerSocket server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());

    BoatOfBefore() throws IOException {
        Thread thread = new Thread(this::serve, "boat-of-before");
        thread.setDaemon(true);
        thread.start();
    }

    InetSocketAddress address() {
        return (InetSocketAddress) server.getLocalSocketAddress();
    }

    private void serve() {
        try (Socket client = server.accept()) {
            FrameReader frames = new FrameReader(client.getInputStream(), LinkCodec.STANDARD);
            frames.next();
            client.getOutputStream()
                    .write(LinkCodec.STANDARD.encode(0, new Welcome("anna", "boot", Role.OBSERVER, "")));
            frames.next();
            String detail = "UNKNOWN_TYPE at /type: no message type that is known here";
            client.getOutputStream().write(LinkCodec.STANDARD.encode(1, new Nack("", NackReason.MALFORMED, detail)));
            frames.next();
        } catch (IOException | LinkException e) {
            // the client has gone
        }
    }

    @Override
    public void close() throws IOException {
        server.close();
    }
}
